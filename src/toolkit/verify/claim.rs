//! A claim about a formula, and the result of checking it.

use crate::formula::NORMWISE;
use serde::{Deserialize, Serialize};

/// A claim about a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// The claim in words.
    pub claim: String,
    /// The largest deviation allowed; where some points have another bound, that of the worst deviation.
    pub bound: f64,
    /// The number of comparisons.
    pub checks: usize,
    /// The number of deviations above the bound.
    pub failures: usize,
    /// The largest deviation, relative to its bound.
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
    /// The case, or the index of the random point.
    pub point: String,
    /// The value found.
    #[serde(with = "any_double")]
    pub found: f64,
    /// The value expected.
    #[serde(with = "any_double")]
    pub expected: f64,
    /// The inputs in the format of golden files, to be pasted back.
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

    /// Whether its bound is [normwise](crate::formula::Spec::normwise).
    pub fn is_normwise(&self) -> bool {
        self.claim.contains(NORMWISE)
    }

    /// The same claim, with nothing checked.
    #[must_use]
    pub(super) fn begun_anew(self) -> Self {
        Self::new(self.claim, self.bound)
    }

    /// Merges this claim with its checks at further points. Of two deviations of the same size the first is kept.
    #[must_use]
    pub(super) fn and(self, next: Self) -> Self {
        let is_worse = match (&self.worst, &next.worst) {
            (Some(_), Some(worst)) => self.is_exceeded_by(worst.size, next.bound),
            (None, _) => true,
            (_, None) => false,
        };
        let (bound, worst) = if is_worse { (next.bound, next.worst) } else { (self.bound, self.worst) };
        Self {
            claim: self.claim,
            bound,
            checks: self.checks + next.checks,
            failures: self.failures + next.failures,
            worst,
        }
    }

    /// Records that the claim could not be checked.
    pub(super) fn fail(&mut self, reason: String) {
        self.failures += 1;
        let inputs = serde_json::Value::Null;
        let (point, found, expected) = Default::default();
        self.worst = Some(Deviation { size: f64::MAX, entry: reason, point, found, expected, inputs });
    }

    /// Records and returns the last of several upper bounds of a deviation, each of which takes longer to compute than
    /// the previous one. A bound that is within the limit and below the worst deviation suffices, and the following
    /// ones are not computed.
    pub(super) fn record_last(
        &mut self,
        sizes: impl IntoIterator<Item = f64>,
        bound: f64,
        describe: impl FnOnce(f64) -> Deviation,
    ) -> f64 {
        self.record_last_or(sizes, bound, [], describe)
    }

    /// As [`record_last`](Self::record_last), with other deviations, each of which counts as well where those before it exceed the
    /// limit.
    pub(super) fn record_last_or<const N: usize>(
        &mut self,
        sizes: impl IntoIterator<Item = f64>,
        bound: f64,
        others: [&dyn Fn() -> Option<f64>; N],
        describe: impl FnOnce(f64) -> Deviation,
    ) -> f64 {
        let enough = self.worst.as_ref().map_or(f64::NEG_INFINITY, |worst| worst.size).min(bound);
        let mut last = f64::INFINITY;
        for size in sizes {
            last = size;
            if size <= enough {
                break;
            }
        }
        for other in others {
            if last > bound {
                last = other().map_or(last, |other| other.min(last));
            }
        }
        self.record(last, bound, describe);
        last
    }

    /// Counts a deviation, and describes it if it is the worst so far.
    pub(super) fn record(&mut self, size: f64, bound: f64, describe: impl FnOnce(f64) -> Deviation) {
        let size = self.count(size, bound);
        if self.is_exceeded_by(size, bound) {
            self.worst = Some(describe(size));
            self.bound = bound;
        }
    }

    /// Whether a deviation is worse than the worst so far, each compared with its own bound.
    fn is_exceeded_by(&self, size: f64, bound: f64) -> bool {
        self.worst.as_ref().is_none_or(|worst| {
            if bound == self.bound { size > worst.size } else { size * self.bound > worst.size * bound }
        })
    }

    /// Counts and returns a deviation that is not the worst, or for which this is decided elsewhere. NaN counts as
    /// infinite, and exceeds every bound.
    pub(super) fn count(&mut self, size: f64, bound: f64) -> f64 {
        let size = if size.is_nan() { f64::INFINITY } else { size };
        self.checks += 1;
        self.failures += usize::from(size > bound);
        size
    }
}

/// Doubles in the format of golden files, so that a claim that failed with NaN can be read back.
mod any_double {
    use crate::toolkit::verify::golden::{double, number};
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    fn deviation(size: f64, entry: &str) -> Deviation {
        let (found, expected, inputs) = (2.0, 1.0, serde_json::Value::Null);
        Deviation { size, entry: entry.into(), point: "there".into(), found, expected, inputs }
    }

    #[test]
    fn the_worst_deviation_is_the_one_nearest_to_its_own_bound_and_keeps_it() {
        let mut random = Claim::new("a claim", 1e-50);
        random.record(9e-51, 1e-50, |size| deviation(size, "random"));
        let mut hard = Claim::new("a claim", 1e-50);
        hard.record(6e-43, 1e-35, |size| deviation(size, "hard"));
        let shown = |claim: &Claim| (claim.worst.as_ref().map(|worst| worst.entry.clone()).unwrap(), claim.bound);
        assert_eq!(shown(&hard), ("hard".into(), 1e-35));
        for claim in [hard.clone().and(random.clone()), random.clone().and(hard.clone())] {
            assert_eq!((shown(&claim), claim.checks, claim.failures), (("random".into(), 1e-50), 2, 0));
        }
        // A failure is never hidden behind a larger deviation that is allowed.
        random.record(2e-36, 1e-35, |size| deviation(size, "hard"));
        random.record(3e-50, 1e-50, |size| deviation(size, "too large"));
        assert_eq!((shown(&random), random.failures), (("too large".into(), 1e-50), 1));
    }

