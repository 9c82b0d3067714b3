//! One-sided differences at a point, in 237 bits, which show whether value or derivative jumps there.

use crate::Octuple;
use crate::formula::Field;
use crate::toolkit::verify::Subject;
use crate::toolkit::verify::difference::step_size;
use num_traits::{Signed, Zero};

/// What is discontinuous at a kink.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rank {
    /// The value itself.
    Value,
    /// The first derivative.
    Slope,
    /// Only the second derivative.
    Curvature,
}

/// The tolerance for smoothness: two derivatives, or a derivative and its limit, differ by less than this relative to
/// the terms they are made of.
pub(in crate::toolkit::verify) const SMOOTH: f64 = 1e-12;
/// Steps of differences, in units of the size of the inputs: a derivative that jumps does so for both.
const STEPS: [f64; 2] = [1e-24, 1e-36];
/// The distance of a nearby point, relative to the size of an input: for an input that is 0, and for one that is not.
const BESIDE: [f64; 2] = [1e-300, 1e-50];
/// The factor for a shorter step.
const NEARER: f64 = 1e-6;
/// The value itself jumps if it changes by more than this fraction over the shorter step.
const VALUE: f64 = 1e-3;

/// The jump of a derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    /// Relative to the terms of the derivative.
    pub(super) size: f64,
    /// The index of the output.
    pub(super) output: usize,
    /// The derivatives on both sides, per unit of the direction. If only one side is in the domain: over the longer
    /// and the shorter step.
    pub(super) sides: [Octuple; 2],
}

impl Jump {
    pub(super) fn none() -> Self {
        Self { size: 0.0, output: 0, sides: [Octuple::zero(); 2] }
    }

    pub(super) fn or_larger(self, other: Self) -> Self {
        if other.size > self.size { other } else { self }
    }

    pub(super) fn is_smooth(&self) -> bool {
        self.size <= SMOOTH
    }
}

/// The neighbourhood of a point of a formula.
pub(super) struct Neighbourhood<'a> {
    subject: &'a Subject,
    at: &'a [Octuple],
    sizes: Vec<Octuple>,
    here: Vec<Octuple>,
}

impl<'a> Neighbourhood<'a> {
    pub(super) fn new(subject: &'a Subject, at: &'a [Octuple]) -> Self {
        let sizes = (0..at.len()).map(|k| step_size(subject.inputs, at, k)).collect();
        Self { subject, at, sizes, here: (subject.exact_value)(at) }
    }

    /// The inputs for which both sides are in the domain, and those for which only one is, with its sign.
    pub(super) fn sides(&self, inputs: &[usize]) -> (Vec<usize>, Vec<(usize, f64)>) {
        let allows = |k: usize, sign: f64| {
            let domain = fields(self.subject.inputs)[k].quantity.domain;
            domain.allows(self.at[k] + self.sizes[k] * (sign * STEPS[0]))
        };
        let inner = inputs.iter().copied().filter(|&k| allows(k, 1.0) && allows(k, -1.0)).collect();
        let edge = inputs.iter().flat_map(|&k| [(k, 1.0), (k, -1.0)]);
        (inner, edge.filter(|&(k, sign)| allows(k, sign) && !allows(k, -sign)).collect())
    }

    /// The number of inputs.
    pub(super) fn dimensions(&self) -> usize {
        self.at.len()
    }

    /// The direction that changes a single input.
    pub(super) fn axis(&self, input: usize) -> Vec<f64> {
        self.towards(input, 1.0)
    }

    /// That direction, or the opposite one.
    pub(super) fn towards(&self, input: usize, sign: f64) -> Vec<f64> {
        (0..self.at.len()).map(|k| if k == input { sign } else { 0.0 }).collect()
    }

    /// The size of an input, which is the unit of directions.
    pub(super) fn unit(&self, input: usize) -> Octuple {
        self.sizes[input]
    }

