//! Wrong numbers that are constant multiples of the right ones.

use super::model::Map;
use super::sample::Evidence;
use jointproof::formula::Field;
use std::collections::BTreeSet;

/// Factors with names.
const NAMED: [(f64, &str); 10] = [
    (-1.0, "wrong sign:"),
    (0.0, "left out (always 0):"),
    (2.0, "a factor of 2 too much in"),
    (0.5, "a factor of ½ too much in"),
    (-2.0, "a factor of −2 too much in"),
    (-0.5, "a factor of −½ too much in"),
    (4.0, "a factor of 4 too much in"),
    (0.25, "a factor of ¼ too much in"),
    (std::f64::consts::PI / 180.0, "degrees for radians (a factor of π/180) in"),
    (180.0 / std::f64::consts::PI, "degrees for radians (a factor of 180/π) in"),
];

/// What is observed at fewer points may be chance.
const LEAST: usize = 3;

/// Groups of wrong numbers with a common factor, the largest first, in words.
pub(super) fn groups(evidence: &Evidence<'_>) -> Vec<(String, Map)> {
    let mut groups: Vec<(f64, BTreeSet<usize>)> = Vec::new();
    for &place in &evidence.off {
        let Some(factor) = factor(evidence, place) else { continue };
        match groups.iter_mut().find(|(other, _)| (other - factor).abs() <= 1e-9 * factor.abs()) {
            Some((_, places)) => drop(places.insert(place)),
            None => groups.push((factor, BTreeSet::from([place]))),
        }
    }
    groups.sort_by_key(|(_, places)| std::cmp::Reverse(places.len()));
    let worded = |(factor, places): (f64, BTreeSet<usize>)| {
        let what = format!("{} {}", word(factor)?, whose(evidence, &places));
        Some((what, places.into_iter().map(|place| (place, vec![(place, factor)])).collect()))
    };
    groups.into_iter().filter_map(worded).collect()
}

/// The constant factor of a number at all samples.
fn factor(evidence: &Evidence<'_>, place: usize) -> Option<f64> {
    let mut seen = evidence.off_samples(&[place]);
    if seen.len() < LEAST {
        return None;
    }
    // The factor is most accurate where the number is large compared with its scale.
    let size = |sample: &&super::sample::Sample| (sample.right[place] / sample.scale[place]).abs();
    seen.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let ratio = seen[0].found[place]? / seen[0].right[place];
    let named = NAMED.iter().map(|(factor, _)| *factor).find(|factor| (factor - ratio).abs() <= 1e-11 * ratio.abs());
    let factor = named.unwrap_or(ratio);
    // A number that never changes is consistent with any factor.
    let is_constant = seen.iter().all(|sample| sample.right[place] == seen[0].right[place]);
    let fits = |sample: &super::sample::Sample| sample.fits(place, sample.right[place] * factor);
    (factor.is_finite() && !(named.is_none() && is_constant) && evidence.nearly_all(fits)).then_some(factor)
}

pub(super) fn word(factor: f64) -> Option<String> {
    if let Some((_, word)) = NAMED.iter().find(|(named, _)| *named == factor) {
        return Some((*word).to_owned());
    }
    let deviation = (factor - 1.0).abs();
    if (1e-10..2e-7).contains(&deviation) {
        return Some(format!("a constant of single precision (a factor of {factor:?}) in"));
    }
    (deviation >= 1e-4).then(|| format!("a factor of {factor:.6} too much in"))
}

/// A name for these numbers, in as few words as possible.
pub(super) fn whose(evidence: &Evidence<'_>, places: &BTreeSet<usize>) -> String {
    let [value, rest] = evidence.parts();
    let alive = |place: &usize| evidence.samples.iter().any(|sample| sample.right[*place] != 0.0);
    let all: BTreeSet<usize> = rest.clone().filter(alive).collect();
    let (values, rest): (BTreeSet<usize>, BTreeSet<usize>) = places.iter().partition(|place| value.contains(place));
    let (inputs, outputs) = (evidence.court.formula.inputs(), evidence.court.formula.outputs());
    if evidence.names.len() != value.len() * (1 + count(inputs)) {
        return list(&evidence.names, places);
    }
    let derivatives = || {
        if rest == all && all.len() > 1 {
            return "the whole Jacobian".to_owned();
        }
        let [m, n] = [value.len(), count(inputs)];
        let rows = lines(outputs, &rest, &all, |i| (0..n).map(|j| m + i * n + j).collect());
        let columns = lines(inputs, &rest, &all, |j| (0..m).map(|i| m + i * n + j).collect());
        match (rows, columns) {
            (Some(names), _) if rest.len() > 1 => format!("the derivatives of {}", names.join(", ")),
            (_, Some(names)) if rest.len() > 1 => format!("the derivatives with respect to {}", names.join(", ")),
            _ => list(&evidence.names, &rest),
        }
    };
    match (values.is_empty(), rest.is_empty()) {
        (true, _) => derivatives(),
        (false, true) => list(&evidence.names, &values),
        (false, false) => format!("{}, and {}", list(&evidence.names, &values), derivatives()),
    }
}

fn count(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

/// Whether these entries are exactly certain rows or columns, and which: whole fields by their names, else components.
fn lines(
    fields: &[Field],
    entries: &BTreeSet<usize>,
    all: &BTreeSet<usize>,
    line: impl Fn(usize) -> BTreeSet<usize>,
) -> Option<Vec<String>> {
    let (mut names, mut covered, mut next) = (Vec::new(), BTreeSet::new(), 0);
    for field in fields {
        let components: Vec<_> = (0..field.len()).map(|k| (k, &line(next + k) & all)).collect();
        next += field.len();
        let held: Vec<_> = components.iter().filter(|(_, line)| !line.is_empty() && line.is_subset(entries)).collect();
        covered.extend(held.iter().flat_map(|(_, line)| line));
        if held.len() == components.iter().filter(|(_, line)| !line.is_empty()).count() && !held.is_empty() {
            names.push(field.name.to_owned());
        } else {
            names.extend(held.iter().map(|(k, _)| format!("{}[{k}]", field.name)));
        }
    }
    (covered == *entries).then_some(names)
}

/// Numbers by their names.
pub(super) fn list(names: &[String], places: &BTreeSet<usize>) -> String {
    let mut listed: Vec<_> = places.iter().take(4).map(|&place| names[place].clone()).collect();
    if places.len() > 4 {
        listed.push(format!("{} more", places.len() - 4));
    }
    listed.join(", ")
}
