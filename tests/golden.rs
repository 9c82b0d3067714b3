//! The committed golden files agree with the code, and are suitable for testing other code.

use crate::common;
use jointproof::catalog::{AnyFormula, CATALOG, find};
use jointproof::formula::proof::{Convention, Flag};
use jointproof::toolkit::verify::golden::{File, LEAST_CASES, Record};
use rayon::prelude::*;
use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::LazyLock;

/// Every formula with its committed golden file.
static FILES: LazyLock<Vec<(&dyn AnyFormula, File)>> =
    LazyLock::new(|| CATALOG.iter().map(|formula| (*formula, common::golden(*formula))).collect());

fn directory() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("golden")
}

fn committed(formula: &dyn AnyFormula) -> String {
    let path = directory().join(format!("{}.json", formula.spec().id));
    std::fs::read_to_string(&path)
        .unwrap_or_else(|error| panic!("{}: {error}; run: cargo xtask golden", path.display()))
}

#[test]
fn files_are_what_the_code_says_byte_for_byte() {
    FILES.par_iter().for_each(|(formula, file)| {
        let now = formula.golden();
        if now.render().unwrap() != committed(*formula) {
            let differences = now.differences(file);
            let shown: Vec<_> = differences.iter().take(5).map(ToString::to_string).collect();
            panic!("{}: {shown:#?}; to accept: cargo xtask golden", formula.spec().id);
        }
        // Nothing is lost when a file is written and read back.
        assert!(now == *file, "{}: {:?}", file.formula, now.differences(file));
    });
}

/// This is known without computing them, quickly enough to be checked always.
#[test]
fn files_have_the_cases_that_their_formulas_state_now() {
    for (formula, file) in FILES.iter() {
        let first = |case: &Record| case.flags[0];
        let stated: Vec<_> = file.cases.iter().map(first).take_while(|flag| *flag != Flag::Random).collect();
        assert!(stated == formula.cases(), "{}: cases came or went; to accept: cargo xtask golden", file.formula);
        let after: Vec<_> = file.cases.iter().map(first).skip_while(|flag| *flag != Flag::Random).collect();
        assert!(after.iter().all(|flag| [Flag::Random, Flag::Worst, Flag::Invalid].contains(flag)), "{}", file.formula);
    }
}

#[test]
fn files_read_back_to_what_was_written() {
    for (formula, file) in FILES.iter() {
        assert!(file.render().unwrap() == committed(*formula), "{}", file.formula);
    }
}

#[test]
fn every_formula_has_enough_valid_cases_of_every_kind() {
    for (formula, file) in FILES.iter() {
        let with = |flag| file.cases.iter().filter(|case| case.flags.contains(&flag)).count();
        let id = &file.formula;
        assert!(file.cases.len() - with(Flag::Invalid) >= LEAST_CASES, "{id}: too few valid cases");
        assert!(with(Flag::Hand) > 0, "{id}: nothing worked by hand");
        assert!(with(Flag::Hard) > 0, "{id}: no hard case");
        assert!(
            with(Flag::Invalid) >= 3 * formula.inputs().len(),
            "{id}: an input is not tried with NaN and infinities"
        );
        // At a cut the derivative exists, so that no case is flagged there.
        let smooth = formula.kinks().iter().all(|kink| kink.convention == Convention::Cut);
        assert!(smooth == (with(Flag::Kink) == 0), "{id}: kinks and cases on them do not match");
    }
}

#[test]
fn case_identifiers_are_unique() {
    for (_, file) in FILES.iter() {
        let mut seen = HashSet::new();
        for case in &file.cases {
            assert!(seen.insert(case.id.clone()), "{}: two cases are named {}", file.formula, case.id);
        }
    }
}

#[test]
fn only_invalid_cases_have_errors_and_only_they_lack_results() {
    for (_, file) in FILES.iter() {
        for case in &file.cases {
            let invalid = case.flags.contains(&Flag::Invalid);
            let context = format!("{} {}: {:?}", file.formula, case.id, case.error);
            assert_eq!(invalid, case.error.is_some(), "{context}");
            assert_eq!(invalid, case.out.is_none(), "{context}");
            let kink = case.flags.contains(&Flag::Kink);
            let is_closed = file.eta.jacobian.is_some();
            assert!(if is_closed { case.jac.is_some() || invalid || kink } else { case.jac.is_none() }, "{context}");
        }
    }
}

#[test]
fn no_golden_number_is_infinite_or_nan() {
    for (_, file) in FILES.iter() {
        for case in file.cases.iter().filter(|case| case.error.is_none()) {
            // A scale may be beyond all doubles.
            let text = serde_json::to_string(&(&case.inputs, &case.out, &case.jac)).unwrap();
            assert!(!text.contains("NaN") && !text.contains("Infinity"), "{} {}", file.formula, case.id);
        }
    }
}

#[test]
fn no_file_is_without_a_formula() {
    for entry in std::fs::read_dir(directory()).unwrap() {
        let path = entry.unwrap().path();
        let id = path.file_stem().unwrap().to_string_lossy().into_owned();
        if path.is_file() && id != "schema" {
            assert!(find(&id).is_some(), "{} has no formula; run: cargo xtask golden", path.display());
        }
    }
}
