//! The moves of the search from one point to the next.

use crate::pass::Pass;
use crate::space::{Dice, Space, Triad};
use crate::target::Target;
use jointproof::formula::quantity::Domain;
use jointproof::toolkit::graph::{Binary, Graph, Node, Op};

/// How far a move may go.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reach {
    /// To any size, sign and branch.
    Far,
    /// In the low digits mostly.
    Near,
}

/// What moves refer to.
pub(crate) struct Around<'a> {
    pub(crate) graph: &'a Graph,
    pub(crate) space: &'a Space,
    pub(crate) target: &'a Target,
}

impl Around<'_> {
    /// Moves a point in place, one or a few times; the pass is of this point on entry, and is changed.
    pub(crate) fn step(&self, inputs: &mut [f64], pass: &mut Pass, reach: Reach, dice: &mut Dice) {
        let moves = [1, 1, 1, 1, 2, 2, 3][dice.below(7)];
        for _ in 0..moves {
            self.step_once(inputs, pass, reach, dice);
        }
    }

    fn step_once(&self, inputs: &mut [f64], pass: &mut Pass, reach: Reach, dice: &mut Dice) {
        let Space { triads, free, .. } = self.space;
        // As many turns as triads have components among the inputs, and never only turns.
        let turned = 3 * triads.len();
        if dice.below(free.len() + turned) < turned && (free.is_empty() || dice.below(3) > 0) {
            return self.turn(inputs, reach, dice);
        }
        let kind = dice.below(100);
        match (reach, kind) {
            (_, 0..18) => self.solve(inputs, pass, dice),
            (Reach::Near, 18..55) => self.ulps(inputs, dice),
            (Reach::Near, 55..90) => self.stretch(inputs, -48.0, -4.0, dice),
            (_, 90..95) => self.copy(inputs, dice),
            (Reach::Near, _) | (_, 18..50) => self.stretch(inputs, -30.0, 6.5, dice),
            (_, 50..62) => self.stretch_field(inputs, dice),
            (_, 62..72) => {
                let factor = dice.between(-20.0, 20.0).exp2();
                for factor in [factor, factor.recip()] {
                    if let Some(&k) = dice.one_of(free) {
                        inputs[k] *= factor;
                    }
                }
            }
            (_, 72..80) => {
                if let Some(&k) = dice.one_of(free) {
                    inputs[k] = -inputs[k];
                }
            }
            (_, 80..83) => {
                if let Some(&k) = dice.one_of(free) {
                    inputs[k] = 0.0;
                }
            }
            (_, 83..87) => self.change_units(inputs, dice),
            (_, _) => self.ulps(inputs, dice),
        }
    }

    /// Multiplies a component by a factor whose logarithm is drawn by size.
    fn stretch(&self, inputs: &mut [f64], low: f64, high: f64, dice: &mut Dice) {
        let Some(&k) = dice.one_of(&self.space.free) else { return };
        inputs[k] =
            if inputs[k] == 0.0 { dice.doublings(-12.0, 12.0) } else { inputs[k] * dice.doublings(low, high).exp2() };
    }

    /// Multiplies all components of a field by one factor.
    fn stretch_field(&self, inputs: &mut [f64], dice: &mut Dice) {
        let Some(place) = dice.one_of(&self.space.places) else { return };
        if matches!(place.domain, Domain::Direction | Domain::Triad(..)) {
            return;
        }
        let most = self.space.most_doublings().log2();
        let factor = dice.doublings(-10.0, most).exp2();
        inputs[place.range.clone()].iter_mut().for_each(|x| *x *= factor);
    }

    /// Changes the units of length, force and time.
    fn change_units(&self, inputs: &mut [f64], dice: &mut Dice) {
        let powers = [(); 3].map(|()| dice.between(-40.0, 40.0).round());
        for place in &self.space.places {
            let unit = [place.unit.length, place.unit.force, place.unit.time];
            let power: f64 = unit.iter().zip(powers).map(|(&unit, power)| f64::from(unit) * power).sum();
            inputs[place.range.clone()].iter_mut().for_each(|x| *x *= power.exp2());
        }
    }

    /// Moves a component by a few units in the last place.
    fn ulps(&self, inputs: &mut [f64], dice: &mut Dice) {
        let Some(&k) = dice.one_of(&self.space.free) else { return };
        let steps = dice.between(0.0, 24.0).exp2().floor();
        inputs[k] += dice.sign() * steps * (inputs[k].abs() * f64::EPSILON / 2.0);
    }

    /// Makes a component nearly as large as another one.
    fn copy(&self, inputs: &mut [f64], dice: &mut Dice) {
        let (Some(&from), Some(&to)) = (dice.one_of(&self.space.free), dice.one_of(&self.space.free)) else { return };
        let off = if dice.below(2) == 0 { 0.0 } else { dice.doublings(-52.0, 0.0) };
        inputs[to] = dice.sign() * inputs[from] * (1.0 + off);
    }

    /// Turns a triad, or aligns it nearly with another one.
    fn turn(&self, inputs: &mut [f64], reach: Reach, dice: &mut Dice) {
        let Some(triad) = dice.one_of(&self.space.triads) else { return };
        let mut vectors = triad.read(inputs);
        if reach == Reach::Far
            && dice.below(12) == 0
            && let Some(other) = dice.one_of(&self.space.triads)
        {
            let (others, first) = (other.read(inputs), dice.below(3));
            let signs = [dice.sign(), dice.sign()];
            let axis = |k: usize, sign: f64| others[(first + k) % 3].map(|x| x * sign);
            if !triad.is_plane {
                vectors = [axis(0, signs[0]), axis(1, signs[1]), axis(2, signs[0] * signs[1])];
            }
        } else if reach == Reach::Far && dice.below(12) == 0 {
            // Nearly along the axes of the model.
            let first = dice.below(3);
            vectors = [0, 1, 2].map(|k| [0, 1, 2].map(|axis| f64::from(u8::from(axis == (first + k) % 3))));
        }
        let low = if reach == Reach::Near { -54.0 } else { -30.0 };
        let angle = dice.doublings(low, 1.6);
        let axis = if triad.is_plane { [0.0, 0.0, 1.0] } else { [(); 3].map(|()| dice.between(-1.0, 1.0)) };
        // Exactly along the axes now and then.
        let angle = if dice.below(40) == 0 { 0.0 } else { angle };
        triad.write(inputs, vectors.map(|vector| turned(vector, axis, angle)));
    }

    /// Moves one input so that a difference, a comparison or the ordinate of an angle becomes 0, or nearly so.
    fn solve(&self, inputs: &mut [f64], pass: &mut Pass, dice: &mut Dice) {
        let Self { graph, space, target } = self;
        let mut of = None;
        for _ in 0..24 {
            let Some(&node) = dice.one_of(&target.needed) else { return };
            of = match *graph.op(node) {
                Op::Binary(Binary::Add, ..) | Op::Unary(..) => Some([(node, 1.0), (node, 0.0)]),
                Op::Binary(Binary::Subtract | Binary::Maximum, x, y) | Op::Compare(_, x, y) => {
                    Some([(x, 1.0), (y, -1.0)])
                }
                Op::Binary(Binary::Angle, x, y) => Some([(if dice.below(2) == 0 { x } else { y }, 1.0), (node, 0.0)]),
                _ => None,
            };
            if of.is_some() {
                break;
            }
        }
        let Some(of) = of else { return };
        pass.forwards(&target.needed, inputs);
        let number = |node: Node| if graph.is_answer(node) { f64::NAN } else { pass.at(node) };
        let difference: f64 =
            of.iter().filter(|(_, weight)| *weight != 0.0).map(|&(node, weight)| weight * number(node)).sum();
        if !difference.is_finite() || difference == 0.0 {
            return;
        }
        pass.backwards(&of, &target.needed);
        let gradient = pass.gradient(&target.needed, inputs.len());
        let rest = if dice.below(3) == 0 { 0.0 } else { dice.doublings(-54.0, 0.0) };
        let wanted = -difference * (1.0 - rest);
        let places = space.free.len() + space.triads.len();
        for _ in 0..8 {
            let choice = dice.below(places);
            if let Some(&k) = space.free.get(choice) {
                if gradient[k] != 0.0 {
                    inputs[k] += wanted / gradient[k];
                    return;
                }
                continue;
            }
            let triad = &space.triads[choice - space.free.len()];
            let torque = triad.torque(inputs, &gradient);
            let square: f64 = torque.iter().map(|x| x * x).sum();
            let angle = wanted / square.sqrt();
            if square > 0.0 && angle.abs() < 0.7 {
                let vectors = triad.read(inputs);
                return triad.write(inputs, vectors.map(|vector| turned(vector, torque, angle.tan())));
            }
        }
    }
}

