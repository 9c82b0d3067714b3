//! How accurate a program is at ordinary points, beside our own code, and where it loses digits.

use super::{Deviations, Part, Standing};
use crate::console::figure;
use crate::diagnosis;
use crate::verdict::{Court, Etas, Verdict};

/// Roundings that no one would call a loss.
const FEW: f64 = 32.0;

impl Court<'_> {
    /// The part about accuracy.
    pub(super) fn accuracy(&self, verdict: &Verdict, all: &[Option<Deviations>], ordinary: &[usize], is_same: bool) -> Part {
        let title = "how accurate?";
        let etas: Vec<&Etas> = verdict.etas.iter().filter(|etas| ordinary.binary_search(&etas.question).is_ok()).collect();
        let is_within = |etas: &&&Etas| etas.found[0] <= self.bounds.value && etas.found[1] <= self.bound_of_rest();
        let within = etas.iter().filter(is_within).count() + verdict.same_questions;
        let asked = etas.len() + verdict.same_questions;
        let right = [within, asked];
        if asked == 0 {
            return Part { title, standing: Standing::NotAsked, right, says: "no answer".into(), details: Vec::new(), point: None };
        }
        let describe = |part: usize, name: &str| {
            let mut found: Vec<f64> = etas.iter().map(|etas| etas.found[part]).collect();
            found.extend(std::iter::repeat_n(0.0, verdict.same_questions));
            let own = etas.iter().map(|etas| etas.own[part]).fold(0.0, f64::max);
            found.sort_by(f64::total_cmp);
            let at = |share: usize| found[(found.len() - 1) * share / 100];
            format!(
                "{name}: {} digits at worst; η 50 % {}, 99 % {}, worst {} (ours {})",
                digits(at(100)),
                figure(at(50)),
                figure(at(99)),
                figure(at(100)),
                figure(own)
            )
        };
        let rest = if self.is_value_alone() { None } else { Some(describe(1, "Jacobian")) };
        let says = describe(0, "value");
        let size = |etas: &Etas| etas.found[0].max(etas.found[1]);
        let worst = etas.iter().copied().max_by(|a, b| size(a).total_cmp(&size(b)));
        let limited = worst.filter(|worst| size(worst) > FEW.max(self.bounds.value).max(self.bounds.jacobian));
        let mut details: Vec<String> = rest.into_iter().collect();
        if let Some(worst) = limited.filter(|_| is_same) {
            let deviation = all[worst.question].iter().flatten().flatten().fold(0.0_f64, |worst, x| worst.max(*x));
            details.push(if deviation <= FEW * f64::EPSILON {
                "digits are lost in components that are small beside others of their vector or matrix: a sum there cancels".to_owned()
            } else {
                diagnosis::cancellation(self, worst.question).unwrap_or_else(|| "digits are lost in a sum that cancels on the way".to_owned())
            });
        }
        Part {
            title,
            standing: if limited.is_some() { Standing::Limited } else { Standing::Right },
            right,
            says,
            details,
            point: limited.map(|worst| worst.question),
        }
    }

    fn bound_of_rest(&self) -> f64 {
        self.bound(usize::MAX)
    }
}

/// The decimal digits that are right, of those that a double has.
fn digits(eta: f64) -> String {
    let digits = -(eta.max(1.0) * f64::EPSILON / 2.0).log10();
    if digits.is_finite() { format!("{:.1}", digits.max(0.0)) } else { "0".into() }
}
