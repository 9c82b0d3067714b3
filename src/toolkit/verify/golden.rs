//! Golden files: the cases of a formula with their exact results, to test any code in any language against.
//!
//! Values and Jacobians are computed in 237 bits and rounded once to the nearest double, so that a file has the same
//! bytes on every machine. Each number is accompanied by its scale, so that a port can be judged by the backward error
//! η without a derivative of its own.

mod compare;
mod file;
mod layout;
mod numbers;
mod schema;

pub use compare::{Difference, ulps};
pub use file::{Bounds, Description, File, LAYOUT, LEAST_CASES, Provenance, Record};
pub use numbers::components;
pub use numbers::named;

use super::branches::spread;
use super::subject::Subject;
use super::{Sampler, Sensitivity, exact, rounded};
use crate::Octuple;
use crate::formula::Field;
use crate::formula::proof::{Case, Convention, Flag};
use crate::formula::quantity::Domain;
pub(super) use layout::render;
use numbers::named_jacobian;
pub(super) use numbers::{double, four_digits_up, number};

/// The number of points drawn for each one selected, so that every branch is covered.
const CANDIDATES: usize = 4;
/// At least this many cases drawn at random.
pub const LEAST_RANDOM: usize = 16;
/// The seed of the random cases.
const SEED: u64 = 0;

pub(crate) fn of(subject: &Subject, least_random: usize) -> File {
    let spec = subject.spec;
    File {
        schema: "schema.json".into(),
        layout: LAYOUT,
        formula: spec.id.into(),
        title: spec.title.into(),
        source: spec.source.to_string(),
        provenance: spec.source.provenance.into(),
        latex: spec.latex.into(),
        eta: Bounds { value: spec.eta.value, jacobian: spec.eta.jacobian },
        inputs: describe(subject.inputs),
        outputs: describe(subject.outputs),
        cases: cases(subject, least_random).iter().map(|case| record(subject, case)).collect(),
    }
}

pub(super) fn describe(fields: &[Field]) -> Vec<Description> {
    let description = |field: &Field| Description {
        name: field.name.into(),
        shape: field.quantity.shape.dimensions(),
        unit: field.quantity.unit.to_string(),
    };
    fields.iter().map(description).collect()
}

/// All cases of a formula: its own, random ones, the worst that a search found, and every kind of invalid input.
pub(crate) fn cases(subject: &Subject, least_random: usize) -> Vec<Case<Vec<f64>>> {
    let own = (subject.cases)().len();
    cases_with(subject, least_random.max(LEAST_CASES.saturating_sub(own)), None)
}

/// The same with a given number of random cases. Invalid ones differ from the valid point, or one drawn at random, in one number.
pub(super) fn cases_with(subject: &Subject, random: usize, valid: Option<&[f64]>) -> Vec<Case<Vec<f64>>> {
    let mut cases = (subject.cases)();
    let mut sampler = Sampler::for_formula(subject.spec.id, SEED);
    let drawn = (0..random * CANDIDATES).map(|_| sampler.components(subject)).collect();
    let chosen = spread(subject, drawn, random).into_iter().zip(1..);
    cases.extend(chosen.map(|(inputs, k)| Case::new(Flag::Random, format!("random-{k}"), "", inputs)));
    cases.extend(subject.worst.iter().cloned());
    let drawn = || Sampler::for_formula(subject.spec.id, SEED).components(subject);
    cases.extend(out_of_domain(subject.inputs, &valid.map_or_else(drawn, <[f64]>::to_vec)));
    cases.extend((subject.invalid_cases)());
    cases
}

/// The same with random cases as they are drawn, which takes little time for any number of them.
pub(crate) fn cases_drawn(subject: &Subject, random: usize) -> Vec<Case<Vec<f64>>> {
    let mut sampler = Sampler::for_formula(subject.spec.id, SEED);
    let drawn = (0..random).map(|k| Case::new(Flag::Random, format!("random {k}"), "", sampler.components(subject)));
    let drawn: Vec<_> = drawn.collect();
    [cases_with(subject, 0, None), drawn].concat()
}

/// Every input in turn not finite, and outside its domain.
pub(crate) fn out_of_domain(inputs: &[Field], valid: &[f64]) -> Vec<Case<Vec<f64>>> {
    let mut invalid = Vec::new();
    let mut end = 0;
    for field in inputs {
        end += field.len();
        for (what, value) in bad_values(field.quantity.domain) {
            let mut components = valid.to_vec();
            components[end - 1] = value;
            invalid.push(Case::invalid(format!("{}-{what}", field.name), "", components));
        }
    }
    invalid
}

