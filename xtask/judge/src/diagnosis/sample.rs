//! The answers that a mistake has to explain: at points in general position, of ordinary sizes.

use crate::answer::Answer;
use crate::map::names;
use crate::question::{Kind, Question, sizes};
use crate::scale::scales;
use crate::verdict::Court;
use std::ops::Range;

/// Numbers may differ from the prediction of a mistake by this part of the deviation that it explains …
const SHARE: f64 = 1e-4;
/// … and by this part of their scale, which is rounding. Beside gross deviations much more may be rounding, in a program that
/// loses digits.
const ROUNDING: f64 = 2e-12;
const BESIDE_GROSS: f64 = 1e-9;
/// A deviation that is not due to lost digits.
const GROSS: f64 = 1e-6;
/// The number of points that mistakes are tried at.
const POINTS: usize = 160;
/// The numbers that are kept at most.
const NUMBERS: usize = 60_000;

/// Fewer points tell too little.
pub(super) const LEAST: usize = 3;

/// Rounded to single precision.
#[expect(clippy::cast_possible_truncation, reason = "the mistake that is looked for")]
pub(super) fn single(x: f64) -> f32 {
    x as f32
}

/// A point, with the right and the computed numbers.
#[derive(Clone)]
pub(super) struct Sample {
    pub(super) inputs: Vec<f64>,
    pub(super) right: Vec<f64>,
    /// The scale of every number: the size of the vector, row and block that it belongs to.
    pub(super) scale: Vec<f64>,
    pub(super) found: Vec<Option<f64>>,
    /// The part of a scale that is rounding.
    rounding: f64,
}

/// The answers that a mistake has to explain.
pub(super) struct Evidence<'a> {
    pub(super) court: &'a Court<'a>,
    pub(super) samples: Vec<Sample>,
    pub(super) names: Vec<String>,
    /// The numbers that are wrong somewhere.
    pub(super) off: Vec<usize>,
}

impl Sample {
    pub(super) fn new(court: &Court<'_>, question: &Question, answer: &Answer) -> Option<Self> {
        let Answer::Numbers(found) = answer else { return None };
        let right = question.right(court.formula, court.wanted)?;
        let scale = scales(court.formula, court.wanted, question, &right)?;
        Some(Self { inputs: question.inputs.clone(), right, scale, found: found.clone(), rounding: ROUNDING })
    }

    /// The deviation of a number, relative to its scale; `None` if it is not given.
    pub(super) fn deviation(&self, place: usize) -> Option<f64> {
        let deviation = (self.found[place]? - self.right[place]).abs() / self.scale[place];
        Some(if deviation.is_nan() {
            if self.found[place] == Some(self.right[place]) { 0.0 } else { f64::INFINITY }
        } else {
            deviation
        })
    }

    /// Whether a number differs from the right one by more than rounding.
    pub(super) fn is_off(&self, place: usize) -> bool {
        self.deviation(place).is_some_and(|deviation| deviation > self.rounding)
    }

    /// Whether a prediction is the number found; true where none is given.
    pub(super) fn fits(&self, place: usize, predicted: f64) -> bool {
        let Some(found) = self.found[place] else { return true };
        if found.is_nan() || predicted.is_nan() {
            return found.is_nan() && predicted.is_nan();
        }
        let deviation = (found - self.right[place]).abs();
        if found.is_infinite() || predicted.is_infinite() {
            return found == predicted;
        }
        let rounding = self.rounding * self.scale[place].max(predicted.abs());
        (found - predicted).abs() <= SHARE.mul_add(deviation, rounding)
    }

    /// Whether it is the right number, rounded to single precision.
    pub(super) fn is_rounding_of_right(&self, place: usize) -> bool {
        let Some(found) = self.found[place] else { return true };
        let (single, right) = (single(found), single(self.right[place]));
        single == right || (f64::from(single) - self.right[place]).abs() <= 1.3e-7 * self.right[place].abs()
    }
}

impl<'a> Evidence<'a> {
    /// From the answers to these questions, of which those with wrong numbers come first.
    pub(super) fn new(court: &'a Court<'a>, answers: &[Answer], questions: impl Iterator<Item = usize>) -> Self {
        let most = (NUMBERS / court.wanted.numbers(sizes(court.formula))).clamp(12, POINTS);
        let sample = |k: usize| Sample::new(court, &court.questions[k], &answers[k]);
        // Points in general position come first.
        let is_special = |k: &usize| court.questions[*k].kind == Kind::Special;
        let (special, general): (Vec<_>, Vec<_>) = questions.partition(is_special);
        let samples: Vec<_> = general.into_iter().chain(special).filter_map(sample).collect();
        let (off, right): (Vec<_>, Vec<_>) =
            samples.into_iter().partition(|sample| (0..sample.right.len()).any(|place| sample.is_off(place)));
        let kept = most - right.len().min(most / 4);
        let samples: Vec<_> = off.into_iter().take(kept).chain(right.into_iter().take(most / 4)).collect();
        Self::of(court, samples)
    }

    /// The evidence of these samples.
    pub(super) fn of(court: &'a Court<'a>, mut samples: Vec<Sample>) -> Self {
        let largest = |sample: &Sample| {
            let all = (0..sample.right.len()).filter_map(|place| sample.deviation(place));
            all.filter(|deviation| deviation.is_finite()).fold(0.0, f64::max)
        };
        let gross = samples.iter().filter(|sample| largest(sample) > GROSS).count();
        for sample in &mut samples {
            // Large wrong numbers have large rounding errors, also in the small ones beside them.
            sample.rounding = if gross >= 3 { BESIDE_GROSS.max(1e-12 * largest(sample)) } else { ROUNDING };
        }
        let names = names(court.formula.inputs(), court.formula.outputs(), court.wanted);
        let off = (0..names.len()).filter(|&place| samples.iter().any(|sample| sample.is_off(place))).collect();
        Self { court, samples, names, off }
    }

    /// The indices of the outputs, and of the numbers that follow them.
    pub(super) fn parts(&self) -> [Range<usize>; 2] {
        let m = sizes(self.court.formula)[1];
        [0..m, m..self.names.len()]
    }

    /// Whether something holds at 19 of 20 samples: at a few special ones the numbers of either side are right.
    pub(super) fn nearly_all(&self, holds: impl Fn(&Sample) -> bool) -> bool {
        self.samples.iter().filter(|sample| holds(sample)).count() * 20 >= self.samples.len() * 19
    }

    /// The samples at which one of these numbers is wrong.
    pub(super) fn off_samples(&self, places: &[usize]) -> Vec<&Sample> {
        self.samples.iter().filter(|sample| places.iter().any(|&place| sample.is_off(place))).collect()
    }
}
