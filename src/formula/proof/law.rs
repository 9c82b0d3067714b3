//! Laws: physical conditions on a formula, and the vocabulary to state them.

use crate::formula::Formula;
use crate::number::scalar::norm;
use crate::{Octuple, Scalar};
use nalgebra::Vector3;
use num_traits::{Signed, Zero};

/// Both sides of a law, at inputs in 237 bits.
type Sides<F> = fn(&<F as Formula>::Inputs<Octuple>) -> Vec<Equation>;

/// A physical law, as pairs of numbers that must be equal.
#[non_exhaustive]
pub struct Law<F: Formula> {
    /// The law in a few words.
    pub statement: String,
    /// Both sides, evaluated in 237 bits at inputs drawn by the sampler.
    pub sides: Sides<F>,
}

impl<F: Formula> Law<F> {
    /// A law in words and in numbers.
    pub fn new(statement: impl Into<String>, sides: Sides<F>) -> Self {
        Self { statement: statement.into(), sides }
    }
}

/// Two numbers that a [`Law`] states to be equal, and the size of the terms they were summed from.
#[derive(Clone, Copy, Debug)]
pub struct Equation {
    /// One side.
    pub left: Octuple,
    /// The other.
    pub right: Octuple,
    /// The size of the terms, against which rounding is judged.
    pub scale: Octuple,
}

/// Two numbers are equal.
pub fn equal(left: Octuple, right: Octuple) -> Vec<Equation> {
    equal_all([(left, right)])
}

/// Two numbers are equal that were summed from terms of the size of `term`.
pub fn equal_with(left: Octuple, right: Octuple, term: Octuple) -> Vec<Equation> {
    equal_all_with([(left, right)], term)
}

/// Pairs of numbers are equal that were summed from terms of the size of `term`.
pub fn equal_all_with(pairs: impl IntoIterator<Item = (Octuple, Octuple)>, term: Octuple) -> Vec<Equation> {
    let scale = |left: Octuple, right: Octuple| left.abs() + right.abs() + term.abs();
    pairs.into_iter().map(|(left, right)| Equation { left, right, scale: scale(left, right) }).collect()
}

/// Pairs of numbers are equal.
pub fn equal_all(pairs: impl IntoIterator<Item = (Octuple, Octuple)>) -> Vec<Equation> {
    equal_all_with(pairs, Octuple::zero())
}

/// The length of a vector.
pub fn length(v: Vector3<Octuple>) -> Octuple {
    norm([v.x, v.y, v.z])
}

/// Two vectors are equal, relative to their length.
pub fn equal_vectors(left: Vector3<Octuple>, right: Vector3<Octuple>) -> Vec<Equation> {
    let scale = length(left) + length(right);
    let equation = |(&left, &right)| Equation { left, right, scale };
    left.iter().zip(right.iter()).map(equation).collect()
}

/// A force does no work along a direction.
pub fn no_work(force: Vector3<Octuple>, direction: Vector3<Octuple>) -> Vec<Equation> {
    let scale = length(force) * length(direction);
    vec![Equation { left: force.dot(&direction), right: Octuple::zero(), scale }]
}

/// Two vectors are parallel.
pub fn parallel(left: Vector3<Octuple>, right: Vector3<Octuple>) -> Vec<Equation> {
    let scale = length(left) * length(right);
    left.cross(&right).iter().map(|&left| Equation { left, right: Octuple::zero(), scale }).collect()
}

/// Numbers vanish that were summed from terms of the size of `term`.
pub fn vanish(numbers: impl IntoIterator<Item = Octuple>, term: Octuple) -> Vec<Equation> {
    equal_all_with(numbers.into_iter().map(|number| (number, Octuple::zero())), term)
}

/// A right-handed orthonormal triad in 237 bits from one that is so in 53 bits: the direction of the first vector and
/// the plane of the first two are kept.
pub fn orthonormal<D: Scalar>([first, second, _]: [Vector3<D>; 3]) -> [Vector3<D>; 3] {
    let unit = |v: Vector3<D>| v / norm([v.x, v.y, v.z]);
    let first = unit(first);
    let third = unit(first.cross(&second));
    [first, third.cross(&first), third]
}

/// The difference of both sides relative to their scale; 0 if all are 0.
pub fn residual(equation: &Equation) -> f64 {
    let difference = (equation.left - equation.right).abs();
    if difference.is_zero() { 0.0 } else { (difference / equation.scale).to_f64() }
}
