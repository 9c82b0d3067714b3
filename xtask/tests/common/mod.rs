//! The command as run by a user, in an environment that a test controls.
#![allow(dead_code, reason = "`gates`, `report` and `review` are programs of their own and use what they need")]

use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;
use tempfile::TempDir;

/// Set if a test program is to act as the measuring program.
pub const IS_MEASURED: &str = "JOINTPROOF_TEST_IS_MEASURED";

/// The repository.
pub fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// The reference report on every formula.
pub fn reference() -> Value {
    serde_json::from_slice(&fs::read(repository().join("book/report.json")).unwrap()).unwrap()
}

/// The file in which commands keep which files of the repository each formula depends on.
const REACH: &str = "target/jointproof/reach.json";

/// Determining this takes longer than auditing a formula, so it is done once.
static KNOWN: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let bench = Bench::empty();
    bench.run(&["audit", "--filter", "slot.contact_force", "--samples", "1"]).exits(0);
    fs::read(bench.path(REACH)).unwrap()
});

/// A folder to work in: commands keep their evidence and put the book there, and if a part of the repository has been
/// copied into it they treat it as the repository.
pub struct Bench {
    directory: TempDir,
    is_root: bool,
}

impl Bench {
    /// For work on the repository itself, which is not changed.
    pub fn new() -> Self {
        let bench = Self::empty();
        let known = bench.path(REACH);
        fs::create_dir_all(known.parent().unwrap()).unwrap();
        fs::write(known, &*KNOWN).unwrap();
        bench
    }

    fn empty() -> Self {
        Self { directory: tempfile::tempdir().unwrap(), is_root: false }
    }

    /// For work on copies of these files and folders of the repository.
    pub fn with(parts: &[&str]) -> Self {
        let bench = Self { directory: tempfile::tempdir().unwrap(), is_root: true };
        for part in parts {
            copy(&repository().join(part), &bench.path(part));
        }
        bench
    }

    /// A path in the folder.
    pub fn path(&self, part: &str) -> PathBuf {
        self.directory.path().join(part)
    }

    /// The command, not yet run, isolated from the environment of the test itself.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_jointproof"));
        for variable in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "RAYON_NUM_THREADS", "JOINTPROOF_ROOT"] {
            command.env_remove(variable);
        }
        command.args(arguments).env("CARGO_TARGET_DIR", self.path("target"));
        if self.is_root {
            command.env("JOINTPROOF_ROOT", self.directory.path());
        }
        command
    }

    /// Runs the command.
    pub fn run(&self, arguments: &[&str]) -> Ran {
        Ran::from(self.command(arguments).output().unwrap())
    }

    /// Runs the command without building or measuring: the measuring program returns this report, and exits with this
    /// code.
    pub fn run_measured(&self, report: &Value, code: i32, arguments: &[&str]) -> Ran {
        let begun = json!({ "Begun": report["build"] });
        let measured = report["formulas"].as_array().unwrap().iter().map(|formula| json!({ "Measured": formula }));
        let events: Vec<_> = std::iter::once(begun).chain(measured).map(|event| event.to_string()).collect();
        let [program, said] = ["program", "said"].map(|name| self.path(name));
        fs::write(&said, events.join("\n")).unwrap();
        script(&program, &format!("cat > /dev/null\ncat '{}'\nexit {code}", said.display()));
        self.run_built(&program, arguments)
    }

    /// Runs the command without building anything: `program` is the measuring program.
    pub fn run_built(&self, program: &Path, arguments: &[&str]) -> Ran {
        let [cargo, built] = ["cargo", "built"].map(|name| self.path(name));
        fs::write(&built, json!({ "executable": program }).to_string()).unwrap();
        script(&cargo, &format!("cat '{}'", built.display()));
        Ran::from(self.command(arguments).env("CARGO", &cargo).env(IS_MEASURED, "yes").output().unwrap())
    }

    /// Every file of a folder, by name, with its bytes and modification time.
    pub fn files(&self, folder: &str) -> BTreeMap<String, (Vec<u8>, std::time::SystemTime)> {
        let entry = |entry: fs::DirEntry| {
            let name = entry.file_name().into_string().unwrap();
            (name, (fs::read(entry.path()).unwrap(), entry.metadata().unwrap().modified().unwrap()))
        };
        fs::read_dir(self.path(folder)).unwrap().map(|file| entry(file.unwrap())).collect()
    }
}

