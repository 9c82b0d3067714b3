//! Parts of an audit, for several machines: each draws the same random points and audits its share of them.
//! Consecutive parts are merged, in any grouping, into the audit of a single machine.

use super::audit::{Audit, audit_share};
use super::claim::Claim;
use super::kinks::{Comparison, Coverage, Examination};
use super::point::Options;
use super::shard::{PartError, Shard};
use super::subject::Subject;
use crate::formula::proof::Proved;
use serde::{Deserialize, Serialize};

/// Audits one formula.
pub fn audit<F: Proved>(options: &Options) -> Audit {
    Part::of(&Subject::of::<F>(), options, Shard::WHOLE).complete()
}

/// A part of the audit of one formula, or several consecutive parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// The first and the last part it contains, counted from 1.
    shards: [usize; 2],
    of: usize,
    samples: usize,
    audit: Audit,
    comparisons: Vec<Comparison>,
}

impl Part {
    /// Audits this share of the random points and, with the first share, all other points.
    pub(crate) fn of(subject: &Subject, options: &Options, shard: Shard) -> Self {
        let (audit, comparisons) = audit_share(subject, options, shard);
        Self { shards: [shard.index; 2], of: shard.of, samples: options.samples, audit, comparisons }
    }

    /// The identifier of the formula.
    pub fn formula(&self) -> &str {
        &self.audit.formula
    }

    /// The index of its first part, counted from 1, by which parts are sorted.
    pub fn first(&self) -> usize {
        self.shards[0]
    }

    /// Merges this part with the next.
    ///
    /// # Errors
    /// If it is a part of another audit, or not the next one.
    pub fn and(self, next: Self) -> Result<Self, PartError> {
        let audits = |part: &Self| (part.audit.formula.clone(), part.audit.seed, part.samples, part.of);
        if audits(&self) != audits(&next) {
            let [one, other] = [&self, &next].map(|part| {
                format!("{}, {} points of seed {}, in {} parts", part.formula(), part.samples, part.audit.seed, part.of)
            });
            return Err(PartError(format!("parts of two audits: {one}; {other}")));
        }
        if self.shards[1] + 1 != next.shards[0] {
            let (last, first, of) = (self.shards[1], next.shards[0], self.of);
            return Err(PartError(format!("{}: part {first} of {of} does not follow {last}", next.formula())));
        }
        let comparisons = self.comparisons.into_iter().zip(next.comparisons).map(|(one, next)| {
            let counts = [0, 1].map(|side| one.counts[side] + next.counts[side]);
            Comparison { words: one.words, counts }
        });
        Ok(Self {
            shards: [self.shards[0], next.shards[1]],
            comparisons: comparisons.collect(),
            audit: self.audit.and(next.audit),
            ..self
        })
    }

    /// The audit, if these are all of its parts.
    ///
    /// # Errors
    /// The parts that are missing.
    pub fn into_audit(self) -> Result<Audit, PartError> {
        let Self { shards: [first, last], of, .. } = self;
        if (first, last) != (1, of) {
            return Err(PartError(format!("{}: parts {first} to {last} of {of} are not all", self.formula())));
        }
        Ok(self.complete())
    }

    /// The audit, with the coverage of comparisons filled in.
    pub(crate) fn complete(self) -> Audit {
        let mut audit = self.audit;
        if let Some(Examination::Graph { coverage, .. }) = &mut audit.examination {
            *coverage = Coverage::of(&self.comparisons);
        }
        audit
    }
}

impl Audit {
    /// Merges this with the results at further points.
    fn and(self, next: Self) -> Self {
        Self {
            formula: self.formula,
            provenance: self.provenance,
            named_points: self.named_points + next.named_points,
            searched_points: self.searched_points + next.searched_points,
            random_points: self.random_points + next.random_points,
            seed: self.seed,
            closed_against_ad: either(self.closed_against_ad, next.closed_against_ad, Claim::and),
            ad_against_differences: self.ad_against_differences.and(next.ad_against_differences),
            eta: self.eta.and(next.eta),
            eta_jacobian: either(self.eta_jacobian, next.eta_jacobian, Claim::and),
            scaled: one_by_one(self.scaled, next.scaled),
            equation: self.equation.and(next.equation),
            equation_jacobian: self.equation_jacobian.and(next.equation_jacobian),
            laws: one_by_one(self.laws, next.laws),
            finite: either(self.finite, next.finite, Claim::and),
            kinks: self.kinks.and(next.kinks),
            register: either(self.register, next.register, Claim::and),
            examination: self.examination.or(next.examination),
        }
    }
}

/// The same claims, each merged with its checks at further points.
fn one_by_one(claims: Vec<Claim>, next: Vec<Claim>) -> Vec<Claim> {
    claims.into_iter().zip(next).map(|(one, next)| one.and(next)).collect()
}

/// Merges the results of two parts, if both have one.
fn either<T>(one: Option<T>, next: Option<T>, and: impl FnOnce(T, T) -> T) -> Option<T> {
    match (one, next) {
        (Some(one), Some(next)) => Some(and(one, next)),
        (one, next) => one.or(next),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::coulomb::ReturnMap;

    #[test]
    fn what_one_part_alone_has_found_is_kept() {
        let joined = |one, next| either(one, next, |one: usize, next| 10 * one + next);
        assert_eq!(joined(Some(1), Some(2)), Some(12));
        assert_eq!((joined(Some(1), None), joined(None, Some(2)), joined(None, None)), (Some(1), Some(2), None));
    }

    /// Consecutive parts with these indices, with `count` checks each.
    fn part(shards: [usize; 2], of: usize, samples: usize, count: usize) -> Part {
        let shard = Shard::new(2, 2).expect("there is one");
        let mut part = Part::of(&Subject::of::<ReturnMap>(), &Options { samples: 0, seed: 1 }, shard);
        assert!(!part.comparisons.is_empty());
        part.comparisons.iter_mut().for_each(|comparison| comparison.counts = [count, 2 * count]);
        part.audit.named_points = count;
        part.audit.searched_points = 3 * count;
        part.audit.random_points = 5 * count;
        Part { shards, of, samples, ..part }
    }

    #[test]
    fn parts_are_joined_that_follow_one_another_in_one_audit() {
        let why = |one: Part, next: Part| one.and(next).expect_err("it is refused").to_string();
        let second = part([2, 3], 5, 8, 10);
        assert_eq!((second.first(), second.formula()), (2, "coulomb.return_map"));
        let found = second.clone().and(part([4, 5], 5, 8, 7)).expect("it follows");
        assert_eq!(found.shards, [2, 5]);
        assert!(found.comparisons.iter().all(|comparison| comparison.counts == [17, 34]));
        let audit = &found.audit;
        assert_eq!([audit.named_points, audit.searched_points, audit.random_points], [17, 51, 85]);
        assert_eq!(why(second.clone(), part([3, 4], 5, 8, 7)), "coulomb.return_map: part 3 of 5 does not follow 3");
        let expected = "parts of two audits: coulomb.return_map, 8 points of seed 1, in 5 parts; \
                        coulomb.return_map, 9 points of seed 1, in 5 parts";
        assert_eq!(why(second.clone(), part([4, 5], 5, 9, 7)), expected);
        assert!(why(second, part([4, 5], 6, 8, 7)).ends_with("in 6 parts"));
        let missing = found.into_audit().expect_err("the first is missing").to_string();
        assert_eq!(missing, "coulomb.return_map: parts 2 to 5 of 5 are not all");
    }
}
