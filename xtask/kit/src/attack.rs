//! `audit --attack`: a search that climbs tries to refute the bounds of η.

use crate::console::{bold, count, figure, green, progress, red};
use crate::selection::Formulas;
use ::attack::{Attack, Effort, attack};
use indicatif::ParallelProgressIterator;
use judge::audited::in_full;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::fmt::Write;

/// Attacks formulas on all cores; returns what was found, and whether no bound is refuted.
pub(crate) fn run(formulas: &Formulas, effort: Effort, seed: u64) -> anyhow::Result<(String, bool)> {
    let bar = progress("attack", formulas.len());
    let attacks: Vec<_> =
        formulas.par_iter().progress_with(bar).map(|formula| attack(*formula, effort, seed)).collect();
    let (mut text, mut refuted, mut evaluations) = (String::new(), 0, 0);
    for (formula, attack) in formulas.iter().zip(attacks) {
        let attack = attack.map_err(|why| anyhow::anyhow!("{}: {why}", formula.spec().id))?;
        text += &of_one(formula.spec().id, &attack)?;
        refuted += usize::from(!attack.holds());
        evaluations += attack.evaluations;
    }
    let [attacked, evaluations, off] = [
        count(formulas.len(), "formula"),
        count(usize::try_from(evaluations)?, "evaluation"),
        count(refuted, "formula"),
    ];
    writeln!(text, "{attacked}, {evaluations}, {off} refuted")?;
    Ok((text, refuted == 0))
}

/// A line per claim, and the worst points in full.
fn of_one(id: &str, attack: &Attack) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let mark = if attack.holds() { green("ok ") } else { red("off") };
    let evaluations = count(usize::try_from(attack.evaluations).unwrap_or(usize::MAX), "evaluation");
    writeln!(text, "{mark} {} in {evaluations}", bold(id))?;
    writeln!(text, "    {:>8} {:>8} {:>8}", "possible", "found", "bound")?;
    for (claim, most) in attack.claims.iter().zip(&attack.first_order) {
        let verdict = if claim.failures > 0 { red("REFUTED: ") } else { String::new() };
        let found = figure(claim.worst.as_ref().map_or(0.0, |worst| worst.size));
        writeln!(text, "    {:>8} {found:>8} {:>8}  {verdict}{}", figure(*most), figure(claim.bound), claim.claim)?;
    }
    for claim in &attack.claims {
        if let Some(worst) = claim.worst.as_ref().filter(|worst| worst.size > 0.0) {
            text += &in_full(claim, worst);
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::toolkit::verify::{Claim, Deviation};

    #[test]
    fn what_is_refuted_is_said_so_with_its_point() {
        let attack = |size: f64| Attack {
            claims: vec![Claim {
                claim: "η of the value in f64".into(),
                bound: 1.5,
                checks: 1,
                failures: usize::from(size > 1.5),
                worst: Some(Deviation {
                    size,
                    entry: "ma[2]".into(),
                    point: "found".into(),
                    found: 1.0,
                    expected: 2.0,
                    inputs: serde_json::json!({"x": 3.0}),
                }),
            }],
            first_order: vec![2.5],
            evaluations: 7,
        };
        let text = |size| anstream::adapter::strip_str(&of_one("a.b", &attack(size)).unwrap()).to_string();
        let expected = "off a.b in 7 evaluations\n    possible    found    bound\n\
             \u{20}       2.50     2.00     1.50  REFUTED: η of the value in f64\n\
             \u{20}   worst of η of the value in f64: 2.00 at ma[2], found\n      found 1.0, expected 2.0\n      --point '{\"x\":3.0}'\n";
        assert_eq!(text(2.0), expected);
        assert!(text(1.25).starts_with("ok  a.b") && !text(1.25).contains("REFUTED"), "{}", text(1.25));
    }
}
