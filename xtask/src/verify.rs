//! `cargo xtask verify`: golden files, scenes, audit, statements of the documents and book, with a short summary.

use crate::book::Summary;
use crate::book::command::build_book;
use crate::console::{self, count, green, print, red, say};
use crate::report::data::Report;
use crate::selection::Selection;
use crate::{Outcome, audit, files, golden, scene, statements};
use jointproof::verify::{Audit, Options};
use std::fmt::Write;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Check everything: golden files, scenes, audit, statements of the documents, book
#[derive(clap::Args)]
#[command(after_help = "Examples:
  cargo xtask verify                  the main job
  cargo xtask verify --samples 100    a quicker audit")]
pub(crate) struct Arguments {
    /// Random points a formula in the audit
    #[arg(long, value_name = "N", default_value_t = Options::default().samples)]
    samples: usize,
}

/// One line of the summary.
struct Step {
    name: &'static str,
    passed: bool,
    counts: String,
    time: Duration,
}

pub(crate) fn run(arguments: &Arguments) -> Outcome {
    let steps = [
        step("golden", check_golden)?,
        step("scenes", check_scenes)?,
        step("audit", || check_audit(arguments.samples))?,
        step("statements", statements::verify)?,
        step("book", || Ok(check_book()))?,
    ];
    let mut summary = String::new();
    for Step { name, passed, counts, time } in &steps {
        let verdict = if *passed { green("ok ") } else { red("off") };
        writeln!(summary, "{verdict} {name:<10} {counts} in {:.1} s", time.as_secs_f64())?;
    }
    print(&summary)?;
    Ok(if steps.iter().all(|step| step.passed) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn step(name: &'static str, job: impl FnOnce() -> anyhow::Result<(bool, String)>) -> anyhow::Result<Step> {
    let start = Instant::now();
    let (passed, counts) = job()?;
    Ok(Step { name, passed, counts, time: start.elapsed() })
}

fn check_golden() -> anyhow::Result<(bool, String)> {
    let checked = golden::check(&Selection::ALL)?;
    if !checked.passed {
        say(checked.report.trim_end());
        say(golden::MEND);
    }
    Ok((checked.passed, format!("{}, {}", count(checked.formulas, "file"), count(checked.cases, "case"))))
}

fn check_scenes() -> anyhow::Result<(bool, String)> {
    let checked = scene::check()?;
    let (passed, report) = golden::scene_report(&checked);
    if !passed {
        say(report.trim_end());
        say(golden::MEND);
    }
    Ok((passed, format!("{}, {}", count(checked.scenes, "scene"), count(checked.numbers, "number"))))
}

fn check_audit(samples: usize) -> anyhow::Result<(bool, String)> {
    let audits = audit::audit(&Selection::ALL.formulas()?, &Options { samples, ..Options::default() })?;
    let failed: Vec<Audit> = audits.iter().filter(|audit| !audit.passed()).cloned().collect();
    if !failed.is_empty() {
        say(audit::text(&failed, Audit::passed)?.trim_end());
    }
    let comparisons: usize = audits.iter().flat_map(Audit::claims).map(|claim| claim.checks).sum();
    Ok((
        failed.is_empty(),
        format!("{} formulas, {comparisons} comparisons, {} formulas off", audits.len(), failed.len()),
    ))
}

fn check_book() -> (bool, String) {
    match build_book(None, Report::kept()) {
        Ok(Summary { chapters, formulas, index, .. }) => {
            (true, format!("{chapters} chapters, {formulas} formulas: {}", files::shown(&index)))
        }
        // The other verdicts stand whatever ails the book.
        Err(error) => {
            console::error(&format!("{error:#}"));
            (false, "not built".into())
        }
    }
}
