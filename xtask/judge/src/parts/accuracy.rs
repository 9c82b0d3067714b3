//! How accurate a program is at ordinary points, beside our own code, and where it loses digits.

use super::{Deviations, Part, Standing};
use crate::console::figure;
use crate::diagnosis;
use crate::question::sizes;
use crate::verdict::{Court, Etas, Verdict};

/// Roundings that no one would call a loss.
const FEW: f64 = 32.0;

impl Court<'_> {
    /// The part about accuracy.
    pub(super) fn accuracy(
        &self,
        verdict: &Verdict,
        all: &[Option<Deviations>],
        ordinary: &[usize],
        is_same: &[bool],
    ) -> Part {
        let title = "how accurate?";
        let etas: Vec<&Etas> =
            verdict.etas.iter().filter(|etas| ordinary.binary_search(&etas.question).is_ok()).collect();
        let m = sizes(self.formula)[1];
        // Of the numbers that are those of the formula.
        let largest = |etas: &[Option<f64>], part: usize| {
            let places = if part == 0 { 0..m } else { m..etas.len() };
            places.filter(|&place| is_same[place]).filter_map(|place| etas[place]).fold(0.0, f64::max)
        };
        let is_within = |etas: &&&Etas| {
            largest(&etas.found, 0) <= self.bounds.value && largest(&etas.found, 1) <= self.bound(usize::MAX)
        };
        let within = etas.iter().filter(is_within).count() + verdict.same_questions;
        let asked = etas.len() + verdict.same_questions;
        let right = [within, asked];
        let none =
            |says: &str| Part { title, standing: Standing::NotAsked, right, says: says.into(), ..Part::default() };
        if asked == 0 {
            return none("no answer");
        }
        if !is_same.contains(&true) {
            return none("no number is that of the formula");
        }
        let describe = |part: usize, name: &str| {
            let mut found: Vec<f64> = etas.iter().map(|etas| largest(&etas.found, part)).collect();
            found.extend(std::iter::repeat_n(0.0, verdict.same_questions));
            let own = etas.iter().map(|etas| largest(&etas.own, part)).fold(0.0, f64::max);
            found.sort_by(f64::total_cmp);
            let at = |share: usize| found[(found.len() - 1) * share / 100];
            let places = if part == 0 { 0..m } else { m..is_same.len() };
            let deviations = ordinary
                .iter()
                .filter_map(|&k| all[k].as_ref())
                .flat_map(|all| places.clone().filter(|&place| is_same[place]).filter_map(|place| all[place]));
            format!(
                "{name}: {} digits of its norm at worst; η 50 % {}, 99 % {}, worst {} (ours {})",
                digits(deviations.fold(0.0, f64::max)),
                figure(at(50)),
                figure(at(99)),
                figure(at(100)),
                figure(own)
            )
        };
        let described = [(0, "value", 0..m), (1, "Jacobian", m..is_same.len())]
            .into_iter()
            .filter_map(|(part, name, places)| is_same[places].contains(&true).then(|| describe(part, name)));
        let mut described = described.collect::<Vec<_>>().into_iter();
        let says = described.next().unwrap_or_default();
        let size = |etas: &Etas| largest(&etas.found, 0).max(largest(&etas.found, 1));
        let worst = etas.iter().copied().max_by(|a, b| size(a).total_cmp(&size(b)));
        let limited = worst.filter(|worst| size(worst) > FEW.max(self.bounds.value).max(self.bounds.jacobian));
        let mut details: Vec<String> = described.collect();
        if let Some(worst) = limited {
            let deviation = all[worst.question]
                .iter()
                .flatten()
                .zip(is_same)
                .filter(|(_, same)| **same)
                .filter_map(|(x, _)| *x)
                .fold(0.0, f64::max);
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
            ..Part::default()
        }
    }
}

/// The decimal digits that are right, with a deviation relative to the norm.
fn digits(deviation: f64) -> String {
    let digits = -deviation.max(f64::EPSILON / 2.0).log10();
    format!("{:.1}", if digits > 0.0 { digits } else { 0.0 })
}
