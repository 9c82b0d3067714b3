//! Misinterpreted inputs: in degrees, in single precision, exchanged, or with the opposite sign.

use super::evidence::{Evidence, LEAST, Sample};
use super::observed::rounded;
use jointproof::formula::Field;
use jointproof::formula::quantity::{Domain, Unit};
use jointproof::toolkit::verify::Known;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::f64::consts::PI;

/// Other inputs in place of the ones given.
pub(super) struct Other {
    pub(super) what: String,
    /// The source of each component, and its factor.
    from: Vec<(usize, f64)>,
    is_single: bool,
}

impl Other {
    pub(super) fn of(&self, inputs: &[f64]) -> Vec<f64> {
        let single = |x: f64| if self.is_single { f64::from(rounded(x)) } else { x };
        self.from.iter().map(|&(place, factor)| single(inputs[place] * factor)).collect()
    }
}

/// How the Jacobian follows from the other inputs.
#[derive(Clone, Copy, PartialEq)]
enum Chain {
    /// As it is at the other inputs.
    There,
    /// With respect to the original inputs.
    ByOriginals,
}

/// The mistake in the inputs that explains these numbers, in words.
pub(super) fn cause(evidence: &Evidence<'_>, off: &[usize]) -> Option<String> {
    let samples = evidence.off_samples(off);
    if samples.len() < LEAST {
        return None;
    }
    // With other inputs all results are affected, including those that happen to be right.
    let parts = evidence.parts().into_iter().filter(|part| !evidence.off_in(part).is_empty());
    let parts: Vec<_> = parts.filter(|part| off.iter().any(|place| part.contains(place))).flatten().collect();
    let off = parts.as_slice();
    let inputs = evidence.court.formula.inputs();
    let chains = [Chain::ByOriginals, Chain::There];
    let fits = |other: &Other| {
        chains.into_iter().any(|chain| {
            samples[..LEAST].iter().all(|sample| is_near(evidence, sample, off, other, chain))
                && is_exact(evidence, off, other, chain)
        })
    };
    others(inputs).into_iter().find(fits).map(|other| other.what)
}

/// Whether the wrong numbers are approximately, in doubles, those for the other inputs.
fn is_near(evidence: &Evidence<'_>, sample: &Sample, off: &[usize], other: &Other, chain: Chain) -> bool {
    let there = other.of(sample.inputs(evidence));
    let Ok((value, jacobian)) = evidence.court.formula.value_and_jacobian(&there) else { return false };
    let numbers = [value.clone(), jacobian].concat();
    let at = |place: usize| -> f64 {
        let terms = sources(other, chain, value.len(), place);
        terms.into_iter().map(|(source, factor)| numbers[source] * factor).sum()
    };
    let fits = |&place: &usize| {
        let (Some(found), Some(known)) = (sample.found[place], &sample.expected[place]) else { return true };
        // Half of the digits agree, or the number is not wrong at all.
        let expected = at(place);
        known.with(expected.into()).eta(found) <= 1e8 || known.eta(found) <= evidence.tolerance(place)
    };
    off.iter().all(fits)
}

/// Whether they agree in 237 bits, at all samples.
fn is_exact(evidence: &Evidence<'_>, off: &[usize], other: &Other, chain: Chain) -> bool {
    let m = evidence.parts()[0].len();
    // Each part is checked as a whole.
    let has_jacobian = off.contains(&m);
    let samples: Vec<_> = evidence.samples.iter().collect();
    let formula = evidence.court.formula;
    let results = samples.par_iter().map_init(
        || formula.judge(),
        |judge, sample| {
            let Ok(truth) = judge.at(&other.of(sample.inputs(evidence)), has_jacobian) else { return false };
            let numbers: Vec<Known> = truth.value.into_iter().chain(truth.jacobian.into_iter().flatten()).collect();
            off.iter().all(|&place| {
                let (Some(found), Some(_)) = (sample.found[place], &sample.expected[place]) else { return true };
                let terms = sources(other, chain, m, place).into_iter();
                let terms: Option<Vec<_>> =
                    terms.map(|(source, factor)| Some((*numbers.get(source)?, factor))).collect();
                // On a kink there is nothing to compare with.
                let Some(terms) = terms else { return true };
                let known = match terms.as_slice() {
                    [(known, factor)] => known.times(*factor),
                    _ => Known::combined(terms.into_iter()),
                };
                known.eta(found) <= evidence.tolerance(place)
            })
        },
    );
    results.all(|fits| fits)
}

/// The numbers at the other inputs from which a number follows, each with its factor.
fn sources(other: &Other, chain: Chain, m: usize, place: usize) -> Vec<(usize, f64)> {
    if place < m || chain == Chain::There {
        return vec![(place, 1.0)];
    }
    let n = other.from.len();
    let (row, column) = ((place - m) / n, (place - m) % n);
    let follows = other.from.iter().enumerate().filter(|(_, (from, _))| *from == column);
    follows.map(|(k, (_, factor))| (m + row * n + k, *factor)).collect()
}

/// All mistakes in the inputs that are searched for.
pub(super) fn others(inputs: &[Field]) -> Vec<Other> {
    let count = inputs.iter().map(Field::len).sum();
    let same: Vec<_> = (0..count).map(|k| (k, 1.0)).collect();
    let mut starts = Vec::new();
    let mut start = 0;
    for field in inputs {
        starts.push((field, start));
        start += field.len();
    }
    let mut others = Vec::new();
    let mut add = |what: String, from: Vec<(usize, f64)>| others.push(Other { what, from, is_single: false });
    for &(field, start) in &starts {
        let components = start..start + field.len();
        let times = |factor: f64| {
            let scaled = |&(k, one): &(usize, f64)| (k, if components.contains(&k) { factor } else { one });
            same.iter().map(scaled).collect()
        };
        let name = field.name;
        if field.quantity.unit == Unit::ONE && field.len() == 1 && field.quantity.domain != Domain::NonNegative {
            add(format!("{name} is taken for degrees"), times(PI / 180.0));
            add(format!("{name} is converted to degrees"), times(180.0 / PI));
        }
        add(format!("the sign of the input {name} is turned"), times(-1.0));
        add(format!("the input {name} is taken twice"), times(2.0));
        add(format!("half of the input {name} is taken"), times(0.5));
        for a in components.clone() {
            for b in components.start..a {
                let mut from = same.clone();
                from.swap(a, b);
                add(format!("exchanged: the inputs {name}[{}] and {name}[{}]", b - start, a - start), from);
            }
        }
        for &(before, first) in starts.iter().take_while(|(before, _)| before.name != name) {
            if before.quantity.shape == field.quantity.shape {
                let mut from = same.clone();
                (0..field.len()).for_each(|k| from.swap(first + k, start + k));
                add(format!("exchanged: the inputs {} and {name}", before.name), from);
            }
        }
    }
    others.push(Other { what: "inputs are rounded to single precision".into(), from: same, is_single: true });
    others
}

#[cfg(test)]
mod tests {
    use super::others;
    use jointproof::catalog::find;

    #[test]
    fn single_numbers_without_a_unit_may_be_angles() {
        let degrees = |id| {
            let others = others(find(id).unwrap().inputs()).into_iter().map(|other| other.what);
            others.filter(|what| what.contains("degrees")).collect::<Vec<_>>()
        };
        assert_eq!(degrees("coulomb.yield"), [""; 0]);
        assert_eq!(degrees("slot.constraint"), [""; 0]);
        assert_eq!(degrees("universal.constraint"), ["c0 is taken for degrees", "c0 is converted to degrees"]);
    }
}
