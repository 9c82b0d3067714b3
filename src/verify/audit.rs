//! The audit: every claim about a formula, checked at its cases, beside its kinks and at random points.

use super::difference::step_size;
use super::jet::entries;
use super::{
    Sampler, Sensitivity, central_differences, derivative_of_jacobian, eta, exactly, golden, jacobian_by_ad, kink, law,
};
use crate::formula::{Convention, Field, Fields, Formula, Kink, check};
use crate::{Error, Octuple};
use num_traits::Signed;
use serde::{Deserialize, Serialize};

/// How much to audit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Random points, beside the cases and the neighbourhoods of kinks.
    pub samples: usize,
    /// Seed of the random points.
    pub seed: u64,
}

impl Default for Options {
    /// A thousand points of seed 1.
    fn default() -> Self {
        Self { samples: 1000, seed: 1 }
    }
}

/// Closed form and automatic differentiation agree in 237 bits to this.
const CLOSED_AGAINST_AD: f64 = 1e-60;
/// Automatic differentiation and differences agree in 237 bits to this at random points.
const AD_AGAINST_DIFFERENCES: f64 = 1e-50;
/// At hard points the step of differences must be shorter than the distance to the next kink, and digits are lost.
const AD_AGAINST_DIFFERENCES_HARD: f64 = 1e-35;
/// Laws hold in 237 bits to this.
const LAW: f64 = 1e-60;

/// Steps of differences: the first one at random points, the best one at hard points.
const STEPS: [f64; 4] = [1e-18, 1e-22, 1e-26, 1e-30];

/// What an audit of one formula found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Audit {
    /// The formula's identifier.
    pub formula: String,
    /// Named points: the cases, and points on and beside kinks.
    pub named_points: usize,
    /// Random points.
    pub random_points: usize,
    /// The seed of the random points.
    pub seed: u64,
    /// The closed-form Jacobian is the derivative: it equals automatic differentiation, in 237 bits.
    pub closed_against_ad: Claim,
    /// Automatic differentiation is right: it equals differences, in 237 bits.
    pub ad_against_differences: Claim,
    /// The value in `f64` is accurate.
    pub eta: Claim,
    /// The closed-form Jacobian in `f64` is accurate.
    pub eta_jacobian: Claim,
    /// Homogeneity, frame indifference, and the formula's own laws.
    pub laws: Vec<Claim>,
}

impl Audit {
    /// Every claim.
    pub fn claims(&self) -> impl Iterator<Item = &Claim> {
        let derivatives = [&self.closed_against_ad, &self.ad_against_differences, &self.eta, &self.eta_jacobian];
        derivatives.into_iter().chain(&self.laws)
    }

    /// Whether no claim failed. At a single point on a kink there may be claims that cannot be checked.
    pub fn no_claim_failed(&self) -> bool {
        self.claims().all(|claim| claim.failures == 0)
    }

    /// Whether every claim was checked, and none failed.
    pub fn passed(&self) -> bool {
        self.claims().all(Claim::held)
    }
}

/// A claim about a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// What is claimed.
    pub claim: String,
    /// The largest deviation allowed.
    pub bound: f64,
    /// How many numbers were compared.
    pub checks: usize,
    /// How many deviated by more than the bound.
    pub failures: usize,
    /// The largest deviation.
    pub worst: Option<Deviation>,
}

/// One comparison.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deviation {
    /// Its size, in the unit of the claim.
    pub size: f64,
    /// The entry: `fc`, or `∂fc/∂f2`.
    pub entry: String,
    /// The case, or the number of the random point.
    pub point: String,
    /// What was found.
    pub found: f64,
    /// What was expected.
    pub expected: f64,
    /// The inputs, as golden files give them, to be pasted back.
    pub inputs: serde_json::Value,
}

impl Claim {
    fn new(claim: impl Into<String>, bound: f64) -> Self {
        Self { claim: claim.into(), bound, checks: 0, failures: 0, worst: None }
    }

    /// Whether something was checked and nothing deviated by more than the bound.
    pub fn held(&self) -> bool {
        self.checks > 0 && self.failures == 0
    }

    fn record(&mut self, size: f64, bound: f64, describe: impl FnOnce(f64) -> Deviation) {
        self.checks += 1;
        self.failures += usize::from(size > bound);
        if self.worst.as_ref().is_none_or(|worst| size > worst.size) {
            self.worst = Some(describe(size));
        }
    }
}

/// Audits one formula.
pub fn audit<F: Formula>(options: &Options) -> Audit {
    let named = named_points::<F>();
    let mut sampler = Sampler::new::<F>(options.seed);
    let random: Vec<_> = (0..options.samples)
        .map(|k| Point::<F>::new(format!("random {k} of seed {}", options.seed), true, sampler.inputs::<F>()))
        .collect();

    audit_points(&named, &random, options.seed)
}

