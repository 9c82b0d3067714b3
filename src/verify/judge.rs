//! What is exact at a point, to judge the answers of another program by.

use super::audit::beside_kinks;
use super::point::Options;
use super::subject::Subject;
use super::{Sampler, Sensitivity, eta, exact, golden};
use crate::proof::{Convention, Proved};
use crate::{Error, Octuple};

/// Judges what another program answers for a formula.
///
/// ```
/// use jointproof::slot::ContactForce;
/// use jointproof::verify::Judge;
///
/// let truth = Judge::of::<ContactForce>().at(&[3.0, 4.0], true)?;
/// assert_eq!(truth.value[0].eta(5.0), 0.0);
/// assert!(truth.jacobian.unwrap()[0].eta(0.6 * (1.0 + 1e-6)) > 1e9);
/// # Ok::<(), jointproof::Error>(())
/// ```
pub struct Judge {
    subject: Subject,
}

/// What is exact at a point.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The components of the value.
    pub value: Vec<Known>,
    /// The entries of the Jacobian, output by output; `None` where they are not asked for, and on a
    /// [switch](Convention::Switch), where either side's are as good.
    pub jacobian: Option<Vec<Known>>,
    /// The condition of the kink that the point is on, in LaTeX, and the convention there.
    pub kink: Option<(String, Convention)>,
}

/// A number in 237 bits, and how much it changes with the inputs.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// The number.
    pub exact: Octuple,
    sensitivity: Sensitivity,
}

impl Known {
    /// The backward error of a number that was computed.
    pub fn eta(&self, computed: f64) -> f64 {
        eta(computed, self.exact, self.sensitivity)
    }

    /// Another number that changes as this one does.
    #[must_use]
    pub fn with(self, exact: Octuple) -> Self {
        Self { exact, ..self }
    }

    /// This number times another one.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { exact: self.exact * factor, sensitivity: self.sensitivity.times(factor) }
    }

    /// A sum of products with doubles, whose size is the sum of the sizes.
    pub fn combined(terms: impl Iterator<Item = (Self, f64)>) -> Self {
        let none = Self { exact: Octuple::from(0.0), sensitivity: Sensitivity::none() };
        terms.fold(none, |sum, (known, factor)| {
            let term = known.times(factor);
            let size = sum.sensitivity.and(term.sensitivity.plus(term.exact));
            Self { exact: sum.exact + term.exact, sensitivity: size }
        })
    }
}

impl Judge {
    /// Of this formula.
    pub fn of<F: Proved>() -> Self {
        Self { subject: Subject::of::<F>() }
    }

    /// Points to ask for, each with its name: golden cases, also those that must be refused, points on and beside kinks, and
    /// random ones.
    pub fn points(&self, options: &Options) -> Vec<(String, Vec<f64>)> {
        let cases = golden::cases(&self.subject).into_iter().map(|case| (case.id, case.inputs));
        let mut sampler = Sampler::for_formula(self.subject.spec.id, options.seed);
        let random = (0..options.samples)
            .map(|k| (format!("random {k} of seed {}", options.seed), sampler.components(&self.subject)));
        cases.chain(beside_kinks(&self.subject)).chain(random).collect()
    }

    /// What is exact at these components, with the Jacobian by automatic differentiation or without it.
    ///
    /// # Errors
    /// Why they are refused.
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
        let known = |(&exact, gradient): (&Octuple, &[Octuple])| Known {
            exact,
            sensitivity: Sensitivity::new(gradient, &inputs),
        };
        let values = (self.subject.exact_value)(&inputs);
        let value = values.iter().zip(derivative.chunks(inputs.len())).map(known).collect();
        let has_one = !matches!(kink, Some((_, Convention::Switch)));
        let jacobian = (with_jacobian && has_one).then(|| {
            let bends = self.subject.second_derivative(&inputs);
            derivative.iter().zip(bends.iter().map(Vec::as_slice)).map(known).collect()
        });
        Ok(Truth { value, jacobian, kink })
    }
}
