//! The copy built, with all faults that the compiler takes.

use super::bench::Bench;
use super::choice::{self, Choice};
use super::fault::Fault;
use super::plant::Planted;
use crate::console::{count, say};
use anyhow::{Context, bail, ensure};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What is tried before giving up: the compiler says a part of what it has to say at a time.
const ROUNDS: usize = 40;
/// Where it is kept which faults the compiler refuses.
const REFUSED: &str = "refused.json";

/// Which tests are built and run.
#[derive(clap::Args)]
pub(super) struct Programs {
    /// Only the tests of this package
    #[arg(long, value_name = "NAME")]
    pub(super) package: Option<String>,
    /// Only this program of tests; may be given several times
    #[arg(long, value_name = "NAME")]
    pub(super) test: Vec<String>,
}

impl Programs {
    /// As cargo takes them.
    fn arguments(&self) -> Vec<&str> {
        let packages = self.package.as_deref().map_or(vec!["--workspace"], |package| vec!["--package", package]);
        packages.into_iter().chain(self.test.iter().flat_map(|test| ["--test", test])).collect()
    }
}

impl fmt::Display for Programs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.test.is_empty() {
            write!(f, "{} of ", self.test.join(", "))?;
        }
        f.write_str(self.package.as_deref().unwrap_or("every package"))
    }
}

/// A program with tests.
#[derive(Clone, Debug)]
pub(super) struct Binary {
    /// As the target is called, with the package's name before it where that is not the first.
    pub(super) name: String,
    pub(super) path: PathBuf,
    /// The folder of its package.
    pub(super) folder: PathBuf,
}

/// What the build made.
pub(super) struct Built {
    pub(super) faults: Vec<Fault>,
    pub(super) binaries: Vec<Binary>,
}

/// A message of cargo, of which only this is read.
#[derive(Deserialize)]
struct Message {
    reason: String,
    #[serde(rename = "message")]
    diagnostic: Option<Diagnostic>,
    target: Option<Target>,
    executable: Option<PathBuf>,
    manifest_path: Option<PathBuf>,
    profile: Option<Profile>,
}

#[derive(Deserialize)]
struct Diagnostic {
    level: String,
    rendered: Option<String>,
    spans: Vec<Span>,
}

