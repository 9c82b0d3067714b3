//! `cargo xtask report`: its JSON, its completeness, its files, its location in the book, and the output of `--against`. No time
//! is judged here. This program is both the tests and the measuring program, unoptimised; therefore it has no test harness.

mod common;

use common::{Bench, IS_MEASURED, Ran, reference};
use jointproof::catalog::{AnyFormula, CATALOG};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::sync::LazyLock;

fn main() -> ExitCode {
    if std::env::var_os(IS_MEASURED).is_some() {
        return measuring::main(CATALOG, <dyn AnyFormula>::errors, <dyn AnyFormula>::times);
    }
    // Listing or filtering tests runs none of these, and a shell script requires Unix.
    if cfg!(unix) && std::env::args().len() == 1 {
        the_report_keeps_to_its_schema();
        every_formula_of_the_catalog_is_in_it_with_finite_figures();
        a_planted_loss_of_accuracy_is_named_and_exits_1();
        a_planted_slowdown_is_named_and_exits_1();
        a_formula_that_vanished_is_named_if_it_was_asked_for();
        two_reports_on_everything_can_be_compared();
        the_points_are_written_for_other_programs();
        every_format_shows_every_way();
        what_is_no_report_is_refused_with_advice();
        a_report_on_everything_is_kept_for_the_book_unless_the_measuring_failed();
    }
    ExitCode::SUCCESS
}

/// The smallest measurement possible.
const LEAST: [&str; 8] = ["report", "--quick", "--samples", "2", "--rounds", "2", "--columns", "1"];

/// A report on every formula.
static REPORT: LazyLock<String> =
    LazyLock::new(|| least(&Bench::new(), &["--format", "json"]).exits(0).says("kept for the book in ").stdout);

fn report() -> Value {
    serde_json::from_str(&REPORT).unwrap()
}

/// A report on some formulas, made on the spot.
fn quick(bench: &Bench, filter: &str, more: &[&str]) -> Ran {
    least(bench, &[&["--filter", filter], more].concat())
}

/// This program acts as the measuring program.
fn least(bench: &Bench, more: &[&str]) -> Ran {
    bench.run_built(&std::env::current_exe().unwrap(), &[&LEAST[..], more].concat())
}

fn the_report_keeps_to_its_schema() {
    let schema: Value = serde_json::from_str(&Bench::new().run(&["report", "--schema"]).quiet().stdout).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let errors: Vec<_> = validator.iter_errors(&report()).map(|error| error.to_string()).collect();
    assert_eq!(errors, [""; 0]);
    let mut other = report();
    other["formulas"][0]["methods"][0]["title"] = Value::Null;
    assert!(!validator.is_valid(&other), "a way without a title is accepted");
    let mut other = report();
    other["author"] = "me".into();
    assert!(!validator.is_valid(&other), "an extra key is accepted");
}

fn every_formula_of_the_catalog_is_in_it_with_finite_figures() {
    let report = report();
    let formulas = report["formulas"].as_array().unwrap();
    let ids: Vec<_> = formulas.iter().map(|formula| formula["formula"].as_str().unwrap()).collect();
    assert_eq!(ids, CATALOG.iter().map(|formula| formula.spec().id).collect::<Vec<_>>());
    for formula in formulas {
        let id = &formula["formula"];
        assert_eq!(formula["random_points"], 2, "{id}");
        assert_figures(&formula["copy"], &format!("{id} copy"));
        assert_eq!(formula["curves"].as_array().unwrap().len(), 3, "{id}");
        let methods = formula["methods"].as_array().unwrap();
        for expected in
            ["closed", "checked", "single", "ad", "complex", "forward", "central", "fourth", "octuple", "octuple-ad"]
        {
            let method = methods.iter().find(|method| method["id"] == expected);
            let method = method.unwrap_or_else(|| panic!("{id} has no way {expected}"));
            let is_automatic = !jointproof::catalog::find(id.as_str().unwrap()).unwrap().spec().is_closed();
            if is_automatic && ["closed", "checked", "single", "octuple"].contains(&expected) {
                assert!(method["jacobian"].is_null(), "{id} {expected}");
                continue;
            }
            assert_figures(&method["jacobian"], &format!("{id} {expected}"));
            assert_figures(&method["jacobian"]["ratio"], &format!("{id} {expected}"));
        }
        for method in methods.iter().filter(|method| !method["value"].is_null()) {
            assert_figures(&method["value"], &format!("{id} {method}"));
        }
        let hard_points = formula["hard_points"].as_u64().map(|count| usize::try_from(count).unwrap());
        if methods[0]["jacobian"].is_null() {
            continue;
        }
        for method in &methods[..2] {
            let times = method["jacobian"]["hard_times"].as_array().map(Vec::len);
            assert_eq!(times, hard_points, "{id}: the closed form, checked or not, is timed at every hard point");
        }
        let closed = &methods[0]["jacobian"]["random"];
        assert_eq!(closed["not_finite"], 0, "{id}: the closed form fails at a random point");
    }
}