/// Audits one formula at one point.
///
/// # Errors
/// The input that is not valid.
pub fn audit_at<F: Formula>(inputs: &F::Inputs<f64>) -> Result<Audit, Error> {
    check::<F>(inputs)?;
    Ok(audit_points(&[Point::<F>::new("given".into(), false, *inputs)], &[], 0))
}

fn audit_points<F: Formula>(named: &[Point<F>], random: &[Point<F>], seed: u64) -> Audit {
    // Laws hold at points in general position; at a single given point they are checked there.
    let general = if random.is_empty() { named } else { random };
    let mut audit = Audit {
        formula: F::SPEC.id.into(),
        named_points: named.len(),
        random_points: random.len(),
        seed,
        closed_against_ad: Claim::new("closed form = automatic differentiation, in 237 bits", CLOSED_AGAINST_AD),
        ad_against_differences: Claim::new(
            "automatic differentiation = differences, in 237 bits",
            AD_AGAINST_DIFFERENCES,
        ),
        eta: Claim::new("η of the value in f64", F::SPEC.eta),
        eta_jacobian: Claim::new("η of the closed-form Jacobian in f64", F::SPEC.eta_jacobian),
        laws: law::all::<F>().iter().map(|law| check_law(law, general)).collect(),
    };
    named.iter().chain(random).for_each(|point| audit.check(point));
    audit
}

/// A point, with all that is compared there.
struct Point<F: Formula> {
    label: String,
    random: bool,
    inputs: F::Inputs<f64>,
    exact: F::Inputs<Octuple>,
    kink: Option<Convention>,
}

impl<F: Formula> Point<F> {
    fn new(label: String, random: bool, inputs: F::Inputs<f64>) -> Self {
        Self { label, random, inputs, exact: exactly::<F>(&inputs), kink: kink::<F>(&inputs) }
    }

    fn deviation(&self, size: f64, entry: String, found: f64, expected: f64) -> Deviation {
        let inputs = golden::named::<F::Inputs<f64>>(&self.inputs.components()).into();
        Deviation { size, entry, point: self.label.clone(), found, expected, inputs }
    }
}

/// The formula's own cases, and points on both sides of every kink and on it.
fn named_points<F: Formula>() -> Vec<Point<F>> {
    let cases = F::cases().into_iter().map(|case| (case.id, case.inputs));
    cases
        .chain(beside_kinks::<F>())
        .filter(|(_, inputs)| check::<F>(inputs).is_ok())
        .map(|(label, inputs)| Point::new(label, false, inputs))
        .collect()
}

/// Points on every kink and on both sides of it, near and nearer, each with its name; some may be invalid inputs.
pub(crate) fn beside_kinks<F: Formula>() -> Vec<(String, F::Inputs<f64>)> {
    let around = |kink: Kink<F>| {
        let (at, across) = ((kink.at)().components(), (kink.across)().components());
        [0.0, 2e-3, -2e-3, 1e-9, -1e-9].map(|step| {
            let moved: Vec<_> = at.iter().zip(&across).map(|(x, direction)| x + step * direction).collect();
            let inputs = F::Inputs::from_slice(&moved).unwrap_or_else(kink.at);
            (format!("kink {} {step:+}", kink.condition), inputs)
        })
    };
    F::kinks().into_iter().flat_map(around).collect()
}

/// The four claims made about every formula.
impl Audit {
    fn check<F: Formula>(&mut self, point: &Point<F>) {
        let inputs = point.exact.components();
        let values = F::eval(&point.exact).components();
        let closed = entries::<F, _>(&F::jacobian(&point.exact));
        let ad = entries::<F, _>(&jacobian_by_ad::<F, _>(&point.exact));
        let gradients = derivative_of_jacobian::<F, _>(&point.exact);
        let bends: Vec<_> = gradients.iter().map(|gradient| Sensitivity::new(gradient, &inputs)).collect();
        let names = Names::new::<F>();

        self.check_closed_form(point, &names, &closed, &ad, &bends);
        if point.kink.is_none() {
            self.check_ad(point, &names, &inputs, &values, &ad);
        }
        self.check_value(point, &names, &inputs, &values, &ad);
        if point.kink != Some(Convention::Switch) {
            self.check_jacobian(point, &names, &ad, &bends);
        }
    }

    /// Judged against the entry and what rounding of the inputs can do to it: an entry may be what a cancellation left.
    fn check_closed_form<F: Formula>(
        &mut self,
        point: &Point<F>,
        names: &Names,
        closed: &[Octuple],
        ad: &[Octuple],
        bends: &[Sensitivity],
    ) {
        for (k, ((&closed, &ad), bend)) in closed.iter().zip(ad).zip(bends).enumerate() {
            let describe = |size| point.deviation(size, names.entry(k), closed.to_f64(), ad.to_f64());
            self.closed_against_ad.record(bend.plus(ad).share_of(closed - ad), CLOSED_AGAINST_AD, describe);
        }
    }