    fn moved(&self, direction: &[f64], step: f64) -> Vec<Octuple> {
        let moved = self.at.iter().zip(&self.sizes).zip(direction);
        moved.map(|((&x, &size), &by)| if by == 0.0 { x } else { x + size * by * step }).collect()
    }

    /// The derivatives along a direction, over a step of this sign and length.
    fn slopes(&self, direction: &[f64], step: f64) -> Vec<Octuple> {
        let there = (self.subject.exact_value)(&self.moved(direction, step));
        there.iter().zip(&self.here).map(|(&there, &here)| (there - here) / step).collect()
    }

    /// The derivatives along a direction by the closed form at a nearby point, on the side given by the sign.
    fn beside(&self, direction: &[f64], part: f64) -> Vec<Octuple> {
        let step = |x: Octuple| if x.is_zero() { BESIDE[0] } else { BESIDE[1] };
        let moved = self.at.iter().zip(&self.sizes).zip(direction);
        let moved: Vec<_> = moved.map(|((&x, &size), &by)| x + size * by * step(x) * part).collect();
        let along = |row: &[Octuple]| {
            let terms = row.iter().zip(&self.sizes).zip(direction).filter(|(_, by)| **by != 0.0);
            terms.fold(Octuple::zero(), |sum, ((&slope, &size), &by)| sum + slope * size * by)
        };
        (self.subject.exact_jacobian)(&moved).chunks(self.at.len()).map(along).collect()
    }

    /// For every output, at a step along an input: the value, or its difference quotient with respect to the input, or
    /// that of the derivative.
    pub(super) fn seen(&self, rank: Rank, input: usize, step: f64) -> Vec<Octuple> {
        let (axis, unit) = (self.axis(input), self.sizes[input]);
        let of_input = |entries: Vec<Octuple>| entries.into_iter().skip(input).step_by(self.at.len());
        match rank {
            Rank::Value if step == 0.0 => self.here.clone(),
            Rank::Value => (self.subject.exact_value)(&self.moved(&axis, step)),
            Rank::Slope => self.slopes(&axis, step).into_iter().map(|slope| slope / unit).collect(),
            Rank::Curvature => {
                let entries = |at: &[Octuple]| of_input((self.subject.exact_jacobian)(at));
                let there = entries(&self.moved(&axis, step));
                there.zip(entries(self.at)).map(|(there, here)| (there - here) / (unit * step)).collect()
            }
        }
    }

    /// The largest jump between the two sides of the point. A side without a value is outside the domain.
    pub(super) fn across(&self, direction: &[f64]) -> Jump {
        worst(self.each_across(direction))
    }

    /// As [`across`](Self::across), for every output.
    pub(super) fn each_across(&self, direction: &[f64]) -> Vec<Jump> {
        let sides = |step: f64| [-step, step].map(|step| self.slopes(direction, step));
        let first = sides(STEPS[0]);
        let is_defined = |side: &Vec<Octuple>| side.iter().all(|slope| !slope.is_nan());
        match first.each_ref().map(is_defined) {
            [true, true] => self.jumps(&first, sides, |parts| parts.map(|part| self.beside(direction, part))),
            [false, true] => self.each_inward(direction),
            [true, false] => self.each_inward(&direction.iter().map(|by| -by).collect::<Vec<_>>()),
            [false, false] => vec![Jump::none(); self.here.len()],
        }
    }

    /// Whether the derivative towards the inside of the domain has a limit, if there is no other side.
    pub(super) fn inward(&self, direction: &[f64]) -> Jump {
        worst(self.each_inward(direction))
    }

    fn each_inward(&self, direction: &[f64]) -> Vec<Jump> {
        let both = |step: f64| [step, step * NEARER].map(|step| self.slopes(direction, step));
        self.jumps(&both(STEPS[0]), both, |_| [1.0, NEARER].map(|part| self.beside(direction, part)))
    }