    /// A claim with bound 3, checked at deviations of these sizes, named by their positions.
    fn checked(sizes: &[f64]) -> Claim {
        let mut claim = Claim::new("it is so", 3.0);
        for (k, &size) in sizes.iter().enumerate() {
            claim.record(size, 3.0, |size| deviation(size, &k.to_string()));
        }
        claim
    }

    fn worst(claim: &Claim) -> (f64, &str) {
        claim.worst.as_ref().map_or((-1.0, ""), |worst| (worst.size, &worst.entry))
    }

    #[test]
    fn a_claim_holds_that_was_checked_and_did_not_fail() {
        assert!(!checked(&[]).held());
        assert!(checked(&[0.0]).held() && checked(&[1.0, 3.0]).held());
        assert!(!checked(&[3.0_f64.next_up(), 0.0]).held());
    }

    #[test]
    fn checks_and_failures_are_counted_and_the_first_of_the_worst_is_kept() {
        let claim = checked(&[0.0, 4.0, 3.0, 4.0, 5.0, 5.0]);
        assert_eq!((claim.checks, claim.failures, worst(&claim)), (6, 4, (5.0, "4")));
        assert_eq!(worst(&checked(&[0.0, 0.0])), (0.0, "0"));
        let nan = checked(&[f64::NAN, 9.0]);
        assert_eq!((nan.failures, worst(&nan)), (2, (f64::INFINITY, "0")));
        assert_eq!(claim.begun_anew(), checked(&[]));
    }

    #[test]
    fn of_two_parts_checks_are_added_and_the_larger_deviation_is_kept() {
        let both = |one: &[f64], next: &[f64]| checked(one).and(checked(next));
        let joined = both(&[1.0, 7.0], &[4.0, 8.0, 2.0]);
        assert_eq!((joined.checks, joined.failures, worst(&joined)), (5, 3, (8.0, "1")));
        assert_eq!(worst(&both(&[1.0, 7.0], &[7.0])), (7.0, "1"));
        assert_eq!(worst(&both(&[1.0, 7.0], &[])), (7.0, "1"));
        assert_eq!(worst(&both(&[], &[2.0])), (2.0, "0"));
        assert_eq!(both(&[], &[]), checked(&[]));
    }

    #[test]
    fn what_is_counted_is_not_the_worst_and_may_fail() {
        let mut claim = checked(&[1.0]);
        let counted = [0.5, 9.0, f64::NAN].map(|size| claim.count(size, 3.0));
        assert_eq!(counted, [0.5, 9.0, f64::INFINITY]);
        assert_eq!((claim.checks, claim.failures, worst(&claim)), (4, 2, (1.0, "0")));
    }

    #[test]
    fn what_cannot_be_checked_has_failed() {
        let mut claim = checked(&[1.0]);
        claim.fail("it cannot be read".into());
        assert_eq!((claim.checks, claim.failures, worst(&claim)), (1, 1, (f64::MAX, "it cannot be read")));
    }

    /// A non-increasing sequence of sizes: how many are computed, and which is recorded.
    #[test]
    fn a_size_is_looked_at_more_closely_where_it_would_fail_or_be_the_worst() {
        let last = |before: &[f64], sizes: [f64; 3]| {
            let (mut claim, asked) = (checked(before), Cell::new(0));
            let ask = |k: usize| {
                asked.set(asked.get() + 1);
                sizes[k]
            };
            claim.record_last((0..3).map(ask), 3.0, |size| deviation(size, "last"));
            assert_eq!(claim.checks, before.len() + 1);
            let (size, entry) = worst(&claim);
            (asked.get(), (size, if entry == "last" { "last" } else { "before" }), claim.failures)
        };
        // Nothing is known yet: the first one is the worst in any case.
        assert_eq!(last(&[], [2.0, 1.0, 0.5]), (3, (0.5, "last"), 0));
        assert_eq!(last(&[2.0], [2.0, 1.0, 0.5]), (1, (2.0, "before"), 0));
        assert_eq!(last(&[2.0], [2.5, 1.0, 0.5]), (2, (2.0, "before"), 0));
        assert_eq!(last(&[2.0], [2.5, 2.5, 2.5]), (3, (2.5, "last"), 0));
        // Below the worst, but above the bound.
        assert_eq!(last(&[9.0], [4.0, 3.0, 0.5]), (2, (9.0, "before"), 1));
        assert_eq!(last(&[9.0], [4.0, 4.0, 4.0]), (3, (9.0, "before"), 2));
    }

    #[test]
    fn a_deviation_that_is_no_number_is_read_back() {
        let said = serde_json::to_value(deviation(f64::INFINITY, "a")).unwrap();
        assert_eq!((&said["size"], &said["found"]), (&"Infinity".into(), &2.0.into()));
        let back: Deviation = serde_json::from_value(said.clone()).unwrap();
        assert_eq!(back, deviation(f64::INFINITY, "a"));
        let mut wrong = said;
        wrong["size"] = "large".into();
        let refused = serde_json::from_value::<Deviation>(wrong).unwrap_err().to_string();
        assert_eq!(refused, "\"large\" is no number");
    }
}
