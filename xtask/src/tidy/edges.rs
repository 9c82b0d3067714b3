//! Which file uses which, and where.

use super::import::Known;
use super::tree::{FileId, Module, Tree};
use std::collections::BTreeMap;

/// For every file and another that it uses, one location of a use.
pub(super) type Edges = BTreeMap<(FileId, FileId), Place>;

/// A location where a file names an item of another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    /// Its line.
    pub(super) line: usize,
    /// The text there.
    pub(super) text: String,
}

/// Every edge. Imports are shown before paths, and paths before bare names.
pub(super) fn edges(tree: &Tree) -> Edges {
    let mut edges = Edges::new();
    for (id, module) in tree.modules.iter().enumerate() {
        for (path, place) in named(module) {
            for to in tree.definitions(id, &path).into_iter().filter(|&to| to != module.file) {
                edges.entry((module.file, to)).or_insert_with(|| place.clone());
            }
        }
    }
    edges
}

/// The names that a module uses. Mere re-exports do not count as uses.
fn named(module: &Module) -> impl Iterator<Item = (Vec<String>, Place)> {
    let imports = module.imports.iter().filter(|import| !import.is_public || import.known == Known::Nameless);
    let imports = imports.map(|import| (import.path.clone(), Place { line: import.line, text: import.shown() }));
    let paths = module.words.paths.iter();
    let paths =
        paths.map(|mention| (mention.path.clone(), Place { line: mention.line, text: mention.path.join("::") }));
    let names = module.words.names.iter();
    let names = names.map(|(name, &line)| (vec![name.clone()], Place { line, text: name.clone() }));
    imports.chain(paths).chain(names)
}
