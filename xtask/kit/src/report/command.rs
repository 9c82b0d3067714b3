//! `report`: its arguments and its output, and the files it keeps.

use super::data::Report;
use super::measuring::{self, OPTIMISED};
use super::{against, export, tables};
use crate::console::{print, say};
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::prove;
use crate::selection::Selection;
use anyhow::Context;
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::measure::Options;
use std::path::PathBuf;

/// Measure speed and error of every method to compute a formula
///
/// Closed form, single precision, automatic differentiation, differences, 237-bit arithmetic and other methods that a
/// formula registers are compared with the exact value at random and at hard points, and timed alternately. The
/// measurement runs in a program built with optimisation, which the first run compiles. A report on all formulas is stored
/// for the book.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} report                              all formulas, more than ten minutes
  {command} report --quick --filter '{family}.*'    a first look
  {command} report --quick --reference          and keep it for the book of all
  {command} report --format json > old.json     to keep
  {command} report --against old.json           what became worse; exit code 1 if anything did
  {command} report --inputs points              points for a program in another language
  {command} report --timing-json times.json     times of the closed forms at these points")]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: Selection,
    /// Fewer points and rounds, and columns that the caches hold: a minute or two for all formulas
    #[arg(long)]
    quick: bool,
    /// Random points at which errors are found [default: 1000, or 50 if quick]
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// How often each method is timed [default: 301, or 61 if quick]
    #[arg(long, value_name = "N")]
    rounds: Option<usize>,
    /// Bytes of the columns over which batches are timed [default: 134217728, or 524288 if quick]
    #[arg(long, value_name = "N")]
    columns: Option<usize>,
    /// Format of the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Compare with a report written by --format json
    #[arg(long, value_name = "FILE")]
    against: Option<PathBuf>,
    /// Write the points of the time measurement as little-endian doubles, with a description in JSON
    #[arg(long, value_name = "FOLDER")]
    inputs: Option<PathBuf>,
    /// Write nanoseconds per value, and per value with Jacobian, for each formula
    #[arg(long, value_name = "FILE")]
    timing_json: Option<PathBuf>,
    /// Keep the report in the repository, too, for the book on machines where nothing was measured
    #[arg(long, conflicts_with_all = ["profile", "filter"])]
    reference: bool,
    /// Profile of cargo that the measuring program is built in, such as one of yours that keeps symbols for a profiler
    #[arg(long, value_name = "NAME", default_value = OPTIMISED)]
    profile: String,
    /// Print the schema of reports in JSON, and measure nothing
    #[arg(long)]
    schema: bool,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Format {
    /// For a terminal
    Text,
    /// For a code review
    Markdown,
    /// For a program, and for --against
    Json,
}

impl Arguments {
    /// The extent of the measurements.
    fn options(&self) -> Options {
        let options = if self.quick { Options::quick() } else { Options::full() };
        Options {
            random_points: self.samples.unwrap_or(options.random_points),
            rounds: self.rounds.unwrap_or(options.rounds),
            column_bytes: self.columns.unwrap_or(options.column_bytes),
            ..options
        }
    }
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    if arguments.schema {
        print(&serde_json::to_string_pretty(&schemars::schema_for!(Report))?)?;
        return Ok(verdict(true));
    }
    project.needs_sources("report")?;
    let formulas = arguments.selection.formulas(project)?;
    let old = arguments.against.as_deref().map(Report::read).transpose()?;
    let options = arguments.options();
    if let Some(folder) = &arguments.inputs {
        export::inputs(folder, &formulas, &options)?;
    }
    let report = measure(project, &formulas, options, &arguments.profile)?;
    if arguments.selection.is_all() {
        keep(project, &report, arguments.reference)?;
    }
    if let Some(path) = &arguments.timing_json {
        export::timing(path, &report)?;
    }
    let is_asked = arguments.selection.is_asked()?;
    let comparison = old.map(|old| against::compare(&old, &report, is_asked));
    let accuracy = |id: &str| project.find(id).map(|formula| prove::accuracy(project, formula, None));
    match (arguments.format, &comparison) {
        (Format::Json, _) => print(&serde_json::to_string_pretty(&report)?)?,
        (Format::Text | Format::Markdown, Some(comparison)) => print(&comparison.text())?,
        (Format::Text, None) => print(&tables::text(&report, &accuracy)?)?,
        (Format::Markdown, None) => print(&tables::markdown(&report, &accuracy)?)?,
    }
    if let (Format::Json, Some(comparison)) = (arguments.format, &comparison) {
        say(&comparison.text());
    }
    let worse = comparison.is_some_and(|comparison| !comparison.changes.is_empty());
    Ok(verdict(!worse))
}

