//! Points of a formula with its values there, against which an equation written by someone else can be tested.

use super::audit::named_points;
use super::claim::{Claim, Deviation};
use super::point::{Names, Options, Point};
use super::printed::{EQUATION, found};
use super::subject::Subject;
use super::{Sampler, Sensitivity, golden};
use crate::Octuple;
use crate::formula::Field;
use crate::toolkit::equation::Equation;

/// The values of a formula at its cases, near its kinks and at random points, in 237 bits.
///
/// ```
/// use jointproof::catalog::AnyFormula;
/// use jointproof::toolkit::equation::Equation;
/// use jointproof::connector::slot::ContactForce;
/// use jointproof::toolkit::verify::Options;
///
/// let formula: &dyn AnyFormula = &ContactForce;
/// let trial = formula.trial(&Options { samples: 5, seed: 1 });
/// let renamed = [("a", "f2"), ("b", "f3"), ("F", "fc")];
/// let right = Equation::read(r"F = \sqrt{a^2 + b^2}", &renamed, &formula.signature())?;
/// assert!(trial.compare(&right).held());
/// let wrong = Equation::read(r"F = \sqrt{a^2 - b^2}", &renamed, &formula.signature())?;
/// assert_eq!(trial.first_difference(&wrong).unwrap().entry, "fc");
/// # Ok::<(), jointproof::toolkit::equation::Error>(())
/// ```
pub struct Trial {
    inputs: &'static [Field],
    names: Vec<String>,
    points: Vec<TrialPoint>,
}

struct TrialPoint {
    label: String,
    inputs: Vec<f64>,
    exact: Vec<Octuple>,
    values: Vec<Octuple>,
    /// The sensitivity of each value to the inputs.
    sizes: Vec<Sensitivity>,
    on_kink: bool,
}

impl Trial {
    /// Evaluates a formula.
    pub(crate) fn of(subject: &Subject, options: &Options) -> Self {
        let mut sampler = Sampler::for_formula(subject.spec.id, options.seed);
        let random = (0..options.samples).map(|k| {
            let label = format!("random {k} of seed {}", options.seed);
            Point::new(subject, label, true, sampler.components(subject))
        });
        let points = random.chain(named_points(subject)).map(evaluated);
        Self { inputs: subject.inputs, names: Names::new(subject).outputs, points: points.collect() }
    }

    /// Compares the values of an equation at every point.
    pub fn compare(&self, equation: &Equation) -> Claim {
        let mut claim = Claim::new("equation = value, in 237 bits", EQUATION);
        self.points.iter().for_each(|point| self.check(point, equation, &mut claim));
        claim
    }

    /// The largest deviation at the first point where an equation differs from the formula.
    pub fn first_difference(&self, equation: &Equation) -> Option<Deviation> {
        self.points.iter().find_map(|point| {
            let mut claim = Claim::new("equation = value, in 237 bits", EQUATION);
            self.check(point, equation, &mut claim);
            claim.worst.filter(|_| claim.failures > 0)
        })
    }

    fn check(&self, point: &TrialPoint, equation: &Equation, claim: &mut Claim) {
        if !equation.is_defined(point.on_kink) {
            return;
        }
        let found = found(equation, &point.exact, &point.values);
        found.record_values(
            claim,
            &point.values,
            |k| point.sizes[k],
            &self.names,
            |size, entry, found, expected| {
                let inputs = golden::named(self.inputs, &point.inputs).into();
                Deviation { size, entry, point: point.label.clone(), found, expected, inputs }
            },
        );
    }
}

fn evaluated(point: Point<'_>) -> TrialPoint {
    let Point { subject, label, inputs, exact, kink, .. } = point;
    let values = (subject.exact_value)(&exact);
    let gradients = subject.derivative(&exact);
    let sizes = gradients.chunks(exact.len()).map(|gradient| Sensitivity::new(gradient, &exact)).collect();
    TrialPoint { label, inputs, exact, values, sizes, on_kink: kink.is_some() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_points_are_as_many_as_asked() {
        let points = |samples| {
            let options = Options { samples, ..Options::default() };
            Trial::of(&Subject::of::<crate::connector::slot::ContactForce>(), &options).points.len()
        };
        assert_eq!(points(5), points(0) + 5);
    }

    use crate::catalog::AnyFormula;
    use crate::connector::slot::ContactForce;

    fn read(latex: &str) -> Equation {
        let renamed = [("a", "f2"), ("b", "f3"), ("F", "fc")];
        Equation::read(latex, &renamed, &<dyn AnyFormula>::signature(&ContactForce)).expect("it can be read")
    }

    /// A deviation at one of many points is found there, and nothing elsewhere.
    #[test]
    fn an_equation_is_compared_at_every_point() {
        let trial = Trial::of(&Subject::of::<ContactForce>(), &Options { samples: 3, seed: 1 });
        let right = trial.compare(&read(r"F = \sqrt{a^2 + b^2}"));
        assert_eq!((right.checks, right.failures), (trial.points.len(), 0));
        let on_kink =
            read(r"F = \begin{cases} \sqrt{a^2 + b^2} & a \ne 0 \\ \sqrt{a^2 + b^2} + 1 & \text{otherwise}\end{cases}");
        let compared = trial.compare(&on_kink);
        let there = trial.points.iter().filter(|point| point.inputs[0] == 0.0).count();
        assert_eq!((compared.checks, compared.failures, there > 0), (trial.points.len(), there, true));
        let first = trial.first_difference(&on_kink).expect("there is one");
        let point = trial.points.iter().find(|point| point.inputs[0] == 0.0).expect("it was counted");
        assert_eq!((&first.point, first.entry.as_str()), (&point.label, "fc"));
        assert_eq!((first.found - first.expected, &first.inputs["f2"]), (1.0, &0.0.into()));
        assert_eq!(trial.first_difference(&read(r"F = \sqrt{a^2 + b^2}")), None);
    }

    /// Random points come first, since points in general position are the most informative.
    #[test]
    fn what_is_known_of_a_point_is_exact() {
        let trial = Trial::of(&Subject::of::<ContactForce>(), &Options { samples: 1, seed: 1 });
        assert_eq!(trial.points[0].label, "random 0 of seed 1");
        let point = trial.points.iter().find(|point| point.inputs == [3.0, 4.0]).expect("it is a case");
        assert_eq!((point.values[0], point.on_kink), (5.0.into(), false));
        assert!((point.sizes[0].size().to_f64() - 5.0).abs() < 1e-15, "{:?}", point.sizes);
        assert!(trial.points.iter().any(|point| point.on_kink && point.inputs == [0.0, 0.0]));
    }
}
