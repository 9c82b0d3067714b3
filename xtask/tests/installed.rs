//! `jointproof` as installed by `cargo install`: it judges the project in whose folder it is called, or none.

use crate::common::{self, Bench, Ran, repository};
use std::fs;
use std::path::Path;

/// The command in a folder, as somebody who installed it calls it.
fn installed_in(bench: &Bench, folder: &Path, arguments: &[&str]) -> Ran {
    let mut command = bench.command(arguments);
    for variable in ["CARGO", "CARGO_MANIFEST_DIR", "CARGO_TARGET_DIR", "JOINTPROOF_ROOT"] {
        command.env_remove(variable);
    }
    Ran::from(command.current_dir(folder).output().unwrap())
}

/// The command in an empty folder.
fn installed(bench: &Bench, arguments: &[&str]) -> Ran {
    installed_in(bench, &bench.path(""), arguments)
}

/// Commands that judge the sources of a project.
const JUDGING: [&[&str]; 7] = [
    &["verify"],
    &["golden"],
    &["golden", "--check"],
    &["audit", "--filter", "coulomb.yield"],
    &["audit", "--since", "main"],
    &["report"],
    &["book"],
];

#[test]
fn what_judges_other_programs_needs_no_project() {
    let bench = Bench::new();
    let run = |arguments: &[&str]| installed(&bench, arguments);
    run(&["formulas", "--filter", "coulomb.yield", "--show"]).quiet().prints(r"\Phi = P");
    run(&["check", "--formula", "coulomb.yield", "--driver", "python"]).quiet();
    let peer = "while read p mu fn; do echo 0 0 0 0; done";
    let wrong = run(&["check", "--formula", "coulomb.yield", "--samples", "10", "--", "sh", "-c", peer]);
    wrong.exits(1).prints("off coulomb.yield");
    run(&["equation", r"\Phi = P - \mu F_N", "--against", "coulomb.yield"]).quiet().prints("the same function");
    run(&["export", "--lang", "numpy", "--filter", "coulomb.yield", "--out", "exported"]).quiet();
    fs::write(bench.path("scene.json"), run(&["scene", "--generate", "3"]).quiet().stdout).unwrap();
    run(&["scene", "scene.json", "--format", "csv"]).quiet().prints("s0");
    run(&["complete", "bash"]).quiet().prints("jointproof");
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
}

#[test]
fn in_an_empty_folder_there_is_no_project() {
    let bench = Bench::with(&[]);
    for command in JUDGING.iter().copied().chain([&["new", "coulomb.power"][..], &["tidy"]]) {
        let ran = installed(&bench, command).bad_usage("works on the project jointproof, and neither ");
        ran.says("nor a folder above it is its folder").says("These need no project: check, ");
    }
    assert_eq!(fs::read_dir(bench.path("")).unwrap().count(), 0, "nothing is written");
}

#[test]
fn another_crate_is_not_taken_for_the_project() {
    let bench = Bench::with(&[]);
    fs::create_dir(bench.path("src")).unwrap();
    fs::write(bench.path("src/lib.rs"), "").unwrap();
    fs::write(bench.path("Cargo.toml"), "[package]\nname = \"other\"\n").unwrap();
    for command in JUDGING {
        installed(&bench, command).bad_usage("works on the project jointproof, and neither ");
    }
    let folder = bench.path("");
    let named = ["audit", "--project", &folder.to_string_lossy()];
    installed(&bench, &named).bad_usage("is not the folder of jointproof: its Cargo.toml does not name that package");
}

#[test]
fn sources_that_it_was_not_built_from_are_not_judged() {
    let bench = Bench::with(&["Cargo.toml", "src", "golden/schema.json", "golden/coulomb.yield.json"]);
    let file = bench.path("src/contact/coulomb/surface.rs");
    let sources = fs::read_to_string(&file).unwrap();
    fs::write(&file, format!("{sources}\n// One more line.\n")).unwrap();
    for command in JUDGING {
        let ran = installed(&bench, command).bad_usage("this program was built from other sources than those in ");
        ran.says(&format!("there, use `cargo xtask {}`", command[0]));
    }
    assert!(!bench.path("target").exists(), "nothing is kept");
}

#[test]
fn the_same_sources_elsewhere_are_judged_there() {
    let bench = Bench::with(&["Cargo.toml", "src", "golden/schema.json", "golden/coulomb.yield.json"]);
    let checked = ["golden", "--check", "--filter", "coulomb.yield"];
    let (below, folder) = (bench.path("src/contact"), bench.path("").to_string_lossy().into_owned());
    installed_in(&bench, &below, &checked).exits(0);
    installed_in(&bench, repository(), &[&checked[..], &["--project", &folder]].concat()).exits(0);
    assert!(bench.path("target/jointproof").exists(), "evidence is kept there");
    let file = bench.path("golden/coulomb.yield.json");
    let golden = fs::read_to_string(&file).unwrap();
    assert_eq!(golden.matches("\"phi\": -0.5").count(), 1, "{golden}");
    fs::write(&file, golden.replace("\"phi\": -0.5", "\"phi\": 0.5")).unwrap();
    installed_in(&bench, &below, &checked).exits(1).prints("coulomb.yield");
}
