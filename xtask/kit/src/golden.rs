//! `golden`: the golden files, written or checked.

use crate::console::{bold, count, green, print, progress, red, say};
use crate::elements::GoldenFiles;
use crate::evidence::{Evidence, GoldenCheck};
use crate::extension::Beside;
use crate::files;
use crate::outcome::{Outcome, verdict};
use crate::owed::owed;
use crate::project::Project;
use crate::selection::Selection;
use anyhow::Context;
use indicatif::ParallelProgressIterator;
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::verify::golden::{Difference, File, LEAST_RANDOM};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Write the golden files, or check that they agree with the code
///
/// Values and Jacobians are computed in 237 bits and rounded once, so the files have the same bytes on every machine.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} golden                       write changed files, remove files without a formula
  {command} golden --check               regenerate in memory and compare, write nothing
  {command} golden --filter '{family}.*' only the formulas of a family
  {command} golden --out cases           into a folder of another project
  {command} golden --out cases --random 1000 with more cases drawn at random")]
pub(crate) struct Arguments {
    /// Compare with the committed files and write nothing; exit 1 on any difference
    #[arg(long)]
    check: bool,
    /// Write the files and their schema into this folder, for another project; the committed files are not changed
    #[arg(long, value_name = "FOLDER", conflicts_with = "check")]
    out: Option<PathBuf>,
    /// At least so many cases drawn at random, other ones than those of the committed files
    #[arg(long, value_name = "N", requires = "out")]
    random: Option<usize>,
    #[command(flatten)]
    selection: Selection,
}

/// Says what to do about a difference.
pub(crate) fn say_what_mends(project: &Project) {
    say(&format!("to make the files what the code says: {} golden", project.command()));
}

/// Differences shown per file before the rest is only counted.
const SHOWN: usize = 10;

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    if let Some(folder) = &arguments.out {
        let least_random = arguments.random.unwrap_or(LEAST_RANDOM);
        print(&write_into(folder, project, &arguments.selection, least_random)?)?;
        return Ok(verdict(true));
    }
    project.needs_repository("golden", ", or take --out FOLDER, which writes the files elsewhere")?;
    let (formulas, _) = arguments.selection.formulas_and_elements(project)?;
    if !arguments.check {
        let written = write(project, &arguments.selection)?;
        let owed = owed(project, &formulas)?;
        print(&(written + &owed.concat()))?;
        return Ok(verdict(owed.is_empty()));
    }
    let mut checks = vec![check(project, &arguments.selection)?];
    if let Some((_, beside)) = project.extension.beside.filter(|_| arguments.selection.is_all()) {
        checks.push(check_beside(project, &beside(project)?));
    }
    let owed = owed(project, &formulas)?;
    let reports: String = checks.iter().map(|checked| checked.report.as_str()).collect();
    print(&(reports + &owed.concat()))?;
    let passed = checks.iter().all(|checked| checked.passed);
    if !passed {
        say_what_mends(project);
    }
    Ok(verdict(passed && owed.is_empty()))
}

/// A golden file as the code says it is.
struct Regenerated {
    path: PathBuf,
    file: File,
    text: String,
}

fn regenerate(
    project: &Project,
    selection: &Selection,
    folder: &Path,
    least_random: usize,
) -> anyhow::Result<(Vec<Regenerated>, GoldenFiles)> {
    let (formulas, elements) = selection.formulas_and_elements(project)?;
    let elements = GoldenFiles::made(&elements, folder)?;
    let bar = progress("golden", formulas.len());
    let one = |formula: &&dyn AnyFormula| {
        let file = formula.golden_with(least_random);
        Ok(Regenerated { path: folder.join(format!("{}.json", formula.spec().id)), text: file.render()?, file })
    };
    let formulas: anyhow::Result<_> = formulas.par_iter().progress_with(bar).map(one).collect();
    Ok((formulas?, elements))
}

/// The schema of golden files, made from the types that write them.
fn schema(folder: &Path) -> anyhow::Result<(PathBuf, String)> {
    let schema = schemars::schema_for!(File);
    Ok((folder.join("schema.json"), serde_json::to_string_pretty(&schema)? + "\n"))
}

