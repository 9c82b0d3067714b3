//! `verify`: requirements on formulas, golden files, certificates, audit, chapters and book, with a short summary.

use crate::book::{Summary, build_book};
use crate::console::{self, count, green, red, say, show};
use crate::golden::{self, Checked};
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::prove::Certified;
use crate::report::data::Report;
use crate::selection::Selection;
use crate::{audit, elements, missing, prose, prove};
use jointproof::toolkit::verify::{Audit, Options};
use judge::audited;
use std::time::{Duration, Instant};

/// Check everything: golden files, proved bounds, audit, statements, chapters, book
///
/// A formula of which this very program has found already that every claim holds is not audited again: it would find the same.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} verify                  the main job
  {command} verify --samples 100    a quicker audit
  {command} verify --fresh          audits again what it knows")]
pub(crate) struct Arguments {
    /// Random points per formula in the audit; a tenth of them per element, or fewer
    #[arg(long, value_name = "N", default_value_t = Options::default().samples)]
    samples: usize,
    /// Audit every formula, also those of which it is known that every claim holds
    #[arg(long)]
    fresh: bool,
}

/// One line of the summary.
struct Step {
    name: &'static str,
    passed: bool,
    counts: String,
    time: Duration,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    project.needs_sources("verify")?;
    let mut steps = vec![step("missing", || check_missing(project))?];
    steps.push(step("golden", || Ok(outcome(project, golden::check(project, &Selection::ALL)?)))?);
    if prove::has_certificates(project) {
        steps.push(step("bounds", || check_bounds(project))?);
    }
    if let Some((name, beside)) = project.extension.beside {
        steps.push(step(name, || Ok(outcome(project, golden::check_beside(project, &beside(project)?))))?);
    }
    steps.push(step("audit", || check_audit(project, arguments))?);
    if !project.elements().is_empty() {
        steps.push(step("elements", || check_elements(project, arguments))?);
    }
    for (name, check) in &project.extension.checks {
        steps.push(step(name, || check(project))?);
    }
    steps.push(step("prose", || check_prose(project))?);
    steps.push(step("book", || Ok(check_book(project)))?);
    show(&summary(&steps))?;
    Ok(verdict(steps.iter().all(|step| step.passed)))
}

/// One line per step, with the counts aligned in a column.
fn summary(steps: &[Step]) -> String {
    let width = steps.iter().map(|step| step.name.len()).max().unwrap_or_default();
    let line = |Step { name, passed, counts, time }: &Step| {
        let mark = if *passed { green("ok ") } else { red("off") };
        format!("{mark} {name:<width$} {counts} in {:.1} s\n", time.as_secs_f64())
    };
    steps.iter().map(line).collect()
}

fn step(name: &'static str, job: impl FnOnce() -> anyhow::Result<(bool, String)>) -> anyhow::Result<Step> {
    let start = Instant::now();
    let (passed, counts) = job()?;
    Ok(Step { name, passed, counts, time: start.elapsed() })
}

/// Reports the differences of golden files, in full.
fn outcome(project: &Project, Checked { passed, counts, report }: Checked) -> (bool, String) {
    if !passed {
        say(report.trim_end());
        golden::say_what_mends(project);
    }
    (passed, counts)
}

/// Adds up every certificate.
fn check_bounds(project: &Project) -> anyhow::Result<(bool, String)> {
    let Certified { passed, counts, off } = prove::check(project, &Selection::ALL)?;
    if !passed {
        say(off.trim_end());
        prove::say_what_mends(project);
    }
    Ok((passed, counts))
}

fn check_missing(project: &Project) -> anyhow::Result<(bool, String)> {
    let missing = missing::missing(project, project.catalog())?;
    if !missing.is_empty() {
        say(missing.concat().trim_end());
    }
    Ok((missing.is_empty(), missing::summary(project.catalog().len(), &missing)))
}

fn check_audit(project: &Project, arguments: &Arguments) -> anyhow::Result<(bool, String)> {
    let options = Options { samples: arguments.samples, ..Options::default() };
    let (audits, known) = if arguments.fresh {
        (audit::audit(project, project.catalog(), &options)?, 0)
    } else {
        audit::audit_unknown(project, project.catalog(), &options)?
    };
    let failed: Vec<Audit> = audits.iter().filter(|audit| !audit.passed()).cloned().collect();
    if !failed.is_empty() {
        say(audited::text(&failed, Audit::passed, &|audit| prove::of_audit(project, audit))?.trim_end());
    }
    let comparisons = audits.iter().flat_map(Audit::claims).map(|claim| claim.checks).sum();
    let [audited, comparisons, off] =
        [(audits.len(), "formula"), (comparisons, "comparison"), (failed.len(), "formula")]
            .map(|(number, noun)| count(number, noun));
    let known = if known == 0 { String::new() } else { format!(", {known} known from before") };
    Ok((failed.is_empty(), format!("{audited}, {comparisons}, {off} off{known}")))
}

fn check_elements(project: &Project, arguments: &Arguments) -> anyhow::Result<(bool, String)> {
    let options = Options { samples: arguments.samples, ..Options::default() };
    let audits = elements::audit(project.elements(), &options);
    let failed: Vec<_> = audits.iter().filter(|audit| !audit.passed()).cloned().collect();
    if !failed.is_empty() {
        say(elements::text(&failed)?.trim_end());
    }
    Ok((failed.is_empty(), elements::total(&audits)))
}

/// Reports the faults in the mathematics and the numbers of chapters.
fn check_prose(project: &Project) -> anyhow::Result<(bool, String)> {
    let (faults, counts) = prose::check(project)?;
    for fault in &faults {
        say(&fault.to_string());
    }
    Ok((faults.is_empty(), counts))
}

fn check_book(project: &Project) -> (bool, String) {
    match build_book(project, None, Report::kept(project)) {
        Ok(Summary { chapters, formulas, index, .. }) => {
            let [chapters, formulas] =
                [(chapters, "chapter"), (formulas, "formula")].map(|(number, noun)| count(number, noun));
            (true, format!("{chapters}, {formulas}: {}", project.shown(&index)))
        }
        // The other verdicts remain valid, whatever is wrong with the book.
        Err(error) => {
            console::error(&format!("{error:#}"));
            (false, "not built".into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_is_a_line_a_step_with_what_was_looked_at_in_a_column() {
        let step = |name, passed, counts: &str, milliseconds| Step {
            name,
            passed,
            counts: counts.into(),
            time: Duration::from_millis(milliseconds),
        };
        let steps = [step("missing", true, "1 formula", 0), step("statements", false, "2 sides", 1234)];
        let expected = "ok  missing    1 formula in 0.0 s\noff statements 2 sides in 1.2 s\n";
        assert_eq!(console::plain(&summary(&steps)), expected);
        assert_eq!(summary(&[]), "");
    }
}
