//! What is exact at a point, and the backward errors of value and Jacobian in `f64`.

use super::claim::Claim;
use super::point::{Names, Point};
use super::subject::Subject;
use super::{Sensitivity, eta};
use crate::Octuple;
use crate::power::power_of_two;
use crate::proof::Convention;
use num_traits::{Signed, Zero};

/// What is known exactly at a point.
pub(super) struct Exact {
    pub(super) values: Vec<Octuple>,
    /// The Jacobian by automatic differentiation.
    pub(super) ad: Vec<Octuple>,
    /// How much every entry of it changes with the inputs.
    pub(super) bends: Vec<Sensitivity>,
}

impl Exact {
    pub(super) fn at(point: &Point, closed: &[Octuple]) -> Self {
        let (subject, inputs) = (point.subject, &point.exact);
        Self { values: (subject.exact_value)(inputs), ad: subject.derivative(inputs), bends: bends_at(point, closed) }
    }

    /// The largest entry in the row of the k-th.
    pub(super) fn largest_of_output(&self, k: usize, inputs: usize) -> Octuple {
        let row = k / inputs * inputs;
        self.ad[row..row + inputs]
            .iter()
            .fold(Octuple::zero(), |most, entry| if entry.abs() > most { entry.abs() } else { most })
    }

    /// How much every output changes with the inputs.
    pub(super) fn sensitivities(&self, inputs: &[Octuple]) -> Vec<Sensitivity> {
        self.ad.chunks(inputs.len()).map(|gradient| Sensitivity::new(gradient, inputs)).collect()
    }
}

/// How much every entry of the Jacobian, here `closed`, changes with the inputs.
pub(super) fn bends_at(point: &Point, closed: &[Octuple]) -> Vec<Sensitivity> {
    let (subject, inputs) = (point.subject, point.exact.as_slice());
    // At random points no kink is near, and a difference has 35 digits for a small part of the time.
    if point.random && point.kink.is_none() {
        return bends_by_differences(subject, inputs, closed);
    }
    let gradients = subject.second_derivative(inputs);
    gradients.iter().map(|gradient| Sensitivity::new(gradient, inputs)).collect()
}

/// As [`bends_at`], by what a change of one input after another, by the same part, does to the Jacobian.
fn bends_by_differences(subject: &Subject, inputs: &[Octuple], here: &[Octuple]) -> Vec<Sensitivity> {
    let part = power_of_two(-118);
    let changes = (0..inputs.len()).map(|k| {
        let mut moved = inputs.to_vec();
        moved[k] += inputs[k] * part;
        (subject.exact_jacobian)(&moved)
    });
    let mut sums = vec![Octuple::zero(); here.len()];
    for there in changes {
        sums.iter_mut().zip(there.iter().zip(here)).for_each(|(sum, (&there, &here))| *sum += (there - here).abs());
    }
    sums.into_iter().map(|sum| Sensitivity::new(&[sum], &[Octuple::from(part.recip())])).collect()
}

/// Value and Jacobian in `f64`, each alone and as they come together; on a switch there is no derivative.
pub(super) fn check_accuracy([value, jacobian]: [&mut Claim; 2], point: &Point, names: &Names, exact: &Exact) {
    let (subject, inputs) = (point.subject, &point.inputs);
    let [with_jacobian, linearized] = (subject.linearized)(inputs);
    check_value(value, point, names, exact, [(subject.value)(inputs), with_jacobian]);
    if point.kink != Some(Convention::Switch) {
        check_jacobian(jacobian, point, names, exact, [(subject.jacobian)(inputs), linearized]);
    }
}

fn check_value(claim: &mut Claim, point: &Point, names: &Names, exact: &Exact, values: [Vec<f64>; 2]) {
    let sizes = exact.sensitivities(&point.exact);
    for computed in values {
        for (output, ((&computed, &value), &sensitivity)) in computed.iter().zip(&exact.values).zip(&sizes).enumerate()
        {
            let describe = |size| point.deviation(size, names.outputs[output].clone(), computed, value.to_f64());
            claim.record(eta(computed, value, sensitivity), claim.bound, describe);
        }
    }
}

/// The closed form in `f64` is judged against automatic differentiation, so that a wrong one cannot be its own judge.
fn check_jacobian(claim: &mut Claim, point: &Point, names: &Names, exact: &Exact, jacobians: [Vec<f64>; 2]) {
    for computed in jacobians {
        for (entry, ((&computed, &ad), &bend)) in computed.iter().zip(&exact.ad).zip(&exact.bends).enumerate() {
            let size = eta(computed, ad, bend);
            let describe = |size| point.deviation(size, names.entry(entry), computed, ad.to_f64());
            claim.record(size, claim.bound, describe);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_entry_is_that_of_the_output() {
        let ad = [1.0, -5.0, 2.0, 0.25, 0.5, -0.125].map(Octuple::from).to_vec();
        let exact = Exact { values: Vec::new(), ad, bends: Vec::new() };
        let largest: Vec<_> = (0..6).map(|k| exact.largest_of_output(k, 3).to_f64()).collect();
        assert_eq!(largest, [5.0, 5.0, 5.0, 0.5, 0.5, 0.5]);
    }
}
