//! Mathematical claims in prose, checked at the points of the formula they are about.

use super::audit::named_points;
use super::claim::{Claim, Deviation};
use super::point::Options;
use super::printed::EQUATION;
use super::subject::{Kink, Subject};
use super::{Sampler, Sensitivity, exact, golden};
use crate::Octuple;
use crate::formula::Field;
use crate::formula::quantity::Domain;
use crate::toolkit::equation::{ClaimAt, Claims, Free, Setting, Signature};
use nalgebra::Vector3;
use num_traits::Zero;

/// Checks claims about a formula at its cases, near its kinks and at random points, in 237 bits.
pub(crate) fn claims_about(subject: &Subject, claims: &Claims, options: &Options) -> Claim {
    let mut sampler = Sampler::for_formula(subject.spec.id, options.seed);
    let random =
        (0..options.samples).map(|k| (format!("random {k} of seed {}", options.seed), sampler.components(subject)));
    let random: Vec<_> = random.collect();
    let named = named_points(subject).into_iter().map(|point| (point.label, point.inputs));
    let mut claim = Claim::new("prose, in 237 bits", EQUATION);
    for (label, inputs) in named.chain(random) {
        let mut exact = exact(&inputs);
        if claims.triads {
            make_orthonormal(subject.inputs, &mut exact);
        }
        let free = free(claims, &mut sampler);
        let exact = claims.inputs(&exact, &free);
        // There are no derivatives on a kink.
        if subject.kink(&exact).is_some() {
            continue;
        }
        let [values, jacobian] = [(subject.exact_value)(&exact), (subject.exact_jacobian)(&exact)];
        let point = claims.point(&exact, Some([&values, &jacobian]), &free);
        let sizes = || sizes(subject, &exact, &values, &jacobian, claims.triads);
        let inputs = || golden::named(subject.inputs, &inputs).into();
        check(claims, &point, sizes, &mut claim, |size, of| deviation(size, of, &label, inputs()));
    }
    claim
}

/// Checks claims that concern no formula, for random numbers.
pub fn claims_at_large(claims: &Claims, options: &Options) -> Claim {
    let mut sampler = Sampler::for_formula("prose", options.seed);
    let mut claim = Claim::new("prose, in 237 bits", EQUATION);
    for k in 0..options.samples {
        let free = free(claims, &mut sampler);
        let point = claims.point(&[], None, &free);
        let numbers = || free.iter().map(|x| x.to_f64()).collect::<Vec<_>>().into();
        check(claims, &point, Vec::new, &mut claim, |size, of| deviation(size, of, &format!("random {k}"), numbers()));
    }
    claim
}

/// Whether the printed condition of a kink is the registered one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Printed {
    /// It was executed at this many points, and is.
    Executed(usize),
    /// It is written in words.
    InWords,
    /// It cannot be read, or is a different one: the discrepancy.
    Off(String),
}

/// Executes the printed condition of every kink: it must hold on the kink and not near it, and at each case exactly if
/// the registered one does.
pub(crate) fn kinks_as_printed(subject: &Subject) -> Vec<(String, Printed)> {
    let of = Signature { spec: subject.spec, inputs: subject.inputs, outputs: subject.outputs };
    let setting = Setting { of: Some(of), is_deep: true, ..Setting::default() };
    let all = subject.kinks.iter().map(|kink| (kink.condition.clone(), printed(subject, kink, &setting)));
    all.collect()
}

fn printed(subject: &Subject, kink: &Kink, setting: &Setting) -> Printed {
    if kink.condition.contains(r"\text") {
        return Printed::InWords;
    }
    let claims = match Claims::read(&kink.condition, setting) {
        Ok(claims) => claims,
        Err(error) => return Printed::Off(error.to_string()),
    };
    let moved = |step: f64| kink.at.iter().zip(&kink.across).map(|(x, by)| x + step * by).collect();
    let beside = [2e-3, -2e-3].map(|step| (false, moved(step))).into_iter();
    let cases = (subject.cases)().into_iter().map(|case| ((kink.holds)(&exact(&case.inputs)), case.inputs));
    let points = std::iter::once((true, kink.at.clone())).chain(beside).chain(cases);
    let mut executed = 0;
    for (expected, inputs) in points.filter(|(_, inputs)| (subject.check)(inputs).is_ok()) {
        executed += 1;
        if is_met(subject, &claims, &exact(&inputs)) != expected {
            let negation = if expected { "is not" } else { "is" };
            let inputs = serde_json::Value::from(golden::named(subject.inputs, &inputs));
            return Printed::Off(format!("`{}` {negation} so at {inputs}", kink.condition));
        }
    }
    Printed::Executed(executed)
}

/// Whether all claims hold at a point.
fn is_met(subject: &Subject, claims: &Claims, inputs: &[Octuple]) -> bool {
    let [values, jacobian] = [(subject.exact_value)(inputs), (subject.exact_jacobian)(inputs)];
    let point = claims.point(inputs, Some([&values, &jacobian]), &[]);
    let sizes = || sizes(subject, inputs, &values, &jacobian, false);
    claims
        .at(&point)
        .iter()
        .all(|at| if at.is_equality { share(claims, at, &point, sizes) <= EQUATION } else { at.holds })
}

