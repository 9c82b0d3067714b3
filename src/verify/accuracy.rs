//! What is exact at a point, and the backward errors of value and Jacobian in `f64`.

use super::claim::Claim;
use super::point::{Names, Point};
use super::subject::Subject;
use super::{Sensitivity, eta};
use crate::Octuple;
use crate::power::power_of_two;
use crate::proof::Convention;
use num_traits::{Signed, Zero};
use std::cell::OnceCell;

/// What is known exactly at a point.
pub(super) struct Exact {
    pub(super) values: Vec<Octuple>,
    /// The Jacobian by automatic differentiation, and by the closed form.
    pub(super) ad: Vec<Octuple>,
    pub(super) closed: Vec<Octuple>,
    /// How much every entry of the Jacobian changes with the inputs, and a part of that, once they were asked for.
    bends: OnceCell<Vec<Sensitivity>>,
    least_bends: OnceCell<Vec<Sensitivity>>,
}

impl Exact {
    pub(super) fn at(point: &Point) -> Self {
        let (subject, inputs) = (point.subject, &point.exact);
        Self {
            values: (subject.exact_value)(inputs),
            ad: subject.derivative(inputs),
            closed: (subject.exact_jacobian)(inputs),
            bends: OnceCell::new(),
            least_bends: OnceCell::new(),
        }
    }

    /// How much the k-th entry of the Jacobian changes with the inputs, which takes a Jacobian for every input.
    pub(super) fn bend(&self, point: &Point, k: usize) -> Sensitivity {
        self.bends.get_or_init(|| bends_at(point, &self.closed))[k]
    }

    /// A number that is not larger, by one Jacobian more.
    pub(super) fn least_bend(&self, point: &Point, k: usize) -> Sensitivity {
        self.least_bends.get_or_init(|| least_bends(point, &self.closed))[k]
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
    if has_no_kink_near(point) {
        return bends_by_differences(subject, inputs, closed);
    }
    let gradients = subject.second_derivative(inputs);
    gradients.iter().map(|gradient| Sensitivity::new(gradient, inputs)).collect()
}

/// At random points no kink is near, and a difference has 35 digits for a small part of the time.
fn has_no_kink_near(point: &Point) -> bool {
    point.random && point.kink.is_none()
}

/// Inputs change by this part of them in differences of Jacobians.
const PART: i64 = -118;

/// As [`bends_at`], by what a change of one input after another, by the same part, does to the Jacobian.
fn bends_by_differences(subject: &Subject, inputs: &[Octuple], here: &[Octuple]) -> Vec<Sensitivity> {
    let part = power_of_two(PART);
    let changes = (0..inputs.len()).map(|k| {
        let mut moved = inputs.to_vec();
        moved[k] += inputs[k] * part;
        (subject.exact_jacobian)(&moved)
    });
    let mut sums = vec![Octuple::zero(); here.len()];
    for there in changes {
        sums.iter_mut().zip(there.iter().zip(here)).for_each(|(sum, (&there, &here))| *sum += (there - here).abs());
    }
    sums.into_iter().map(per_part).collect()
}

/// By what a change of all inputs at once does, every other one up and every other one down; near a kink it tells nothing.
fn least_bends(point: &Point, here: &[Octuple]) -> Vec<Sensitivity> {
    if !has_no_kink_near(point) {
        return vec![Sensitivity::none(); here.len()];
    }
    let part = power_of_two(PART);
    let moved: Vec<_> =
        point.exact.iter().zip([part, -part].into_iter().cycle()).map(|(&x, part)| x + x * part).collect();
    let there = (point.subject.exact_jacobian)(&moved);
    there.iter().zip(here).map(|(&there, &here)| per_part(there - here)).collect()
}

fn per_part(change: Octuple) -> Sensitivity {
    Sensitivity::new(&[change], &[Octuple::from(power_of_two(PART).recip())])
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
        for (entry, (&computed, &ad)) in computed.iter().zip(&exact.ad).enumerate() {
            let at_most = || eta(computed, ad, Sensitivity::none());
            let closer = || eta(computed, ad, exact.least_bend(point, entry));
            let size = || eta(computed, ad, exact.bend(point, entry));
            let describe = |size| point.deviation(size, names.entry(entry), computed, ad.to_f64());
            claim.record_last([&at_most, &closer, &size], claim.bound, describe);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::ReturnMap;
    use crate::proof::Proved;
    use crate::slot::{ContactForce, Friction};
    use crate::verify::Options;
    use crate::verify::audit::named_points;
    use crate::verify::point::random_points;

    /// On a kink, beside it, and at random points.
    #[test]
    fn the_least_bend_is_not_more_than_the_bend() {
        fn compare<F: Proved>() {
            let subject = Subject::of::<F>();
            let random = random_points(&subject, &Options { samples: 20, seed: 1 }, 0..20);
            let mut kinks = 0;
            for point in named_points(&subject).iter().chain(&random) {
                let exact = Exact::at(point);
                kinks += usize::from(point.kink.is_some());
                for k in 0..exact.ad.len() {
                    let [least, bend] = [exact.least_bend(point, k), exact.bend(point, k)].map(Sensitivity::size);
                    // As far as differences have digits.
                    let size = (bend + exact.ad[k].abs()) * 1e-30;
                    assert!(least <= bend + size, "{} at {}: {least:?} > {bend:?}", subject.spec.id, point.label);
                }
            }
            assert!(kinks > 0, "{} has no point on a kink", subject.spec.id);
        }
        compare::<ReturnMap>();
        compare::<ContactForce>();
        compare::<Friction>();
    }

    #[test]
    fn the_largest_entry_is_that_of_the_output() {
        let ad = [1.0, -5.0, 2.0, 0.25, 0.5, -0.125].map(Octuple::from).to_vec();
        let (values, closed) = Default::default();
        let exact = Exact { values, ad, closed, bends: OnceCell::new(), least_bends: OnceCell::new() };
        let largest: Vec<_> = (0..6).map(|k| exact.largest_of_output(k, 3).to_f64()).collect();
        assert_eq!(largest, [5.0, 5.0, 5.0, 0.5, 0.5, 0.5]);
    }

    fn point<'a>(subject: &'a Subject, random: bool, inputs: &[f64]) -> Point<'a> {
        Point::new(subject, "here".into(), random, inputs.to_vec())
    }

