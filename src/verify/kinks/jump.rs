//! One-sided differences at a point, in 237 bits: whether value or derivative jumps there.

use super::register::Rank;
use crate::Octuple;
use crate::formula::Field;
use crate::verify::Subject;
use crate::verify::difference::step_size;
use num_traits::{Signed, Zero};

/// Two derivatives, or a derivative and its limit, differ by no more than this part of what they are made of where the
/// formula is smooth.
pub(in crate::verify) const SMOOTH: f64 = 1e-12;
/// Steps of differences, in units of the size of the inputs: a derivative that jumps does so at both.
const STEPS: [f64; 2] = [1e-30, 1e-36];

/// By how much a derivative jumps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    /// Relative to what the derivative is made of.
    pub(super) size: f64,
    /// The place of the output.
    pub(super) output: usize,
    /// The derivatives on both sides, by one unit of the direction. Where only one side is in the domain: over the longer
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

/// A formula at a point, of which its neighbourhood is asked.
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

    /// The inputs of which both sides are in the domain, and those of which one is, with its sign.
    pub(super) fn sides(&self, inputs: &[usize]) -> (Vec<usize>, Vec<(usize, f64)>) {
        let allows = |k: usize, sign: f64| {
            let domain = fields(self.subject.inputs)[k].quantity.domain;
            domain.allows(self.at[k] + self.sizes[k] * (sign * STEPS[0]))
        };
        let inner = inputs.iter().copied().filter(|&k| allows(k, 1.0) && allows(k, -1.0)).collect();
        let edge = inputs.iter().flat_map(|&k| [(k, 1.0), (k, -1.0)]);
        (inner, edge.filter(|&(k, sign)| allows(k, sign) && !allows(k, -sign)).collect())
    }

    /// How many inputs there are.
    pub(super) fn dimensions(&self) -> usize {
        self.at.len()
    }

    /// The direction that changes a single input.
    pub(super) fn axis(&self, input: usize) -> Vec<f64> {
        (0..self.at.len()).map(|k| f64::from(u8::from(k == input))).collect()
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
    pub(super) fn slopes(&self, direction: &[f64], step: f64) -> Vec<Octuple> {
        let there = (self.subject.exact_value)(&self.moved(direction, step));
        there.iter().zip(&self.here).map(|(&there, &here)| (there - here) / step).collect()
    }

    /// Of every output, at a step along an input: the value, or the derivative from here to there by the input, or that of
    /// the derivative.
    pub(super) fn seen(&self, rank: Rank, input: usize, step: f64) -> Vec<Octuple> {
        let (axis, unit) = (self.axis(input), self.sizes[input]);
        let of_input = |entries: Vec<Octuple>| entries.into_iter().skip(input).step_by(self.at.len());
        match rank {
            Rank::Value if step == 0.0 => self.here.clone(),
            Rank::Value => (self.subject.exact_value)(&self.moved(&axis, step)),
            Rank::Slope => self.slopes(&axis, step).into_iter().map(|slope| slope / unit).collect(),
            Rank::Curvature => {
                let [here, there] = [self.at.to_vec(), self.moved(&axis, step)].map(|at| (self.subject.exact_jacobian)(&at));
                of_input(there).zip(of_input(here)).map(|(there, here)| (there - here) / (unit * step)).collect()
            }
        }
    }

    /// The largest jump between the two sides of the point. A side on which there is no value is outside.
    pub(super) fn across(&self, direction: &[f64]) -> Jump {
        let sides = |step: f64| [-step, step].map(|step| self.slopes(direction, step));
        let first = sides(STEPS[0]);
        let is_defined = |side: &Vec<Octuple>| side.iter().all(|slope| !slope.is_nan());
        match first.each_ref().map(is_defined) {
            [true, true] => self.largest(direction, &first, || sides(STEPS[1])),
            [false, true] => self.inward(direction),
            [true, false] => self.inward(&direction.iter().map(|by| -by).collect::<Vec<_>>()),
            [false, false] => Jump::none(),
        }
    }

    /// Whether the derivative into the domain has a limit, where there is no other side.
    pub(super) fn inward(&self, direction: &[f64]) -> Jump {
        let both = STEPS.map(|step| self.slopes(direction, step));
        self.largest(direction, &both, || STEPS.map(|step| self.slopes(direction, step * 1e-3)))
    }

    /// Whether the derivative along the sum of two directions is the sum of their derivatives, as it is where there is
    /// a derivative at all.
    pub(super) fn additive(&self, [a, b]: [&[f64]; 2]) -> Jump {
        let sum: Vec<f64> = a.iter().zip(b).map(|(a, b)| a + b).collect();
        let both = |step: f64| {
            let parts = self.slopes(a, step).into_iter().zip(self.slopes(b, step));
            [parts.map(|(a, b)| a + b).collect(), self.slopes(&sum, step)]
        };
        self.largest(&sum, &both(STEPS[0]), || both(STEPS[1]))
    }

    /// The largest difference between pairs of numbers, one an output, which others must confirm.
    fn largest(&self, direction: &[f64], pairs: &[Vec<Octuple>; 2], again: impl Fn() -> [Vec<Octuple>; 2]) -> Jump {
        let jumps = |[a, b]: &[Vec<Octuple>; 2], terms: &dyn Fn(usize) -> Octuple| -> Vec<f64> {
            let relative = |output: usize| {
                let [a, b] = [a[output], b[output]];
                let scale = a.abs() + b.abs() + self.here[output].abs() + terms(output);
                let difference = (a - b).abs();
                if difference.is_zero() { 0.0 } else { (difference / scale).to_f64() }
            };
            (0..self.here.len()).map(relative).collect()
        };
        let first = jumps(pairs, &|_| Octuple::zero());
        if first.iter().all(|&size| size <= SMOOTH) {
            return worst(&first, pairs);
        }
        let terms = self.terms(direction);
        let [first, second] = [jumps(pairs, &|k| terms[k]), jumps(&again(), &|k| terms[k])];
        let confirmed: Vec<_> = first.iter().zip(&second).map(|(a, b)| a.min(*b)).collect();
        worst(&confirmed, pairs)
    }

    /// The terms that rounding of each output is in proportion to: what every input does to it, beside the point.
    fn terms(&self, direction: &[f64]) -> Vec<Octuple> {
        let beside = self.moved(direction, STEPS[0]);
        let entries = (self.subject.exact_jacobian)(&beside);
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

/// The largest; NaN, which is no derivative at all, is not a jump.
fn worst(sizes: &[f64], [a, b]: &[Vec<Octuple>; 2]) -> Jump {
    let jump = |(output, &size): (usize, &f64)| Jump { size, output, sides: [a[output], b[output]] };
    sizes.iter().enumerate().map(jump).fold(Jump::none(), Jump::or_larger)
}