/// Golden files of formulas that no longer exist.
fn orphans(project: &Project) -> anyhow::Result<Vec<PathBuf>> {
    files::json_but(&project.golden(), |id| id == "schema" || project.find(id).is_some())
}

fn write(project: &Project, selection: &Selection) -> anyhow::Result<String> {
    let (regenerated, elements) = regenerate(project, selection, &project.golden(), LEAST_RANDOM)?;
    let mut report = String::new();
    let mut outputs: Vec<_> = regenerated.iter().map(|golden| (&golden.path, &golden.text)).collect();
    let (schema_path, schema) = schema(&project.golden())?;
    outputs.push((&schema_path, &schema));
    let beside = match project.extension.beside {
        Some((_, beside)) if selection.is_all() => beside(project)?,
        _ => Beside::default(),
    };
    outputs.extend(beside.files.iter().map(|(path, text)| (path, text)));
    for (path, text) in outputs {
        if files::write(path, text)? {
            writeln!(report, "wrote {}", project.shown(path))?;
        }
    }
    for path in elements.write()? {
        writeln!(report, "wrote {}", project.shown(path))?;
    }
    let orphans = if selection.is_all() { orphans(project)? } else { Vec::new() };
    let of_elements = if selection.is_all() { GoldenFiles::orphans(project)? } else { Vec::new() };
    let of_formulas = orphans.iter().map(|path| (path, "no such formula"));
    let of_elements = of_elements.iter().map(|path| (path, "no such element"));
    for (orphan, why) in
        of_formulas.chain(of_elements).chain(beside.orphans.iter().map(|path| (path, "nothing makes it")))
    {
        let shown = project.shown(orphan);
        std::fs::remove_file(orphan).with_context(|| format!("cannot remove {shown}"))?;
        writeln!(report, "removed {shown}: {why}")?;
    }
    writeln!(report, "{}{}", counts(&regenerated), elements.counts())?;
    Ok(report)
}

/// Writes the files of some formulas into a folder that is not the project's own. Nothing is removed there.
fn write_into(folder: &Path, project: &Project, selection: &Selection, least_random: usize) -> anyhow::Result<String> {
    let (regenerated, elements) = regenerate(project, selection, folder, least_random)?;
    elements.write()?;
    let (schema_path, schema) = schema(folder)?;
    for (path, text) in regenerated.iter().map(|golden| (&golden.path, &golden.text)).chain([(&schema_path, &schema)]) {
        files::write(path, text)?;
    }
    Ok(format!("{}{} in {}\n", counts(&regenerated), elements.counts(), folder.display()))
}

fn counts(regenerated: &[Regenerated]) -> String {
    let cases = regenerated.iter().map(|golden| golden.file.cases.len()).sum();
    format!("{}, {}", count(regenerated.len(), "formula"), count(cases, "case"))
}

/// What a check found.
pub(crate) struct Checked {
    pub(crate) passed: bool,
    /// How much was compared.
    pub(crate) counts: String,
    /// The verdict, and before it what is off.
    pub(crate) report: String,
}

/// Whether a committed file is what the code says.
fn is_current(path: &Path, text: &str) -> bool {
    std::fs::read_to_string(path).is_ok_and(|committed| committed == text)
}

/// Checks the golden files of formulas and elements, and keeps what was found as evidence.
pub(crate) fn check(project: &Project, selection: &Selection) -> anyhow::Result<Checked> {
    let (regenerated, elements) = regenerate(project, selection, &project.golden(), LEAST_RANDOM)?;
    let mut evidence = Evidence::load(project);
    let mut off = Vec::new();
    for golden in &regenerated {
        let same = is_current(&golden.path, &golden.text);
        if !same {
            off.push(explain(project, golden));
        }
        let check = GoldenCheck { cases: golden.file.cases.len(), same };
        evidence.golden.insert(golden.file.formula.clone(), check);
    }
    let (path, schema) = schema(&project.golden())?;
    if !is_current(&path, &schema) {
        off.push(format!("{} is not the schema that the code writes\n", bold(project.shown(&path))));
    }
    let orphan = |path: PathBuf| format!("{} has no formula\n", bold(project.shown(&path)));
    off.extend(orphans(project)?.into_iter().map(orphan));
    off.extend(elements.off(project));
    let orphan = |path: PathBuf| format!("{} has no element\n", bold(project.shown(&path)));
    off.extend(GoldenFiles::orphans(project)?.into_iter().map(orphan));
    evidence.save(project)?;
    Ok(checked(counts(&regenerated) + &elements.counts(), &off))
}

