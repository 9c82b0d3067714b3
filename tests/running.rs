//! The worked numbers of a chapter belong to one state: what one formula yields, the next is given.

use crate::common;
use jointproof::catalog::{AnyFormula, find};
use jointproof::formula::Field;
use jointproof::formula::proof::RUNNING;
use jointproof::toolkit::verify::golden::components;
use std::collections::BTreeMap;

/// The chapters, each of which follows one state.
const CHAPTERS: [&str; 14] = [
    "slot",
    "coulomb",
    "cardan",
    "translator",
    "universal",
    "ujoint",
    "arm-model",
    "hinge",
    "slider",
    "slide-line",
    "interaction",
    "elements",
    "stiffness",
    "unknowns",
];

/// What changes on the way, as the chapter says: m is put on the line; surfaces approach until they overlap.
const CHANGES: [(&str, &str); 2] = [("slider", "xm"), ("interaction", "h")];

/// The largest number of characters of an input.
const SHORT: usize = 8;

/// A body in the plane is another one than that in space, a chapter on slide lines has four places, and the line of SLIDER is none
/// of them.
fn place(id: &str) -> &'static str {
    let places = ["_2d", "smoothed_linear", "smoothed_parabolic", "contact_area", "torque", "parabol", "slider", ""];
    let found = places.into_iter().find(|part| id.contains(part)).unwrap_or_default();
    if found == "torque" && id.starts_with("slide_line") { "contact_area" } else { found }
}

/// The formulas of a chapter, in its order.
fn formulas(chapter: &str) -> Vec<&'static dyn AnyFormula> {
    let path = format!("{}/book/src/{chapter}.md", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let ids = text.lines().filter_map(|line| line.strip_prefix("{{#formula ")?.strip_suffix("}}"));
    ids.map(|id| find(id).unwrap_or_else(|| panic!("{chapter}: there is no {id}"))).collect()
}

/// The running case of a formula: its inputs and outputs.
fn running(formula: &dyn AnyFormula) -> [Vec<f64>; 2] {
    let (id, golden) = (formula.spec().id, common::golden(formula));
    let case =
        golden.cases.iter().find(|case| case.id == RUNNING).unwrap_or_else(|| panic!("{id} has no running case"));
    let inputs = components(formula.inputs(), &case.inputs).unwrap();
    let outputs =
        components(formula.outputs(), case.out.as_ref().unwrap_or_else(|| panic!("{id} refuses it"))).unwrap();
    [inputs, outputs]
}

/// The fields with their numbers.
fn named<'n>(fields: &'static [Field], numbers: &'n [f64]) -> Vec<(&'static str, &'n [f64])> {
    let mut rest = numbers;
    let next = |field: &Field| {
        let (here, behind) = rest.split_at(field.len());
        rest = behind;
        (field.name, here)
    };
    fields.iter().map(next).collect()
}

#[test]
fn the_formulas_of_a_chapter_are_followed_in_one_state() {
    for chapter in CHAPTERS {
        let mut given: BTreeMap<_, (Vec<f64>, &str)> = BTreeMap::new();
        let mut yielded = Vec::new();
        for formula in formulas(chapter) {
            let (id, [inputs, outputs]) = (formula.spec().id, running(formula));
            for (name, numbers) in named(formula.inputs(), &inputs) {
                let (known, by) = given.entry((place(id), name)).or_insert_with(|| (numbers.to_vec(), id));
                let is_same = known == numbers || CHANGES.contains(&(chapter, name));
                assert!(is_same, "{chapter}: {name} is {known:?} in {by} and {numbers:?} in {id}");
            }
            let outputs = named(formula.outputs(), &outputs).into_iter();
            yielded.extend(outputs.map(|(name, numbers)| ((place(id), name), numbers.to_vec(), id)));
        }
        for (key, numbers, id) in yielded {
            let Some((known, by)) = given.get(&key).filter(|(known, _)| known.len() == numbers.len()) else { continue };
            // An input may be rounded to a few digits.
            let is_same = known.iter().zip(&numbers).all(|(x, y)| (x - y).abs() <= 1e-4 * (1.0 + y.abs()));
            assert!(is_same, "{chapter}: {id} yields {numbers:?} for {}, and {by} is given {known:?}", key.1);
        }
    }
}

#[test]
fn a_running_state_can_be_followed_with_a_pencil() {
    for formula in CHAPTERS.into_iter().flat_map(formulas) {
        let (id, [inputs, _]) = (formula.spec().id, running(formula));
        let inputs = named(formula.inputs(), &inputs);
        for (name, numbers) in &inputs {
            assert!(numbers.len() == 1 || numbers.iter().any(|x| *x != 0.0), "{id}: {name} is zero");
            assert!(numbers.iter().all(|x| x.to_string().len() <= SHORT), "{id}: {name} is {numbers:?}");
        }
        let axes = inputs.iter().filter(|(name, axis)| name.len() == 3 && name.starts_with('e') && axis.len() > 1);
        let axes: Vec<_> = axes.collect();
        for (k, (name, one)) in axes.iter().enumerate() {
            for (other, two) in &axes[k..] {
                let product = one.iter().zip(*two).map(|(x, y)| x * y).sum::<f64>();
                let square = f64::from(u8::from(name == other));
                let is_one_triad = name[2..] == other[2..];
                assert!(!is_one_triad || (product - square).abs() < 1e-15, "{id}: {name}·{other} = {product}");
            }
        }
    }
}
