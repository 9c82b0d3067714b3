//! `cargo xtask golden`: the golden files, written or checked.

use crate::console::{bold, count, green, print, progress, red, say};
use crate::evidence::{Evidence, GoldenCheck};
use crate::selection::Selection;
use crate::{Outcome, files, scene};
use anyhow::Context;
use indicatif::ParallelProgressIterator;
use jointproof::catalog::{AnyFormula, find};
use jointproof::verify::golden::{Difference, File};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Write the golden files, or check that they are what the code says
///
/// Values and Jacobians are computed in 237 bits and rounded once, so the files have the same bytes on every machine.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  cargo xtask golden                     write what has changed, remove what has no formula
  cargo xtask golden --check             regenerate in memory and compare, write nothing
  cargo xtask golden --filter 'slot.*'   only the SLOT formulas")]
pub(crate) struct Arguments {
    /// Compare with the committed files and write nothing; exit 1 on any difference
    #[arg(long)]
    check: bool,
    #[command(flatten)]
    selection: Selection,
}

/// What to do about a difference.
pub(crate) const MEND: &str = "to make the files what the code says: cargo xtask golden";
/// Differences shown per file before the rest is only counted.
const SHOWN: usize = 10;

pub(crate) fn run(arguments: &Arguments) -> Outcome {
    if arguments.check {
        let checked = check(&arguments.selection)?;
        print(&checked.report)?;
        let mut passed = checked.passed;
        if arguments.selection.is_all() {
            let scenes = scene_report(&scene::check()?);
            print(&scenes.1)?;
            passed &= scenes.0;
        }
        if !passed {
            say(MEND);
        }
        Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
    } else {
        print(&write(&arguments.selection)?)?;
        Ok(ExitCode::SUCCESS)
    }
}

/// The verdict on the scenes, and the files that are off.
pub(crate) fn scene_report(checked: &scene::Checked) -> (bool, String) {
    let summary = format!("{}, {}", count(checked.scenes, "scene"), count(checked.numbers, "number"));
    let differs = |path: &PathBuf| format!("{} differs\n", bold(files::shown(path)));
    let lines = checked.off.iter().map(differs).collect::<Vec<_>>().concat();
    let verdict = if checked.off.is_empty() { green("ok") } else { red("off") };
    (checked.off.is_empty(), format!("{lines}{verdict} {summary}\n"))
}

/// A golden file as the code says it is.
struct Regenerated {
    path: PathBuf,
    file: File,
    text: String,
}

fn regenerate(selection: &Selection) -> anyhow::Result<Vec<Regenerated>> {
    let formulas = selection.formulas()?;
    let bar = progress("golden", formulas.len());
    let one = |formula: &&dyn AnyFormula| {
        let file = formula.golden();
        Ok(Regenerated { path: path(formula.spec().id), text: file.render()?, file })
    };
    formulas.par_iter().progress_with(bar).map(one).collect()
}

fn directory() -> PathBuf {
    files::root().join("golden")
}

fn path(id: &str) -> PathBuf {
    directory().join(format!("{id}.json"))
}

/// The schema of golden files, made from the types that write them.
fn schema() -> anyhow::Result<(PathBuf, String)> {
    let schema = schemars::schema_for!(File);
    Ok((directory().join("schema.json"), serde_json::to_string_pretty(&schema)? + "\n"))
}

/// Golden files of formulas that no longer exist.
fn orphans() -> anyhow::Result<Vec<PathBuf>> {
    let entries = match std::fs::read_dir(directory()) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.context("cannot list golden/")?,
    };
    let mut orphans = Vec::new();
    for entry in entries {
        let path = entry?.path();
        let id = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let golden = path.extension().is_some_and(|extension| extension == "json") && id != "schema";
        if golden && find(&id).is_none() {
            orphans.push(path);
        }
    }
    orphans.sort();
    Ok(orphans)
}

fn write(selection: &Selection) -> anyhow::Result<String> {
    let regenerated = regenerate(selection)?;
    let mut report = String::new();
    let mut outputs: Vec<_> = regenerated.iter().map(|golden| (&golden.path, &golden.text)).collect();
    let (schema_path, schema) = schema()?;
    outputs.push((&schema_path, &schema));
    let scenes = if selection.is_all() { scene::regenerate()? } else { Vec::new() };
    outputs.extend(scenes.iter().map(|(path, text)| (path, text)));
    for (path, text) in outputs {
        if files::write(path, text)? {
            writeln!(report, "wrote {}", files::shown(path))?;
        }
    }
    let orphans = if selection.is_all() { [orphans()?, scene::orphans(&scenes)?].concat() } else { Vec::new() };
    for orphan in orphans {
        std::fs::remove_file(&orphan).with_context(|| format!("cannot remove {}", files::shown(&orphan)))?;
        writeln!(report, "removed {}: no such formula or scene", files::shown(&orphan))?;
    }
    let cases: usize = regenerated.iter().map(|golden| golden.file.cases.len()).sum();
    writeln!(report, "{}, {}", count(regenerated.len(), "formula"), count(cases, "case"))?;
    Ok(report)
}

/// What a check found.
pub(crate) struct Checked {
    pub(crate) passed: bool,
    pub(crate) cases: usize,
    pub(crate) formulas: usize,
    pub(crate) report: String,
}

pub(crate) fn check(selection: &Selection) -> anyhow::Result<Checked> {
    let regenerated = regenerate(selection)?;
    let mut evidence = Evidence::load();
    let mut report = String::new();
    let mut off = 0;
    for golden in &regenerated {
        let same = std::fs::read_to_string(&golden.path).is_ok_and(|committed| committed == golden.text);
        if !same {
            off += 1;
            report += &explain(golden);
        }
        let check = GoldenCheck { cases: golden.file.cases.len(), same };
        evidence.golden.insert(golden.file.formula.clone(), check);
    }
    let (path, schema) = schema()?;
    if !std::fs::read_to_string(&path).is_ok_and(|committed| committed == schema) {
        off += 1;
        writeln!(report, "{} is not the schema that the code writes", bold(files::shown(&path)))?;
    }
    for orphan in orphans()? {
        off += 1;
        writeln!(report, "{} has no formula", bold(files::shown(&orphan)))?;
    }
    let cases = regenerated.iter().map(|golden| golden.file.cases.len()).sum();
    let summary = format!("{}, {}", count(regenerated.len(), "formula"), count(cases, "case"));
    if off == 0 {
        writeln!(report, "{} {summary}: every file is what the code says", green("ok"))?;
    } else {
        writeln!(report, "{} {summary}: {} off", red("off"), count(off, "file"))?;
    }
    evidence.save()?;
    Ok(Checked { passed: off == 0, cases, formulas: regenerated.len(), report })
}

/// What differs in a committed file.
fn explain(golden: &Regenerated) -> String {
    let name = bold(files::shown(&golden.path));
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
pub(crate) fn changes(formula: &dyn AnyFormula) -> Result<Vec<Difference>, String> {
    let committed = std::fs::read_to_string(path(formula.spec().id)).map_err(|error| error.to_string())?;
    let committed = File::parse(&committed).map_err(|error| error.to_string())?;
    Ok(formula.golden().differences(&committed))
}
