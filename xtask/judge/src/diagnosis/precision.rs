//! Patterns in the digits of the wrong numbers: single precision, and differences in place of derivatives.

use super::sample::{Evidence, single};

/// Deviations of arithmetic in single precision, relative to the right numbers: their median.
const SINGLE: std::ops::RangeInclusive<f64> = 3e-10..=3e-6;
/// Deviations of finite differences.
const DIFFERENCES: std::ops::RangeInclusive<f64> = 1e-12..=3e-4;
/// Deviations below are those of any program.
const NOTHING: f64 = 1e-12;
/// How many numbers have to show a pattern.
const LEAST: usize = 12;

/// The pattern of all wrong numbers, in words.
pub(super) fn cause(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let mut deviations: Vec<f64> = Vec::new();
    let (mut given, mut rounded) = (0, 0);
    for sample in &evidence.samples {
        for &place in off {
            let Some(found) = sample.found[place] else { continue };
            let right = sample.right[place];
            if right != 0.0 {
                deviations.push(((found - right) / right).abs());
            }
            if found != 0.0 && found.is_finite() {
                given += 1;
                rounded += usize::from(f64::from(single(found)) == found);
            }
        }
    }
    if given < LEAST {
        return None;
    }
    // What is right by chance, or because it is not affected, tells nothing.
    deviations.retain(|deviation| *deviation > NOTHING);
    deviations.sort_by(f64::total_cmp);
    if deviations.len() < LEAST {
        return None;
    }
    let at = |share: usize| deviations[(deviations.len() - 1) * share / 100];
    let m = evidence.parts()[0].len();
    if rounded == given && at(95) < 1e-3 {
        let half = |place: &usize| evidence.samples.iter().all(|sample| sample.is_rounding_of_right(*place));
        return Some(if off.iter().all(half) {
            "results are rounded to single precision".into()
        } else {
            "the arithmetic has single precision (32 bits)".into()
        });
    }
    let is_common = deviations.len() * 4 > given;
    if off.iter().all(|&place| place >= m)
        && DIFFERENCES.contains(&at(50))
        && at(90) < 1e-2
        && is_common
        && spread(&deviations)
    {
        return Some("the derivatives are finite differences, or have as few digits".into());
    }
    (SINGLE.contains(&at(50)) && at(95) < 1e-3 && spread(&deviations))
        .then(|| "the arithmetic has single precision (32 bits) on the way".into())
}

/// Whether deviations look like rounding: of many sizes, and none of them common.
fn spread(sorted: &[f64]) -> bool {
    let distinct = sorted.windows(2).filter(|pair| pair[1] > pair[0] * (1.0 + 1e-9)).count();
    distinct * 2 > sorted.len() && sorted[sorted.len() * 9 / 10] > 1.5 * sorted[sorted.len() / 10]
}
