//! `export --shell`: a user routine for a finite-element program in one file, with the exported formulas that it calls.
//!
//! Elements share `uel.f90` and differ in their module `jp_connector`. The text before `---` in a connector's file describes the
//! layout of its properties, its state and its multipliers, and becomes part of the head of the element.

use super::language::Language;
use super::recorded::record;
use super::{Project, fortran::Fortran};
use crate::files;
use anyhow::Context;
use jointproof::catalog::AnyFormula;
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
    /// A friction model of Abaqus: Coulomb's, in one direction or two
    Fric,
    /// A multi-point constraint of Abaqus: SLIDER
    Mpc,
}

impl Shell {
    /// The name of its file.
    fn file(self) -> &'static str {
        match self {
            Self::UelSlot => "uel_slot.f90",
            Self::UelTranslator => "uel_translator.f90",
            Self::UelUjoint => "uel_ujoint.f90",
            Self::Fric => "fric.f90",
            Self::Mpc => "mpc.f90",
        }
    }

    /// Its own code, in addition to the formulas.
    fn own(self) -> String {
        match self {
            Self::UelSlot => element("SLOT", include_str!("shell/slot.f90")),
            Self::UelTranslator => element("TRANSLATOR", include_str!("shell/translator.f90")),
            Self::UelUjoint => element("UJOINT", include_str!("shell/ujoint.f90")),
            Self::Fric => include_str!("shell/fric.f90").to_owned(),
            Self::Mpc => include_str!("shell/mpc.f90").to_owned(),
        }
    }
}

/// An element around a connector.
fn element(title: &str, connector: &str) -> String {
    let (places, connector) = connector.split_once("---\n").expect("a connector has notes and a module");
    let parameter = |name: &str| {
        let (_, rest) = connector.split_once(&format!("{name} = ")).expect("a connector says how many it has");
        rest.chars().take_while(char::is_ascii_digit).collect::<String>()
    };
    let multipliers = parameter("multipliers");
    let degrees: Vec<_> = (1..=multipliers.parse().unwrap_or(0)).map(|k: usize| k.to_string()).collect();
    let filled_in = [
        ("title", title.to_owned()),
        ("places", places.to_owned()),
        ("states", parameter("states")),
        ("properties", parameter("properties")),
        ("degrees", degrees.join(", ")),
        ("multipliers", multipliers),
    ];
    let uel = include_str!("shell/uel.f90").to_owned();
    let uel = filled_in.iter().fold(uel, |text, (name, what)| text.replace(&format!("{{{name}}}"), what));
    let (head, body) = uel.split_once("subroutine uel").expect("the element is a routine");
    [head, "\n", include_str!("shell/element.f90"), "\n", connector, "\nsubroutine uel", body].concat()
}

/// The formulas that a text calls.
fn called(project: &Project, text: &str) -> Vec<&'static dyn AnyFormula> {
    let calls = |formula: &&'static dyn AnyFormula| {
        let name = formula.spec().id.replace('.', "_");
        ["value", "jacobian"].iter().any(|what| text.contains(&format!("jp_{name}_{what}(")))
    };
    project.catalog().iter().copied().filter(calls).collect()
}

/// Writes the routine in one file: its head, the formulas as modules, and itself.
pub(super) fn write(project: &Project, shell: Shell, folder: &Path) -> anyhow::Result<String> {
    let own = shell.own();
    let (recorded, _) = record(&called(project, &own), Some(&project.golden()));
    let mut modules = Fortran.files(&recorded);
    modules.retain(|(name, _)| {
        Path::new(name).extension().is_some_and(|extension| extension == "f90") && !name.starts_with("driver")
    });
    let modules = in_order(modules.into_iter().map(|(_, text)| text).collect());
    let begin = own.find("\nmodule ").or_else(|| own.find("\nsubroutine ")).context("a routine is a routine")?;
    let begin = own[..begin].rfind("\n\n").map_or(begin, |blank| blank + 1);
    let text = [&own[..begin], "\n", &modules.join("\n"), &own[begin..]].concat();
    files::write(&folder.join(shell.file()), &text)?;
    Ok(format!(
        "{} formulas, {} lines in {}\n",
        recorded.len(),
        text.lines().count(),
        folder.join(shell.file()).display()
    ))
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