/// Every number is present, finite and not negative; null appears only if there are no hard points.
fn assert_figures(figures: &Value, what: &str) {
    match figures {
        Value::Number(number) => assert!(number.as_f64().is_some_and(|x| x.is_finite() && x >= 0.0), "{what}"),
        Value::Object(fields) => {
            for (name, value) in fields.iter().filter(|(name, value)| *name != "hard" || !value.is_null()) {
                assert_figures(value, &format!("{what} {name}"));
            }
        }
        Value::Array(all) => all.iter().for_each(|one| assert_figures(one, what)),
        // The name of a hard point.
        Value::String(_) | Value::Bool(_) => {}
        Value::Null => panic!("{what} is null"),
    }
}

/// Writes the report with a change to `slot.contact_force`.
fn tampered(path: &Path, tamper: impl Fn(&mut Value)) {
    let mut report = report();
    let formulas = report["formulas"].as_array_mut().unwrap();
    formulas.iter_mut().filter(|formula| formula["formula"] == "slot.contact_force").for_each(tamper);
    fs::write(path, report.to_string()).unwrap();
}

fn a_planted_loss_of_accuracy_is_named_and_exits_1() {
    let bench = Bench::new();
    let old = bench.path("old.json");
    tampered(&old, |formula| formula["methods"][0]["jacobian"]["random"]["eta"][2] = 0.01.into());
    let ran = quick(&bench, "slot.contact_force", &["--against", old.to_str().unwrap()]).exits(1);
    let ran = ran.prints("slot.contact_force closed Jacobian, random points").prints("less accurate");
    let count = ran.stdout.matches("less accurate slot").count();
    assert_eq!(count, 1, "errors are the same in every run: {ran:#?}");
    // With JSON only the report is printed, and comments go to the other stream.
    let wanted = ["--format", "json", "--against", old.to_str().unwrap()];
    let ran =
        quick(&bench, "slot.contact_force", &wanted).exits(1).says("less accurate slot.contact_force closed Jacobian");
    serde_json::from_str::<serde_json::Value>(&ran.stdout).unwrap();
}

fn a_planted_slowdown_is_named_and_exits_1() {
    let bench = Bench::new();
    let old = bench.path("old.json");
    tampered(&old, |formula| {
        for figure in ["median", "low", "high"] {
            let time = &mut formula["methods"][0]["jacobian"]["time"][figure];
            *time = (time.as_f64().unwrap() / 1000.0).into();
        }
    });
    let ran = quick(&bench, "slot.contact_force", &["--against", old.to_str().unwrap()]).exits(1);
    let ran = ran.prints("slot.contact_force closed Jacobian: ");
    assert!(ran.stdout.contains("slower"), "{ran:#?}");
}

fn a_formula_that_vanished_is_named_if_it_was_asked_for() {
    let bench = Bench::new();
    let old = bench.path("old.json");
    tampered(&old, |formula| formula["formula"] = "slot.contact_farce".into());
    let against = |filter| quick(&bench, filter, &["--against", old.to_str().unwrap()]);
    against("slot.contact_f*").exits(1).prints("missing slot.contact_farce: no longer measured");
    let ran = against("slot.contact_force");
    assert!(!ran.stdout.contains("missing"), "{ran:#?}");
}

