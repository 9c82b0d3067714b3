//! Properties of every formula of the catalog, tested by proptest on inputs from the declared domains.

use crate::common;
use jointproof::catalog::{AnyFormula, CATALOG};
use jointproof::formula::Field;
use jointproof::formula::quantity::Unit;
use jointproof::toolkit::verify::golden;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// Runs a property on every formula, at `cases` points each.
fn for_every_formula(cases: u32, property: impl Fn(&'static dyn AnyFormula, &[f64]) -> Result<(), TestCaseError>) {
    for formula in CATALOG {
        let mut runner = TestRunner::new(Config::with_cases(cases));
        let outcome = runner.run(&common::inputs(*formula), |inputs| property(*formula, &inputs));
        outcome.unwrap_or_else(|error| panic!("{}: {error}", formula.spec().id));
    }
}

/// The same points in every run, so that a failure depends only on the code. `.cargo/config.toml` ensures this for every test
/// that cargo runs; `.ci/long` uses other points.
#[test]
fn random_points_are_the_same_in_every_run() {
    let config = Config::default();
    assert!(matches!(config.rng_seed, RngSeed::Fixed(_)), "PROPTEST_RNG_SEED is set by cargo in the repository");
    assert!(config.failure_persistence.is_none(), "what one run found steers another");
    let tests = std::fs::read_dir(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")).unwrap();
    let kept = tests
        .map(|entry| entry.unwrap().path())
        .find(|path| path.extension().is_some_and(|x| x == "proptest-regressions"));
    assert_eq!(kept, None, "what was found once is a test with a name");
}

/// Components in units of length 2ᵃ, force 2ᵇ and time 2ᶜ.
fn in_units(components: &[f64], fields: &[Field], [a, b, c]: [i32; 3]) -> Vec<f64> {
    let power = |unit: Unit| unit.length * a + unit.force * b + unit.time * c;
    let factors = fields.iter().flat_map(|field| vec![2.0_f64.powi(power(field.quantity.unit)); field.len()]);
    components.iter().zip(factors).map(|(x, factor)| x * factor).collect()
}

/// Other units rescale the result, bit for bit: a wrong unit or a missing factor cannot hide.
#[test]
fn formulas_are_dimensionally_homogeneous_to_the_last_bit() {
    for_every_formula(64, |formula, inputs| {
        let Ok(value) = formula.value(inputs) else { return Ok(()) };
        for units in [[3, 0, 0], [0, -5, 0], [0, 0, 7], [-11, 13, -2]] {
            let scaled = formula.value(&in_units(inputs, formula.inputs(), units)).unwrap();
            prop_assert_eq!(scaled, in_units(&value, formula.outputs(), units));
        }
        Ok(())
    });
}

/// Derivatives, accuracy and laws, at points that the sampler would not draw.
#[test]
fn audits_hold_at_any_point() {
    for_every_formula(24, |formula, inputs| {
        let Ok(audit) = formula.audit_at(inputs) else { return Ok(()) };
        prop_assert!(audit.no_claim_failed(), "{audit:#?}");
        Ok(())
    });
}

/// If value and Jacobian share work, both have the same bits as when computed alone.
#[test]
fn together_value_and_jacobian_are_those_of_each_alone() {
    let compare = |formula: &dyn AnyFormula, inputs: &[f64]| {
        let Ok((value, jacobian)) = formula.value_and_jacobian(inputs) else { return false };
        let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(value), bits(formula.value(inputs).unwrap()), "{} at {inputs:?}", formula.spec().id);
        assert_eq!(bits(jacobian), bits(formula.jacobian(inputs).unwrap()), "{} at {inputs:?}", formula.spec().id);
        true
    };
    for formula in CATALOG {
        let golden = common::golden(*formula);
        let inputs = golden.cases.iter().map(|case| golden::components(formula.inputs(), &case.inputs).unwrap());
        let compared = inputs.filter(|inputs| compare(*formula, inputs)).count();
        assert!(compared >= golden::LEAST_CASES, "{}: {compared}", formula.spec().id);
    }
    for_every_formula(64, |formula, inputs| {
        compare(formula, inputs);
        Ok(())
    });
}

/// For every input, a result or a typed error, and no panic.
#[test]
fn no_input_panics() {
    for formula in CATALOG {
        let components: usize = formula.inputs().iter().map(Field::len).sum();
        let mut runner = TestRunner::new(Config::with_cases(256));
        let anything = prop::collection::vec(common::anything(), components);
        let outcome = runner.run(&anything, |inputs| {
            if let Ok(outputs) = formula.value(&inputs) {
                prop_assert!(inputs.iter().all(|x| x.is_finite()));
                prop_assert!(outputs.iter().all(|y| y.is_finite()), "{:?} gives {:?}", inputs, outputs);
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{}: {error}", formula.spec().id));
    }
}
