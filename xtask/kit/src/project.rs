//! The subject of the commands: a catalog of formulas, and the folder of its sources, golden files and book.

use crate::{
    extension::{Beside, Extras},
    outcome::{Outcome, Usage},
};
use clap::{ArgMatches, Args, FromArgMatches};
use jointproof::catalog::{AnyElement, AnyFormula};
use std::path::{Path, PathBuf};

/// Every formula of a project, in the order of its book.
pub type Catalog = &'static [&'static dyn AnyFormula];

/// Every element of a project, in the order of its book.
pub type Elements = &'static [&'static dyn AnyElement];

/// A catalog of formulas and elements, and the folder of everything about it.
///
/// In its folder, `src` and `tests` contain the sources, `golden` the golden files and `book` the book.
pub struct Project {
    name: &'static str,
    command: &'static str,
    by_cargo: &'static str,
    folder: PathBuf,
    measured: Option<PathBuf>,
    root: PathBuf,
    place: Place,
    sources: Option<u64>,
    permalinks: &'static str,
    catalog: Catalog,
    elements: Elements,
    pub(crate) extension: Extension,
}

/// How the folder of a project was found.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    /// It is the package's own, or a copy that a test made and changed.
    Given,
    /// The command was called in it, or it was named.
    Found,
    /// There is none where the command was called.
    Nowhere,
}

/// A project's extensions of the commands.
#[derive(Default)]
pub(crate) struct Extension {
    pub(crate) commands: Vec<Command>,
    pub(crate) beside: Option<(&'static str, Golden)>,
    pub(crate) checks: Vec<(&'static str, Check)>,
    pub(crate) extras: Option<fn(&Project) -> anyhow::Result<Extras>>,
    pub(crate) reach: Option<Reach>,
    pub(crate) requirements: Vec<(&'static str, IsMet, &'static str)>,
}

/// A command, and the function that runs it.
type Command = (clap::Command, Box<dyn Fn(&Project, &ArgMatches) -> Outcome + Send + Sync>);

/// Whether the formula with this identifier meets a requirement.
type IsMet = fn(&Project, &str) -> bool;

/// For every formula, by identifier, the files, as paths from the root, on which its evidence depends.
pub type Reach = fn(&Project) -> anyhow::Result<std::collections::BTreeMap<String, Vec<PathBuf>>>;

/// Generates golden files other than those of formulas.
type Golden = fn(&Project) -> anyhow::Result<Beside>;

/// An additional step of `verify`: whether all is well, and how much was checked. Faults are reported on standard error.
pub type Check = fn(&Project) -> anyhow::Result<(bool, String)>;

impl Project {
    /// The project of a package: `Project::new(env!("CARGO_PKG_NAME"), env!("CARGO_MANIFEST_DIR"), CATALOG)`.
    pub fn new(name: &'static str, manifest_dir: &'static str, catalog: Catalog) -> Self {
        let folder = Path::new(manifest_dir);
        Self {
            name,
            command: "cargo run --",
            by_cargo: "cargo run --",
            folder: folder.to_path_buf(),
            measured: None,
            root: folder.to_path_buf(),
            place: Place::Given,
            sources: None,
            permalinks: "",
            catalog,
            elements: &[],
            extension: Extension::default(),
        }
    }

    /// Adds elements to the formulas.
    #[must_use]
    pub fn with_elements(self, elements: Elements) -> Self {
        Self { elements, ..self }
    }

    /// Puts sources, golden files and book in this folder, relative to the package's own, as `..`, instead of the package's own.
    #[must_use]
    pub fn in_folder(self, relative: &str) -> Self {
        Self { root: self.beside(relative), ..self }
    }

    /// Sets the package, in this folder relative to the package's own, whose program `report` builds and times.
    #[must_use]
    pub fn measured_by(self, relative: &str) -> Self {
        Self { measured: Some(self.beside(relative)), ..self }
    }

    /// Sets what the [sources](crate::sources) of the formulas were when they were compiled. Without it, only a program that cargo
    /// has just built judges them.
    #[must_use]
    pub fn built_from(self, sources: u64) -> Self {
        Self { sources: Some(sources), ..self }
    }

    /// Sets the list of addresses of the book, `book/permalinks.txt`, so that an identifier that was once used leads to the new one.
    #[must_use]
    pub fn with_permalinks(self, permalinks: &'static str) -> Self {
        Self { permalinks, ..self }
    }

    /// The project in this folder, or else in the one where the command was called or above.
    ///
    /// # Errors
    /// If the folder is not that of this project.
    pub(crate) fn found(self, named: Option<&PathBuf>) -> Result<Self, Usage> {
        // A test of the commands, which plants faults in a copy.
        if let Some(copy) = std::env::var_os("JOINTPROOF_ROOT") {
            return Ok(Self { root: copy.into(), ..self });
        }
        if let Some(folder) = named {
            if !self.is_in(folder) {
                let (name, folder) = (self.name, folder.display());
                return Err(Usage(format!(
                    "{folder} is not the folder of {name}: its Cargo.toml does not name that package"
                )));
            }
            let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.clone());
            return Ok(self.moved(folder, Place::Found));
        }
        let here = std::env::current_dir().unwrap_or_default();
        Ok(match here.ancestors().find(|folder| self.is_in(folder)) {
            Some(root) => self.moved(root.to_path_buf(), Place::Found),
            None => self.moved(here, Place::Nowhere),
        })
    }

    /// The same project in another folder.
    fn moved(self, root: PathBuf, place: Place) -> Self {
        let moved =
            |folder: &PathBuf| folder.strip_prefix(&self.root).map_or_else(|_| folder.clone(), |part| root.join(part));
        Self { measured: self.measured.as_ref().map(moved), root, place, ..self }
    }

    /// Whether the manifest in this folder is that of the project.
    fn is_in(&self, folder: &Path) -> bool {
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
        let package = manifest.split("[package]").nth(1).unwrap_or_default();
        let name = package.lines().find_map(|line| line.strip_prefix("name")?.trim_start().strip_prefix('='));
        name.is_some_and(|name| name.trim().trim_matches('"') == self.name)
    }

    /// A folder relative to the package's own, without `..` in its path.
    fn beside(&self, relative: &str) -> PathBuf {
        let mut folder = self.folder.clone();
        for part in Path::new(relative) {
            if part == ".." {
                folder.pop();
            } else {
                folder.push(part);
            }
        }
        folder
    }

    /// Sets the command named in help and messages, instead of `cargo run --`: by cargo, and the name of the installed program.
    #[must_use]
    pub fn called(self, by_cargo: &'static str, installed: &'static str) -> Self {
        let command = if std::env::var_os("CARGO").is_some() { by_cargo } else { installed };
        Self { command, by_cargo, ..self }
    }

    /// The name, under which reports and evidence are kept.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What users type before the name of a command.
    pub fn command(&self) -> &'static str {
        self.command
    }

