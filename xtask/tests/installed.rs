//! `jointproof` as installed by `cargo install`: outside any repository.

use crate::common::{self, Bench, Ran};
use std::fs;

/// The command in an empty folder, without a repository.
fn installed(bench: &Bench, arguments: &[&str]) -> Ran {
    let mut command = bench.command(arguments);
    command.current_dir(bench.path("")).env("JOINTPROOF_ROOT", bench.path("gone"));
    command.env_remove("CARGO").env_remove("CARGO_TARGET_DIR");
    Ran::from(command.output().unwrap())
}

#[test]
fn what_judges_formulas_and_other_programs_needs_no_repository() {
    let bench = Bench::new();
    let run = |arguments: &[&str]| installed(&bench, arguments);
    run(&["formulas", "--filter", "coulomb.yield", "--show"]).quiet().prints(r"\Phi = P");
    run(&["audit", "--filter", "coulomb.yield", "--samples", "50"]).quiet().prints("ok  coulomb.yield");
    for format in ["github", "sarif", "rdjson", "json", "markdown"] {
        run(&["audit", "--filter", "coulomb.yield", "--samples", "50", "--format", format]).quiet();
    }
    run(&["check", "--formula", "coulomb.yield", "--driver", "python"]).quiet();
    let peer = "while read p mu fn; do echo 0 0 0 0; done";
    let wrong = run(&["check", "--formula", "coulomb.yield", "--samples", "10", "--", "sh", "-c", peer]);
    wrong.exits(1).prints("off coulomb.yield");
    run(&["equation", r"\Phi = P - \mu F_N", "--against", "coulomb.yield"]).quiet().prints("the same function");
    run(&["export", "--lang", "numpy", "--filter", "coulomb.yield", "--out", "exported"]).quiet();
    fs::write(bench.path("scene.json"), run(&["scene", "--generate", "3"]).quiet().stdout).unwrap();
    run(&["scene", "scene.json", "--format", "csv"]).quiet().prints("s0");
    run(&["complete", "bash"]).quiet().prints("jointproof");
    assert!(!bench.path("gone").exists());
}

#[test]
fn golden_cases_are_written_to_a_folder() {
    let bench = Bench::new();
    installed(&bench, &["golden", "--out", "cases", "--filter", "coulomb.*"]).quiet().prints("cases in cases");
    let files = bench.files("cases");
    assert!(files.contains_key("schema.json") && files.contains_key("coulomb.yield.json"), "{:?}", files.keys());
    assert!(files.keys().all(|name| name == "schema.json" || name.starts_with("coulomb.")), "{:?}", files.keys());
    for (name, (bytes, _)) in files {
        assert_eq!(bytes, fs::read(common::repository().join("golden").join(&name)).unwrap(), "{name}");
    }
    assert!(!bench.path("gone").exists());
}

#[test]
fn what_works_on_the_repository_says_that_it_is_not_there() {
    let bench = Bench::new();
    let commands: [&[&str]; 8] = [
        &["verify"],
        &["golden"],
        &["golden", "--check"],
        &["audit", "--since", "main"],
        &["report"],
        &["book"],
        &["new", "coulomb.power"],
        &["tidy"],
    ];
    for command in commands {
        installed(&bench, command)
            .bad_usage("works on the repository, and ")
            .says("gone is not there; say where it is");
    }
    assert!(!bench.path("gone").exists());
}
