//! `cargo xtask tidy` as run by a user, on a copy of the repository.

use crate::common::Bench;
use std::fs;

const REPOSITORY: [&str; 6] = ["ARCHITECTURE.md", "Cargo.toml", "book/src", "src", "tests", "xtask"];

/// Appends a line to a file.
fn append(bench: &Bench, file: &str, line: &str) {
    let text = fs::read_to_string(bench.path(file)).unwrap();
    fs::write(bench.path(file), format!("{text}{line}\n")).unwrap();
}

#[test]
fn a_circle_planted_in_the_repository_is_found() {
    let bench = Bench::with(&REPOSITORY);
    let before = bench.run(&["tidy", "circles"]);
    assert!(!before.stdout.contains("src/formula/quantity.rs"), "{before:#?}");
    append(&bench, "src/formula/quantity.rs", "use crate::connector::slot::Friction as Planted;");
    let ran = bench.run(&["tidy", "circles"]).exits(1);
    ran.prints("src/formula/quantity.rs → src/connector/slot/")
        .prints("use crate::connector::slot::Friction as Planted")
        .prints("use crate::formula::quantity::");
}

#[test]
fn what_is_planted_in_the_repository_is_found_by_each_rule() {
    let bench = Bench::with(&REPOSITORY);
    append(&bench, "src/number/scalar.rs", "const PLANTED: &str = \"slot.friction\";");
    append(&bench, "src/number/scalar.rs", "type Planted = crate::connector::slot::Friction;");
    append(&bench, "src/number/scalar.rs", &"// Planted.\n".repeat(500));
    append(&bench, "book/src/slot.md", "\n{{#formula slot.friction}}");
    let mut ran = bench.run(&["tidy", "ids", "layers", "lengths", "directives"]).exits(1);
    for expected in [
        "the identifier \"slot.friction\" is typed; write `Friction::SPEC.id`",
        "`crate::connector::slot::Friction`: ARCHITECTURE.md has `number` below `connector`",
        "src/number/scalar.rs: ",
        "formula `slot.friction` has its entry already, at book/src/slot.md:",
    ] {
        ran = ran.prints(expected);
    }
}

#[test]
fn an_unknown_rule_is_bad_usage() {
    Bench::new().run(&["tidy", "circle"]).bad_usage("circles");
}
