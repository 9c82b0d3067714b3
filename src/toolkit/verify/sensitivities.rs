//! The sensitivities of Jacobian entries to the inputs, computed only as far as needed.

use super::Sensitivity;
use super::point::Point;
use crate::Octuple;
use crate::number::power::power_of_two;
use std::cell::OnceCell;

/// For every entry of the Jacobian at a point, the change caused by a relative change of 1 in every input: its sensitivity.
///
/// It takes one Jacobian per input. Often a part suffices: an error that is small compared with the effect of the first inputs is
/// small compared with the effect of all of them.
pub(super) struct Sensitivities {
    /// First with all inputs moving at once, then for the first input, the first two, and so on. Near a kink, where
    /// differences are useless, by second derivatives only.
    steps: Vec<OnceCell<Vec<Sensitivity>>>,
}

impl Sensitivities {
    pub(super) fn at(point: &Point) -> Self {
        let by_inputs = if has_no_kink_near(point) { point.exact.len() } else { 0 };
        Self { steps: vec![OnceCell::new(); 1 + by_inputs] }
    }

    /// The sensitivity of the k-th entry; `here` is the Jacobian.
    pub(super) fn of(&self, point: &Point, here: &[Octuple], k: usize) -> Sensitivity {
        self.step(point, here, self.steps.len() - 1)[k]
    }

    /// Lower bounds of the sensitivity, starting from 0, each of which takes one more Jacobian, and finally the
    /// sensitivity itself.
    pub(super) fn up_to(&self, point: &Point, here: &[Octuple], k: usize) -> impl Iterator<Item = Sensitivity> {
        (0..=self.steps.len()).map(move |step| match step.checked_sub(1) {
            None => Sensitivity::none(),
            Some(step) => self.step(point, here, step)[k],
        })
    }

    fn step(&self, point: &Point, here: &[Octuple], step: usize) -> &[Sensitivity] {
        self.steps[step].get_or_init(|| match step {
            _ if self.steps.len() == 1 => by_second_derivatives(point),
            0 => by_all_inputs(point, here),
            1 => by_input(point, here, 0),
            step => {
                let before = self.step(point, here, step - 1);
                before.iter().zip(by_input(point, here, step - 1)).map(|(sum, next)| sum.and(next)).collect()
            }
        })
    }
}

/// No kink is near a random point; a difference there gives 35 digits in a small fraction of the time.
fn has_no_kink_near(point: &Point) -> bool {
    point.random && point.kink.is_none()
}

fn by_second_derivatives(point: &Point) -> Vec<Sensitivity> {
    let gradients = point.subject.second_derivative(&point.exact);
    gradients.iter().map(|gradient| Sensitivity::new(gradient, &point.exact)).collect()
}

/// The exponent of the relative change of inputs in differences of Jacobians.
const PART: i64 = -118;

/// Moves the inputs up and down alternately.
fn by_all_inputs(point: &Point, here: &[Octuple]) -> Vec<Sensitivity> {
    let part = power_of_two(PART);
    let parts = [part, -part].into_iter().cycle();
    changes(point, here, &point.exact.iter().zip(parts).map(|(&x, part)| x + x * part).collect::<Vec<_>>())
}

fn by_input(point: &Point, here: &[Octuple], input: usize) -> Vec<Sensitivity> {
    let mut moved = point.exact.clone();
    moved[input] += point.exact[input] * power_of_two(PART);
    changes(point, here, &moved)
}