fn bad_values(domain: Domain) -> Vec<(&'static str, f64)> {
    let mut bad = vec![("nan", f64::NAN), ("infinite", f64::INFINITY), ("negative-infinite", f64::NEG_INFINITY)];
    match domain {
        Domain::NonNegative => bad.push(("negative", -1.0)),
        Domain::Positive => bad.extend([("zero", 0.0), ("negative", -1.0)]),
        Domain::Between(low, high) => bad.extend([("too-small", low), ("too-large", high)]),
        Domain::HalfOpen(low, high) => bad.extend([("too-small", low.next_down()), ("too-large", high)]),
        Domain::Within(low, high) => bad.extend([("too-small", low.next_down()), ("too-large", high.next_up())]),
        _ => {}
    }
    bad
}

fn record(subject: &Subject, case: &Case<Vec<f64>>) -> Record {
    let mut record = Record {
        id: case.id.clone(),
        flags: vec![case.flag],
        comment: case.comment.into(),
        inputs: named(subject.inputs, &case.inputs),
        out: None,
        out_scale: None,
        jac: None,
        jac_scale: None,
        error: None,
    };
    if let Err(error) = (subject.check)(&case.inputs) {
        record.error = Some(error.kind().into());
        return record;
    }
    let exact = exact(&case.inputs);
    let kink = subject.kink(&exact);
    if kink.is_some_and(|convention| convention != Convention::Cut) {
        record.flags.push(Flag::Kink);
    }
    let values = (subject.exact_value)(&exact);
    let entries = (subject.exact_jacobian)(&exact);
    record.out = Some(named(subject.outputs, &rounded(&values)));
    record.out_scale = Some(named(subject.outputs, &scales(&values, entries.chunks(exact.len()), &exact)));
    if subject.spec.is_closed() && kink != Some(Convention::Switch) {
        let by_name = |numbers: &[f64]| Some(named_jacobian(subject.outputs, subject.inputs, numbers));
        let gradients = subject.second_derivative(&exact);
        record.jac = by_name(&rounded(&entries));
        record.jac_scale = by_name(&scales(&entries, gradients.iter().map(Vec::as_slice), &exact));
    }
    record
}

