//! What one mistake explains all that was found. Mistakes are tried in 237 bits, the simplest first; where none explains every
//! number at every point, nothing is said but that.

mod altered;
mod factors;
mod inputs;
mod mistakes;
mod observed;
mod permuted;
mod state;
mod wording;

use super::answer::Answer;
use super::map::names;
use super::question::{Own, Wanted, sizes};
use super::verdict::{Court, Verdict};
use jointproof::verify::{Judge, Known};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::ops::Range;

/// So many numbers are kept to try mistakes on, and so many points at which nothing is off.
const NUMBERS: usize = 400_000;
const RIGHT: usize = 200;
/// What is seen at fewer points may be chance.
const LEAST: usize = 3;

/// A point, what has to be there, and what was found.
struct Sample {
    question: usize,
    expected: Vec<Option<Known>>,
    found: Vec<Option<f64>>,
    /// The condition of the kink that it is on.
    kink: Option<String>,
}

/// All that a mistake has to explain.
struct Evidence<'a> {
    court: &'a Court<'a>,
    samples: Vec<Sample>,
    names: Vec<String>,
    /// The numbers that are off somewhere.
    off: Vec<usize>,
}

/// What is known of the cause, a line each.
pub(super) fn diagnose(court: &Court<'_>, answers: &[Vec<Answer>; 2], verdict: &Verdict) -> Vec<String> {
    if verdict.off.is_empty() {
        return Vec::new();
    }
    if !verdict.two_answers.is_empty() {
        return vec![state::diagnose(court, answers, verdict)];
    }
    let evidence = Evidence::new(court, &answers[0], verdict);
    if let Some(what) = observed::on_kinks(&evidence) {
        return vec![what];
    }
    let points = evidence.off_samples(&evidence.off).len();
    if points < LEAST {
        return vec![format!("unexplained: it is off at {points} points alone")];
    }
    evidence.explain()
}

impl<'a> Evidence<'a> {
    fn new(court: &'a Court<'a>, answers: &[Answer], verdict: &Verdict) -> Self {
        let most = NUMBERS / court.wanted.numbers(sizes(court.formula)) + LEAST;
        let is_valid = |k: &usize| matches!(court.questions[*k].own, Own::Results(_));
        let right = (0..answers.len()).filter(|k| is_valid(k) && verdict.off.binary_search(k).is_err());
        // Points drawn at random are in general position.
        let (random, named): (Vec<usize>, _) =
            verdict.off.iter().partition(|&&k| court.questions[k].name.starts_with("random "));
        let chosen: Vec<_> = random.into_iter().chain(named).take(most).chain(right.take(RIGHT.min(most))).collect();
        let samples: Vec<_> = chosen
            .par_iter()
            .map_init(|| court.formula.judge(), |judge, &k| Sample::new(court, judge, k, &answers[k]))
            .flatten()
            .collect();
        let names = names(court.formula.inputs(), court.formula.outputs(), court.wanted);
        let off = (0..names.len()).filter(|&place| verdict.tallies.get(place).is_some_and(|tally| tally.off > 0));
        let off = off.collect();
        Self { court, samples, names, off }
    }

    /// The outputs, and what follows them.
    fn parts(&self) -> [Range<usize>; 2] {
        let m = sizes(self.court.formula)[1];
        [0..m, m..self.names.len()]
    }

    /// The numbers of a part that are off.
    fn off_in(&self, part: &Range<usize>) -> Vec<usize> {
        self.off.iter().copied().filter(|place| part.contains(place)).collect()
    }

    /// How much a number may differ from what a mistake would compute.
    fn tolerance(&self, place: usize) -> f64 {
        16.0 + 4.0 * self.court.bound(place)
    }

    fn is_off(&self, sample: &Sample, place: usize) -> bool {
        match (sample.found[place], &sample.expected[place]) {
            (Some(found), Some(known)) => known.eta(found) > self.court.bound(place),
            _ => false,
        }
    }

    /// The samples at which one of these numbers is off.
    fn off_samples(&self, places: &[usize]) -> Vec<&Sample> {
        self.samples.iter().filter(|sample| places.iter().any(|&place| self.is_off(sample, place))).collect()
    }

    /// Whether a number is, at every sample, what a mistake would compute; where that is not known it is not.
    fn is_always(&self, place: usize, predicted: impl Fn(&Sample) -> Option<Known>) -> bool {
        self.samples.iter().all(|sample| match (sample.found[place], &sample.expected[place]) {
            (Some(found), Some(_)) => predicted(sample).is_some_and(|known| known.eta(found) <= self.tolerance(place)),
            _ => true,
        })
    }

    /// One mistake for everything; else one for the value and one for the Jacobian.
    fn explain(&self) -> Vec<String> {
        let count = self.samples.len();
        let told = |what: String| format!("{what}: this explains all {count} points looked at");
        if let Some(what) = self.cause(&self.off) {
            return vec![told(what)];
        }
        let [value, rest] = self.parts().map(|part| self.off_in(&part));
        if value.is_empty() || rest.is_empty() {
            return vec!["unexplained".into()];
        }
        let of = |part: &str, off: &[usize]| match self.cause(off) {
            Some(what) => told(format!("{part}: {what}")),
            None => format!("{part}: unexplained"),
        };
        vec![of("value", &value), of("Jacobian", &rest)]
    }

    /// The mistake that makes these numbers what they are; all others of the part are as they should be.
    fn cause(&self, off: &[usize]) -> Option<String> {
        let linear = factors::cause(self, off).or_else(|| permuted::cause(self, off));
        if self.court.wanted == Wanted::Products {
            return linear;
        }
        linear
            .or_else(|| inputs::cause(self, off))
            .or_else(|| observed::single_precision(self, off))
            .or_else(|| altered::cause(self, off))
            .or_else(|| permuted::entries(self, off))
    }
}

impl Sample {
    fn new(court: &Court<'_>, judge: &Judge, question: usize, answer: &Answer) -> Option<Self> {
        let Answer::Numbers(found) = answer else { return None };
        let (truth, expected) = court.expected(judge, question);
        let kink = truth.kink.map(|(condition, _)| condition);
        Some(Self { question, expected, found: found.clone(), kink })
    }

    fn inputs<'a>(&self, evidence: &Evidence<'a>) -> &'a [f64] {
        &evidence.court.questions[self.question].inputs
    }
}
