//! The exact results at a point, by which the results of another program are judged.

use super::audit::beside_kinks;
use super::difference::largest_of;
use super::eta::{is_rounding, rounding};
use super::point::Options;
use super::subject::Subject;
use super::{Sampler, Sensitivity, eta, exact, golden};
use crate::formula::proof::Convention;
use crate::{Error, Octuple};

/// Judges the results of another program for a formula.
///
/// ```
/// use jointproof::catalog::AnyFormula;
/// use jointproof::connector::slot::ContactForce;
///
/// let formula: &dyn AnyFormula = &ContactForce;
/// let truth = formula.judge().at(&[3.0, 4.0], true)?;
/// assert_eq!(truth.value[0].eta(5.0), 0.0);
/// assert!(truth.jacobian.unwrap()[0].eta(0.6 * (1.0 + 1e-6)) > 1e9);
/// # Ok::<(), jointproof::Error>(())
/// ```
pub struct Judge {
    subject: Subject,
}

/// The exact results at a point.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The components of the value.
    pub value: Vec<Known>,
    /// The entries of the Jacobian, output by output; `None` if they are not requested, and on a
    /// [switch](Convention::Switch), where those of either side are acceptable.
    pub jacobian: Option<Vec<Known>>,
    /// The condition of the kink that the point is on, in LaTeX, and the convention there.
    pub kink: Option<(String, Convention)>,
}

/// A number in 237 bits, and its sensitivity to the inputs.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// The number.
    pub exact: Octuple,
    sensitivity: Sensitivity,
    /// How exactly it is known.
    rounding: Octuple,
}

impl Known {
    /// The backward error of a computed number.
    pub fn eta(&self, computed: f64) -> f64 {
        if is_rounding(computed, self.exact, self.sensitivity, self.rounding) {
            return 0.0;
        }
        eta(computed, self.exact, self.sensitivity)
    }

    /// Another number with the same sensitivity.
    #[must_use]
    pub fn with(self, exact: Octuple) -> Self {
        Self { exact, ..self }
    }

    /// This number multiplied by another one.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        let rounding = self.rounding * factor.abs();
        Self { exact: self.exact * factor, sensitivity: self.sensitivity.times(factor), rounding }
    }

    /// A linear combination with double coefficients, whose size is the sum of the sizes of its terms.
    pub fn combined(terms: impl Iterator<Item = (Self, f64)>) -> Self {
        let zero = Octuple::from(0.0);
        let none = Self { exact: zero, sensitivity: Sensitivity::none(), rounding: zero };
        terms.fold(none, |sum, (known, factor)| {
            let term = known.times(factor);
            let size = sum.sensitivity.and(term.sensitivity.plus(term.exact));
            Self { exact: sum.exact + term.exact, sensitivity: size, rounding: sum.rounding + term.rounding }
        })
    }
}

impl Judge {
    /// For this formula.
    pub(crate) fn of(subject: Subject) -> Self {
        Self { subject }
    }

    /// Test points with names: golden cases, including those that must be rejected, points on and near kinks, and
    /// random ones.
    pub fn points(&self, options: &Options) -> Vec<(String, Vec<f64>)> {
        let cases = golden::cases(&self.subject, golden::LEAST_RANDOM).into_iter().map(|case| (case.id, case.inputs));
        let mut sampler = Sampler::for_formula(self.subject.spec.id, options.seed);
        let random = (0..options.samples)
            .map(|k| (format!("random {k} of seed {}", options.seed), sampler.components(&self.subject)));
        cases.chain(beside_kinks(&self.subject)).chain(random).collect()
    }

    /// The condition of the kink that these components are on, in LaTeX.
    pub fn kink(&self, components: &[f64]) -> Option<String> {
        let inputs = exact(components);
        self.subject.kinks.iter().find(|kink| (kink.holds)(&inputs)).map(|kink| kink.condition.clone())
    }