fn two_reports_on_everything_can_be_compared() {
    let bench = Bench::new();
    let old = bench.path("old.json");
    fs::write(&old, &*REPORT).unwrap();
    let ran = quick(&bench, "slot.*", &["--against", old.to_str().unwrap()]);
    // Whether something became slower is chance on a machine that runs other tests; errors are the same.
    assert!(matches!(ran.code, Some(0 | 1)), "{ran:#?}");
    for worse in ["less accurate slot", "fails at more points slot", "missing slot"] {
        assert!(!ran.stdout.contains(worse), "{ran:#?}");
    }
}

fn the_points_are_written_for_other_programs() {
    let bench = Bench::new();
    let (points, timing) = (bench.path("points"), bench.path("timing.json"));
    let more = ["--inputs", points.to_str().unwrap(), "--timing-json", timing.to_str().unwrap()];
    let ran = quick(&bench, "slot.friction", &more).exits(0);
    for (what, path) in [("the points", &points), ("times", &timing)] {
        assert!(ran.stderr.contains(&format!("wrote {what} of 1 formula into {}", path.display())), "{ran:#?}");
    }
    let read = |path: &Path| -> Value { serde_json::from_slice(&fs::read(path).unwrap()).unwrap() };
    let description = read(&points.join("slot.friction.json"));
    let [count, stride] = ["count", "stride"].map(|name| usize::try_from(description[name].as_u64().unwrap()).unwrap());
    let names: Vec<_> = description["inputs"].as_array().unwrap().iter().map(|field| &field["name"]).collect();
    assert_eq!(names, ["f1", "f2", "f3", "fc_int", "mu"]);
    assert_eq!(stride, 5);
    let bytes = fs::read(points.join(description["file"].as_str().unwrap())).unwrap();
    let doubles: Vec<_> = bytes.chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect();
    assert_eq!(doubles.len(), count * stride);
    let friction: &dyn AnyFormula = &jointproof::connector::slot::Friction;
    for point in doubles.chunks(stride) {
        assert!(friction.value(point).is_ok(), "{point:?}");
    }
    let times = &read(&timing)["formulas"]["slot.friction"];
    for part in ["value", "value_and_jacobian", "copy"] {
        assert!(times[part]["median"].as_f64() > Some(0.0), "{part}: {times}");
    }
}

fn every_format_shows_every_way() {
    let bench = Bench::new();
    for format in ["text", "markdown"] {
        let ran = quick(&bench, "slot.contact_force", &["--format", format]).exits(0);
        for method in ["closed form", "automatic differentiation", "central differences", "plain square root"] {
            assert!(ran.stdout.contains(method), "{format} has no {method}: {ran:#?}");
        }
    }
}

fn what_is_no_report_is_refused_with_advice() {
    let manifest = common::repository().join("Cargo.toml");
    let ran = Bench::new().run(&["report", "--against", manifest.to_str().unwrap()]).exits(1);
    ran.says("is not a report").says("--format json");
}

/// Runs the command without building or measuring: the measuring program returns the reference, and exits with this
/// code.
fn measured(bench: &Bench, code: i32, arguments: &[&str]) -> Ran {
    bench.run_measured(&reference(), code, arguments)
}

fn a_report_on_everything_is_kept_for_the_book_unless_the_measuring_failed() {
    let bench = Bench::new();
    let kept = bench.path("target/jointproof/report.json");
    measured(&bench, 3, &["report"]).exits(1).says("ended with exit status: 3; what it said is above");
    measured(&bench, 0, &["report", "--filter", "slot.*"]).exits(0);
    assert!(!kept.exists());
    let ran = measured(&bench, 0, &["report", "--format", "json"]).exits(0).says("kept for the book in ");
    let texts = [fs::read_to_string(&kept).unwrap(), ran.stdout];
    let [kept, printed]: [Value; 2] = texts.map(|text| serde_json::from_str(&text).unwrap());
    assert_eq!(kept, printed);
    assert_eq!([&kept["build"], &kept["formulas"]], [&reference()["build"], &reference()["formulas"]]);
}