/// Checks the golden files that are not of formulas.
pub(crate) fn check_beside(project: &Project, beside: &Beside) -> Checked {
    let changed = beside.files.iter().filter(|(path, text)| !is_current(path, text)).map(|(path, _)| path);
    let differs = |path: &PathBuf| format!("{} differs\n", bold(project.shown(path)));
    let off: Vec<_> = changed.chain(&beside.orphans).map(differs).collect();
    checked(beside.counts.clone(), &off)
}

fn checked(counts: String, off: &[String]) -> Checked {
    let (passed, lines) = (off.is_empty(), off.concat());
    let verdict = if passed {
        format!("{} {counts}: every file is what the code says\n", green("ok"))
    } else {
        format!("{} {counts}: {} off\n", red("off"), count(off.len(), "file"))
    };
    Checked { passed, counts, report: lines + &verdict }
}

/// What differs in a committed file.
fn explain(project: &Project, golden: &Regenerated) -> String {
    let name = bold(project.shown(&golden.path));
    let committed = match std::fs::read_to_string(&golden.path) {
        Ok(committed) => committed,
        Err(error) => return format!("{name}: {error}\n"),
    };
    let committed = match File::parse(&committed) {
        Ok(committed) => committed,
        Err(error) => return format!("{name} is not a golden file: {error}\n"),
    };
    let differences = golden.file.differences(&committed);
    if differences.is_empty() {
        return format!("{name}: the cases agree, the description or the layout differs\n");
    }
    let shown: String = differences.iter().take(SHOWN).map(show).collect();
    let rest = match differences.len().saturating_sub(SHOWN) {
        0 => String::new(),
        rest => format!("  … and {rest} more\n"),
    };
    format!("{name}: {}\n{shown}{rest}", count(differences.len(), "difference"))
}

fn show(difference: &Difference) -> String {
    let Difference { case, field, committed, now, ulps } = difference;
    let field = if field.is_empty() { String::new() } else { format!(" {field}") };
    let distance = ulps.map_or(String::new(), |ulps| format!("  ({ulps} ulp apart)"));
    let (committed, now) = (red(format!("- {committed}")), green(format!("+ {now}")));
    format!("  case {case}{field}{distance}\n    {committed}\n    {now}\n")
}

/// What has changed in a formula against its committed golden file, for a review.
///
/// # Errors
/// Why the committed file cannot be compared with.
pub(crate) fn changes(project: &Project, formula: &dyn AnyFormula) -> Result<Vec<Difference>, String> {
    let committed =
        std::fs::read_to_string(project.golden_file(formula.spec().id)).map_err(|error| error.to_string())?;
    let committed = File::parse(&committed).map_err(|error| error.to_string())?;
    Ok(formula.golden().differences(&committed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::connector::slot::ContactForce;

    #[test]
    fn files_of_no_formula_are_named_in_order_and_no_others() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("golden", env!("CARGO_MANIFEST_DIR"), &[&ContactForce]);
        let project = project.in_folder(root.path().to_str().unwrap());
        assert!(orphans(&project).unwrap().is_empty(), "there is no such folder yet");
        let names = ["z.a", "slot.friction", "b.c", "y", "slot.contact", "a.b", "m.n"];
        let others = ["schema.json", "slot.contact_force.json", "a.b.txt", "README.md"].map(str::to_owned);
        for name in names.iter().map(|name| format!("{name}.json")).chain(others) {
            files::write(&project.golden().join(name), "{}").unwrap();
        }
        let found = orphans(&project).unwrap();
        let found: Vec<_> = found.iter().map(|path| project.shown(path)).collect();
        let expected = ["a.b", "b.c", "m.n", "slot.contact", "slot.friction", "y", "z.a"];
        assert_eq!(found, expected.map(|name| format!("golden/{name}.json")));
    }
}