    /// The exact results at these components, optionally with the Jacobian by automatic differentiation.
    ///
    /// # Errors
    /// The reason why they are rejected.
    pub fn at(&self, components: &[f64], with_jacobian: bool) -> Result<Truth, Error> {
        let expected = self.subject.inputs.iter().map(crate::formula::Field::len).sum();
        if components.len() != expected {
            return Err(Error::Components { found: components.len(), expected });
        }
        (self.subject.check)(components)?;
        let inputs = exact(components);
        let kink = self.subject.kinks.iter().find(|kink| (kink.holds)(&inputs));
        let kink = kink.map(|kink| (kink.condition.clone(), kink.convention));
        let derivative = self.subject.derivative(&inputs);
        let values = (self.subject.exact_value)(&inputs);
        let known = |exact, gradient: &[Octuple], rounding| Known {
            exact,
            sensitivity: Sensitivity::new(gradient, &inputs),
            rounding,
        };
        let of_value = |(&exact, gradient)| known(exact, gradient, Octuple::from(0.0));
        let value: Vec<_> = values.iter().zip(derivative.chunks(inputs.len())).map(of_value).collect();
        let has_one = !matches!(kink, Some((_, Convention::Switch)));
        let jacobian = (with_jacobian && has_one).then(|| {
            let sensitivities = self.subject.second_derivative(&inputs);
            let closed = self.subject.spec.is_closed().then(|| (self.subject.exact_jacobian)(&inputs));
            let entry = |(k, gradient): (usize, &Vec<Octuple>)| {
                let (ad, row) = (derivative[k], &derivative[k / inputs.len() * inputs.len()..][..inputs.len()]);
                let other = closed.as_ref().map_or(ad, |closed| closed[k]);
                known(ad, gradient, rounding(ad, other, largest_of(row)))
            };
            sensitivities.iter().enumerate().map(entry).collect()
        });
        Ok(Truth { value, jacobian, kink })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::contact::coulomb::ReturnMap;
    use crate::element::cardan::BetaTwoArgument;
    use crate::formula::proof::Proved;

    fn known(exact: f64, gradient: f64) -> Known {
        let [exact, gradient] = [exact, gradient].map(Octuple::from);
        Known { exact, sensitivity: Sensitivity::new(&[gradient], &[1.0.into()]), rounding: 0.0.into() }
    }

    /// η of a number that is off by 2⁻⁵³.
    fn eta_beside(known: Known) -> f64 {
        known.eta(known.exact.to_f64() + f64::EPSILON / 2.0)
    }

    #[test]
    fn what_is_known_of_a_number_is_known_of_products_and_sums() {
        assert_eq!(known(0.5, 1.5).eta(0.5), 0.0);
        assert_eq!(eta_beside(known(0.5, 1.5)), 0.5);
        let other = known(0.5, 1.5).with(0.25.into());
        assert!(other.exact == 0.25 && eta_beside(other) == 1.0 / 1.75);
        let times = known(0.25, 0.75).times(-2.0);
        assert!(times.exact == -0.5 && eta_beside(times) == 0.5);
        // 0.5 · 3 − 0.25 · 4, where each term has its size and the sensitivity of its number.
        let sum = Known::combined([(known(0.5, 0.5), 3.0), (known(0.25, 1.0), -4.0)].into_iter());
        assert!(sum.exact == 0.5 && eta_beside(sum) == 1.0 / (0.5 + 1.5 + 1.5 + 1.0 + 4.0));
    }

    /// Along a vector whose length does not matter the derivative is 0, and in 237 bits a rounding.
    #[test]
    fn what_is_0_but_for_the_rounding_of_the_reference_is_0() {
        let point = [1.0, 0.0, 0.0, 0.64, 0.768, -0.024, -0.48, 0.424, 0.768, 0.6, -0.48, 0.64];
        let truth = Judge::of(Subject::of::<BetaTwoArgument>()).at(&point, true).expect("the inputs are valid");
        let jacobian = truth.jacobian.expect("it was asked for");
        assert!(jacobian[0].eta(0.0) == 0.0 && jacobian[0].eta(1e-17) > 1.0);
    }

    #[test]
    fn points_are_cases_those_beside_kinks_and_so_many_random_ones() {
        let judge = Judge::of(Subject::of::<ReturnMap>());
        let points = |samples| judge.points(&Options { samples, seed: 5 });
        let (none, two) = (points(0), points(2));
        assert_eq!(
            none.len(),
            golden::cases(&judge.subject, golden::LEAST_RANDOM).len() + 5 * ReturnMap::kinks().len()
        );
        let names: Vec<_> = two[none.len()..].iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["random 0 of seed 5", "random 1 of seed 5"]);
        assert_eq!(two[none.len()].1, Sampler::for_formula("coulomb.return_map", 5).components(&judge.subject));
    }

    #[test]
    fn value_and_jacobian_are_exact_with_what_rounding_of_the_inputs_does() {
        let truth = Judge::of(Subject::of::<ContactForce>()).at(&[3.0, 4.0], true).expect("the inputs are valid");
        let jacobian = truth.jacobian.expect("it was asked for");
        assert_eq!((truth.value.len(), jacobian.len()), (1, 2));
        assert!(truth.kink.is_none());
        assert_eq!(truth.value[0].exact, 5.0);
        // 16 roundings, relative to 5 and as much for the inputs; the sensitivity of x/r is 2 x y²/r³, that of y/r is 2 x² y/r³.
        assert_eq!(truth.value[0].eta(5.0 + 8.0 * f64::EPSILON), 1.6);
        for (known, number, bend) in [(jacobian[0], 0.6, 0.768), (jacobian[1], 0.8, 0.576)] {
            let roundings = 1e-9 / (f64::EPSILON / 2.0);
            let expected = roundings / (number + bend);
            assert!((known.eta(number + 1e-9) / expected - 1.0).abs() < 1e-6, "{number}");
        }
    }

    #[test]
    fn on_a_switch_there_is_no_jacobian_and_elsewhere_none_that_is_not_asked_for() {
        let judge = Judge::of(Subject::of::<ReturnMap>());
        let at = |f_trial, with_jacobian| judge.at(&[f_trial, 0.5, 4.0], with_jacobian).expect("they are valid");
        assert!(at(1.0, true).jacobian.is_some() && at(1.0, false).jacobian.is_none());
        let tie = at(2.0, true);
        assert!(tie.jacobian.is_none());
        assert!(matches!(tie.kink, Some((condition, Convention::Switch)) if condition.contains("mu F_N")));
        let apex = Judge::of(Subject::of::<ContactForce>()).at(&[0.0, 0.0], true).expect("they are valid");
        assert!(matches!(apex.kink, Some((_, Convention::Subgradient))) && apex.jacobian.is_some());
    }

    #[test]
    fn inputs_that_are_too_few_or_not_allowed_are_refused() {
        let judge = Judge::of(Subject::of::<ReturnMap>());
        assert_eq!(judge.at(&[1.0], true).unwrap_err(), Error::Components { found: 1, expected: 3 });
        assert_eq!(
            judge.at(&[1.0, -0.5, 4.0], true).unwrap_err().to_string(),
            "mu is -0.5; allowed is a finite number ≥ 0"
        );
    }
}
