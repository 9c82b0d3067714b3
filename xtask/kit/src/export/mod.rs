//! `export`: the verified program of a formula or an element in another language, with a check that it is the same.

mod amalgam;
mod c;
mod check;
mod element;
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
mod repeated;
mod script;
mod shell;
mod speed;
mod subject;

use crate::console::{green, print, red, say};
use crate::files;
use crate::outcome::{Outcome, Usage, verdict};
use crate::project::Project;
use crate::selection::{self, Selection};
pub(crate) use amalgam::{Download, downloads};
use anyhow::ensure;
use jointproof::catalog::{AnyForm, Form, Rotations};
use language::Language;
use recorded::{Recorded, Subject, record};
pub(crate) use script::{Script, runtime_script, script};
use std::path::PathBuf;

/// Write formulas and elements as programs in other languages
///
/// The exported program has the same operations as the formula or the element in `f64`, in the same order, with all branches. --check compiles
/// it and compares every bit of its results with Rust. Compile it without fused operations (-ffp-contract=off), since they
/// change the results.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} export --lang c --out jp                      everything, a header, a Makefile
  {command} export --lang fortran --out jp --filter '{family}.*'  one family
  {command} export --lang js --out jp --check             and compare every bit
  {command} export --lang c --out jp --speed              and time it, compared with Rust
  {command} export --lang c --out jp --element slot       an element
  {command} export --lang c --out jp --element slot --penalty  without multipliers
  {command} export --lang c --out jp --element slot --arms --unknowns euler-parameters
  {command} export --shell uel --element slot --out jp    an element for Abaqus, in one file
  {command} export --shell uel --element slot --element hinge --fixed --out jp
  {command} export --shell vuel --element slot --out jp   the same for Abaqus/Explicit
  {command} export --shell umpc-user --out jp             SLIDER for CalculiX")]
pub(crate) struct Arguments {
    /// The language
    #[arg(long, value_enum, required_unless_present = "shell")]
    lang: Option<Name>,
    /// A user routine in Fortran in one file, with the functions that it calls
    #[arg(long, value_enum, conflicts_with_all = ["lang", "filter", "check", "speed"])]
    shell: Option<shell::Shell>,
    /// An element, by its identifier, without and with friction; in a shell, several are types U1, U2 and so on
    #[arg(long, value_name = "ID", conflicts_with = "filter")]
    element: Vec<String>,
    #[command(flatten)]
    switches: Switches,
    /// The routine in fixed form
    #[arg(long, requires = "shell")]
    fixed: bool,
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

/// The form of the elements.
#[derive(clap::Args)]
struct Switches {
    /// The element with penalties times its residuals instead of multipliers
    #[arg(long, requires = "element")]
    penalty: bool,
    /// The unknowns of the rotations of its nodes
    #[arg(
        long,
        value_name = "WHICH",
        value_enum,
        requires = "element",
        conflicts_with = "shell",
        default_value = "spins"
    )]
    unknowns: Unknowns,
    /// The element at the ends of rigid arms from its nodes
    #[arg(long, requires = "element", conflicts_with = "shell")]
    arms: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Unknowns {
    Spins,
    RotationVectors,
    EulerParameters,
}

impl Switches {
    fn form(&self) -> Form {
        let rotations = match self.unknowns {
            Unknowns::Spins => Rotations::Spins,
            Unknowns::RotationVectors => Rotations::Vectors,
            Unknowns::EulerParameters => Rotations::EulerParameters,
        };
        Form { has_arms: self.arms, rotations, has_penalties: self.penalty }
    }
}

impl Arguments {
    /// The elements asked for, in their form.
    fn elements(&self, project: &Project) -> Result<Vec<&'static dyn AnyForm>, Usage> {
        let in_form = |id: &String| {
            let element = selection::element(project, id)?;
            let has_multipliers = !element.layout().multipliers.is_empty();
            let is_explicit = self.shell == Some(shell::Shell::Vuel);
            let mut form = self.switches.form();
            form.has_penalties |= is_explicit && has_multipliers;
            if form == Form::default() {
                return Ok(element as &dyn AnyForm);
            }
            element.in_form(form).map_err(|why| Usage(format!("--element {id}: {why}")))
        };
        self.element.iter().map(in_form).collect()
    }
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
    let elements = arguments.elements(project)?;
    if let Some(shell) = arguments.shell {
        if !shell.is_element() && !elements.is_empty() {
            return Err(Usage("--element: elements are routines UEL or VUEL: --shell uel".into()).into());
        }
        print(&shell::write(project, shell, &elements, arguments.fixed, &arguments.out)?)?;
        return Ok(verdict(true));
    }
    let Some(lang) = arguments.lang else { return Ok(verdict(true)) };
    let (formulas, elements) = if elements.is_empty() {
        let (formulas, elements) = arguments.selection.formulas_and_elements(project)?;
        (formulas, elements.into_iter().map(|element| element as &dyn AnyForm).collect())
    } else {
        (Vec::new(), elements)
    };
    let formulas = formulas.into_iter().map(Subject::Formula);
    let subjects: Vec<_> = formulas.chain(elements.into_iter().flat_map(Subject::forms)).collect();
    let recorded = recorded_in(lang.language(), project, &subjects);
    std::fs::create_dir_all(&arguments.out)?;
    let language = lang.language();
    let mut lines = 0;
    for (name, text) in language.files(&recorded) {
        lines += text.lines().count();
        files::write(&arguments.out.join(name), &text)?;
    }
    print(&format!("{}, {lines} lines in {}\n", counted(&recorded, &subjects), arguments.out.display()))?;
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

/// What can be written in a language; of the rest it is said why not.
fn recorded_in(language: &dyn Language, project: &Project, subjects: &[Subject]) -> Vec<Recorded> {
    let (recorded, not_recorded) = record(subjects, Some(project));
    let (recorded, refused): (Vec<_>, Vec<_>) = recorded.into_iter().partition(|one| language.refuses(one).is_none());
    let not_recorded = not_recorded.into_iter().map(|(subject, why)| (subject, why.to_string()));
    let refused = refused.iter().filter_map(|one| Some((one.subject, language.refuses(one)?.to_owned())));
    for (subject, why) in not_recorded.chain(refused) {
        say(&format!("not exported: {subject}: {why}"));
    }
    recorded
}

/// How many of those asked for there are: `117 of 120 formulas, 20 of 22 elements`.
fn counted(recorded: &[Recorded], subjects: &[Subject]) -> String {
    let is_formula = |subject: &Subject| matches!(subject, Subject::Formula(_));
    let count = |formulas: bool| {
        let asked = subjects.iter().filter(|subject| is_formula(subject) == formulas).count();
        let found = recorded.iter().filter(|one| is_formula(&one.subject) == formulas).count();
        (asked, found, if formulas { "formulas" } else { "elements, without and with friction" })
    };
    let counts = [true, false].map(count).into_iter().filter(|(asked, ..)| *asked > 0);
    counts.map(|(asked, found, what)| format!("{found} of {asked} {what}")).collect::<Vec<_>>().join(", ")
}

/// The files of an export, for tests of code that calls it.
#[cfg(test)]
pub(crate) fn files_in(lang: &str, formulas: &[&'static dyn jointproof::catalog::AnyFormula]) -> Vec<(String, String)> {
    let name = <Name as clap::ValueEnum>::from_str(lang, false).expect("a language is named");
    let subjects: Vec<_> = formulas.iter().map(|&formula| Subject::Formula(formula)).collect();
    name.language().files(&record(&subjects, None).0)
}
