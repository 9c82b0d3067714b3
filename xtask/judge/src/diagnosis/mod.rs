//! Searches for the one mistake that explains everything. Mistakes are tried in 237 bits, the simplest first; if none
//! explains every number at every point, only that is reported.

mod altered;
mod evidence;
mod factors;
mod inputs;
mod mistakes;
mod observed;
mod permuted;
mod state;
mod symmetric;
#[cfg(test)]
mod tests;
mod wording;

use super::answer::Answer;
use super::question::Wanted;
use super::verdict::{Court, Verdict};
use evidence::{Evidence, LEAST};

/// The known causes, one line each.
pub(super) fn diagnose(court: &Court<'_>, answers: &[Vec<Answer>; 2], verdict: &Verdict) -> Vec<String> {
    if verdict.off.is_empty() {
        return Vec::new();
    }
    if !verdict.two_answers.is_empty() {
        return vec![state::diagnose(court, answers, verdict)];
    }
    let evidence = Evidence::new(court, &answers[0], verdict);
    if let Some(what) = observed::on_kinks(&evidence) {
        return vec![what];
    }
    let points = evidence.off_samples(&evidence.off).len();
    if points == 0 {
        return vec!["it is off where a rounding decides on which side of a kink it is, and nowhere else".into()];
    }
    if points < LEAST {
        return vec![format!("unexplained: it is off at {} alone", crate::console::count(points, "point"))];
    }
    explain(&evidence)
}

/// One mistake for everything; else one for the value and one for the Jacobian.
fn explain(evidence: &Evidence<'_>) -> Vec<String> {
    let count = evidence.samples.len();
    let described = |what: String| format!("{what}: this explains all {count} points looked at");
    if let Some(what) = cause(evidence, &evidence.off) {
        return vec![described(what)];
    }
    let [value, rest] = evidence.parts().map(|part| evidence.off_in(&part));
    if value.is_empty() || rest.is_empty() {
        return vec!["unexplained".into()];
    }
    let of = |part: &str, off: &[usize]| match cause(evidence, off) {
        Some(what) => described(format!("{part}: {what}")),
        None => format!("{part}: unexplained"),
    };
    vec![of("value", &value), of("Jacobian", &rest)]
}

/// The mistake that explains these numbers; all others of the same part are right.
fn cause(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let linear = factors::cause(evidence, off).or_else(|| permuted::cause(evidence, off));
    if evidence.court.wanted == Wanted::Products {
        return linear;
    }
    linear
        .or_else(|| symmetric::cause(evidence, off))
        .or_else(|| inputs::cause(evidence, off))
        .or_else(|| observed::single_precision(evidence, off))
        .or_else(|| observed::out_of_range(evidence, off))
        .or_else(|| altered::cause(evidence, off))
        .or_else(|| permuted::entries(evidence, off))
}