impl Triad {
    fn dimension(&self) -> usize {
        if self.is_plane { 2 } else { 3 }
    }

    /// The three unit vectors; those that are not inputs are completed.
    fn read(&self, inputs: &[f64]) -> [[f64; 3]; 3] {
        let given = self.axes.map(|start| {
            start.map(|start| {
                let mut vector = [0.0; 3];
                vector[..self.dimension()].copy_from_slice(&inputs[start..start + self.dimension()]);
                vector
            })
        });
        if self.is_plane {
            let left = |[x, y, _]: [f64; 3]| [-y, x, 0.0];
            let right = |[x, y, _]: [f64; 3]| [y, -x, 0.0];
            let first = given[0].or(given[1].map(right)).unwrap_or([1.0, 0.0, 0.0]);
            return [first, left(first), [0.0, 0.0, 1.0]];
        }
        let known = (0..3).find_map(|k| Some((k, given[k]?))).unwrap_or((0, [1.0, 0.0, 0.0]));
        let (k, first) = (known.0, unit(known.1));
        let second = given[(k + 1) % 3].unwrap_or_else(|| match given[(k + 2) % 3] {
            Some(third) => cross(third, first),
            None if first[0].abs() < 0.6 => cross(first, [1.0, 0.0, 0.0]),
            None => cross(first, [0.0, 1.0, 0.0]),
        });
        let along: f64 = dot(first, second);
        let second = unit([0, 1, 2].map(|i| second[i] - along * first[i]));
        let third = cross(first, second);
        let mut vectors = [[0.0; 3]; 3];
        (vectors[k], vectors[(k + 1) % 3], vectors[(k + 2) % 3]) = (first, second, third);
        vectors
    }

