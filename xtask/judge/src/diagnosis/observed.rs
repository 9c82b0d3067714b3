//! Patterns in the wrong numbers themselves.

use super::evidence::{Evidence, LEAST};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// Numbers are wrong only on kinks.
pub(super) fn on_kinks(evidence: &Evidence<'_>) -> Option<String> {
    let off = evidence.off_samples(&evidence.off);
    let kinks: BTreeSet<_> = off.iter().map(|sample| sample.kink.as_deref()).collect();
    let kinks: Option<Vec<_>> = kinks.into_iter().collect();
    let conditions = kinks?.join(" and ");
    let numbers = off.iter().flat_map(|sample| {
        evidence.off.iter().filter(|&&place| evidence.is_off(sample, place)).filter_map(|&place| sample.found[place])
    });
    let (count, mut numbers) = (off.len(), numbers.peekable());
    numbers.peek()?;
    Some(if numbers.all(f64::is_nan) {
        format!("NaN on the kink {conditions}, and right elsewhere ({count} points)")
    } else {
        format!("on the kink {conditions} another convention, and right elsewhere ({count} points)")
    })
}

/// All wrong numbers have only the digits of single precision.
pub(super) fn single_precision(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let samples = evidence.off_samples(off);
    let mut seen = 0;
    for sample in samples {
        for &place in off.iter().filter(|&&place| evidence.is_off(sample, place)) {
            let (found, known) = (sample.found[place]?, sample.expected[place].as_ref()?);
            let own = known.exact.to_f64();
            if found != f64::from(rounded(found)) || found != f64::from(rounded(own)) {
                return None;
            }
            // An overflow occurs in either precision.
            seen += usize::from(found.is_finite());
        }
    }
    (seen >= LEAST).then(|| "results are rounded to single precision".to_owned())
}

/// Numbers whose squares are in the range of doubles, with a margin.
const SQUARED: RangeInclusive<f64> = 1e-140..=1e140;

/// Numbers are wrong where squares of inputs leave the range of doubles, and right elsewhere.
pub(super) fn out_of_range(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let samples = evidence.off_samples(off);
    let is_extreme = |x: &f64| *x != 0.0 && !SQUARED.contains(&x.abs());
    let all_are = samples.iter().all(|sample| sample.inputs(evidence).iter().any(is_extreme));
    let is_lost = |x: f64| x == 0.0 || !x.is_finite();
    let lost = samples.iter().filter(|sample| {
        let mut found = off.iter().filter(|&&place| evidence.is_off(sample, place)).filter_map(|&k| sample.found[k]);
        found.any(is_lost)
    });
    let (count, lost) = (samples.len(), lost.count());
    (all_are && count >= LEAST && lost > 0).then(|| {
        let (least, most) = (SQUARED.start(), SQUARED.end());
        format!(
            "right but for inputs below {least:e} or above {most:e}, where {lost} of {count} points give 0, NaN or an infinity: a \
             square or a product on the way leaves the range of doubles"
        )
    })
}

/// Rounded to single precision.
#[expect(clippy::cast_possible_truncation, reason = "the mistake that is looked for")]
pub(super) fn rounded(x: f64) -> f32 {
    x as f32
}