    /// Whether the derivative along the sum of two directions is the sum of the derivatives along them, as it is if
    /// there is a derivative at all.
    pub(super) fn additive(&self, [a, b]: [&[f64]; 2]) -> Jump {
        let sum: Vec<f64> = a.iter().zip(b).map(|(a, b)| a + b).collect();
        let add = |a: Vec<Octuple>, b: Vec<Octuple>| a.into_iter().zip(b).map(|(a, b)| a + b).collect();
        let both = |step: f64| [add(self.slopes(a, step), self.slopes(b, step)), self.slopes(&sum, step)];
        let beside = |_| [add(self.beside(a, 1.0), self.beside(b, 1.0)), self.beside(&sum, 1.0)];
        worst(self.jumps(&both(STEPS[0]), both, beside))
    }

    /// The differences between pairs of derivatives, one per output. A difference over the first step must be
    /// confirmed over a shorter one and, unless the value itself jumps, at nearby points: for a smooth function it
    /// shrinks with the step.
    fn jumps(
        &self,
        pairs: &[Vec<Octuple>; 2],
        over: impl Fn(f64) -> [Vec<Octuple>; 2],
        beside: impl Fn([f64; 2]) -> [Vec<Octuple>; 2],
    ) -> Vec<Jump> {
        let outputs = 0..self.here.len();
        let difference = |[a, b]: &[Vec<Octuple>; 2], k: usize| (a[k] - b[k]).abs();
        let relative = |pairs: &[Vec<Octuple>; 2], k: usize, terms: Octuple| {
            share(difference(pairs, k), pairs[0][k].abs() + pairs[1][k].abs() + self.here[k].abs() + terms)
        };
        let first: Vec<_> = outputs.clone().map(|k| relative(pairs, k, Octuple::zero())).collect();
        if first.iter().all(|&size| size <= SMOOTH) {
            return jumps_of(&first, pairs);
        }
        let (shorter, beside, terms) = (over(STEPS[1]), beside([-1.0, 1.0]), self.terms());
        let confirmed: Vec<_> = outputs
            .map(|k| {
                let size = relative(pairs, k, terms[k]).min(relative(&shorter, k, terms[k]));
                let by_value = share(difference(&shorter, k) * STEPS[1], difference(pairs, k) * STEPS[0]);
                if by_value > VALUE {
                    return size;
                }
                let lasts =
                    |later: Octuple| if later.is_nan() { 1.0 } else { share(later, difference(pairs, k)).min(1.0) };
                size * lasts(difference(&shorter, k)) * lasts(difference(&beside, k))
            })
            .collect();
        jumps_of(&confirmed, pairs)
    }

    /// The sizes of terms that determine the rounding error of each output: the contributions of all inputs.
    fn terms(&self) -> Vec<Octuple> {
        let entries = (self.subject.exact_jacobian)(self.at);
        let finite = |x: Octuple| if x.is_finite() { x } else { Octuple::zero() };
        let of_output = |row: &[Octuple]| {
            let terms = row.iter().zip(&self.sizes).map(|(&slope, &size)| finite((slope * size).abs()));
            terms.fold(Octuple::zero(), |sum, term| sum + term)
        };
        entries.chunks(self.at.len()).map(of_output).collect()
    }
}

/// The field of every component.
fn fields(fields: &'static [Field]) -> Vec<&'static Field> {
    fields.iter().flat_map(|field| vec![field; field.len()]).collect()
}

/// The quotient; 0 if the part is 0.
fn share(part: Octuple, whole: Octuple) -> f64 {
    if part.is_zero() { 0.0 } else { (part / whole).to_f64() }
}

fn jumps_of(sizes: &[f64], [a, b]: &[Vec<Octuple>; 2]) -> Vec<Jump> {
    let jump = |(output, &size): (usize, &f64)| Jump { size, output, sides: [a[output], b[output]] };
    sizes.iter().enumerate().map(jump).collect()
}

/// The largest jump; NaN, for which there is no derivative at all, does not count.
fn worst(jumps: Vec<Jump>) -> Jump {
    jumps.into_iter().fold(Jump::none(), Jump::or_larger)
}

#[cfg(test)]
mod tests;