#[derive(Deserialize)]
struct Span {
    file_name: String,
    byte_start: usize,
    byte_end: usize,
    is_primary: bool,
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

#[derive(Deserialize)]
struct Profile {
    test: bool,
}

impl Message {
    /// The program with tests that was built.
    fn test(self, tree: &Path) -> Option<Binary> {
        let is_test = self.reason == "compiler-artifact" && self.profile?.test;
        let folder = self.manifest_path?.parent()?.to_path_buf();
        let (path, name) = (self.executable?, name(tree, &folder, &self.target?.name));
        is_test.then_some(Binary { name, path, folder })
    }
}

impl Diagnostic {
    /// Whether it is an error at some place, and not the one that says how many there are.
    fn is_error(&self) -> bool {
        self.level == "error" && !self.spans.is_empty()
    }
}

/// Plants faults and builds all tests. A fault that the compiler refuses is planted in a larger part of the source; if there is
/// none it is given up, and another one is taken.
///
/// # Errors
/// An error of the compiler that no fault is to blame for, or a fault of a list that it refuses.
pub(super) fn build(bench: &Bench, choice: &Choice, per_area: usize, programs: &Programs) -> anyhow::Result<Built> {
    let sources = bench.sources()?;
    let (mut refused, mut places) = load(bench);
    for _ in 0..ROUNDS {
        let faults: Vec<_> = choice
            .take(per_area, &refused)
            .into_iter()
            .map(|fault| {
                let place = places.get(&choice::key(&fault)).copied().unwrap_or(0);
                (fault, place)
            })
            .collect();
        let planted = bench.plant(&faults, &sources)?;
        let (binaries, errors) = cargo(bench, programs)?;
        if errors.is_empty() {
            bench.clear()?;
            let listed = choice.refused(&refused).join(", ");
            ensure!(listed.is_empty(), "the compiler refuses faults of the lists: {listed}");
            let faults = faults.into_iter().map(|(fault, _)| fault).collect();
            return Ok(Built { faults, binaries });
        }
        let blamed = blamed(&planted, &errors)?;
        say(&format!("the compiler refuses {}", count(blamed.len(), "fault")));
        for number in blamed {
            let (fault, place) = &faults[number];
            if place + 1 < fault.places.len() {
                places.insert(choice::key(fault), place + 1);
            } else {
                refused.insert(choice::key(fault));
            }
        }
        let kept = serde_json::to_string_pretty(&(&refused, &places))?;
        crate::files::write(&bench.beside(REFUSED), &kept)?;
    }
    bail!("the compiler still refuses faults after {ROUNDS} rounds")
}

/// What was refused the last time; whoever changes a source changes where its faults are, which costs a round.
fn load(bench: &Bench) -> (BTreeSet<String>, BTreeMap<String, usize>) {
    let text = std::fs::read_to_string(bench.beside(REFUSED)).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

/// The faults that the compiler has refused.
pub(super) fn refused(bench: &Bench) -> BTreeSet<String> {
    load(bench).0
}

/// The faults that are to blame for errors.
fn blamed(planted: &BTreeMap<String, Planted>, errors: &[Diagnostic]) -> anyhow::Result<BTreeSet<usize>> {
    let mut all = BTreeSet::new();
    for error in errors {
        let of = |span: &&Span| {
            planted.get(&span.file_name).map_or(Vec::new(), |p| p.blamed(&(span.byte_start..span.byte_end)))
        };
        let (primary, others): (Vec<_>, Vec<_>) = error.spans.iter().partition(|span| span.is_primary);
        let mut found: Vec<usize> = primary.iter().flat_map(of).collect();
        if found.is_empty() {
            found = others.iter().flat_map(of).collect();
        }
        all.extend(found);
    }
    if all.is_empty() {
        let said: Vec<_> = errors.iter().filter_map(|error| error.rendered.as_deref()).collect();
        bail!("this does not build, and no fault is to blame:\n{}", said.concat());
    }
    Ok(all)
}

/// Builds the tests: the programs, or the compiler's errors.
fn cargo(bench: &Bench, programs: &Programs) -> anyhow::Result<(Vec<Binary>, Vec<Diagnostic>)> {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.arg("test").args(programs.arguments()).args(["--no-run", "--no-fail-fast", "--message-format", "json"]);
    command.current_dir(bench.tree()).env("CARGO_TARGET_DIR", bench.beside("target"));
    command.env("CARGO_PROFILE_DEV_DEBUG", "none");
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().context("cannot start cargo")?;
    let (mut binaries, mut errors) = (Vec::new(), Vec::new());
    for line in BufReader::new(child.stdout.take().context("it is piped")?).lines() {
        let Ok(message) = serde_json::from_str::<Message>(&line?) else { continue };
        match message {
            Message { diagnostic: Some(diagnostic), .. } if diagnostic.is_error() => errors.push(diagnostic),
            message => binaries.extend(message.test(&bench.tree())),
        }
    }
    let well = child.wait()?.success();
    ensure!(well || !errors.is_empty(), "this does not build");
    binaries.sort_by(|a, b| a.name.cmp(&b.name));
    Ok((binaries, errors))
}

fn name(tree: &Path, folder: &Path, target: &str) -> String {
    match folder.strip_prefix(tree) {
        Ok(inside) if !inside.as_os_str().is_empty() => format!("{}/{target}", inside.display()),
        _ => target.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::Range;

    #[test]
    fn programs_are_named_to_cargo_and_to_readers() {
        let all = Programs { package: None, test: Vec::new() };
        assert_eq!((all.arguments(), all.to_string()), (vec!["--workspace"], "every package".to_owned()));
        let two = Programs { package: Some("tiny".into()), test: vec!["sums".into(), "roots".into()] };
        assert_eq!(two.arguments(), ["--package", "tiny", "--test", "sums", "--test", "roots"]);
        assert_eq!(two.to_string(), "sums, roots of tiny");
    }

    #[test]
    fn the_fault_that_an_error_points_at_is_to_blame() {
        let switches = vec![(0, 0..20, 5..10), (1, 30..50, 35..40)];
        let planted = BTreeMap::from([("a.rs".to_owned(), Planted { text: String::new(), switches })]);
        let span = |at: Range<usize>, is_primary| Span {
            file_name: "a.rs".into(),
            byte_start: at.start,
            byte_end: at.end,
            is_primary,
        };
        let blamed = |spans: [Span; 2]| {
            let error =
                Diagnostic { level: "error".into(), rendered: Some("mismatched types".into()), spans: spans.into() };
            blamed(&planted, &[error]).map(|all| all.into_iter().collect::<Vec<_>>())
        };
        assert_eq!(blamed([span(6..8, true), span(36..38, false)]).unwrap(), [0]);
        assert_eq!(blamed([span(90..91, true), span(36..38, false)]).unwrap(), [1]);
        let nobody = blamed([span(90..91, true), span(95..96, false)]).unwrap_err().to_string();
        assert!(nobody.contains("mismatched types"), "{nobody}");
    }

    #[test]
    fn of_what_cargo_says_programs_with_tests_are_taken() {
        let built = |reason: &str, executable: &str, folder: &str, test: bool| {
            let message = format!(
                "{{\"reason\": \"{reason}\", \"executable\": {executable}, \"target\": {{\"name\": \"audit\"}}, \
                 \"manifest_path\": \"/tree/{folder}Cargo.toml\", \"profile\": {{\"test\": {test}}}}}"
            );
            let message: Message = serde_json::from_str(&message).unwrap();
            message.test(Path::new("/tree")).map(|binary| (binary.name, binary.path, binary.folder))
        };
        let taken = |name: &str, folder: &str| Some((name.to_owned(), "/target/a".into(), folder.into()));
        assert_eq!(built("compiler-artifact", "\"/target/a\"", "", true), taken("audit", "/tree"));
        assert_eq!(built("compiler-artifact", "\"/target/a\"", "tool/", true), taken("tool/audit", "/tree/tool"));
        assert_eq!(built("compiler-artifact", "\"/target/a\"", "", false), None);
        assert_eq!(built("build-script-executed", "\"/target/a\"", "", true), None);
        assert_eq!(built("compiler-artifact", "null", "", true), None);
    }

    #[test]
    fn an_error_is_one_that_has_a_place() {
        let is_error = |level: &str, places: usize| {
            let span = |_| Span { file_name: "a.rs".into(), byte_start: 1, byte_end: 2, is_primary: true };
            Diagnostic { level: level.into(), rendered: None, spans: (0..places).map(span).collect() }.is_error()
        };
        assert!(is_error("error", 1) && is_error("error", 2) && !is_error("error", 0) && !is_error("warning", 1));
    }
}
