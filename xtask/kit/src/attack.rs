//! `audit --attack`: a search that climbs tries to refute the bounds of η, those that are stated and those that are proved.

use crate::console::{bold, count, figure, green, progress, red};
use crate::project::Project;
use crate::prove;
use crate::selection::Formulas;
use ::attack::{Attack, Effort, attack};
use indicatif::ParallelProgressIterator;
use jointproof::toolkit::verify::Claim;
use judge::audited::in_full;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::fmt::Write;

/// Attacks formulas on all cores; returns what was found, and whether no bound is refuted.
pub(crate) fn run(project: &Project, formulas: &Formulas, effort: Effort, seed: u64) -> anyhow::Result<(String, bool)> {
    let bar = progress("attack", formulas.len());
    let attacks: Vec<_> =
        formulas.par_iter().progress_with(bar).map(|formula| attack(*formula, effort, seed)).collect();
    let (mut text, mut refuted, mut evaluations) = (String::new(), 0, 0);
    for (formula, attack) in formulas.iter().zip(attacks) {
        let attack = attack.map_err(|why| anyhow::anyhow!("{}: {why}", formula.spec().id))?;
        let proved = prove::stated(project, *formula);
        let proved = proved.map_or([None; 2], |both| both.map(|of| of.of_all(&formula.spec())));
        text += &of_one(formula.spec().id, &attack, proved)?;
        refuted += usize::from(!holds(&attack, proved));
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

/// Whether neither a stated nor a proved bound is refuted.
fn holds(attack: &Attack, proved: [Option<f64>; 2]) -> bool {
    let both = attack.claims.iter().zip(&attack.first_order).zip(proved);
    attack.holds() && both.into_iter().all(|((claim, most), proved)| !is_contradicted(claim, *most, proved))
}

/// Whether a proof is wrong: more is found than it allows, or possible to first order, which is computed in `f64`. What is found is not
/// judged normwise where it need not be. A result that underflows, of which proofs do not speak, has an η of up to 1.
fn is_contradicted(claim: &Claim, most: f64, proved: Option<f64>) -> bool {
    const ROUNDING: f64 = 1e-3;
    let found = claim.worst.as_ref().filter(|_| !claim.is_normwise()).map_or(0.0, |worst| worst.size);
    proved.is_some_and(|proved| most.max(if found > 1.0 { found } else { 0.0 }) > proved * (1.0 + ROUNDING))
}

/// A line per claim, and the worst points in full.
fn of_one(id: &str, attack: &Attack, proved: [Option<f64>; 2]) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let mark = if holds(attack, proved) { green("ok ") } else { red("off") };
    let evaluations = count(usize::try_from(attack.evaluations).unwrap_or(usize::MAX), "evaluation");
    writeln!(text, "{mark} {} in {evaluations}", bold(id))?;
    writeln!(text, "    {:>8} {:>8} {:>8} {:>8}", "possible", "found", "bound", "proved")?;
    for ((claim, most), proved) in attack.claims.iter().zip(&attack.first_order).zip(proved) {
        let mut verdict = if claim.failures > 0 { red("REFUTED: ") } else { String::new() };
        if is_contradicted(claim, *most, proved) {
            verdict += &red("CONTRADICTS A PROOF: ");
        }
        let found = figure(claim.worst.as_ref().map_or(0.0, |worst| worst.size));
        let proved = proved.map_or("–".into(), figure);
        let [most, bound] = [*most, claim.bound].map(figure);
        writeln!(text, "    {most:>8} {found:>8} {bound:>8} {proved:>8}  {verdict}{}", claim.claim)?;
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
    use jointproof::toolkit::verify::Deviation;

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
        let proved = |size, proved| {
            let text = of_one("a.b", &attack(size), [proved, None]).unwrap();
            anstream::adapter::strip_str(&text).to_string()
        };
        let text = |size| proved(size, None);
        let expected = "off a.b in 7 evaluations\n    possible    found    bound   proved\n\
             \u{20}       2.50     2.00     1.50        –  REFUTED: η of the value in f64\n\
             \u{20}   worst of η of the value in f64: 2.00 at ma[2], found\n      found 1.0, expected 2.0\n      --point '{\"x\":3.0}'\n";
        assert_eq!(text(2.0), expected);
        let contradicted = proved(1.25, Some(2.0));
        assert!(contradicted.starts_with("off a.b") && contradicted.contains("CONTRADICTS A PROOF"), "{contradicted}");
        assert!(proved(1.25, Some(2.5)).starts_with("ok  a.b"), "{}", proved(1.25, Some(2.5)));
        assert!(text(1.25).starts_with("ok  a.b") && !text(1.25).contains("REFUTED"), "{}", text(1.25));
    }
}
