//! `export`: the verified program of a formula in another language, with a check that it is the same.

mod c;
mod check;
mod fortran;
mod fpcore;
mod javascript;
mod language;
mod names;
mod numpy;
mod outline;
mod points;
mod program;
mod recorded;
mod script;
mod shell;
mod speed;

use crate::console::{green, print, red, say};
use crate::files;
use crate::outcome::{Outcome, verdict};
use crate::project::Project;
use crate::selection::Selection;
use anyhow::ensure;
use language::Language;
use recorded::record;
pub(crate) use script::{Script, runtime_script, script};
use std::path::PathBuf;

/// Write formulas as programs in other languages
///
/// The exported program has the same operations as the formula in `f64`, in the same order, with all branches. --check compiles
/// it and compares every bit of its results with Rust. Compile it without fused operations (-ffp-contract=off), since they
/// change the results.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} export --lang c --out jp                      all formulas, a header, a Makefile
  {command} export --lang fortran --out jp --filter '{family}.*'  one family
  {command} export --lang js --out jp --check             and compare every bit
  {command} export --lang c --out jp --speed              and time it, compared with Rust
  {command} export --shell uel-ujoint --out jp            an element for Abaqus, in one file")]
pub(crate) struct Arguments {
    /// The language
    #[arg(long, value_enum, required_unless_present = "shell")]
    lang: Option<Name>,
    /// A user routine in Fortran in one file, with the functions that it calls
    #[arg(long, value_enum, conflicts_with_all = ["lang", "filter", "check", "speed"])]
    shell: Option<shell::Shell>,
    /// The output folder; it is created if necessary
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
    #[command(flatten)]
    selection: Selection,
    /// Compile with every installed compiler, and compare every bit with Rust
    #[arg(long)]
    check: bool,
    /// Time value and Jacobian in C and in Rust at the same points
    #[arg(long)]
    speed: bool,
    /// Random points to compare, in addition to the golden cases
    #[arg(long, value_name = "N", default_value_t = 10_000, requires = "check")]
    samples: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Name {
    C,
    Fortran,
    #[value(name = "js")]
    JavaScript,
    #[value(name = "numpy")]
    NumPy,
    #[value(name = "fpcore")]
    FpCore,
}

impl Name {
    fn language(self) -> &'static dyn Language {
        match self {
            Self::C => &c::C,
            Self::Fortran => &fortran::Fortran,
            Self::JavaScript => &javascript::JavaScript,
            Self::NumPy => &numpy::NumPy,
            Self::FpCore => &fpcore::FpCore,
        }
    }
}

pub(crate) fn run(project: &Project, arguments: &Arguments) -> Outcome {
    std::fs::create_dir_all(&arguments.out)?;
    if let Some(shell) = arguments.shell {
        print(&shell::write(project, shell, &arguments.out)?)?;
    }
    let Some(lang) = arguments.lang else { return Ok(verdict(true)) };
    let formulas = arguments.selection.formulas(project)?;
    let (recorded, not_recorded) = record(&formulas, Some(project));
    let language = lang.language();
    let (recorded, refused): (Vec<_>, Vec<_>) = recorded.into_iter().partition(|one| language.refuses(one).is_none());
    let not_recorded = not_recorded.into_iter().map(|(formula, why)| (formula, why.to_string()));
    let refused = refused.iter().filter_map(|one| Some((one.formula, language.refuses(one)?.to_owned())));
    for (formula, why) in not_recorded.chain(refused) {
        say(&format!("not exported: {}: {why}", formula.spec().id));
    }
    let mut lines = 0;
    for (name, text) in language.files(&recorded) {
        lines += text.lines().count();
        files::write(&arguments.out.join(name), &text)?;
    }
    let folder = arguments.out.display();
    print(&format!("{} of {} formulas, {lines} lines in {folder}\n", recorded.len(), formulas.len()))?;
    if arguments.speed {
        ensure!(lang == Name::C, "--speed takes the time of C: --lang c");
        speed::compare(project, &arguments.out, &recorded)?;
    }
    if !arguments.check {
        return Ok(verdict(true));
    }
    let points = points::all(&recorded, arguments.samples);
    let mut well = true;
    for judged in check::all(language, &arguments.out, &recorded, &points)? {
        well &= judged.is_well();
        let head = if judged.is_well() { green("ok ") } else { red("off") };
        print(&format!("{head} {judged}\n"))?;
    }
    Ok(verdict(well))
}

/// The files of an export, for tests of code that calls it.
#[cfg(test)]
pub(crate) fn files_in(lang: &str, formulas: &[&'static dyn jointproof::catalog::AnyFormula]) -> Vec<(String, String)> {
    let name = <Name as clap::ValueEnum>::from_str(lang, false).expect("a language is named");
    name.language().files(&record(formulas, None).0)
}
