//! `export --shell`: a user routine for a finite-element program in one file, with the exported functions that it calls.
//!
//! FRIC and MPC are written by hand around formulas. An element is `uel.f90` around its recorded functions: from its fields follow
//! the layout of its properties, its state and its multipliers, and the calls.

use super::fortran::driver::passed;
use super::fortran::element::{modules, stem};
use super::fortran::{Fortran, RUNTIME};
use super::language::Language;
use super::program::folded;
use super::recorded::{filled, record};
use crate::files;
use crate::project::Project;
use anyhow::Context;
use jointproof::catalog::{AnyElement, AnyFormula, Erased};
use jointproof::connector::hinge::HingeElement;
use jointproof::connector::slot::SlotElement;
use jointproof::connector::translator::TranslatorElement;
use jointproof::connector::ujoint::UJointElement;
use jointproof::formula::Field;
use jointproof::toolkit::verify::Layout;
use std::path::Path;

/// A routine to take away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Shell {
    /// An element of Abaqus: SLOT with friction and multipliers
    UelSlot,
    /// An element of Abaqus: TRANSLATOR with friction and multipliers
    UelTranslator,
    /// An element of Abaqus: UJOINT with friction and multipliers
    UelUjoint,
    /// An element of Abaqus: HINGE with friction and multipliers
    UelHinge,
    /// A friction model of Abaqus: Coulomb's, in one direction or two
    Fric,
    /// A multi-point constraint of Abaqus: SLIDER
    Mpc,
}

/// Two nodes, each with translations and rotations.
const MOTIONS: usize = 12;
/// The places of both triads in PROPS.
const TRIADS: usize = 18;
/// The columns of the places and of the descriptions in the head of an element.
const COLUMNS: [usize; 2] = [11, 19];
/// The largest length of a line of the head.
const WIDTH: usize = 120;

impl Shell {
    /// The name of its file without the ending, and its own text with the modules that it uses.
    fn parts(self, project: &Project) -> anyhow::Result<(String, String, Vec<String>)> {
        let element: &dyn AnyElement = match self {
            Self::UelSlot => &Erased::<SlotElement, 2, MOTIONS>(SlotElement),
            Self::UelTranslator => &Erased::<TranslatorElement, 5, MOTIONS>(TranslatorElement),
            Self::UelUjoint => &Erased::<UJointElement, 4, MOTIONS>(UJointElement),
            Self::UelHinge => &Erased::<HingeElement, 5, MOTIONS>(HingeElement),
            Self::Fric => return Ok(by_hand(project, "fric", include_str!("shell/fric.f90"))),
            Self::Mpc => return Ok(by_hand(project, "mpc", include_str!("shell/mpc.f90"))),
        };
        let functions = [modules(element, false)?, modules(element, true)?].concat();
        let modules = [RUNTIME.to_owned()].into_iter().chain(functions).collect();
        Ok((format!("uel_{}", element.spec().id), uel(element), modules))
    }
}

/// A routine around formulas.
fn by_hand(project: &Project, name: &str, text: &str) -> (String, String, Vec<String>) {
    let (recorded, _) = record(&called(project, text), Some(project));
    let is_module = |name: &str| {
        Path::new(name).extension().is_some_and(|extension| extension == "f90") && !name.starts_with("driver")
    };
    let modules = Fortran.files(&recorded).into_iter().filter(|(name, _)| is_module(name)).map(|(_, text)| text);
    (name.to_owned(), text.to_owned(), modules.collect())
}

