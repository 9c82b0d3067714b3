//! The results of audits, in words.

use crate::console::{bold, count, figure, green, red};
use crate::examination;
use jointproof::toolkit::verify::{Audit, Claim, Deviation};
use std::fmt::Write;

/// The failures in full, then one line per formula; `accuracy` says how the bounds of η are known, if that is known here.
///
/// # Errors
/// None in practice; those of formatting are passed on.
pub fn text(
    audits: &[Audit],
    passed: fn(&Audit) -> bool,
    accuracy: &dyn Fn(&Audit) -> Option<String>,
) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    for audit in audits {
        let points = audit.named_points + audit.random_points;
        let said: Vec<_> = std::iter::once(audit.provenance.clone()).chain(accuracy(audit)).collect();
        text += &heading(&audit.formula, passed(audit), points, &said.join("\n    "))?;
        for claim in audit.claims() {
            writeln!(text, "    {}", line(claim))?;
        }
        for line in audit.examination.iter().flat_map(examination::lines) {
            writeln!(text, "    {line}")?;
        }
        for claim in audit.claims().filter(|claim| !claim.held() || is_error_figure(claim)) {
            text += &claim.worst.as_ref().map_or(String::new(), |worst| in_full(claim, worst));
        }
    }
    Ok(text + &total(audits, passed))
}

/// One line per claim of an element, then the failures in full.
///
/// # Errors
/// None in practice; those of formatting are passed on.
pub fn claims(
    name: &str,
    passed: bool,
    points: usize,
    provenance: &str,
    claims: &[Claim],
) -> Result<String, std::fmt::Error> {
    let mut text = heading(name, passed, points, provenance)?;
    for claim in claims {
        writeln!(text, "    {}", line(claim))?;
    }
    for claim in claims.iter().filter(|claim| !claim.held()) {
        text += &claim.worst.as_ref().map_or(String::new(), |worst| in_full(claim, worst));
    }
    Ok(text)
}

fn heading(name: &str, passed: bool, points: usize, provenance: &str) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let mark = if passed { green("ok ") } else { red("off") };
    writeln!(text, "{mark} {} at {}", bold(name), count(points, "point"))?;
    writeln!(text, "    {provenance}")?;
    writeln!(text, "    {:>9} {:>8} {:>7}", "checked", "worst", "bound")?;
    Ok(text)
}

/// A one-line summary of the audits.
pub fn total(audits: &[Audit], passed: fn(&Audit) -> bool) -> String {
    let failed = audits.iter().filter(|audit| !passed(audit)).count();
    let checks: usize = audits.iter().flat_map(Audit::claims).map(|claim| claim.checks).sum();
    let [audited, checks, off] = [(audits.len(), "formula"), (checks, "comparison"), (failed, "formula")]
        .map(|(number, noun)| count(number, noun));
    format!("{audited}, {checks}, {off} off\n")
}

/// Whether a claim is an error measure, whose worst point is of interest even within the bound.
fn is_error_figure(claim: &Claim) -> bool {
    claim.claim.starts_with('η') && claim.worst.as_ref().is_some_and(|worst| worst.size > 0.0)
}

fn line(claim: &Claim) -> String {
    let Claim { claim, bound, checks, failures, worst } = claim;
    let verdict = match (checks, failures) {
        (0, _) => red("NOT CHECKED: "),
        (_, 0) => String::new(),
        (_, failures) => red(format!("FAILED {failures} TIMES: ")),
    };
    let worst = figure(worst.as_ref().map_or(0.0, |worst| worst.size));
    format!("{checks:>9} {worst:>8} {:>7}  {verdict}{claim}", figure(*bound))
}

/// The worst deviation of a claim, with the inputs there.
pub fn in_full(claim: &Claim, worst: &Deviation) -> String {
    let Deviation { size, entry, point, found, expected, inputs } = worst;
    format!(
        "    worst of {}: {} at {entry}, {point}\n      found {found:?}, expected {expected:?}\n      --point '{inputs}'\n",
        claim.claim,
        figure(*size),
    )
}
