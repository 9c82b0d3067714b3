//! The results of a measurement, as plain data.

use super::Scheme;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// All figures of one formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Measurement {
    /// The formula's identifier.
    pub formula: String,
    /// Number of input components.
    pub inputs: usize,
    /// Number of output components.
    pub outputs: usize,
    /// Random points at which errors were found.
    pub random_points: usize,
    /// Hard points: the cases flagged hard, and points beside every kink and on it.
    pub hard_points: usize,
    /// Time to copy inputs, outputs and a dense Jacobian, and do nothing else.
    pub copy: Option<Time>,
    /// Time of a fixed piece of arithmetic, the same for every formula: how fast the machine was meanwhile.
    pub yardstick: Option<Time>,
    /// Many points at once.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub columns: Option<Columns>,
    /// The ways, the closed form first.
    pub methods: Vec<MethodFigures>,
    /// Error of differences over their step.
    pub curves: Vec<Curve>,
}

impl Measurement {
    /// Merges the rounds of another measurement of the same formula: medians are the mean of both, and the spread
    /// covers both.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        for (ours, theirs) in self.methods.iter_mut().zip(&other.methods) {
            for (ours, theirs) in [(&mut ours.value, &theirs.value), (&mut ours.jacobian, &theirs.jacobian)] {
                if let (Some(ours), Some(theirs)) = (ours, theirs) {
                    ours.and(theirs);
                }
            }
        }
        self.copy = Time::of_both(self.copy, other.copy);
        self.yardstick = Time::of_both(self.yardstick, other.yardstick);
        self.columns = self.columns.zip(other.columns).map(|(ours, theirs)| ours.and(theirs));
        self
    }

    /// The method with this identifier.
    pub fn method(&self, id: &str) -> Option<&MethodFigures> {
        self.methods.iter().find(|method| method.id == id)
    }
}

/// Value and Jacobian over columns: nanoseconds a row, and ratios of times taken in the same round.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Columns {
    /// How many rows there are.
    pub rows: usize,
    /// Bytes that are read and written for a row: inputs, outputs, and entries of the Jacobian that are not zero everywhere.
    pub bytes: usize,
    /// All threads.
    pub threads: usize,
    /// A program's loop over the columns, checked.
    pub looped: Time,
    /// A batch on one thread.
    pub one_thread: Time,
    /// A batch on all threads.
    pub all_threads: Time,
    /// A batch on one thread, over the loop.
    pub one_over_loop: Time,
    /// A batch on all threads, over the loop.
    pub all_over_loop: Time,
    /// A batch on one thread, over copying as many bytes on one: what memory allows.
    pub one_over_copy: Time,
    /// A batch on all threads, over copying as many bytes on all.
    pub all_over_copy: Time,
}

impl Columns {
    fn and(self, other: Self) -> Self {
        Self {
            looped: self.looped.and(other.looped),
            one_thread: self.one_thread.and(other.one_thread),
            all_threads: self.all_threads.and(other.all_threads),
            one_over_loop: self.one_over_loop.and(other.one_over_loop),
            all_over_loop: self.all_over_loop.and(other.all_over_loop),
            one_over_copy: self.one_over_copy.and(other.one_over_copy),
            all_over_copy: self.all_over_copy.and(other.all_over_copy),
            ..self
        }
    }
}

/// The figures of one way to compute a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MethodFigures {
    /// Its identifier, as `closed` or `ad`.
    pub id: String,
    /// What it is.
    pub title: String,
    /// Of differences: their step, the best of the sweep.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// The value alone, where the way has one of its own.
    pub value: Option<Figures>,
    /// The Jacobian; its time is that of value and Jacobian together.
    pub jacobian: Option<Figures>,
}

/// How fast, and how wrong.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    /// Nanoseconds an evaluation.
    pub time: Option<Time>,
    /// Time in units of the closed form's value alone, measured in the same round.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<Time>,
    /// Times at hard points, one by one: of the closed form, with and without checks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub hard_times: Vec<PointTime>,
    /// Errors at random points.
    pub random: Errors,
    /// Errors at hard points, where the formula has any.
    pub hard: Option<Errors>,
}

