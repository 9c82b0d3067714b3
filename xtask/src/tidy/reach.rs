//! The files on which the evidence of every formula depends.
//!
//! In the modules of formula families these are the file of the formula, the files that prove it, and everything these
//! use, directly or indirectly. All formulas depend on the code outside these modules, numbers and toolkit, because
//! traits are not named where they are used.

use super::edges::edges;
use super::layers::{Part, part};
use super::tree::{FileId, Tree};
use kit::Project;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

/// For every formula of the catalog, the files, as paths from the root of the project.
pub(crate) fn reach(project: &Project) -> anyhow::Result<BTreeMap<String, Vec<PathBuf>>> {
    let tree = Tree::library(project.root())?;
    let mut uses = BTreeMap::<FileId, BTreeSet<FileId>>::new();
    for &(from, to) in edges(&tree).keys() {
        uses.entry(from).or_default().insert(to);
    }
    let of_part = |wanted| -> BTreeSet<FileId> {
        let files = tree.sources.iter().enumerate();
        files.filter(|(_, source)| part(&source.path) == Some(wanted)).map(|(file, _)| file).collect()
    };
    let (common, modules) = (of_part(Part::Common), of_part(Part::Formulas));
    let of = |id: &str| {
        let defines = |file: &&FileId| {
            let specs = tree.sources[**file].formulas.iter().flat_map(|formula| &formula.spec);
            specs.into_iter().any(|(text, _)| text == id)
        };
        let Some(&own) = modules.iter().find(defines) else {
            // It is defined by a macro, so it may depend on anything.
            return modules.union(&common).copied().collect();
        };
        let proves =
            |file: &&FileId| tree.sources[**file].proves && uses.get(*file).is_some_and(|to| to.contains(&own));
        let mut reached: BTreeSet<FileId> = modules.iter().filter(proves).copied().chain([own]).collect();
        let mut next: Vec<FileId> = reached.iter().copied().collect();
        while let Some(file) = next.pop() {
            let fresh = uses.get(&file).into_iter().flatten().filter(|to| modules.contains(to));
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
    use jointproof::connector::slot::{ContactForce, Friction};
    use std::fs;

    #[test]
    fn a_formula_rests_on_its_room_and_on_what_all_have_in_common() {
        let project = Project::new("jointproof", env!("CARGO_MANIFEST_DIR"), CATALOG).in_folder("..");
        let reach = reach(&project).unwrap();
        assert_eq!(reach.len(), CATALOG.len());
        let rests = |id: &str, file: &str| reach[id].contains(&PathBuf::from(file));
        assert!(
            rests("coulomb.yield", "src/contact/coulomb.rs") && rests("coulomb.yield", "src/contact/coulomb/proof.rs")
        );
        for id in ["coulomb.yield", "join.constraint", "slider.line"] {
            assert!(
                rests(id, "src/number/scalar.rs")
                    && rests(id, "src/toolkit/verify/audit.rs")
                    && rests(id, &format!("golden/{id}.json"))
            );
            assert!(
                !rests(id, "src/connector/slot.rs") && !rests(id, "src/catalog.rs") && !rests(id, "src/scene/mod.rs"),
                "{id}"
            );
            assert!(reach[id].iter().all(|file| project.root().join(file).exists()), "{id}");
        }
        assert!(!rests("coulomb.yield", "src/connector/join.rs") && !rests("slider.line", "src/contact/coulomb.rs"));
        let alone = reach.values().filter(|files| files.len() < reach["coulomb.yield"].len() + 40).count();
        assert!(alone > CATALOG.len() / 2, "most formulas rest on few rooms: {alone} of {}", CATALOG.len());
    }

    const FILES: [(&str, &str); 13] = [
        ("Cargo.toml", "[package]\nname = \"jointproof\"\n"),
        (
            "src/lib.rs",
            "mod formula;\nmod catalog;\nmod toolkit;\nmod slot;\nmod low;\nmod lower;\nmod hard;\nmod other;\n\
             mod another;\n",
        ),
        ("src/formula.rs", "pub trait Formula {}\n"),
        ("src/toolkit.rs", "pub mod measure;\npub fn law() {}\n"),
        ("src/toolkit/measure.rs", "pub fn way() {}\n"),
        ("src/catalog.rs", "use crate::slot::ContactForce;\n"),
        ("src/slot.rs", "mod contact_force;\nmod proof;\npub use contact_force::ContactForce;\n"),
        (
            "src/slot/contact_force.rs",
            "use crate::low::Low;\npub struct ContactForce;\nimpl Formula for ContactForce {\n    \
             const SPEC: Spec = Spec::new(\"slot.contact_force\", \"A title\");\n}\n",
        ),
        ("src/slot/proof.rs", "use super::ContactForce;\nuse crate::hard::Hard;\nimpl Proved for ContactForce {}\n"),
        ("src/low.rs", "use crate::lower::Lower;\npub struct Low(Lower);\n"),
        ("src/lower.rs", "use crate::low::Low;\npub struct Lower(Low);\n"),
        ("src/hard.rs", "pub struct Hard;\n"),
        // One uses the formula and proves nothing, the other proves something else.
        ("src/other.rs", "use crate::slot::ContactForce;\nuse crate::another::Another;\n"),
    ];

    #[test]
    fn a_formula_rests_on_what_proves_it_and_on_all_that_these_use() {
        let root = tempfile::tempdir().unwrap();
        for (file, text) in
            FILES.iter().chain(&[("src/another.rs", "pub struct Another;\nimpl Proved for Another {}\n")])
        {
            fs::create_dir_all(root.path().join(file).parent().unwrap()).unwrap();
            fs::write(root.path().join(file), text).unwrap();
        }
        let project = Project::new("reached", env!("CARGO_MANIFEST_DIR"), &[&ContactForce, &Friction]);
        let reached = reach(&project.in_folder(root.path().to_str().unwrap())).unwrap();
        let of = |id: &str| {
            let mut files: Vec<_> = reached[id].iter().map(|file| file.to_str().unwrap()).collect();
            files.sort_unstable();
            files
        };
        let own = ["src/hard.rs", "src/low.rs", "src/lower.rs", "src/slot/contact_force.rs", "src/slot/proof.rs"];
        let common = ["src/formula.rs", "src/toolkit.rs"];
        let sorted = |parts: &[&[&'static str]]| {
            let mut all = parts.concat();
            all.sort_unstable();
            all
        };
        assert_eq!(
            of("slot.contact_force"),
            sorted(&[&["Cargo.lock", "golden/slot.contact_force.json"], &common, &own])
        );
        // No file defines the other formula, so it may depend on all families.
        let modules = ["src/another.rs", "src/other.rs", "src/slot.rs"];
        assert_eq!(
            of("slot.friction"),
            sorted(&[&["Cargo.lock", "golden/slot.friction.json"], &common, &own, &modules])
        );
        assert_eq!(reached.len(), 2);
    }
}
