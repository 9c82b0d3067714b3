//! On which files the evidence of every formula rests.
//!
//! In the rooms these are the file of the formula, the files that prove it, and all that these use, directly or not. What is
//! below and beside the rooms, numbers and toolkit, all formulas rest on: traits are not named where they are used.

use super::edges::edges;
use super::layers::{Part, part};
use super::tree::{FileId, Tree};
use kit::Project;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

/// For every formula of the catalog the files from the root of the project.
pub(crate) fn reach(project: &Project) -> anyhow::Result<BTreeMap<String, Vec<PathBuf>>> {
    let tree = Tree::library(project.root())?;
    let mut uses = BTreeMap::<FileId, BTreeSet<FileId>>::new();
    for &(from, to) in edges(&tree).keys() {
        uses.entry(from).or_default().insert(to);
    }
    let files: Vec<FileId> = (0..tree.sources.len()).collect();
    let of_part = |file: &FileId, wanted| part(&tree.sources[*file].path) == Some(wanted);
    let common: BTreeSet<FileId> = files.iter().copied().filter(|file| of_part(file, Part::Common)).collect();
    let rooms: BTreeSet<FileId> = files.iter().copied().filter(|file| of_part(file, Part::Room)).collect();
    let of = |id: &str| {
        let defines = |file: &&FileId| {
            let specs = tree.sources[**file].formulas.iter().flat_map(|formula| &formula.spec);
            specs.into_iter().any(|(text, _)| text == id)
        };
        let Some(&own) = rooms.iter().find(defines) else {
            // A macro defines it: it may rest on anything.
            return rooms.union(&common).copied().collect();
        };
        let proves =
            |file: &&FileId| tree.sources[**file].proves && uses.get(*file).is_some_and(|to| to.contains(&own));
        let mut reached: BTreeSet<FileId> = rooms.iter().filter(proves).copied().chain([own]).collect();
        let mut next: Vec<FileId> = reached.iter().copied().collect();
        while let Some(file) = next.pop() {
            let fresh = uses.get(&file).into_iter().flatten().filter(|to| rooms.contains(to));
            let fresh: Vec<_> = fresh.copied().filter(|to| !reached.contains(to)).collect();
            next.extend(&fresh);
            reached.extend(fresh);
        }
        reached.union(&common).copied().collect::<BTreeSet<FileId>>()
    };
    let paths = |id: &str| {
        let sources = of(id).into_iter().map(|file| PathBuf::from(&tree.sources[file].path));
        sources.chain([format!("golden/{id}.json"), "Cargo.lock".to_owned()].map(PathBuf::from)).collect()
    };
    let ids = project.catalog().iter().map(|formula| formula.spec().id);
    Ok(ids.map(|id| (id.to_owned(), paths(id))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::CATALOG;

    #[test]
    fn a_formula_rests_on_its_room_and_on_what_all_have_in_common() {
        let project = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("..");
        let reach = reach(&project).unwrap();
        assert_eq!(reach.len(), CATALOG.len());
        let rests = |id: &str, file: &str| reach[id].contains(&PathBuf::from(file));
        assert!(rests("coulomb.yield", "src/coulomb.rs") && rests("coulomb.yield", "src/coulomb/proof.rs"));
        for id in ["coulomb.yield", "join.constraint", "slider.line"] {
            assert!(
                rests(id, "src/scalar.rs")
                    && rests(id, "src/verify/audit.rs")
                    && rests(id, &format!("golden/{id}.json"))
            );
            assert!(
                !rests(id, "src/slot.rs") && !rests(id, "src/catalog.rs") && !rests(id, "src/scene/mod.rs"),
                "{id}"
            );
            assert!(reach[id].iter().all(|file| project.root().join(file).exists()), "{id}");
        }
        assert!(!rests("coulomb.yield", "src/join.rs") && !rests("slider.line", "src/coulomb.rs"));
        let alone = reach.values().filter(|files| files.len() < reach["coulomb.yield"].len() + 40).count();
        assert!(alone > CATALOG.len() / 2, "most formulas rest on few rooms: {alone} of {}", CATALOG.len());
    }
}