    /// Writes the vectors that are inputs, of length 1 and normal to each other up to rounding.
    fn write(&self, inputs: &mut [f64], vectors: [[f64; 3]; 3]) {
        let first = unit(vectors[0]);
        let along = dot(first, vectors[1]);
        let second = unit([0, 1, 2].map(|i| vectors[1][i] - along * first[i]));
        for (start, vector) in self.axes.iter().zip([first, second, cross(first, second)]) {
            if let Some(start) = *start {
                inputs[start..start + self.dimension()].copy_from_slice(&vector[..self.dimension()]);
            }
        }
    }

    /// The derivative with respect to a small rotation.
    fn torque(&self, inputs: &[f64], gradient: &[f64]) -> [f64; 3] {
        let mut torque = [0.0; 3];
        for start in self.axes.iter().flatten() {
            let part = |all: &[f64]| {
                let mut vector = [0.0; 3];
                vector[..self.dimension()].copy_from_slice(&all[*start..*start + self.dimension()]);
                vector
            };
            let one = cross(part(inputs), part(gradient));
            torque.iter_mut().zip(one).for_each(|(sum, x)| *sum += x);
        }
        torque
    }
}

/// A vector turned about an axis of any length, by the angle whose tangent, or for small ones whose size, is given.
fn turned(vector: [f64; 3], axis: [f64; 3], angle: f64) -> [f64; 3] {
    let axis = unit(axis);
    let (sine, cosine) = angle.atan().sin_cos();
    let (across, along) = (cross(axis, vector), dot(axis, vector));
    [0, 1, 2].map(|k| vector[k] * cosine + across[k] * sine + axis[k] * along * (1.0 - cosine))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    jointproof::number::scalar::direction(vector)
}
