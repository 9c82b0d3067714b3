//! Finds forgotten tests: a test file that no test program names is never compiled.

use super::finding::Finding;
use super::tree::{Tree, manifest, texts_below};
use std::path::Path;

/// The test program that contains the tests, if there is a single one.
const ALL: &str = "all";

/// Every file next to the common test program that it does not name and that is not a test program itself.
pub(super) fn forgotten(root: &Path, tree: &Tree) -> anyhow::Result<Vec<Finding>> {
    let mut findings = Vec::new();
    for member in ["."].into_iter().chain(tree.members.iter().map(String::as_str)) {
        let folder = format!("{member}/tests");
        let folder = folder.trim_start_matches("./");
        let mut texts = Vec::new();
        texts_below(root, folder, &mut texts)?;
        let beside = |path: &str| Some(path.strip_prefix(folder)?.strip_prefix('/')?.strip_suffix(".rs")?.to_owned());
        let Some((_, all)) = texts.iter().find(|(path, _)| beside(path).as_deref() == Some(ALL)) else { continue };
        let programs: Vec<_> =
            manifest(&root.join(member).join("Cargo.toml"))?.test.into_iter().filter_map(|test| test.name).collect();
        for (path, _) in &texts {
            let Some(name) = beside(path).filter(|name| name != ALL && !name.contains('/')) else { continue };
            if !programs.contains(&name) && !all.lines().any(|line| line == format!("mod {name};")) {
                let what = format!("no program has these tests; write `mod {name};` in {folder}/{ALL}.rs");
                findings.push(Finding::new(path, 0, what));
            }
        }
    }
    Ok(findings)
}
