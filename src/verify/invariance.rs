//! The laws that every formula obeys: dimensional homogeneity and frame indifference.

use super::sample::rotation;
use super::subject::{Law, Subject};
use crate::Octuple;
use crate::formula::Field;
use crate::proof::Equation;
use crate::proof::law::equal_all;
use crate::quantity::{Domain, Shape, Unit};
use crate::scalar::direction;
use num_traits::{One, Signed, Zero};

/// The laws that every formula obeys.
pub(crate) fn of_all(subject: &Subject) -> Vec<Law> {
    let (inputs, outputs, value) = (subject.inputs, subject.outputs, subject.exact_value);
    let homogeneity = Law {
        statement: "dimensional homogeneity: other base units only rescale the outputs".into(),
        sides: Box::new(move |i| equal_all(value(&rescale(inputs, i)).into_iter().zip(rescale(outputs, &value(i))))),
    };
    let indifference = Law {
        statement: "frame indifference: a rigid-body motion of the model displaces and rotates the outputs with it"
            .into(),
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
    let factor = |unit: Unit| {
        Octuple::from(2.0_f64.powi(3 * unit.length - 5 * unit.force + 7 * unit.time + 11 * unit.temperature))
    };
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

/// Turns vectors and matrices, and turns and moves points.
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
    if !domain.turns() || shape == Shape::Scalar {
        return part.to_vec();
    }
    let number = Octuple::from;
    let triad = if matches!(shape, Shape::Vec2 | Shape::Mat2) {
        let (c, s, zero) = (number(3.0) / 5.0, number(4.0) / 5.0, number(0.0));
        [[c, s, zero], [-s, c, zero], [zero; 3]]
    } else {
        let [w, x, y, z] = direction([2.0, -1.0, 3.0, 4.0].map(number));
        rotation(w, x, y, z)
    };
    let translation = [1.25, -7.0, 3.5].map(|x| reach * x);
    if let [rows, _] = *shape.dimensions() {
        // Row i, column j is of both axes.
        let turned = |row: usize, column: usize| {
            let product = |k: usize| part[k] * triad[k / rows][row] * triad[k % rows][column];
            (0..part.len()).map(product).fold(Octuple::zero(), |sum, x| sum + x)
        };
        return (0..part.len()).map(|k| turned(k / rows, k % rows)).collect();
    }
    let shift = |axis: usize| if domain == Domain::Point { translation[axis] } else { Octuple::zero() };
    (0..part.len())
        .map(|axis| part.iter().enumerate().fold(shift(axis), |sum, (k, &x)| sum + x * triad[k][axis]))
        .collect()
}
