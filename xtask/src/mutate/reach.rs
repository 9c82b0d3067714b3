//! Every test run once without a fault: how long it takes, and which faults it comes to.

use super::bench::Bench;
use super::build::{Binary, Built};
use super::process::{self, How};
use super::workers::in_parallel;
use crate::console::say;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, SystemTime};

/// What is kept of the runs, so that only tests that were built anew are run again.
const KEPT: &str = "reach.json";

/// A test.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Test {
    /// The program, by its number, and the name of the test in it; empty where the program is one test.
    #[serde(skip)]
    pub(super) binary: usize,
    pub(super) name: String,
    pub(super) seconds: f64,
    /// Whether it succeeds without a fault. One that does not tells nothing.
    pub(super) succeeds: bool,
    /// The names of the faults that it comes to.
    pub(super) reached: BTreeSet<String>,
}

type Kept = BTreeMap<String, (SystemTime, Vec<Test>)>;

/// Runs every test that was not run since it was built.
///
/// # Errors
/// What the file system says.
pub(super) fn reach(bench: &Bench, built: &Built, longest: Duration, jobs: usize) -> anyhow::Result<Vec<Test>> {
    let mut kept: Kept = std::fs::read_to_string(bench.beside(KEPT))
        .ok()
        .and_then(|text| serde_json::from_str(&text).ok())
        .unwrap_or_default();
    let mut all = Vec::new();
    for (number, binary) in built.binaries.iter().enumerate() {
        let modified = std::fs::metadata(&binary.path)?.modified()?;
        let key = binary.path.display().to_string();
        if kept.get(&key).is_none_or(|(time, _)| *time != modified) {
            let tests = of_binary(bench, built, binary, longest, jobs)?;
            let seconds: f64 = tests.iter().map(|test| test.seconds).sum();
            say(&format!("{}: {} tests, {seconds:.1} s", binary.name, tests.len()));
            kept.insert(key.clone(), (modified, tests));
            crate::files::write(&bench.beside(KEPT), &serde_json::to_string(&kept)?)?;
        }
        let tests = kept.get(&key).map(|(_, tests)| tests.clone()).unwrap_or_default();
        all.extend(tests.into_iter().map(|test| Test { binary: number, ..test }));
    }
    for test in all.iter().filter(|test| !test.succeeds) {
        say(&format!(
            "{} {} fails or takes too long without a fault, so it tells nothing",
            built.binaries[test.binary].name, test.name
        ));
    }
    all.retain(|test| test.succeeds);
    Ok(all)
}

fn of_binary(
    bench: &Bench,
    built: &Built,
    binary: &Binary,
    longest: Duration,
    jobs: usize,
) -> anyhow::Result<Vec<Test>> {
    let mut list = command(binary, &[]);
    list.arg("--list");
    let listed = process::run(list, longest)?.said;
    let names: Vec<&str> = listed.lines().filter_map(|line| line.strip_suffix(": test")).collect();
    // A program of its own making is one test, and says nothing of a list.
    let has_harness = listed.lines().any(|line| line.contains(" tests, ") || line.contains(" test, "));
    let names = if has_harness { names } else { vec![""] };
    in_parallel(jobs, &names, |name| {
        let folder = tempfile::tempdir_in(bench.beside(""))?;
        let names: &[&str] = if name.is_empty() { &[] } else { &[name] };
        let mut command = command(binary, names);
        command.env("JOINTPROOF_FAULTS_ASKED", folder.path());
        let ended = process::run(command, longest)?;
        let reached =
            asked(folder.path())?.iter().filter_map(|&number| Some(built.faults.get(number)?.id.clone())).collect();
        let (seconds, succeeds) = (ended.time.as_secs_f64(), ended.how == How::Well);
        Ok(Test { binary: 0, name: (*name).to_owned(), seconds, succeeds, reached })
    })
}

/// Every number in the files of a folder.
fn asked(folder: &Path) -> anyhow::Result<BTreeSet<usize>> {
    let mut all = BTreeSet::new();
    for entry in std::fs::read_dir(folder)? {
        let text = std::fs::read_to_string(entry?.path())?;
        all.extend(text.lines().filter_map(|line| line.parse::<usize>().ok()));
    }
    Ok(all)
}

/// A program, with these tests of it alone or, where none is named, all of it, as cargo would run it.
pub(super) fn command(binary: &Binary, tests: &[&str]) -> Command {
    let mut command = Command::new(&binary.path);
    command.current_dir(&binary.folder).env("CARGO_MANIFEST_DIR", &binary.folder);
    command.env("CARGO", std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.env("RAYON_NUM_THREADS", "1").env("PROPTEST_FAILURE_PERSISTENCE", "off");
    // The tests are about the copy, also where the commands are told of another project.
    command.env_remove("JOINTPROOF_ROOT");
    if !tests.is_empty() {
        command.args(["--exact", "--test-threads", "1"]).args(tests);
    }
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_run_as_cargo_would_run_it_and_repeatably() {
        let binary = Binary { name: "a".into(), path: "/target/a".into(), folder: "/tree/a".into() };
        let all = command(&binary, &[]);
        assert_eq!((all.get_program(), all.get_current_dir()), ("/target/a".as_ref(), Some("/tree/a".as_ref())));
        assert_eq!(all.get_args().count(), 0);
        let given = |name: &str| all.get_envs().find(|(key, _)| *key == name).and_then(|(_, value)| value?.to_str());
        assert_eq!(given("CARGO_MANIFEST_DIR"), Some("/tree/a"));
        assert!(given("CARGO").is_some_and(|program| program.ends_with("cargo")));
        assert_eq!([given("RAYON_NUM_THREADS"), given("PROPTEST_FAILURE_PERSISTENCE")], [Some("1"), Some("off")]);
        assert!(all.get_envs().any(|(key, value)| key == "JOINTPROOF_ROOT" && value.is_none()));
        let some = command(&binary, &["b::c", "d"]);
        assert!(some.get_args().eq(["--exact", "--test-threads", "1", "b::c", "d"]));
    }
}
