//! A failing audit as seen by reviewers. This program is both the tests and, on request, a project whose only formula
//! has a wrong derivative; therefore it has no test harness.

#[path = "common/broken.rs"]
mod broken;
mod common;

use common::{Ran, repository};
use kit::Project;
use serde_json::Value;
use std::process::{Command, ExitCode};

/// Set if this program is to act as the project.
const IS_PROJECT: &str = "JOINTPROOF_TEST_IS_PROJECT";

fn main() -> ExitCode {
    if std::env::var_os(IS_PROJECT).is_some() {
        return kit::main(Project::new("review", env!("CARGO_MANIFEST_DIR"), &[&broken::Square]));
    }
    // Listing or filtering tests runs none of these.
    if std::env::args().len() == 1 {
        a_failing_audit_stands_on_the_line_of_the_derivative();
        a_failing_audit_of_a_change_stands_on_the_changed_line();
        what_is_missing_is_no_finding_and_fails();
    }
    ExitCode::SUCCESS
}

/// A folder with the formula's source, in which it is audited.
struct Review(tempfile::TempDir);

impl Review {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("src")).unwrap();
        std::fs::copy(repository().join("xtask/tests/common/broken.rs"), folder.path().join("src/broken.rs")).unwrap();
        Self(folder)
    }

    fn run(&self, arguments: &[&str]) -> Ran {
        let mut command = Command::new(std::env::current_exe().unwrap());
        command.args(arguments).env(IS_PROJECT, "yes").env("JOINTPROOF_ROOT", self.0.path());
        command.env("CARGO_TARGET_DIR", self.0.path().join("target"));
        command.env("GITHUB_STEP_SUMMARY", self.0.path().join("summary.md")).env("NO_COLOR", "1");
        Ran::from(command.output().unwrap())
    }
}

fn a_failing_audit_stands_on_the_line_of_the_derivative() {
    let review = Review::new();
    review.run(&["golden"]);
    let source = std::fs::read_to_string(review.0.path().join("src/broken.rs")).unwrap();
    let line = 1 + source.lines().position(|line| line.contains("fn jacobian")).unwrap();
    let audit = |format: &str| review.run(&["audit", "--samples", "20", "--format", format]).exits(1).stdout;

    let github = audit("github");
    let errors: Vec<_> = github.lines().filter(|line| line.starts_with("::error ")).collect();
    let [error] = errors[..] else { panic!("one fault is one annotation: {github}") };
    assert!(error.starts_with(&format!("::error file=src/broken.rs,line={line},title=broken.square%3A ")), "{error}");
    assert!(error.contains("--point '{\"a\":") && error.contains("%0Aalso: broken.square: "), "{error}");
    let summary = std::fs::read_to_string(review.0.path().join("summary.md")).unwrap();
    assert!(summary.contains("broken.square"), "{summary}");

    let sarif: Value = serde_json::from_str(&audit("sarif")).unwrap();
    let results = sarif["runs"][0]["results"].as_array().unwrap();
    assert!(!results.is_empty());
    for result in results {
        let place = &result["locations"][0]["physicalLocation"];
        assert_eq!(place["artifactLocation"]["uri"], "src/broken.rs", "{result}");
        assert_eq!(place["region"]["startLine"], line, "{result}");
        assert!(result["partialFingerprints"].as_object().is_some_and(|prints| !prints.is_empty()), "{result}");
    }

    let rdjson: Value = serde_json::from_str(&audit("rdjson")).unwrap();
    let diagnostics = rdjson["diagnostics"].as_array().unwrap();
    assert_eq!(diagnostics.len(), 1, "{diagnostics:?}");
    assert_eq!(diagnostics[0]["location"]["path"], "src/broken.rs");
    assert_eq!(diagnostics[0]["location"]["range"]["start"]["line"], line);
}

fn a_failing_audit_of_a_change_stands_on_the_changed_line() {
    let review = Review::new();
    let git = |arguments: &[&str]| {
        let identity = ["-c", "user.name=a", "-c", "user.email=a@b"];
        let output = Command::new("git").args(identity).args(arguments).current_dir(review.0.path()).output();
        assert!(output.unwrap().status.success(), "{arguments:?}");
    };
    let source = review.0.path().join("src/broken.rs");
    let text = std::fs::read_to_string(&source).unwrap();
    let sign = text.lines().position(|line| line.contains("-2.0")).expect("the fault is a sign");
    std::fs::write(&source, text.replace("-2.0", "2.0")).unwrap();
    git(&["init", "--quiet"]);
    git(&["add", "."]);
    git(&["commit", "--quiet", "--message", "before"]);
    std::fs::write(&source, text).unwrap();
    let github = review.run(&["audit", "--since", "HEAD", "--samples", "20", "--format", "github"]).exits(1).stdout;
    assert!(github.starts_with(&format!("::error file=src/broken.rs,line={},", sign + 1)), "{github}");
}

fn what_is_missing_is_no_finding_and_fails() {
    let review = Review::new();
    let point = ["audit", "--filter", "broken.square", "--point", "{\"a\": 0}", "--format", "sarif"];
    // At a = 0 the wrong sign does not show, and the audit of a single point requires no further evidence.
    let sarif: Value = serde_json::from_str(&review.run(&point).quiet().stdout).unwrap();
    assert_eq!(sarif["runs"][0]["results"], Value::Array(Vec::new()));
    let ran = review.run(&["audit", "--samples", "20", "--format", "github"]).exits(1);
    ran.says("broken.square lacks").says("its golden file");
}
