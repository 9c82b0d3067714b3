//! Builds the measuring program, runs it, and follows its events.

use crate::console::progress;
use crate::outcome::Usage;
use crate::project::Project;
use anyhow::{Context, bail};
use indicatif::ProgressBar;
use jointproof::toolkit::measure::{Measurement, Options};
use measuring::{Build, Event, Request};
use std::io::{BufRead, BufReader, IsTerminal};
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The default cargo profile for the measuring program.
pub(crate) const OPTIMISED: &str = "release";

/// Builds the measuring program in this profile; returns its build and its measurements.
pub(super) fn run(
    project: &Project,
    formulas: Vec<String>,
    options: Options,
    profile: &str,
) -> anyhow::Result<(Build, Vec<Measurement>)> {
    let mut record = Record { build: None, measured: Vec::new(), bar: progress("report", 3 * formulas.len()) };
    let request = Request { formulas, options };
    ask(project, &request, profile, &mut record)?;
    record.bar.finish_and_clear();
    Ok((record.build.context("the measuring program did not say how it was built")?, record.measured))
}

/// The events so far.
struct Record {
    build: Option<Build>,
    measured: Vec<Measurement>,
    bar: ProgressBar,
}

impl Record {
    fn note(&mut self, event: Event) {
        match event {
            Event::Begun(build) => {
                self.build = Some(build);
                // The time of compilation tells nothing about the rest.
                self.bar.reset();
            }
            Event::Compared(formula) => self.step(format!("errors of {formula}")),
            Event::Timed(formula) => self.step(format!("times of {formula}")),
            Event::Measured(measurement) => {
                self.step(format!("times of {} again", measurement.formula));
                self.measured.push(*measurement);
            }
        }
    }

    fn step(&self, what: String) {
        self.bar.set_message(what);
        self.bar.inc(1);
    }
}

/// Builds the measuring program in a cargo profile, with the same cargo, and sends it the request.
///
/// It runs as a copy, whose pages are contiguous in memory. Those of a file written by a linker may be anywhere, in which case a
/// formula whose code nearly fills the instruction cache may take one and a half times as long until the next build.
fn ask(project: &Project, request: &Request, profile: &str, record: &mut Record) -> anyhow::Result<()> {
    let built = build(project, profile)?;
    let folder = tempfile::tempdir_in(built.parent().context("it is a file")?)?;
    let copy = folder.path().join(built.file_name().context("it is a file")?);
    std::fs::copy(&built, &copy).with_context(|| format!("cannot copy {}", built.display()))?;
    let mut child = Command::new(&copy)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot run {}", copy.display()))?;
    // The pipe must be dropped, so that the program sees the end of the request.
    serde_json::to_writer(child.stdin.take().context("the measuring program takes no input")?, request)?;
    let out = child.stdout.take().context("the measuring program has no output")?;
    for line in BufReader::new(out).lines() {
        record.note(serde_json::from_str(&line?).context("the measuring program said something unexpected")?);
    }
    let status = child.wait()?;
    if !status.success() {
        bail!("`{}` ended with {status}; what it said is above", built.display());
    }
    Ok(())
}

/// The path of the built program.
fn build(project: &Project, profile: &str) -> anyhow::Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let manifest = project.measured();
    let manifest = manifest.ok_or_else(|| Usage("no program is measured: name its package by `measured_by`".into()))?;
    let mut child = Command::new(&cargo)
        .args(["build", "--profile", profile, "--bins", "--manifest-path"])
        .arg(&manifest)
        .args(["--message-format", "json-render-diagnostics"])
        // Compiling takes a while the first time, which users at a terminal should see.
        .args((!std::io::stderr().is_terminal()).then_some("--quiet"))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot run {}", cargo.display()))?;
    let mut built = None;
    for line in BufReader::new(child.stdout.take().context("cargo has no output")?).lines() {
        built = executable(&line?).or(built);
    }
    let status = child.wait()?;
    if !status.success() {
        bail!(
            "`cargo build --profile {profile} --bins --manifest-path {}` ended with {status}; what it said is above",
            manifest.display()
        );
    }
    built.with_context(|| format!("cargo did not say where it built the program of {}", manifest.display()))
}

/// The path of the program, if this line of cargo's output contains it.
fn executable(line: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    message["executable"].as_str().map(PathBuf::from)
}

#[cfg(test)]
mod tests {
    use super::executable;
    use std::path::PathBuf;

    #[test]
    fn cargo_says_where_the_program_is() {
        let line = |found: &str| format!(r#"{{"reason":"compiler-artifact","executable":{found}}}"#);
        assert_eq!(executable(&line(r#""/target/release/mine""#)), Some(PathBuf::from("/target/release/mine")));
        assert_eq!(executable(&line("null")), None);
        assert_eq!(executable("Compiling"), None);
    }
}