    /// Differences are judged against the entry and what rounding of the value can do to it, |y|/|x|, where |x| is the
    /// size that the step is a part of.
    fn check_ad<F: Formula>(
        &mut self,
        point: &Point<F>,
        names: &Names,
        inputs: &[Octuple],
        values: &[Octuple],
        ad: &[Octuple],
    ) {
        let steps = if point.random { &STEPS[..1] } else { &STEPS[..] };
        let bound = if point.random { AD_AGAINST_DIFFERENCES } else { AD_AGAINST_DIFFERENCES_HARD };
        for input in 0..inputs.len() {
            let attempts: Vec<_> = steps.iter().map(|&step| central_differences::<F>(inputs, input, step)).collect();
            for (output, &value) in values.iter().enumerate() {
                let entry = output * inputs.len() + input;
                let gradient = &ad[output * inputs.len()..][..inputs.len()];
                let size = Sensitivity::new(gradient, inputs).plus(value).per(step_size::<F>(inputs, input));
                let scale = ad[entry].abs() + size;
                let deviations = attempts.iter().map(|rows| (ad[entry] - rows[output]).abs());
                let best = deviations.reduce(|best, next| if next < best { next } else { best });
                let Some(best) = best else { continue };
                let relative = if best == 0.0 { 0.0 } else { (best / scale).to_f64() };
                let found = attempts[0][output].to_f64();
                let describe = |size| point.deviation(size, names.entry(entry), ad[entry].to_f64(), found);
                self.ad_against_differences.record(relative, bound, describe);
            }
        }
    }

    fn check_value<F: Formula>(
        &mut self,
        point: &Point<F>,
        names: &Names,
        inputs: &[Octuple],
        values: &[Octuple],
        ad: &[Octuple],
    ) {
        // The value alone, and the value that comes with the Jacobian.
        for computed in [F::eval(&point.inputs), F::linearized(&point.inputs).0] {
            for (output, (&computed, &value)) in computed.components().iter().zip(values).enumerate() {
                let sensitivity = Sensitivity::new(&ad[output * inputs.len()..], inputs);
                let describe = |size| point.deviation(size, names.outputs[output].clone(), computed, value.to_f64());
                self.eta.record(eta(computed, value, sensitivity), F::SPEC.eta, describe);
            }
        }
    }

    /// The closed form in `f64` is judged against automatic differentiation, so that a wrong one cannot be its own judge.
    fn check_jacobian<F: Formula>(&mut self, point: &Point<F>, names: &Names, ad: &[Octuple], bends: &[Sensitivity]) {
        // The Jacobian alone, and the one that comes with the value.
        for computed in [F::jacobian(&point.inputs), F::linearized(&point.inputs).1] {
            let computed: Vec<f64> = entries::<F, _>(&computed);
            for (entry, ((&computed, &exact), &bend)) in computed.iter().zip(ad).zip(bends).enumerate() {
                let size = eta(computed, exact, bend);
                let describe = |size| point.deviation(size, names.entry(entry), computed, exact.to_f64());
                self.eta_jacobian.record(size, F::SPEC.eta_jacobian, describe);
            }
        }
    }
}

fn check_law<F: Formula>(law: &crate::formula::Law<F>, points: &[Point<F>]) -> Claim {
    let mut claim = Claim::new(law.statement, LAW);
    // On a kink or a cut a law may hold from one side only.
    for point in points.iter().filter(|point| point.kink.is_none()) {
        for (k, equation) in (law.sides)(&point.exact).iter().enumerate() {
            let (left, right) = (equation.left.to_f64(), equation.right.to_f64());
            let describe = |size| point.deviation(size, format!("equation {k}"), left, right);
            claim.record(law::residual(equation), LAW, describe);
        }
    }
    claim
}

/// Names of components: `x`, `xa[2]`.
struct Names {
    inputs: Vec<String>,
    outputs: Vec<String>,
}

impl Names {
    fn new<F: Formula>() -> Self {
        Self { inputs: names(F::Inputs::<f64>::FIELDS), outputs: names(F::Outputs::<f64>::FIELDS) }
    }

    /// Of the k-th Jacobian entry.
    fn entry(&self, k: usize) -> String {
        let (output, input) = (k / self.inputs.len(), k % self.inputs.len());
        format!("∂{}/∂{}", self.outputs[output], self.inputs[input])
    }
}

fn names(fields: &[Field]) -> Vec<String> {
    let of_field = |field: &Field| match field.len() {
        1 => vec![field.name.to_string()],
        len => (0..len).map(|k| format!("{}[{k}]", field.name)).collect(),
    };
    fields.iter().flat_map(of_field).collect()
}
