//! The extent of a measurement.

use crate::toolkit::verify::{Sampler, Subject};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How much to measure.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Options {
    /// Seed of the random points.
    pub seed: u64,
    /// Random points at which errors are found.
    pub random_points: usize,
    /// Random points over which time is taken; the first of the same sequence.
    pub timing_points: usize,
    /// Steps a decade in the sweep of differences from 1e-2 to 1e-16.
    pub steps_per_decade: usize,
    /// How often each way is timed, all ways taking turns.
    pub rounds: usize,
    /// How long one turn lasts, in nanoseconds.
    pub turn_ns: f64,
    /// Bytes of the columns of many points.
    #[serde(default)]
    pub column_bytes: usize,
}

impl Options {
    /// About a tenth of a second per formula.
    pub const fn quick() -> Self {
        Self {
            seed: 1,
            random_points: 50,
            timing_points: 128,
            steps_per_decade: 2,
            rounds: 61,
            turn_ns: 60e3,
            column_bytes: 1 << 19,
        }
    }

    /// Several seconds per formula.
    pub const fn full() -> Self {
        Self {
            seed: 1,
            random_points: 1000,
            timing_points: 128,
            steps_per_decade: 4,
            rounds: 301,
            turn_ns: 300e3,
            // More than the caches of most processors.
            column_bytes: 1 << 27,
        }
    }

    /// The points used for timing, as components.
    pub(crate) fn timing_inputs(&self, subject: &Subject) -> Vec<Vec<f64>> {
        random(subject, self.seed, self.timing_points)
    }
}

/// The first random inputs of a seed.
pub(super) fn random(subject: &Subject, seed: u64, count: usize) -> Vec<Vec<f64>> {
    let mut sampler = Sampler::for_formula(subject.spec.id, seed);
    (0..count).map(|_| sampler.components(subject)).collect()
}

#[cfg(test)]
mod tests {
    use super::Options;

    /// As stated in `report --help` and in the book.
    #[test]
    fn as_much_is_measured_as_is_said() {
        let [quick, full] = [Options::quick(), Options::full()];
        for Options { seed, timing_points, .. } in [quick, full] {
            assert_eq!((seed, timing_points), (1, 128));
        }
        let counts = [quick, full].map(|it| (it.random_points, it.steps_per_decade, it.rounds, it.column_bytes));
        assert_eq!(counts, [(50, 2, 61, 524_288), (1000, 4, 301, 134_217_728)]);
    }
}
