//! Errors from published software, re-enacted in this project's formulas, and what the audit of the formula alone
//! reports for each.

mod piece;
mod pieces;
mod shipped;

use anyhow::ensure;
use jointproof::toolkit::verify::{Audit, Claim};
use piece::Piece;
use std::fmt::Write;

/// The claims that failed.
fn failed(audit: &Audit) -> impl Iterator<Item = &Claim> {
    audit.claims().filter(|claim| claim.failures > 0)
}

/// The chapter: every error, with the audit's report.
///
/// # Errors
/// An error that is not caught, or a formula that fails without it.
pub(crate) fn chapter() -> anyhow::Result<String> {
    let mut text = String::new();
    for (k, piece) in pieces::all().iter().enumerate() {
        let Piece { thread, there, here, formula, claim, planted, audit, control, judged } = piece;
        let (audit, control) = (audit(), control());
        let failed: Vec<&Claim> = failed(&audit).collect();
        ensure!(failed.iter().any(|failed| failed.claim.contains(claim)), "{thread} is not caught in {formula}");
        ensure!(self::failed(&control).count() == 0, "{formula} is off without the error of {thread}");
        let heading = without_links(thread);
        let reported = if heading == *thread { String::new() } else { format!("Reported in {thread}. ") };
        let _ = writeln!(
            text,
            "## {}. {heading}\n\n{reported}{there}\n\nHere, in `{formula}`: {here} The audit says:\n",
            k + 1
        );
        text += "```text\n";
        for claim in failed {
            let _ = writeln!(text, "{}: failed {} of {}", claim.claim, claim.failures, claim.checks);
            if let Some(worst) = &claim.worst {
                let [one, other] = planted.compared(&claim.claim);
                let _ = writeln!(text, "    at {}: {one} {:?}, {other} {:?}", worst.entry, worst.found, worst.expected);
            }
        }
        text += "```\n\n";
        let [wrong, right] = judged.map(|judged| judged());
        ensure!(right.is_well, "check refuses {formula} without the error of {thread}:\n{}", right.text);
        let _ = writeln!(text, "As a program it is judged by `check`:\n\n```text");
        for (part, _) in &wrong.parts {
            let _ = writeln!(text, "{}: {}", part.title, part.says);
        }
        for cause in &wrong.causes {
            let _ = writeln!(text, "{cause}");
        }
        text += "```\n\n";
    }
    Ok(text)
}

/// The words of Markdown with links, for a heading, which is a link itself.
fn without_links(text: &str) -> String {
    let mut pieces = text.split("](");
    let first = pieces.next().unwrap_or_default().to_owned();
    let rest = pieces.map(|piece| piece.split_once(')').map_or("", |(_, after)| after));
    (first + &rest.collect::<String>()).replace('[', "")
}

#[cfg(test)]
mod tests {
    use super::piece::Planted;
    use super::*;

    #[test]
    fn one_failure_is_enough_to_fail() {
        let mut audit = crate::worked_example::run();
        audit.eta.failures = 1;
        let failures: Vec<_> = failed(&audit).map(|claim| claim.failures).collect();
        assert!(failures.contains(&1) && !failures.contains(&0) && failures.len() < audit.claims().count());
    }

    #[test]
    fn a_heading_has_the_words_of_its_links() {
        let links = "a, [issue 1](https://a.test/1) and [pull 2](https://a.test/2)";
        assert_eq!(without_links(links), "a, issue 1 and pull 2");
        assert_eq!(without_links("none"), "none");
    }

    #[test]
    fn the_wrong_number_is_said_to_be_planted() {
        let compared = |planted: Planted, claim: &str| planted.compared(claim).map(|name| name.ends_with("(planted)"));
        let (closed, printed) =
            ("closed form = automatic differentiation, in 237 bits", "printed equation = value, in 237 bits");
        assert_eq!(compared(Planted::Jacobian, closed), [true, false]);
        assert_eq!(compared(Planted::Value, closed), [false, true]);
        assert_eq!(compared(Planted::Value, printed), [false, true]);
        assert_eq!(compared(Planted::Value, "η of the value in f64"), [true, false]);
        // Errors of the value: those of equations, of the value that comes with a Jacobian, and of a lever arm.
        let value: Vec<_> =
            pieces::all().iter().filter(|piece| piece.planted == Planted::Value).map(|p| p.formula).collect();
        assert!(value.len() > 2 && value.len() < 9, "{value:?}");
        let text = chapter().unwrap();
        assert!(!text.contains("expected") && text.matches("(planted) ").count() >= 10, "{text}");
    }

    #[test]
    fn every_error_is_caught_by_the_audit_of_its_formula_alone() {
        let pieces = pieces::all();
        assert_eq!(pieces.len(), 12);
        for Piece { thread, claim, audit, control, formula, judged, .. } in pieces {
            assert!(jointproof::catalog::find(formula).is_some(), "{formula}");
            let found = failed(&audit()).map(|failed| failed.claim.clone()).collect::<Vec<_>>();
            assert!(found.iter().any(|failed| failed.contains(claim)), "{thread}: {claim:?} is not among {found:?}");
            let control = control();
            let wrong = failed(&control).collect::<Vec<_>>();
            assert!(wrong.is_empty(), "{thread}: without the error {wrong:#?}");
            assert!(control.claims().any(|held| held.claim.contains(claim) && held.checks > 0), "{thread}: {claim}");
            let [wrong, right] = judged.map(|judged| judged());
            assert!(right.is_well && !wrong.is_well, "{thread}: {}\n{}", right.text, wrong.text);
        }
    }
}