    /// Of x/r and y/r at (3, 4): 2 x y²/r³ and 2 x² y/r³, since what one input adds, the other one moving the other way adds too.
    #[test]
    fn bends_are_what_each_input_does_to_a_derivative() {
        let subject = Subject::of::<ContactForce>();
        let point = point(&subject, true, &[3.0, 4.0]);
        let exact = Exact::at(&point);
        for (k, expected) in [0.768, 0.576].into_iter().enumerate() {
            for found in [exact.least_bend(&point, k), exact.bend(&point, k)].map(Sensitivity::size) {
                assert!((found.to_f64() - expected).abs() < 1e-15, "{k}: {found:?}");
            }
        }
    }

    /// At a named point it is the second derivative to the last digit, and so on a kink, where a difference would be a jump.
    #[test]
    fn differences_tell_bends_at_random_points_alone() {
        let subject = Subject::of::<ReturnMap>();
        for (random, f_trial, by_differences) in [(true, 3.0, true), (false, 3.0, false), (true, 2.0, false)] {
            let point = point(&subject, random, &[f_trial, 0.5, 4.0]);
            assert_eq!(has_no_kink_near(&point), by_differences, "{random} {f_trial}");
            let exact = Exact::at(&point);
            for k in 0..3 {
                let [least, bend] = [exact.least_bend(&point, k), exact.bend(&point, k)].map(Sensitivity::size);
                assert!(bend <= 4.0 && (by_differences || least == 0.0), "{random} {f_trial}: {least:?}, {bend:?}");
            }
        }
        let subject = Subject::of::<ContactForce>();
        let point = point(&subject, false, &[3.0, 4.0]);
        let exact = Exact::at(&point);
        let expected = Sensitivity::new(&subject.second_derivative(&point.exact)[0], &point.exact);
        assert_eq!(
            (exact.bend(&point, 0).size(), exact.least_bend(&point, 0).size()),
            (expected.size(), Octuple::zero())
        );
    }

    /// What is off in one part of what is exact is found there, by its size.
    #[test]
    fn value_and_jacobian_are_judged_by_their_own_errors() {
        let subject = Subject::of::<ContactForce>();
        let (point, names) = (point(&subject, false, &[3.0, 4.0]), Names::new(&subject));
        let off = |x: &mut Octuple| *x *= 1.0 + power_of_two(-40);
        let [mut value, mut jacobian] = ["value", "Jacobian"].map(|claim| Claim::new(claim, 2.0));
        let mut exact = Exact::at(&point);
        exact.values.iter_mut().for_each(off);
        off(&mut exact.ad[1]);
        check_accuracy([&mut value, &mut jacobian], &point, &names, &exact);
        // Alone and together; 2¹³ roundings, of which the sensitivity takes a share.
        assert_eq!((value.checks, value.failures, jacobian.checks, jacobian.failures), (2, 2, 4, 2));
        let worst = [value, jacobian].map(|claim| claim.worst.expect("it was checked"));
        assert_eq!(worst.each_ref().map(|worst| worst.entry.as_str()), ["fc", "∂fc/∂f3"]);
        for (worst, (expected, number)) in worst.iter().zip([(8192.0 / 2.0, 5.0), (8192.0 * 0.8 / 1.376, 0.8)]) {
            assert!((worst.size / expected - 1.0).abs() < 1e-3, "{worst:?}");
            assert!((worst.found - number).abs() < 1e-15 && worst.expected > worst.found, "{worst:?}");
        }
    }

    #[test]
    fn on_a_switch_no_derivative_is_judged() {
        let subject = Subject::of::<ReturnMap>();
        let checks = |f_trial| {
            let (point, names) = (point(&subject, false, &[f_trial, 0.5, 4.0]), Names::new(&subject));
            let [mut value, mut jacobian] = ["value", "Jacobian"].map(|claim| Claim::new(claim, 2.0));
            check_accuracy([&mut value, &mut jacobian], &point, &names, &Exact::at(&point));
            (value.checks, jacobian.checks)
        };
        assert_eq!((checks(2.0), checks(3.0)), ((2, 0), (2, 6)));
    }
}