impl Figures {
    /// The ordinary point that takes longest.
    pub fn hardest(&self) -> Option<&PointTime> {
        let ordinary = self.hard_times.iter().filter(|point| point.ordinary);
        ordinary.max_by(|a, b| a.ratio.median.total_cmp(&b.ratio.median))
    }

    /// Merges the rounds of another measurement of the same.
    fn and(&mut self, other: &Self) {
        self.time = Time::of_both(self.time, other.time);
        self.ratio = Time::of_both(self.ratio, other.ratio);
        for (ours, theirs) in self.hard_times.iter_mut().zip(&other.hard_times) {
            ours.time = ours.time.and(theirs.time);
            ours.ratio = ours.ratio.and(theirs.ratio);
        }
    }
}

/// Time at one hard point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointTime {
    /// The case, or the kink and the step away from it.
    pub case: String,
    /// Whether every number there is of a size that models have: zero, or from 1e-100 to 1e100.
    pub ordinary: bool,
    /// Nanoseconds an evaluation.
    pub time: Time,
    /// Time in units of that over random points, measured in the same round.
    pub ratio: Time,
}

/// A time, or a ratio of times: the median of the rounds, and between what values four of five rounds were. Of rounds in
/// two parts, the mean of the medians, and a spread for both.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// The median.
    pub median: f64,
    /// The 10th percentile.
    pub low: f64,
    /// The 90th percentile.
    pub high: f64,
}

impl Time {
    fn of_both(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        Some(one?.and(other?))
    }

    fn and(self, other: Self) -> Self {
        Self {
            median: f64::midpoint(self.median, other.median),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }
}

/// Errors over a set of points, each point counting by the worst of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Errors {
    /// How many points.
    pub points: usize,
    /// At how many of them the result was not finite; the quantiles leave these out.
    pub not_finite: usize,
    /// Backward error in units of 2⁻⁵³, see [`eta`](crate::toolkit::verify::eta).
    pub eta: Quantiles,
    /// The median relative error, see [`relative`](crate::toolkit::verify::relative): 1 means that no digit is right.
    pub relative: f64,
}

/// What a set of errors looks like; zeros where it is empty. In JSON these are three numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "[f64; 3]", into = "[f64; 3]")]
pub struct Quantiles {
    /// The median.
    pub median: f64,
    /// The 99th percentile.
    pub p99: f64,
    /// The largest.
    pub max: f64,
}

impl From<[f64; 3]> for Quantiles {
    fn from([median, p99, max]: [f64; 3]) -> Self {
        Self { median, p99, max }
    }
}

impl From<Quantiles> for [f64; 3] {
    fn from(Quantiles { median, p99, max }: Quantiles) -> Self {
        [median, p99, max]
    }
}

/// The number of decades that the steps of differences span.
const DECADES: usize = 14;

/// Error of a scheme of differences over its step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Curve {
    /// The scheme.
    pub scheme: Scheme,
    /// The median relative error of the Jacobian at random points, with each of the [`steps`](Self::steps).
    pub errors: Vec<f64>,
    /// Which step has the least error, of those with which the Jacobian is finite at most points.
    pub best: usize,
}

impl Curve {
    /// Steps of differences, `per_decade` for each decade from 1e-2 down to 1e-16, in units of the input's size.
    pub fn steps(per_decade: usize) -> impl Iterator<Item = f64> {
        #[expect(clippy::cast_precision_loss, reason = "a few steps")]
        let step = move |k: usize| 10.0_f64.powf(-2.0 - k as f64 / per_decade as f64);
        (0..=DECADES * per_decade).map(step)
    }

    /// Every step with its error.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        Self::steps(self.errors.len() / DECADES).zip(self.errors.iter().copied())
    }

    /// The best step with its error.
    pub fn best(&self) -> Option<(f64, f64)> {
        self.points().nth(self.best)
    }
}