/// Keeps a complete report for the book here, and in the repository if it is to be the reference.
fn keep(project: &Project, report: &Report, is_reference: bool) -> anyhow::Result<()> {
    say(&format!("kept for the book in {}", project.shown(&report.keep(project)?)));
    if is_reference {
        say(&format!("and as the reference in {}", project.shown(&report.keep_as_reference(project)?)));
    }
    Ok(())
}

/// Measures these formulas with a program that cargo builds in this profile.
pub(crate) fn measure(
    project: &Project,
    formulas: &[&dyn AnyFormula],
    options: Options,
    profile: &str,
) -> anyhow::Result<Report> {
    let ids = formulas.iter().map(|formula| formula.spec().id.to_owned()).collect();
    let (build, formulas) = measuring::run(project, ids, options, profile).context("the measuring failed")?;
    Ok(Report::new(project, build, options, formulas))
}

/// The report kept for the book, here or in the repository, or a quick one made now if none covers every formula.
pub(crate) fn kept_or_quick(project: &Project) -> anyhow::Result<Report> {
    if let Some(kept) = Report::kept(project) {
        return Ok(kept);
    }
    let command = project.command();
    say(&format!("no report on every formula is kept: measuring quickly; `{command} report` measures thoroughly"));
    let report = measure(project, project.catalog(), Options::quick(), OPTIMISED)?;
    report.keep(project)?;
    Ok(report)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{Args, FromArgMatches};

    #[test]
    fn as_much_is_measured_as_is_asked_for() {
        let options = |arguments: &[&str]| {
            let command = Arguments::augment_args(clap::Command::new("report").no_binary_name(true));
            Arguments::from_arg_matches(&command.try_get_matches_from(arguments).unwrap()).unwrap().options()
        };
        assert_eq!([options(&[]), options(&["--quick"])], [Options::full(), Options::quick()]);
        let some = options(&["--samples", "3", "--rounds", "4", "--columns", "5"]);
        assert_eq!(some, Options { random_points: 3, rounds: 4, column_bytes: 5, ..Options::full() });
    }

    /// Nothing can be built here, so that only kept reports are available.
    #[test]
    fn what_is_kept_is_not_measured_anew_and_what_is_not_is_by_an_optimised_program() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("anew", root.path().to_str().unwrap().to_owned().leak(), &[]);
        // In a shared target folder it outlives the test.
        let _ = std::fs::remove_file(project.kept("report.json"));
        let said = kept_or_quick(&project).unwrap_err().to_string();
        assert_eq!(said, "the measuring failed");
        let report = crate::sample::report();
        report.keep(&project).unwrap();
        assert_eq!(kept_or_quick(&project).unwrap(), report);
    }

    #[test]
    fn a_report_is_the_reference_only_if_it_is_to_be() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("kept", root.path().to_str().unwrap().to_owned().leak(), &[]);
        let report = crate::sample::report();
        let reference = report.keep_as_reference(&project).unwrap();
        for is_reference in [false, true] {
            let _ = std::fs::remove_file(&reference);
            keep(&project, &report, is_reference).unwrap();
            assert_eq!((Report::kept(&project).as_ref(), reference.exists()), (Some(&report), is_reference));
        }
    }
}
