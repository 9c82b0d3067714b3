//! Has the measuring program built and run, and follows it.

use crate::console::progress;
use crate::measuring::{Build, Event, Request, measure};
use crate::project::Project;
use anyhow::{Context, bail};
use indicatif::ProgressBar;
use jointproof::measure::{Measurement, Options};
use std::io::{BufRead, BufReader, IsTerminal};
use std::process::{Command, Stdio};

/// What the measuring program was and what it found.
pub(super) fn run(
    project: &Project,
    formulas: Vec<String>,
    options: Options,
    program: Program<'_>,
) -> anyhow::Result<(Build, Vec<Measurement>)> {
    let mut record = Record { build: None, measured: Vec::new(), bar: progress("report", 3 * formulas.len()) };
    let request = Request { formulas, options };
    match program {
        Program::This => measure(project, &request, |event| {
            record.note(event);
            Ok::<_, anyhow::Error>(())
        })?,
        Program::Built { profile } => ask(project, &request, profile, &mut record)?,
    }
    record.bar.finish_and_clear();
    Ok((record.build.context("the measuring program did not say how it was built")?, record.measured))
}

/// Which program measures.
#[derive(Clone, Copy)]
pub(crate) enum Program<'p> {
    /// The one that runs.
    This,
    /// Another one, without the commands, that cargo builds in this profile.
    Built { profile: &'p str },
}

impl Program<'_> {
    /// What is measured unless something else is asked for.
    pub(crate) const OPTIMISED: Self = Self::Built { profile: "release" };
}

/// What was said so far.
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
                // What it took to compile says nothing about the rest.
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

/// Builds this program in a profile of cargo and without what the commands need, by the same cargo, and asks it.
fn ask(project: &Project, request: &Request, profile: &str, record: &mut Record) -> anyhow::Result<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let this = std::env::current_exe()?;
    let program = this.file_stem().context("this program has no name")?;
    let mut child = Command::new(&cargo)
        .args(["run", "--profile", profile, "--no-default-features", "--features", "measure", "--manifest-path"])
        .arg(project.manifest())
        .arg("--bin")
        .arg(program)
        // Compiling takes a while the first time; somebody who watches should see that.
        .args((!std::io::stderr().is_terminal()).then_some("--quiet"))
        .args(["--", "measure"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot run {}", cargo.display()))?;
    // The end of the pipe must be dropped, so that the program sees the end of the request.
    serde_json::to_writer(child.stdin.take().context("the measuring program takes no input")?, request)?;
    let out = child.stdout.take().context("the measuring program has no output")?;
    for line in BufReader::new(out).lines() {
        record.note(serde_json::from_str(&line?).context("the measuring program said something unexpected")?);
    }
    let status = child.wait()?;
    if !status.success() {
        let manifest = project.manifest().display();
        bail!(
            "`cargo run --profile {profile} --no-default-features --features measure --manifest-path {manifest}` ended with {status}; what it said is above"
        );
    }
    Ok(())
}
