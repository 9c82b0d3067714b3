//! A claim about a formula, and what was found about it.

use serde::{Deserialize, Serialize};

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
    #[serde(with = "any_double")]
    pub size: f64,
    /// The entry: `fc`, or `∂fc/∂f2`.
    pub entry: String,
    /// The case, or the number of the random point.
    pub point: String,
    /// What was found.
    #[serde(with = "any_double")]
    pub found: f64,
    /// What was expected.
    #[serde(with = "any_double")]
    pub expected: f64,
    /// The inputs, as golden files give them, to be pasted back.
    pub inputs: serde_json::Value,
}

impl Claim {
    pub(super) fn new(claim: impl Into<String>, bound: f64) -> Self {
        Self { claim: claim.into(), bound, checks: 0, failures: 0, worst: None }
    }

    /// Whether something was checked and nothing deviated by more than the bound.
    pub fn held(&self) -> bool {
        self.checks > 0 && self.failures == 0
    }

    /// The same claim, of which nothing was checked.
    #[must_use]
    pub(super) fn begun_anew(self) -> Self {
        Self::new(self.claim, self.bound)
    }

    /// This claim, checked at more points, which follow. Of two deviations of one size the first is kept.
    #[must_use]
    pub(super) fn and(self, next: Self) -> Self {
        let is_larger = match (&self.worst, &next.worst) {
            (Some(worst), Some(next)) => next.size > worst.size,
            (None, _) => true,
            (_, None) => false,
        };
        Self {
            checks: self.checks + next.checks,
            failures: self.failures + next.failures,
            worst: if is_larger { next.worst } else { self.worst },
            ..self
        }
    }

    /// What is claimed cannot even be checked.
    pub(super) fn fail(&mut self, reason: String) {
        self.failures += 1;
        let inputs = serde_json::Value::Null;
        let (point, found, expected) = Default::default();
        self.worst = Some(Deviation { size: f64::MAX, entry: reason, point, found, expected, inputs });
    }

    /// Records the last of sizes of which none is larger than the one before, but each takes longer to compute. Where one
    /// that is too large is within the bound and not the largest deviation, the others are not asked for.
    pub(super) fn record_last(
        &mut self,
        sizes: [&dyn Fn() -> f64; 3],
        bound: f64,
        describe: impl FnOnce(f64) -> Deviation,
    ) {
        let known = self.worst.as_ref().map_or(f64::NEG_INFINITY, |worst| worst.size);
        let mut size = f64::INFINITY;
        for next in sizes {
            size = next();
            if size <= known.min(bound) {
                break;
            }
        }
        self.record(size, bound, describe);
    }

    /// What is not a number is no deviation that anybody knows, and within no bound.
    pub(super) fn record(&mut self, size: f64, bound: f64, describe: impl FnOnce(f64) -> Deviation) {
        let size = if size.is_nan() { f64::INFINITY } else { size };
        self.checks += 1;
        self.failures += usize::from(size > bound);
        if self.worst.as_ref().is_none_or(|worst| size > worst.size) {
            self.worst = Some(describe(size));
        }
    }
}

/// Doubles as golden files have them, so that a claim that failed by NaN can be read back.
mod any_double {
    use crate::verify::golden::{double, number};
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use serde_json::Value;

    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
    pub(super) fn serialize<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        number(*x).serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        let value = Value::deserialize(deserializer)?;
        double(&value).ok_or_else(|| Error::custom(format_args!("{value} is no number")))
    }
}