/// The value of an expression about a formula, if all inputs it needs are given.
pub(crate) fn number_of(subject: &Subject, expression: &Claims) -> Octuple {
    let count = subject.inputs.iter().map(Field::len).sum();
    let inputs = expression.inputs(&vec![Octuple::NAN; count], &[]);
    let [values, jacobian] = [(subject.exact_value)(&inputs), (subject.exact_jacobian)(&inputs)];
    expression.number(&expression.point(&inputs, Some([&values, &jacobian]), &[]))
}

/// The value of an expression that concerns no formula.
pub fn number_at_large(expression: &Claims) -> Octuple {
    expression.number(&expression.point(&[], None, &[]))
}

fn check(
    claims: &Claims,
    point: &[Octuple],
    sizes: impl Fn() -> Vec<Octuple>,
    claim: &mut Claim,
    describe: impl Fn(f64, &ClaimAt<'_>) -> Deviation,
) {
    for at in claims.at(point) {
        // Somebody's tangent of a right angle.
        let is_infinite = |side: Octuple| !side.is_finite() && !side.is_nan();
        if claims.is_partial && (is_infinite(at.left) || is_infinite(at.right)) {
            continue;
        }
        let share = if !at.is_equality && at.holds { 0.0 } else { share(claims, &at, point, &sizes) };
        claim.record(share, EQUATION, |share| describe(share, &at));
    }
}

/// The difference of two sides relative to their size or, if that is too strict, also to the terms they are made of.
fn share(claims: &Claims, at: &ClaimAt<'_>, point: &[Octuple], sizes: impl Fn() -> Vec<Octuple>) -> f64 {
    let whole = Sensitivity::new(&[], &[]).plus(at.left).plus(at.right);
    match whole.share_of(at.right - at.left) {
        share if share > EQUATION => whole.plus(claims.terms(at, point, &sizes())).share_of(at.right - at.left),
        share => share,
    }
}

fn deviation(size: f64, of: &ClaimAt<'_>, point: &str, inputs: serde_json::Value) -> Deviation {
    let (found, expected) = (of.right.to_f64(), of.left.to_f64());
    Deviation { size, entry: of.text.into(), point: point.into(), found, expected, inputs }
}

/// The rounding error of each number of a point: none for inputs, which are exact, unless a triad was made orthonormal.
fn sizes(
    subject: &Subject,
    inputs: &[Octuple],
    values: &[Octuple],
    jacobian: &[Octuple],
    triads: bool,
) -> Vec<Octuple> {
    let is_rounded = |field: &Field| triads && matches!(field.quantity.domain, Domain::Triad(..));
    let of_field = |field: &Field| vec![Octuple::from(f64::from(u8::from(is_rounded(field)))); field.len()];
    let off: Vec<_> = subject.inputs.iter().flat_map(of_field).collect();
    // The error of a component of a unit vector is relative to 1, not to itself.
    let scales: Vec<_> = inputs.iter().zip(&off).map(|(&x, &off)| if off.is_zero() { x } else { off }).collect();
    let gradients = subject.derivative(inputs);
    let sensitivities = subject.second_derivative(inputs);
    let of_values = gradients.chunks(inputs.len()).zip(values);
    let of_entries = sensitivities.iter().map(Vec::as_slice).zip(jacobian);
    let known = of_values.chain(of_entries).map(|(gradient, &y)| Sensitivity::new(gradient, &scales).plus(y).size());
    off.iter().copied().chain(known).collect()
}

fn free(claims: &Claims, sampler: &mut Sampler) -> Vec<Octuple> {
    let domain = |free: &Free| match free {
        Free::Signed => Domain::Real,
        Free::Positive => Domain::Positive,
    };
    claims.free().iter().map(|free| sampler.number(domain(free)).into()).collect()
}

/// Makes each vector of a triad perpendicular to those before it, and of length 1.
fn make_orthonormal(fields: &[Field], inputs: &mut [Octuple]) {
    let mut before: Vec<(crate::formula::quantity::Node, Vector3<Octuple>)> = Vec::new();
    let mut first = 0;
    for field in fields {
        let place = first..first + field.len();
        first = place.end;
        let Domain::Triad(node, _) = field.quantity.domain else { continue };
        let at = |k: usize| inputs.get(place.start + k).filter(|_| k < field.len()).copied().unwrap_or_default();
        let mut vector = Vector3::new(at(0), at(1), at(2));
        for (_, other) in before.iter().filter(|(other, _)| *other == node) {
            vector -= *other * other.dot(&vector);
        }
        vector /= num_dual::DualNum::sqrt(&vector.dot(&vector));
        inputs[place].iter_mut().zip(vector.iter()).for_each(|(component, &x)| *component = x);
        before.push((node, vector));
    }
}

#[cfg(test)]
mod tests;