/// Writes a shell script.
fn script(path: &Path, text: &str) {
    fs::write(path, format!("#!/bin/sh\n{text}\n")).unwrap();
    #[cfg(unix)]
    fs::set_permissions(path, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
}

/// Asserts that named texts are those that were reviewed and accepted, whose digests are kept in `tests/printed`. If
/// `UPDATE_PRINTED` is set in the environment, they are accepted.
pub fn assert_accepted(test: &str, kept: &str, texts: &[(String, String)]) {
    let mut now: Vec<_> =
        texts.iter().map(|(name, text)| format!("{} {:016x}", name.replace(' ', "_"), digest(text))).collect();
    now.sort();
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/printed").join(kept);
    if std::env::var_os("UPDATE_PRINTED").is_some() {
        fs::write(&kept, now.join("\n") + "\n").unwrap();
    }
    let kept = fs::read_to_string(kept).unwrap_or_default();
    let (kept, now): (BTreeSet<&str>, BTreeSet<&str>) =
        (kept.lines().collect(), now.iter().map(String::as_str).collect());
    let other: BTreeSet<_> = kept.symmetric_difference(&now).filter_map(|line| line.split(' ').next()).collect();
    assert!(
        other.is_empty(),
        "look at {other:#?}; to accept: UPDATE_PRINTED=1 cargo test -p xtask --test all {test}::"
    );
}

/// FNV-1a, the same everywhere.
fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Whether all mistakes are planted in programs of others, which takes many minutes, and not only some.
pub fn all_mistakes() -> bool {
    std::env::var_os("JOINTPROOF_ALL_MISTAKES").is_some()
}

/// Whether a program that a comparison needs is available. If not, the comparison is skipped with a message, unless it
/// is required as in `.ci/run`.
pub fn is_here(program: &str) -> bool {
    const REQUIRED: &str = "JOINTPROOF_REQUIRE_FOREIGN";
    let is_here = Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success());
    if !is_here {
        assert!(std::env::var_os(REQUIRED).is_none(), "{REQUIRED} is set, but {program} is not found");
        eprintln!("skipped: there is no {program}");
    }
    is_here
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        for entry in fs::read_dir(from).unwrap() {
            let name = entry.unwrap().file_name();
            copy(&from.join(&name), &to.join(&name));
        }
    } else {
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(from, to).unwrap();
    }
}

/// The outcome of a command.
#[derive(Debug)]
pub struct Ran {
    /// The exit code; `None` if a signal ended it.
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl From<Output> for Ran {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Self { code: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}

impl Ran {
    /// Asserts the exit code.
    #[track_caller]
    pub fn exits(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{self:#?}");
        self
    }

    /// Asserts that it succeeded without messages besides the results.
    #[track_caller]
    pub fn quiet(self) -> Self {
        let ran = self.exits(0);
        assert_eq!(ran.stderr, "");
        ran
    }

    /// Asserts that the results contain this text.
    #[track_caller]
    pub fn prints(self, expected: &str) -> Self {
        assert!(self.stdout.contains(expected), "{expected:?} is not in the standard output of\n{self:#?}");
        self
    }

    /// Asserts that the messages contain this text.
    #[track_caller]
    pub fn says(self, expected: &str) -> Self {
        assert!(self.stderr.contains(expected), "{expected:?} is not in the standard error of\n{self:#?}");
        self
    }

    /// Asserts bad usage: exit code 2, no results, and this message.
    #[track_caller]
    pub fn bad_usage(self, expected: &str) -> Self {
        let ran = self.exits(2).says(expected);
        assert_eq!(ran.stdout, "", "{ran:#?}");
        assert!(ran.stderr.starts_with("error: "), "{ran:#?}");
        ran
    }
}
