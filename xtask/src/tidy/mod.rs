//! `cargo xtask tidy`: rules about the sources that a machine can check.
//!
//! # Uses
//! A file uses another if it names an item defined there: in a `use`, in a path within code, or by a bare name that
//! comes from a glob or from its own re-export. Re-exports are followed to the defining file. Neither a re-export nor
//! `mod` is a use. Tests, attributes, documentation and the bodies of `macro_rules!` do not count, calls of macros do.
//! Methods and traits that are never named are not detected.
//!
//! # Circles
//! There are none between files, nor between the entries of a folder: its files and its folders, each folder taken as
//! a whole (`a.rs` belongs to the folder `a/`). So every use counts once, in the folder where the paths to both files
//! diverge. Treating a folder's own files as one unit would be too strict: its folders are built on some of them, and
//! others are built on its folders.

mod architecture;
mod circles;
mod edges;
mod finding;
mod graph;
mod ids;
mod import;
mod inline;
mod language;
mod layers;
mod lengths;
mod programs;
mod reach;
mod resolve;
mod source;
#[cfg(test)]
mod tests;
mod tree;
mod words;

use crate::Outcome;
use crate::console::{bold, count, green, print, red};
use finding::Finding;
use kit::Project;
use std::path::Path;
use std::process::ExitCode;
use tree::Tree;

pub(crate) use reach::reach;

/// Check the sources: circular imports, layers, papers, identifiers, lengths, tests
///
/// Circular imports between files or folders are not allowed, direct or indirect. An import is a `use` or a path in code that
/// names something of another file, followed through re-exports to the file that defines it; tests do not count. In each
/// folder, its files and subfolders are compared; a subfolder counts as one with everything below it. For each circle one
/// place per import is shown, the shortest circles first.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} tidy                   every rule
  {command} tidy circles layers    these two")]
pub(crate) struct Arguments {
    /// The rules to check [default: all]
    #[arg(value_enum, value_name = "RULE")]
    rules: Vec<Rule>,
}

/// What is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Rule {
    /// No circular imports between files or folders
    Circles,
    /// No folder uses one that is higher in ARCHITECTURE.md, and files of formulas neither `verify` nor `measure`
    Layers,
    /// ARCHITECTURE.md names every folder of `src` and every crate, and links of papers lead somewhere
    Papers,
    /// Identifiers of formulas are taken from `SPEC.id`
    Ids,
    /// Every `eval`, `jacobian` and `linearized` of a formula is `#[inline]`
    Inline,
    /// Every formula of the catalog has one directive in the book
    Directives,
    /// No file has more than 500 lines
    Lengths,
    /// Every file of tests belongs to a program
    Tests,
    /// Chapters and printed strings are in the words of the field
    Language,
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    project.needs_project("tidy")?;
    let ids: Vec<&str> = project.catalog().iter().map(|formula| formula.spec().id).collect();
    let tidiness = check(project.root(), &ids, &arguments.rules)?;
    print(&tidiness.text())?;
    Ok(if tidiness.findings.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The result of the checks.
#[derive(Debug)]
struct Tidiness {
    /// The faults, by location.
    findings: Vec<Finding>,
    /// A one-line summary of what was checked.
    counts: String,
}

impl Tidiness {
    /// All findings, then a one-line verdict.
    fn text(&self) -> String {
        let Self { findings, counts } = self;
        let lines = findings.iter().map(ToString::to_string);
        let verdict = if findings.is_empty() { green("ok ") } else { red("off") };
        let summary = format!("{verdict} {}: {}; {counts}", bold("tidy"), count(findings.len(), "finding"));
        lines.chain([summary]).collect::<Vec<_>>().join("\n")
    }
}

/// Checks the workspace at `root` by these rules, or by all rules if none is named. `formulas` are the identifiers of
/// the catalog.
fn check(root: &Path, formulas: &[&str], rules: &[Rule]) -> anyhow::Result<Tidiness> {
    let mut tree = Tree::read(root)?;
    let mut findings = std::mem::take(&mut tree.faults);
    let order = architecture::Order::read(root)?;
    let edges = edges::edges(&tree);
    let circles = circles::circles(&tree, &edges);
    let (mut too_long, files) = lengths::too_long(root, &tree)?;
    let (with_formulas, median) = lengths::median(&tree);
    too_long.extend(lengths::median_too_long(median));
    let counts = format!(
        "{}, {}, {} of files, {} with folders; {} with formulas, median {median} lines",
        count(files, "file"),
        count(edges.len(), "use"),
        count(circles.of_files, "circle"),
        circles.of_folders,
        count(with_formulas, "file"),
    );
    let found = [
        (Rule::Circles, circles.findings),
        (Rule::Layers, layers::crossed(&tree, &edges, &order)),
        (Rule::Papers, architecture::untrue(root, &tree, &order)),
        (Rule::Ids, ids::typed(&tree)),
        (Rule::Inline, inline::missing(&tree)),
        (Rule::Directives, kit::uncovered(root, formulas)?.into_iter().map(Finding::from).collect()),
        (Rule::Lengths, too_long),
        (Rule::Tests, programs::forgotten(root, &tree)?),
        (Rule::Language, language::foreign(root, &tree)?),
    ];
    let wanted = found.into_iter().filter(|(rule, _)| rules.is_empty() || rules.contains(rule));
    findings.extend(wanted.flat_map(|(_, found)| found));
    findings.sort();
    Ok(Tidiness { findings, counts })
}
