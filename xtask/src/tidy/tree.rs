//! The workspace as a tree of modules: its members, their crates, and the files that `mod` names.

use super::finding::Finding;
use super::import::Import;
use super::source::{Scope, Source};
use super::words::Words;
use anyhow::Context;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The index of a file in [`Tree::sources`].
pub(super) type FileId = usize;
/// The index of a module in [`Tree::modules`].
pub(super) type ModuleId = usize;

/// Features that enable the evidence of formulas.
const PROOF: [&str; 2] = ["verify", "measure"];

/// All modules of the workspace except tests.
#[derive(Debug, Default)]
pub(super) struct Tree {
    /// The folders of the members other than the one at the root.
    pub(super) members: Vec<String>,
    /// The files, in the order in which they were found.
    pub(super) sources: Vec<Source>,
    /// The modules.
    pub(super) modules: Vec<Module>,
    /// The root modules of libraries, by the names of the libraries.
    pub(super) libraries: BTreeMap<String, ModuleId>,
    /// Files that cannot be read.
    pub(super) faults: Vec<Finding>,
}

/// A module.
#[derive(Debug, Default)]
pub(super) struct Module {
    /// The file that contains it.
    pub(super) file: FileId,
    /// The module around it, unless it is a root.
    pub(super) parent: Option<ModuleId>,
    /// The root of its crate.
    pub(super) root: ModuleId,
    /// Its submodules.
    pub(super) children: BTreeMap<String, ModuleId>,
    /// The names it defines.
    pub(super) items: BTreeSet<String>,
    /// The macros that the crate exports, with the files that define them; only in a root.
    pub(super) macros: BTreeMap<String, FileId>,
    /// Its imports and re-exports.
    pub(super) imports: Vec<Import>,
    /// The names used in its code.
    pub(super) words: Words,
    /// Whether it is compiled only for verification or measurement.
    pub(super) is_proof: bool,
}

#[derive(Deserialize)]
pub(super) struct Manifest {
    package: Option<Named>,
    lib: Option<Named>,
    workspace: Option<Workspace>,
    #[serde(default)]
    pub(super) test: Vec<Named>,
}

#[derive(Deserialize)]
pub(super) struct Named {
    pub(super) name: Option<String>,
}

#[derive(Deserialize)]
struct Workspace {
    #[serde(default)]
    members: Vec<String>,
}

impl Tree {
    /// Reads every member of the workspace at `root`.
    pub(super) fn read(root: &Path) -> anyhow::Result<Self> {
        let manifest = manifest(&root.join("Cargo.toml"))?;
        let members = manifest.workspace.map_or_else(Vec::new, |workspace| workspace.members);
        let mut tree = Self { members, ..Self::default() };
        tree.member(root, "")?;
        for member in tree.members.clone() {
            tree.member(root, &member)?;
        }
        Ok(tree)
    }

    /// Reads only the package at `root`.
    pub(super) fn library(root: &Path) -> anyhow::Result<Self> {
        let mut tree = Self::default();
        tree.member(root, "")?;
        Ok(tree)
    }

    /// Reads the crates of a member: `lib.rs` and `main.rs`.
    fn member(&mut self, root: &Path, member: &str) -> anyhow::Result<()> {
        let Manifest { package, lib, .. } = manifest(&root.join(member).join("Cargo.toml"))?;
        let library = lib.and_then(|lib| lib.name).or_else(|| Some(package?.name?.replace('-', "_")));
        let folder = if member.is_empty() { "src".to_owned() } else { format!("{member}/src") };
        let mut texts = Vec::new();
        texts_below(root, &folder, &mut texts)?;
        let mut sources = BTreeMap::new();
        for source in texts.into_par_iter().map(|(path, text)| Source::read(path, &text)).collect::<Vec<_>>() {
            match source {
                Ok(source) => _ = sources.insert(source.path.clone(), source),
                Err(fault) => self.faults.push(fault),
            }
        }
        for head in ["lib.rs", "main.rs"] {
            let Some(source) = sources.remove(&format!("{folder}/{head}")) else { continue };
            let root = self.modules.len();
            if head == "lib.rs" {
                self.libraries.extend(library.clone().map(|name| (name, root)));
            }
            self.file(source, Module { root, ..Module::default() }, &folder, &mut sources);
        }
        Ok(())
    }

    /// Adds a file and the files it names.
    fn file(&mut self, source: Source, module: Module, folder: &str, rest: &mut BTreeMap<String, Source>) -> ModuleId {
        let file = self.sources.len();
        self.sources.push(source);
        let scope = std::mem::take(&mut self.sources[file].scope);
        self.scope(scope, Module { file, ..module }, folder, rest)
    }

    /// Adds a module and its submodules, whose files are in `folder`.
    fn scope(&mut self, scope: Scope, module: Module, folder: &str, rest: &mut BTreeMap<String, Source>) -> ModuleId {
        let id = self.modules.len();
        let (file, root, is_proof) = (module.file, module.root, module.is_proof);
        let Scope { items, exported, imports, children, words } = scope;
        self.modules.push(Module { items, imports, words, ..module });
        self.modules[root].macros.extend(exported.into_iter().map(|name| (name, file)));
        for child in children {
            let folder = format!("{folder}/{}", child.name);
            let is_proof = is_proof || child.features.iter().any(|feature| PROOF.contains(&feature.as_str()));
            let module = Module { file, root, is_proof, parent: Some(id), ..Module::default() };
            let file = [format!("{folder}.rs"), format!("{folder}/mod.rs")].iter().find_map(|path| rest.remove(path));
            let inner = match (child.scope, file) {
                (Some(scope), _) => self.scope(scope, module, &folder, rest),
                (None, Some(source)) => self.file(source, module, &folder, rest),
                (None, None) => continue,
            };
            self.modules[id].children.insert(child.name, inner);
        }
        id
    }
}

pub(super) fn manifest(path: &Path) -> anyhow::Result<Manifest> {
    let text = fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    toml::from_str(&text).with_context(|| format!("cannot read {}", path.display()))
}

/// The Rust files below a folder, with their paths from the root, except hidden folders and build output.
pub(super) fn texts_below(root: &Path, folder: &str, texts: &mut Vec<(String, String)>) -> anyhow::Result<()> {
    let directory = root.join(folder);
    if !directory.is_dir() {
        return Ok(());
    }
    let shown = || format!("cannot read {}", directory.display());
    for entry in fs::read_dir(&directory).with_context(shown)? {
        let entry = entry.with_context(shown)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{folder}/{name}");
        if entry.path().is_dir() && name != "target" && !name.starts_with('.') {
            texts_below(root, &path, texts)?;
        } else if Path::new(&name).extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(entry.path()).with_context(|| format!("cannot read {path}"))?;
            texts.push((path, text));
        }
    }
    Ok(())
}
