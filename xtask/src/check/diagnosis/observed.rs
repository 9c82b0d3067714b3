//! What is seen in the numbers themselves.

use super::evidence::{Evidence, LEAST};
use std::collections::BTreeSet;

/// It is off on kinks alone.
pub(super) fn on_kinks(evidence: &Evidence<'_>) -> Option<String> {
    let off = evidence.off_samples(&evidence.off);
    let kinks: BTreeSet<_> = off.iter().map(|sample| sample.kink.as_deref()).collect();
    let kinks: Option<Vec<_>> = kinks.into_iter().collect();
    let conditions = kinks.filter(|kinks| !kinks.is_empty())?.join(" and ");
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

/// All that is off has the digits of single precision alone.
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
            seen += 1;
        }
    }
    (seen >= LEAST).then(|| "results are rounded to single precision".to_owned())
}

/// In single precision.
#[expect(clippy::cast_possible_truncation, reason = "the mistake that is looked for")]
pub(super) fn rounded(x: f64) -> f32 {
    x as f32
}