/// The change of every entry when the inputs move, per relative change.
fn changes(point: &Point, here: &[Octuple], moved: &[Octuple]) -> Vec<Sensitivity> {
    let there = (point.subject.exact_jacobian)(moved);
    let parts = Octuple::from(power_of_two(PART).recip());
    there.iter().zip(here).map(|(&there, &here)| Sensitivity::new(&[there - here], &[parts])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::{ContactForce, Friction};
    use crate::contact::coulomb::ReturnMap;
    use crate::formula::proof::Proved;
    use crate::toolkit::verify::Options;
    use crate::toolkit::verify::audit::named_points;
    use crate::toolkit::verify::point::random_points;
    use crate::toolkit::verify::subject::Subject;
    use num_traits::{Signed, Zero};

    fn jacobian(point: &Point) -> Vec<Octuple> {
        (point.subject.exact_jacobian)(&point.exact)
    }

    /// On a kink, near it, and at random points.
    #[test]
    fn no_number_before_it_is_more_than_the_bend() {
        fn compare<F: Proved>() {
            let subject = Subject::of::<F>();
            let random = random_points(&subject, &Options { samples: 20, seed: 1 }, 0..20);
            let mut kinks = 0;
            for point in named_points(&subject).iter().chain(&random) {
                let (sensitivities, here) = (Sensitivities::at(point), jacobian(point));
                kinks += usize::from(point.kink.is_some());
                for (k, entry) in here.iter().enumerate() {
                    let bend = sensitivities.of(point, &here, k).size();
                    // Within the accuracy of differences.
                    let most = bend + (bend + entry.abs()) * 1e-30;
                    let before: Vec<_> = sensitivities.up_to(point, &here, k).map(Sensitivity::size).collect();
                    assert!(
                        before.iter().all(|&size| size <= most),
                        "{} at {}: {bend:?}",
                        subject.spec.id,
                        point.label
                    );
                    assert_eq!((before[0], before[before.len() - 1]), (Octuple::zero(), bend));
                }
            }
            assert!(kinks > 0, "{} has no point on a kink", subject.spec.id);
        }
        compare::<ReturnMap>();
        compare::<ContactForce>();
        compare::<Friction>();
    }

    fn point<'a>(subject: &'a Subject, random: bool, inputs: &[f64]) -> Point<'a> {
        Point::new(subject, "here".into(), random, inputs.to_vec())
    }

    /// For x/r and y/r at (3, 4): x y²/r³ and x² y/r³ from each of the two inputs, which also add up if they move in
    /// opposite directions.
    #[test]
    fn sensitivities_are_what_each_input_does_to_a_derivative() {
        let subject = Subject::of::<ContactForce>();
        let point = point(&subject, true, &[3.0, 4.0]);
        let (sensitivities, here) = (Sensitivities::at(&point), jacobian(&point));
        for (k, half) in [0.384, 0.288].into_iter().enumerate() {
            let found = sensitivities.up_to(&point, &here, k).zip([0.0, 2.0 * half, half, 2.0 * half]);
            assert_eq!(sensitivities.up_to(&point, &here, k).count(), 4);
            for (found, expected) in found {
                assert!((found.size().to_f64() - expected).abs() < 1e-15, "{k}: {found:?} is not {expected}");
            }
        }
    }

    /// At a named point it is the second derivative to the last digit, also on a kink, where a difference would contain the jump.
    #[test]
    fn differences_give_sensitivities_at_random_points_alone() {
        let subject = Subject::of::<ReturnMap>();
        for (random, f_trial, by_differences) in [(true, 3.0, true), (false, 3.0, false), (true, 2.0, false)] {
            let point = point(&subject, random, &[f_trial, 0.5, 4.0]);
            let (sensitivities, here) = (Sensitivities::at(&point), jacobian(&point));
            for k in 0..3 {
                assert!(sensitivities.of(&point, &here, k).size() <= 4.0, "{random} {f_trial}");
                let numbers = if by_differences { 5 } else { 2 };
                assert_eq!(sensitivities.up_to(&point, &here, k).count(), numbers, "{random} {f_trial}");
            }
        }
        let subject = Subject::of::<ContactForce>();
        let point = point(&subject, false, &[3.0, 4.0]);
        let expected = Sensitivity::new(&subject.second_derivative(&point.exact)[0], &point.exact);
        assert_eq!(Sensitivities::at(&point).of(&point, &jacobian(&point), 0).size(), expected.size());
    }

    /// For some, the first inputs suffice, and the others are not moved.
    #[test]
    fn no_more_is_computed_than_is_asked_for() {
        let subject = Subject::of::<ContactForce>();
        let point = point(&subject, true, &[3.0, 4.0]);
        let (sensitivities, here) = (Sensitivities::at(&point), jacobian(&point));
        let known = || sensitivities.steps.iter().filter(|step| step.get().is_some()).count();
        for asked in 1..=4 {
            sensitivities.up_to(&point, &here, 0).take(asked).for_each(drop);
            assert_eq!(known(), asked - 1);
        }
    }
}
