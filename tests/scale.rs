//! The sizes of inputs up to which the bounds of η hold, and the fact that they do not hold beyond.
//!
//! The audit checks the bounds at sizes up to the [scale](jointproof::formula::Spec::scale) that a formula states. This file uses
//! inputs slightly larger or smaller, at which a bound is exceeded, for every formula whose bounds do not hold everywhere. `cargo
//! test --test all scale:: -- --ignored` repeats the search for the scales and such inputs.

use jointproof::catalog::{AnyFormula, CATALOG};
use jointproof::toolkit::verify::golden::components;
use jointproof::toolkit::verify::{Claim, Deviation, Options};
use rayon::prelude::*;
use serde_json::{Map, Value};
use std::path::PathBuf;

/// The scales from which a formula states one.
const SCALES: [f64; 15] = [1e3, 1e5, 1e10, 1e15, 1e20, 1e30, 1e40, 1e50, 1e60, 1e80, 1e100, 1e120, 1e150, 1e200, 1e250];
/// The random points, converted to other sizes, at which a search checks whether a bound is exceeded.
const SEARCHED: Options = Options { samples: 3000, seed: 5 };

fn file() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/beyond.json")
}

/// For each formula whose bounds do not hold everywhere, inputs at which they do not.
fn kept() -> Map<String, Value> {
    serde_json::from_str(&std::fs::read_to_string(file()).unwrap()).unwrap()
}

/// The number of steps between the stated scale and the first at which the search finds a bound exceeded, since another search
/// may find one earlier.
const MARGIN: usize = 2;

/// The scale at which a bound is exceeded if this one is stated; `None` for the largest, which is stated if no bound is exceeded.
fn beyond(scale: f64) -> Option<f64> {
    let place = SCALES.iter().position(|&known| known == scale).unwrap();
    let last = SCALES.len() - 1;
    (place < last).then(|| SCALES[(place + MARGIN).min(last)])
}

fn exceeded<'a>(claims: impl IntoIterator<Item = &'a Claim>) -> bool {
    claims.into_iter().any(|claim| claim.failures > 0)
}

#[test]
fn beyond_the_sizes_that_are_stated_a_bound_is_exceeded() {
    let kept = kept();
    for formula in CATALOG {
        let spec = formula.spec();
        assert!(SCALES.contains(&spec.scale), "{} states {:e}", spec.id, spec.scale);
        let Some(beyond) = beyond(spec.scale) else {
            assert!(!kept.contains_key(spec.id), "{} holds everywhere", spec.id);
            continue;
        };
        let named = kept.get(spec.id).and_then(Value::as_object);
        let named = named.unwrap_or_else(|| panic!("nothing is kept of {}", spec.id));
        let inputs = components(formula.inputs(), named).unwrap();
        assert!(inputs.iter().all(|&x| x == 0.0 || (1.0 / beyond..=beyond).contains(&x.abs())), "{}: too far", spec.id);
        let audit = formula.audit_at(&inputs).unwrap();
        assert!(
            exceeded([&audit.eta].into_iter().chain(&audit.eta_jacobian)),
            "{} holds at {}",
            spec.id,
            kept[spec.id]
        );
    }
}

/// A formula may state a smaller scale if the stored inputs justify it: other points find what these do not.
#[test]
#[ignore = "searches for hours, or a quarter of one where the library is optimised"]
fn no_sizes_are_stated_beyond_those_that_a_search_finds() {
    let found: Vec<_> = CATALOG.par_iter().map(|formula| search(*formula)).collect();
    let before = kept();
    let mut kept = Map::new();
    let mut others = Vec::new();
    for (formula, (scale, beyond)) in CATALOG.iter().zip(found) {
        let spec = formula.spec();
        if spec.scale > scale {
            others.push(format!("{} states {:e}, found is {scale:e}", spec.id, spec.scale));
        }
        let shown = if spec.scale < scale { before.get(spec.id).cloned() } else { beyond.map(|beyond| beyond.inputs) };
        kept.extend(shown.map(|inputs| (spec.id.to_owned(), inputs)));
    }
    std::fs::write(file(), serde_json::to_string_pretty(&kept).unwrap() + "\n").unwrap();
    assert_eq!(others, [""; 0]);
}

/// The scale to be stated, and the point at which a bound is exceeded most at the first scale at which it is.
fn search(formula: &dyn AnyFormula) -> (f64, Option<Deviation>) {
    for (k, &scale) in SCALES.iter().enumerate().skip(1) {
        let claims = formula.eta_at_scale(scale, &SEARCHED);
        assert!(claims.iter().all(|claim| claim.checks > 0), "{}: nothing was drawn", formula.spec().id);
        let worst = claims.into_iter().filter(|claim| claim.failures > 0).find_map(|claim| claim.worst);
        if worst.is_some() {
            return (SCALES[k.saturating_sub(MARGIN)], worst);
        }
    }
    (SCALES[SCALES.len() - 1], None)
}
