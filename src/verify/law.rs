//! Laws: what physics demands of every formula, and the words to state more.

use super::subject::{Law, Subject};
use crate::formula::{Equation, Field, turns};
use crate::quantity::{Domain, Shape, Unit};
use crate::scalar::{direction, norm};
use crate::verify::sample::rotation;
use crate::{Octuple, Scalar};
use nalgebra::Vector3;
use num_traits::{One, Signed, Zero};

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

/// A force does no work in a direction.
pub fn no_work(force: Vector3<Octuple>, direction: Vector3<Octuple>) -> Vec<Equation> {
    let scale = length(force) * length(direction);
    vec![Equation { left: force.dot(&direction), right: Octuple::zero(), scale }]
}

/// Two vectors are parallel.
pub fn parallel(left: Vector3<Octuple>, right: Vector3<Octuple>) -> Vec<Equation> {
    let scale = length(left) * length(right);
    left.cross(&right).iter().map(|&left| Equation { left, right: Octuple::zero(), scale }).collect()
}

/// Numbers are 0 that were summed from terms of the size of `term`.
pub fn vanish(numbers: impl IntoIterator<Item = Octuple>, term: Octuple) -> Vec<Equation> {
    equal_all_with(numbers.into_iter().map(|number| (number, Octuple::zero())), term)
}

/// A right-handed orthonormal triad to 237 bits from one that is so to 53: the first vector is kept in direction, the
/// second in the plane of the first two.
pub fn orthonormal<D: Scalar>([first, second, _]: [Vector3<D>; 3]) -> [Vector3<D>; 3] {
    let unit = |v: Vector3<D>| v / norm([v.x, v.y, v.z]);
    let first = unit(first);
    let third = unit(first.cross(&second));
    [first, third.cross(&first), third]
}

/// By how much the two sides differ, relative to their scale; 0 where all is 0.
pub fn residual(equation: &Equation) -> f64 {
    let difference = (equation.left - equation.right).abs();
    if difference.is_zero() { 0.0 } else { (difference / equation.scale).to_f64() }
}

/// The laws that every formula obeys.
pub(crate) fn of_all(subject: &Subject) -> Vec<Law> {
    let (inputs, outputs, value) = (subject.inputs, subject.outputs, subject.exact_value);
    let homogeneity = Law {
        statement: "dimensional homogeneity: other units of length, force and time only rescale the outputs",
        sides: Box::new(move |i| equal_all(value(&rescale(inputs, i)).into_iter().zip(rescale(outputs, &value(i))))),
    };
    let indifference = Law {
        statement: "frame indifference: moving and turning the model moves and turns the outputs",
        sides: Box::new(move |i| {
            let reach = reach(inputs, i);
            let sides = value(&moved(inputs, i, reach)).into_iter().zip(moved(outputs, &value(i), reach));
            // Cancellation leaves a rounding of the inputs' size in outputs of any size.
            let size = i.iter().fold(Octuple::from(1.0), |size, x| size + x.abs());
            sides.map(|(left, right)| Equation { left, right, scale: size * size + left.abs() }).collect()
        }),
    };
    if subject.spec.objective { vec![homogeneity, indifference] } else { vec![homogeneity] }
}

/// Scales every field by its unit.
fn rescale(fields: &[Field], components: &[Octuple]) -> Vec<Octuple> {
    let factor = |unit: Unit| Octuple::from(2.0_f64.powi(3 * unit.length - 5 * unit.force + 7 * unit.time));
    let factors = fields.iter().flat_map(|field| vec![factor(field.quantity.unit); field.len()]);
    components.iter().zip(factors).map(|(&x, factor)| x * factor).collect()
}

/// The largest coordinate of a point, or 1: the translation is in proportion, lest it swallow a small model.
fn reach(fields: &[Field], components: &[Octuple]) -> Octuple {
    let is_point = fields.iter().flat_map(|field| vec![field.quantity.domain == Domain::Point; field.len()]);
    let coordinates = components.iter().zip(is_point).filter(|(_, is_point)| *is_point).map(|(x, _)| x.abs());
    coordinates
        .reduce(|largest, x| if x > largest { x } else { largest })
        .filter(|x| !x.is_zero())
        .unwrap_or_else(Octuple::one)
}

/// Turns vectors, and turns and moves points.
fn moved(fields: &[Field], components: &[Octuple], reach: Octuple) -> Vec<Octuple> {
    let mut rest = components;
    let mut result = Vec::new();
    for field in fields {
        let (part, tail) = rest.split_at(field.len().min(rest.len()));
        rest = tail;
        result.extend(move_part(part, field.quantity.domain, field.quantity.shape, reach));
    }
    result
}

fn move_part(part: &[Octuple], domain: Domain, shape: Shape, reach: Octuple) -> Vec<Octuple> {
    if !turns(domain) || shape == Shape::Scalar {
        return part.to_vec();
    }
    let number = Octuple::from;
    let triad = if shape == Shape::Vec2 {
        let (c, s, zero) = (number(3.0) / 5.0, number(4.0) / 5.0, number(0.0));
        [[c, s, zero], [-s, c, zero], [zero; 3]]
    } else {
        let [w, x, y, z] = direction([2.0, -1.0, 3.0, 4.0].map(number));
        rotation(w, x, y, z)
    };
    let translation = [1.25, -7.0, 3.5].map(|x| reach * x);
    let shift = |axis: usize| if domain == Domain::Point { translation[axis] } else { Octuple::zero() };
    (0..part.len())
        .map(|axis| part.iter().enumerate().fold(shift(axis), |sum, (k, &x)| sum + x * triad[k][axis]))
        .collect()
}