    /// The manifest of the package whose program is measured, if there is one.
    pub fn measured(&self) -> Option<PathBuf> {
        Some(self.measured.as_ref()?.join("Cargo.toml"))
    }

    /// The folder of the project.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Every formula.
    pub fn catalog(&self) -> Catalog {
        self.catalog
    }

    /// Every element.
    pub fn elements(&self) -> Elements {
        self.elements
    }

    /// The formula with this identifier.
    pub fn find(&self, id: &str) -> Option<&'static dyn AnyFormula> {
        self.catalog.iter().copied().find(|formula| formula.spec().id == id)
    }

    /// The identifiers of all formulas and elements.
    pub(crate) fn ids(&self) -> impl Iterator<Item = &'static str> {
        let formulas = self.catalog.iter().map(|formula| formula.spec().id);
        formulas.chain(self.elements.iter().map(|element| element.spec().id))
    }

    /// The formula with the identifier given as an argument of this option.
    ///
    /// # Errors
    /// If there is none, with what may be meant.
    pub(crate) fn named(&self, option: &str, id: &str) -> Result<&'static dyn AnyFormula, Usage> {
        self.find(id).ok_or_else(|| Usage(format!("{option} '{id}' is no formula; {}", self.instead_of(id))))
    }

    /// What may be meant by an identifier that is not in the catalog, and how all are listed.
    pub(crate) fn instead_of(&self, id: &str) -> String {
        let mut families: Vec<_> = self.ids().filter_map(|id| Some(id.split_once('.')?.0)).collect();
        families.sort_unstable();
        families.dedup();
        let patterns = families.iter().filter(|_| id.contains('*')).map(|family| format!("{family}.*"));
        let mut near: Vec<_> = patterns.chain(self.ids().map(str::to_owned)).collect();
        near.retain(|known| strsim::osa_distance(known, id) <= id.len() / 3);
        near.sort_by_key(|known| strsim::osa_distance(known, id));
        near.truncate(3);
        let renamed = self.permalinks.lines().filter_map(|line| line.split_once(" -> ")).find(|(old, _)| *old == id);
        let meant = match renamed {
            Some((_, new)) => format!("it is now {new}"),
            None if near.is_empty() => format!("families are {}", families.join(", ")),
            None => format!("did you mean {}?", near.join(" or ")),
        };
        format!("{meant}\n  `{} formulas` lists all", self.command)
    }

    /// The folder of the golden files.
    pub fn golden(&self) -> PathBuf {
        self.root.join("golden")
    }

    /// Whether there are chapters of a book.
    pub fn has_book(&self) -> bool {
        self.root.join("book/src").exists()
    }

    /// The golden file of the formula with this identifier.
    pub fn golden_file(&self, id: &str) -> PathBuf {
        self.golden().join(format!("{id}.json"))
    }

    /// The folder of generated files: the book, and below it reports and evidence.
    pub fn target(&self) -> PathBuf {
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| self.root.join("target"), PathBuf::from)
    }

    /// Where reports and evidence are kept between commands.
    pub fn kept(&self, file: &str) -> PathBuf {
        self.target().join(self.name).join(file)
    }

    /// A path as typed in the folder of the project.
    pub fn shown(&self, path: &Path) -> String {
        path.strip_prefix(&self.root).unwrap_or(path).display().to_string()
    }

    /// Whether the command was called in the project, or on it.
    pub(crate) fn is_here(&self) -> bool {
        self.place != Place::Nowhere
    }

    /// Checks that there is a project, for a command that needs one.
    ///
    /// # Errors
    /// If there is none, with advice what to do instead.
    pub fn needs_project(&self, command: &str) -> Result<(), Usage> {
        if self.is_here() {
            return Ok(());
        }
        let (name, here) = (self.name, self.root.display());
        Err(Usage(format!(
            "{command} works on the project {name}, and neither {here} nor a folder above it is its folder; go there, or name it by \
             --project. These need no project: check, equation, export, formulas, scene, golden --out"
        )))
    }

    /// Checks that there is a project whose sources are those that this program was built from, for a command that judges them.
    ///
    /// # Errors
    /// If there is none, or it has other sources, with the command to use there.
    pub fn needs_sources(&self, command: &str) -> Result<(), Usage> {
        self.needs_project(command)?;
        let folder = self.root.display();
        let by_cargo =
            || std::env::var_os("CARGO_MANIFEST_DIR").is_some_and(|folder| Path::new(&folder) == self.folder);
        let fresh = || self.folder.starts_with(&self.root) && by_cargo();
        match self.sources {
            _ if self.place == Place::Given => Ok(()),
            Some(sources) if sources == crate::sources::sources(&self.root) => Ok(()),
            None if fresh() => Ok(()),
            _ => Err(Usage(format!(
                "this program was built from other sources than those in {folder}, so that it cannot judge them; there, use \
                 `{} {command}`",
                self.by_cargo
            ))),
        }
    }

    /// Adds a command. Its arguments are derived by clap, and its examples refer to it as `{command} NAME …`.
    #[must_use]
    pub fn with_command<A: Args + FromArgMatches + 'static>(
        mut self,
        name: &'static str,
        run: fn(&Self, &A) -> Outcome,
    ) -> Self {
        let command = A::augment_args(clap::Command::new(name));
        let run = move |project: &Self, matches: &ArgMatches| run(project, &A::from_arg_matches(matches)?);
        self.extension.commands.push((command, Box::new(run)));
        self
    }

    /// Adds golden files other than those of the formulas, under a name for the summary of `verify`.
    #[must_use]
    pub fn with_golden(mut self, name: &'static str, files: Golden) -> Self {
        self.extension.beside = Some((name, files));
        self
    }

    /// Adds a step to `verify`, under a name for its summary.
    #[must_use]
    pub fn with_check(mut self, name: &'static str, check: Check) -> Self {
        self.extension.checks.push((name, check));
        self
    }

    /// Sets the function that returns the files on which the evidence of every formula depends, so that an edit
    /// invalidates only the evidence it affects. Without it, any edit of `src` or `golden` invalidates all evidence.
    #[must_use]
    pub fn with_reach(mut self, reach: Reach) -> Self {
        self.extension.reach = Some(reach);
        self
    }

    /// Adds a requirement on every formula: a description, whether a formula meets it, and how to meet it.
    #[must_use]
    pub fn with_requirement(mut self, what: &'static str, is_met: IsMet, how: &'static str) -> Self {
        self.extension.requirements.push((what, is_met, how));
        self
    }

    /// Adds generated content for the book.
    #[must_use]
    pub fn with_extras(mut self, extras: fn(&Self) -> anyhow::Result<Extras>) -> Self {
        self.extension.extras = Some(extras);
        self
    }
}
