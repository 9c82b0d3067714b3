//! The evidence that a mistake has to explain.

use crate::answer::Answer;
use crate::map::names;
use crate::question::{Own, sizes};
use crate::verdict::{Court, Verdict};
use jointproof::toolkit::verify::{Judge, Known};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::ops::Range;

/// The limit on numbers kept to try mistakes on, and on points without wrong numbers.
const NUMBERS: usize = 400_000;
const RIGHT: usize = 200;
/// What is observed at fewer points may be chance.
pub(super) const LEAST: usize = 3;

/// A point, with the expected and the computed numbers.
pub(super) struct Sample {
    pub(super) question: usize,
    pub(super) expected: Vec<Option<Known>>,
    pub(super) found: Vec<Option<f64>>,
    /// The condition of the kink that it is on.
    pub(super) kink: Option<String>,
}

/// The evidence that a mistake has to explain.
pub(super) struct Evidence<'a> {
    pub(super) court: &'a Court<'a>,
    pub(super) samples: Vec<Sample>,
    pub(super) names: Vec<String>,
    /// The numbers that are wrong somewhere.
    pub(super) off: Vec<usize>,
}

impl<'a> Evidence<'a> {
    pub(super) fn new(court: &'a Court<'a>, answers: &[Answer], verdict: &Verdict) -> Self {
        let most = NUMBERS / court.wanted.numbers(sizes(court.formula));
        let is_valid = |k: &usize| matches!(court.questions[*k].own, Own::Results(_));
        let right = (0..answers.len()).filter(|k| is_valid(k) && verdict.off.binary_search(k).is_err());
        // Random points are in general position.
        let (random, named): (Vec<usize>, _) =
            verdict.off.iter().partition(|&&k| court.questions[k].name.starts_with("random "));
        let chosen: Vec<_> = random.into_iter().chain(named).take(most).chain(right.take(RIGHT.min(most))).collect();
        let samples: Vec<_> = chosen
            .par_iter()
            .map_init(|| court.formula.judge(), |judge, &k| Sample::new(court, judge, k, &answers[k]))
            .flatten()
            // If a rounding error decides on which side of a kink a point is, its answer tells nothing about the program.
            .filter(|sample| sample.kink.is_some() || !court.is_beside_kink(sample.question))
            .collect();
        let names = names(court.formula.inputs(), court.formula.outputs(), court.wanted);
        let mut evidence = Self { court, samples, names, off: Vec::new() };
        let is_off = |place: &usize| evidence.samples.iter().any(|sample| evidence.is_off(sample, *place));
        evidence.off = (0..evidence.names.len()).filter(is_off).collect();
        evidence
    }

    /// The indices of the outputs, and of the numbers that follow them.
    pub(super) fn parts(&self) -> [Range<usize>; 2] {
        let m = sizes(self.court.formula)[1];
        [0..m, m..self.names.len()]
    }

    /// The wrong numbers of a part.
    pub(super) fn off_in(&self, part: &Range<usize>) -> Vec<usize> {
        self.off.iter().copied().filter(|place| part.contains(place)).collect()
    }

    /// How much a number may differ from the prediction of a mistake.
    pub(super) fn tolerance(&self, place: usize) -> f64 {
        16.0 + 4.0 * self.court.bound(place)
    }

    pub(super) fn is_off(&self, sample: &Sample, place: usize) -> bool {
        match (sample.found[place], &sample.expected[place]) {
            (Some(found), Some(known)) => known.eta(found) > self.court.bound(place),
            _ => false,
        }
    }

    /// The samples at which one of these numbers is wrong.
    pub(super) fn off_samples(&self, places: &[usize]) -> Vec<&Sample> {
        self.samples.iter().filter(|sample| places.iter().any(|&place| self.is_off(sample, place))).collect()
    }

    /// Whether a number agrees with a mistake's prediction at every sample; without a prediction it does not.
    pub(super) fn is_always(&self, place: usize, predicted: impl Fn(&Sample) -> Option<Known>) -> bool {
        self.samples.iter().all(|sample| match (sample.found[place], &sample.expected[place]) {
            (Some(found), Some(_)) => predicted(sample).is_some_and(|known| known.eta(found) <= self.tolerance(place)),
            _ => true,
        })
    }
}

impl Sample {
    fn new(court: &Court<'_>, judge: &Judge, question: usize, answer: &Answer) -> Option<Self> {
        let Answer::Numbers(found) = answer else { return None };
        let (truth, expected) = court.expected(judge, question);
        let kink = truth.kink.map(|(condition, _)| condition);
        Some(Self { question, expected, found: found.clone(), kink })
    }

    pub(super) fn inputs<'a>(&self, evidence: &Evidence<'a>) -> &'a [f64] {
        &evidence.court.questions[self.question].inputs
    }
}