/// Σᵢ |∂y/∂xᵢ · xᵢ| + |y| for every number y with its gradient, rounded up to four digits.
fn scales<'a>(numbers: &[Octuple], gradients: impl Iterator<Item = &'a [Octuple]>, inputs: &[Octuple]) -> Vec<f64> {
    let scale = |(&y, gradient): (&Octuple, _)| Sensitivity::new(gradient, inputs).plus(y).size();
    numbers.iter().zip(gradients).map(scale).map(|scale| four_digits_up(scale.to_f64())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::{ContactForce, Friction, Stop};
    use crate::contact::coulomb::ReturnMap;
    use crate::formula::Formula;
    use crate::formula::proof::Proved;

    fn record_of<F: Proved>(inputs: &[f64]) -> Record {
        record(&Subject::of::<F>(), &Case::hand("a", "so", inputs.to_vec()))
    }

    fn json(record: &Record) -> serde_json::Value {
        serde_json::to_value(record).expect("it is written so")
    }

    #[test]
    fn every_domain_has_its_bad_values() {
        let finite = |domain| bad_values(domain).split_off(3);
        assert_eq!(finite(Domain::Real), []);
        assert_eq!(finite(Domain::NonNegative), [("negative", -1.0)]);
        assert_eq!(finite(Domain::Positive), [("zero", 0.0), ("negative", -1.0)]);
        let (below, above) = (2.0_f64.next_down(), 5.0_f64.next_up());
        assert_eq!(finite(Domain::Between(2.0, 5.0)), [("too-small", 2.0), ("too-large", 5.0)]);
        assert_eq!(finite(Domain::HalfOpen(2.0, 5.0)), [("too-small", below), ("too-large", 5.0)]);
        assert_eq!(finite(Domain::Within(2.0, 5.0)), [("too-small", below), ("too-large", above)]);
        let names: Vec<_> = bad_values(Domain::Real).iter().map(|(name, value)| format!("{name} {value}")).collect();
        assert_eq!(names, ["nan NaN", "infinite inf", "negative-infinite -inf"]);
        for domain in [Domain::NonNegative, Domain::Positive, Domain::Between(2.0, 5.0), Domain::HalfOpen(2.0, 5.0)] {
            assert!(finite(domain).iter().all(|&(_, value)| !domain.allows(value)), "{domain:?}");
        }
    }

    /// The last component of every field is the invalid one.
    #[test]
    fn every_input_is_tried_outside_its_domain() {
        let subject = Subject::of::<crate::connector::slot::Constraint>();
        let valid = [0.5; 15];
        let invalid = out_of_domain(subject.inputs, &valid[..subject.inputs.iter().map(Field::len).sum()]);
        assert_eq!(invalid.len(), 3 * subject.inputs.len());
        let place = |case: &Case<Vec<f64>>| case.inputs.iter().position(|x| !x.is_finite());
        let places: Vec<_> = invalid.iter().step_by(3).filter_map(place).collect();
        assert_eq!(places, [2, 5, 8, 11, 12, 13]);
        assert_eq!((invalid[0].id.as_str(), invalid[4].id.as_str()), ("e2a-nan", "e3a-infinite"));
        assert!(invalid.iter().all(|case| case.flag == Flag::Invalid && (subject.check)(&case.inputs).is_err()));
    }

    #[test]
    fn cases_are_those_of_the_formula_random_ones_and_invalid_ones() {
        let subject = Subject::of::<ReturnMap>();
        let (own, all) = ((subject.cases)(), cases(&subject, LEAST_RANDOM));
        assert_eq!(all[..own.len()], own);
        let with = |flag| all.iter().filter(|case| case.flag == flag).count();
        assert_eq!(
            (with(Flag::Random), with(Flag::Invalid)),
            (LEAST_CASES - own.len(), out_of_domain(subject.inputs, &own[0].inputs).len())
        );
        assert_eq!(all[own.len()].id, "random-1");
        let stop = Subject::of::<Stop>();
        let refused = (stop.invalid_cases)();
        assert!(!refused.is_empty() && cases(&stop, LEAST_RANDOM).ends_with(&refused));
        // A formula with many cases of its own still gets some random ones.
        let mut many = subject;
        many.cases = || vec![Case::hand("a", "", vec![1.0, 0.5, 4.0]); LEAST_CASES];
        let random = |least| cases(&many, least).iter().filter(|case| case.flag == Flag::Random).count();
        assert_eq!([LEAST_RANDOM, 100].map(random), [LEAST_RANDOM, 100]);
    }

    #[test]
    fn a_case_has_its_results_and_their_scales() {
        let at = json(&record_of::<ContactForce>(&[3.0, 4.0]));
        let expected = serde_json::json!({
            "id": "a", "flags": ["hand"], "comment": "so", "in": {"f2": 3.0, "f3": 4.0},
            "out": {"fc": 5.0}, "out_scale": {"fc": 10.0},
            "jac": {"fc": {"f2": 0.6, "f3": 0.8}}, "jac_scale": {"fc": {"f2": 1.368, "f3": 1.376}},
        });
        assert_eq!(at, expected);
        let refused = json(&record_of::<ContactForce>(&[f64::NAN, 4.0]));
        let expected = serde_json::json!({
            "id": "a", "flags": ["hand"], "comment": "so", "in": {"f2": "NaN", "f3": 4.0}, "error": "NonFinite",
        });
        assert_eq!(refused, expected);
    }

    #[test]
    fn on_a_kink_a_case_is_flagged_and_on_a_switch_it_has_no_jacobian() {
        let has =
            |record: Record| (record.flags.contains(&Flag::Kink), record.jac.is_some(), record.jac_scale.is_some());
        assert_eq!(has(record_of::<ReturnMap>(&[2.0, 0.5, 4.0])), (true, false, false));
        assert_eq!(has(record_of::<ReturnMap>(&[2.5, 0.5, 4.0])), (false, true, true));
        assert_eq!(has(record_of::<ContactForce>(&[0.0, 0.0])), (true, true, true));
    }

    #[test]
    fn a_file_says_what_the_formula_is() {
        let file = of(&Subject::of::<Friction>(), LEAST_RANDOM);
        assert_eq!(
            (file.formula.as_str(), file.schema.as_str(), file.layout),
            ("slot.friction", "schema.json", LAYOUT)
        );
        assert_eq!((file.eta.value, file.eta.jacobian), (Friction::SPEC.eta.value, Friction::SPEC.eta.jacobian));
        assert_eq!((file.inputs.len(), file.inputs[0].name.as_str(), file.inputs[0].unit.as_str()), (5, "f1", "F"));
        assert_eq!((file.outputs.len(), file.cases.len()), (3, cases(&Subject::of::<Friction>(), LEAST_RANDOM).len()));
    }
}
