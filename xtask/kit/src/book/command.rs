//! `book`: builds the book of a project, and shows it.

use super::build::{Options, Summary, build, check_folder};
use super::calculator;
use super::fault::Faults;
use super::gather::content;
use super::visit;
use crate::console;
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::report::{self, data::Report};
use anyhow::Context;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Build the book: every formula with its source, code, tests, golden cases and evidence
///
/// The evidence shown is what the last `golden --check` and `audit` found about this very version of the code; speed and
/// error are those of the last `report` on all formulas, made here or kept as the reference, or of a quick one made now.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} book           build into target/book; open index.html there
  {command} book --open    and show it in the browser
  {command} book --check-calculators  and use its calculators in Chromium
  {command} book --check-pages  and look at every page in Chromium
  {command} book --screenshots pictures  and take pictures")]
#[expect(clippy::struct_excessive_bools, reason = "they are switches")]
pub(crate) struct Arguments {
    /// Show the book in the browser
    #[arg(long)]
    open: bool,
    /// The folder for the book
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Measure nothing; omit speed and error if there is no stored report
    #[arg(long)]
    unmeasured: bool,
    /// Run every calculator in a headless Chromium with the inputs of all golden cases, and compare every bit with Rust
    #[arg(long)]
    check_calculators: bool,
    /// Check every page in a headless Chromium: accessibility (by axe, if JOINTPROOF_AXE gives its path), width on a phone, size, search, keyboard
    #[arg(long)]
    check_pages: bool,
    /// Take screenshots of the pages in book/screens.txt, for desktop and phone, in the light and the dark theme
    #[arg(long, value_name = "FOLDER")]
    screenshots: Option<PathBuf>,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    project.needs_sources("book")?;
    let report = if arguments.unmeasured { Report::kept(project) } else { Some(report::kept_or_quick(project)?) };
    let summary = build_book(project, arguments.out.clone(), report)?;
    console::print(&format!("{}\n", project.shown(&summary.index)))?;
    console::say(&format!(
        "{} chapters, {} formulas, {} listings in {:.1} s",
        summary.chapters,
        summary.formulas,
        summary.listings,
        summary.elapsed.as_secs_f64()
    ));
    if arguments.open {
        open(&summary.index)?;
    }
    let out = summary.index.parent().context("the first page is in a folder")?;
    let mut is_well = true;
    if arguments.check_calculators {
        is_well &= calculator::check(project, out)?
            .map_or_else(|| Ok(absent()), |checked| said(&checked, checked.is_well()))?;
    }
    if arguments.check_pages {
        is_well &=
            visit::check(project, out)?.map_or_else(|| Ok(absent()), |visited| said(&visited, visited.is_well()))?;
    }
    if let Some(folder) = &arguments.screenshots {
        match visit::take(project, out, folder)? {
            Some(count) => console::say(&format!("{count} pictures in {}", folder.display())),
            None => is_well &= absent(),
        }
    }
    Ok(verdict(is_well))
}

/// Reports the result of a check, and returns whether all is well.
fn said(found: &impl Display, is_well: bool) -> anyhow::Result<bool> {
    console::print(&format!("{} {found}\n", head(is_well)))?;
    Ok(is_well)
}

fn head(is_well: bool) -> String {
    if is_well { console::green("ok ") } else { console::red("off") }
}

/// The result if no browser is available and none is required.
fn absent() -> bool {
    console::say("chromium is not here: the pages are not looked at");
    true
}

/// Builds the book, and lists all its faults if there are any.
pub(crate) fn build_book(project: &Project, out: Option<PathBuf>, report: Option<Report>) -> anyhow::Result<Summary> {
    let out = out.unwrap_or_else(|| project.target().join("book"));
    // Checked before gathering the content, which is slow.
    check_folder(&out)?;
    build(project.root(), &Options { out: Some(out) }, content(project, report)?).map_err(|error| {
        match error.downcast::<Faults>() {
            Ok(faults) => anyhow::anyhow!("the book cannot be built\n{faults}"),
            Err(error) => error,
        }
    })
}

fn open(index: &Path) -> anyhow::Result<()> {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    let shown = index.display();
    Command::new(opener)
        .arg(index)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .with_context(|| format!("cannot run {opener}; open {shown} by hand"))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_off_is_told_and_no_browser_is_no_fault() {
        assert!(said(&"all of it", true).unwrap() && !said(&"one part", false).unwrap());
        assert!(head(true).contains("ok ") && head(false).contains("off"));
        assert!(absent());
    }
}
