//! `cargo xtask report`: its JSON, its completeness, its files, and what `--against` says. No time is judged here.

use assert_cmd::Command;
use jointproof::catalog::{AnyFormula, CATALOG};
use serde_json::Value;
use std::path::Path;
use std::sync::LazyLock;

/// A quick report on every formula, measured within the task's own process.
static REPORT: LazyLock<Value> = LazyLock::new(|| json(&["report", "--here", "--quick", "--format", "json"]));

fn xtask(arguments: &[&str]) -> assert_cmd::assert::Assert {
    Command::cargo_bin("xtask").unwrap().args(arguments).assert()
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_slice(&xtask(arguments).success().get_output().stdout).unwrap()
}

#[test]
fn the_quick_report_keeps_to_its_schema() {
    let schema = json(&["report", "--schema"]);
    let validator = jsonschema::validator_for(&schema).unwrap();
    let errors: Vec<_> = validator.iter_errors(&REPORT).map(|error| error.to_string()).collect();
    assert!(errors.is_empty(), "{errors:#?}");
}

#[test]
fn every_formula_of_the_catalog_is_in_it_with_finite_figures() {
    let formulas = REPORT["formulas"].as_array().unwrap();
    let ids: Vec<_> = formulas.iter().map(|formula| formula["formula"].as_str().unwrap()).collect();
    assert_eq!(ids, CATALOG.iter().map(|formula| formula.spec().id).collect::<Vec<_>>());
    for formula in formulas {
        let id = &formula["formula"];
        assert!(formula["random_points"].as_u64() > Some(0), "{id}");
        assert_figures(&formula["copy"], &format!("{id} copy"));
        assert_eq!(formula["curves"].as_array().unwrap().len(), 3, "{id}");
        let ways = formula["ways"].as_array().unwrap();
        for expected in ["closed", "single", "ad", "forward", "central", "fourth", "octuple", "octuple-ad"] {
            let way = ways.iter().find(|way| way["id"] == expected);
            let way = way.unwrap_or_else(|| panic!("{id} has no way {expected}"));
            assert_figures(&way["jacobian"], &format!("{id} {expected}"));
        }
        for way in ways.iter().filter(|way| !way["value"].is_null()) {
            assert_figures(&way["value"], &format!("{id} {way}"));
        }
        let closed = &ways[0]["jacobian"]["random"];
        assert_eq!(closed["not_finite"], 0, "{id}: the closed form fails at a random point");
    }
}

/// Every number is there, finite and not negative; null stands only where there are no hard points.
fn assert_figures(figures: &Value, what: &str) {
    match figures {
        Value::Number(number) => assert!(number.as_f64().is_some_and(|x| x.is_finite() && x >= 0.0), "{what}"),
        Value::Object(fields) => {
            for (name, value) in fields.iter().filter(|(name, value)| *name != "hard" || !value.is_null()) {
                assert_figures(value, &format!("{what} {name}"));
            }
        }
        other => panic!("{what} is {other}"),
    }
}

#[test]
fn a_planted_loss_of_accuracy_is_named_and_exits_1() {
    let folder = tempfile::tempdir().unwrap();
    let old = folder.path().join("old.json");
    let mut report = REPORT.clone();
    for formula in report["formulas"].as_array_mut().unwrap() {
        if formula["formula"] == "slot.contact_force" {
            formula["ways"][0]["jacobian"]["random"]["eta"]["max"] = 0.01.into();
        }
    }
    std::fs::write(&old, report.to_string()).unwrap();
    let old = old.to_str().unwrap();
    let ran = xtask(&["report", "--here", "--quick", "--filter", "slot.contact_force", "--against", old]).code(1);
    let said = String::from_utf8_lossy(&ran.get_output().stdout).into_owned();
    assert!(said.contains("slot.contact_force closed Jacobian, random points"), "{said}");
    assert!(said.contains("less accurate"), "{said}");
    assert_eq!(said.matches("less accurate").count(), 2, "errors are the same in every run: {said}");
}

#[test]
fn the_points_are_written_for_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let points = folder.path().join("points");
    let timing = folder.path().join("timing.json");
    let arguments = ["report", "--here", "--quick", "--filter", "slot.friction", "--inputs", points.to_str().unwrap()];
    xtask(&[&arguments[..], &["--timing-json", timing.to_str().unwrap()]].concat()).success();
    let read = |path: &Path| -> Value { serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap() };
    let description = read(&points.join("slot.friction.json"));
    let [count, stride] = ["count", "stride"].map(|name| usize::try_from(description[name].as_u64().unwrap()).unwrap());
    let names: Vec<_> = description["inputs"].as_array().unwrap().iter().map(|field| &field["name"]).collect();
    assert_eq!(names, ["f1", "f2", "f3", "fc_int", "mu"]);
    assert_eq!(stride, 5);
    let bytes = std::fs::read(points.join(description["file"].as_str().unwrap())).unwrap();
    let doubles: Vec<_> = bytes.chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect();
    assert_eq!(doubles.len(), count * stride);
    let friction: &dyn AnyFormula = &jointproof::slot::Friction;
    for point in doubles.chunks(stride) {
        assert!(friction.value(point).is_ok(), "{point:?}");
    }
    let times = &read(&timing)["formulas"]["slot.friction"];
    for part in ["value", "value_and_jacobian", "copy"] {
        assert!(times[part]["median"].as_f64() > Some(0.0), "{part}: {times}");
    }
}

#[test]
fn what_is_no_report_is_refused_with_advice() {
    let ran = xtask(&["report", "--against", "Cargo.toml"]).code(1);
    let said = String::from_utf8_lossy(&ran.get_output().stderr).into_owned();
    assert!(said.contains("is not a report") && said.contains("--format json"), "{said}");
}