/// The routine around an element.
fn uel(element: &dyn AnyElement) -> String {
    let Layout { multipliers, start, contact, state, .. } = element.layout();
    let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let stick = TRIADS + count(start) + 1;
    let internal: Vec<_> = (1..=count(multipliers)).map(|k| k.to_string()).collect();
    let nodes = ["ea(:, 1), ea(:, 2), ea(:, 3), eb(:, 1), eb(:, 2), eb(:, 3), xa, xb".to_owned()];
    let smooth = [&nodes[..], &passed(multipliers, "u", MOTIONS + 1), &passed(start, "props", TRIADS + 1)].concat();
    let rubbing = [&smooth[..], &passed(contact, "props", stick), &passed(state, "svars", 1)].concat();
    let filled_in = [
        ("title", element.spec().title.to_owned()),
        ("parameters", places("", &[start, contact].concat(), TRIADS + 1)),
        ("state", places("SVARS", state, 1)),
        ("internal", places("internal", multipliers, 1)),
        ("stick", contact.first().map_or("", |field| field.name).to_owned()),
        ("stick_place", format!("props({stick})")),
        ("states", count(state).to_string()),
        ("properties", (stick + count(contact) - 1).to_string()),
        ("degrees", internal.join(", ")),
        ("multipliers", internal.len().to_string()),
        ("smooth", stem(element, false)),
        ("rubbing", stem(element, true)),
        ("smooth_arguments", [&smooth[..], &["results(:after)".to_owned()]].concat().join(", ")),
        ("rubbing_arguments", [&rubbing[..], &["results".to_owned()]].concat().join(", ")),
    ];
    let text = include_str!("shell/uel.f90").to_owned();
    let text = filled_in.iter().fold(text, |text, (name, what)| text.replace(&format!("{{{name}}}"), what));
    let is_code = |line: &str| !line.starts_with('!') && line.len() > WIDTH;
    let lines = text.lines().flat_map(|line| if is_code(line) { folded(line, " &") } else { vec![line.to_owned()] });
    lines.map(|line| line + "\n").collect()
}

/// What stands where in an array, from this place on: lines of the head of an element.
fn places(array: &str, fields: &[Field], mut from: usize) -> String {
    let [place, description] = COLUMNS;
    let mut lines = Vec::new();
    for (k, field) in fields.iter().enumerate() {
        let to = from + field.len() - 1;
        let range = if to > from { format!("{from}-{to}") } else { from.to_string() };
        let meaning = format!("{}: {}", field.name, field.quantity.meaning);
        let array = if k == 0 { array } else { "" };
        let mut head = format!("{:<place$}{range:<1$}", format!("! {array}"), description - place);
        for line in filled(meaning.split_whitespace(), WIDTH - description) {
            lines.push(format!("{head}{line}\n"));
            head = format!("{:<description$}", "!");
        }
        from = to + 1;
    }
    lines.concat()
}

/// The formulas that a text calls.
fn called(project: &Project, text: &str) -> Vec<&'static dyn AnyFormula> {
    let calls = |formula: &&'static dyn AnyFormula| {
        let name = formula.spec().id.replace('.', "_");
        ["value", "jacobian"].iter().any(|what| text.contains(&format!("jp_{name}_{what}(")))
    };
    project.catalog().iter().copied().filter(calls).collect()
}

/// Writes the routine in one file: its head, the modules, and itself.
pub(super) fn write(project: &Project, shell: Shell, folder: &Path) -> anyhow::Result<String> {
    let (name, own, modules) = shell.parts(project)?;
    let (head, body) = own.split_once("\nsubroutine ").context("a routine is a routine")?;
    let text = [head, "\n\n", &in_order(modules).join("\n"), "\nsubroutine ", body].concat();
    let path = folder.join(format!("{name}.f90"));
    files::write(&path, &text)?;
    Ok(format!("{} lines in {}\n", text.lines().count(), path.display()))
}

/// Sorts modules such that each comes after those it uses.
fn in_order(mut modules: Vec<String>) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    while !modules.is_empty() {
        let missing: Vec<_> = modules.iter().map(|module| format!("    use {}", name(module))).collect();
        let is_ready = |module: &String| !module.lines().any(|line| missing.iter().any(|used| used == line));
        let (ready, rest): (Vec<_>, Vec<_>) = modules.into_iter().partition(is_ready);
        assert!(!ready.is_empty(), "no module uses itself");
        found.extend(ready);
        modules = rest;
    }
    found
}

/// The name of a module.
fn name(module: &str) -> &str {
    module.lines().find_map(|line| line.strip_prefix("module ")).expect("every file is a module")
}
