//! The claim that nothing overflows at inputs of a size that the formula states, at inputs drawn to break it.

use super::claim::Claim;
use super::point::{Names, Point};
use super::sample::Sampler;
use super::subject::Subject;
use crate::formula::Finite;
use crate::power::{exponent, power_of_two};

/// So many drawn from each point of the audit.
const DRAWS: usize = 4;

/// What the formula says of overflow, checked at inputs made of these points, before which there are so many others; `None` where
/// it says nothing.
pub(super) fn claim(subject: &Subject, names: &Names, points: &[Point], before: usize, seed: u64) -> Option<Claim> {
    let smallest = match subject.spec.finite {
        Finite::Unknown => return None,
        Finite::Below => f64::MIN_POSITIVE,
        Finite::Between => Finite::SMALLEST,
    };
    let mut claim = Claim::new("nothing overflows at inputs of the size that is stated, of so many results", 0.0);
    let mut draw = Extremes { sampler: Sampler::for_formula(subject.spec.id, !seed), smallest };
    draw.skip(before * DRAWS, names.inputs.len());
    for point in points {
        for _ in 0..DRAWS {
            let inputs = draw.beside(&point.inputs);
            if (subject.check)(&inputs).is_err() {
                continue;
            }
            let [value, jacobian] = (subject.linearized)(&inputs);
            let results = value.iter().chain(&jacobian);
            for (k, &result) in results.enumerate() {
                let entry = || k.checked_sub(value.len()).map_or_else(|| names.outputs[k].clone(), |k| names.entry(k));
                let at = |size| {
                    Point::new(subject, draw.label(&point.label), false, inputs.clone()).deviation(
                        size,
                        entry(),
                        result,
                        0.0,
                    )
                };
                claim.record(if result.is_finite() { 0.0 } else { f64::MAX }, 0.0, at);
            }
        }
    }
    Some(claim)
}

/// A source of inputs at the limits of what is stated.
struct Extremes {
    sampler: Sampler,
    smallest: f64,
}

impl Extremes {
    fn label(&self, from: &str) -> String {
        format!("extremes of {from}, from {:e} on", self.smallest)
    }

    /// Draws for so many points of so many components, whatever these are.
    fn skip(&mut self, points: usize, components: usize) {
        let point = vec![0.0; components];
        for _ in 0..points {
            self.beside(&point);
        }
    }

    /// The point with some components replaced: by 0, by another component or nearly that, so that they cancel, by the
    /// smallest and the largest number allowed, and by any number between these.
    fn beside(&mut self, point: &[f64]) -> Vec<f64> {
        let often = 1 + self.sampler.below(8);
        let mut inputs = point.to_vec();
        for k in 0..inputs.len() {
            if self.sampler.below(8) < often {
                let other = inputs[self.sampler.below(inputs.len())];
                let replaced = self.number(other);
                if replaced == 0.0 || (self.smallest..Finite::LARGEST).contains(&replaced.abs()) {
                    inputs[k] = replaced;
                }
            }
        }
        inputs
    }

    fn number(&mut self, other: f64) -> f64 {
        let size = match self.sampler.below(7) {
            0 => 0.0,
            1 => other,
            2 => other.next_up(),
            3 => other.next_down(),
            4 => self.smallest,
            5 => Finite::LARGEST.next_down(),
            _ => self.between(),
        };
        if self.sampler.below(2) == 0 { size } else { -size }
    }

    /// Every power of two equally likely.
    fn between(&mut self) -> f64 {
        let drawn = self.sampler.whole(exponent(self.smallest)..=exponent(Finite::LARGEST) - 1);
        power_of_two(drawn) * (1.0 + self.sampler.unit())
    }
}
