//! Checks that every formula of the catalog has exactly one entry in the book.

use super::fault::Fault;
use super::markdown::{Found, Piece, scan};
use anyhow::Context;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The folder of the chapters.
const CHAPTERS: &str = "book/src";

/// A `{{#formula id}}` in a chapter.
#[derive(Debug, Clone)]
pub(crate) struct Directive {
    /// The formula it names.
    pub(crate) id: String,
    /// The chapter.
    pub(crate) file: String,
    /// Its line, from 1.
    pub(crate) line: usize,
}

/// The faults in the entries of the book at `root`.
///
/// # Errors
/// If a chapter cannot be read.
pub fn uncovered(root: &Path, ids: &[&str]) -> anyhow::Result<Vec<Fault>> {
    Ok(faults(ids, &directives(root)?))
}

/// Every entry in the chapters on disk, ordered by the names of the chapters.
pub(crate) fn directives(root: &Path) -> anyhow::Result<Vec<Directive>> {
    let mut directives = Vec::new();
    for (file, text) in chapters(root)? {
        for Found { piece, line, .. } in scan(&text).0 {
            if let Piece::Directive { name, argument: id } = piece
                && name == "formula"
            {
                directives.push(Directive { id, file: file.clone(), line });
            }
        }
    }
    Ok(directives)
}

/// The chapters in the order of their names, with their paths from the root.
pub(crate) fn chapters(root: &Path) -> anyhow::Result<BTreeMap<String, String>> {
    let mut chapters = BTreeMap::new();
    for entry in fs::read_dir(root.join(CHAPTERS)).with_context(|| format!("cannot read {CHAPTERS}"))? {
        let path = entry.with_context(|| format!("cannot read {CHAPTERS}"))?.path();
        if path.extension().is_some_and(|extension| extension == "md") {
            let shown = format!("{CHAPTERS}/{}", path.file_name().unwrap_or_default().display());
            let text = fs::read_to_string(&path).with_context(|| format!("cannot read {shown}"))?;
            chapters.insert(shown, text);
        }
    }
    Ok(chapters)
}

/// Directives that name no formula or a formula that already has an entry, and formulas without an entry.
pub(crate) fn faults(ids: &[&str], directives: &[Directive]) -> Vec<Fault> {
    let mut first: BTreeMap<&str, &Directive> = BTreeMap::new();
    let mut faults = Vec::new();
    for directive in directives {
        let Directive { id, file, line } = directive;
        let message = if !ids.contains(&id.as_str()) {
            let hint = nearest(ids, id).map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
            format!("no formula `{id}` in the catalog{hint}")
        } else if let Some(Directive { file, line, .. }) = first.get(id.as_str()) {
            format!("formula `{id}` has its entry already, at {file}:{line}")
        } else {
            first.insert(id, directive);
            continue;
        };
        faults.push(Fault { file: file.clone(), line: *line, message });
    }
    for id in ids.iter().filter(|id| !first.contains_key(*id)) {
        let message = format!("formula `{id}` is in the catalog but in no chapter; add `{{{{#formula {id}}}}}`");
        faults.push(Fault { file: CHAPTERS.to_owned(), line: 0, message });
    }
    faults
}

/// An id with a similar beginning or end, as a hint.
fn nearest<'a>(ids: &[&'a str], id: &str) -> Option<&'a str> {
    let alike = |known: &str| {
        let front = known.chars().zip(id.chars()).take_while(|(a, b)| a == b).count();
        let back = known.chars().rev().zip(id.chars().rev()).take_while(|(a, b)| a == b).count();
        front + back
    };
    let scored = ids.iter().map(|known| (alike(known), *known));
    scored.filter(|(score, known)| score * 2 >= known.len()).max().map(|(_, known)| known)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chapters_are_the_texts_of_their_folder_with_the_entries_in_them() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join(CHAPTERS);
        fs::create_dir_all(&folder).unwrap();
        for (name, text) in [
            ("b.md", "b\n\n{{#formula t.b}}\n\n{{#text t.c}}\n"),
            ("a.md", "{{#formula t.a}}\n"),
            ("c.txt", "{{#formula t.c}}\n"),
        ] {
            fs::write(folder.join(name), text).unwrap();
        }
        let names: Vec<_> = chapters(root.path()).unwrap().into_keys().collect();
        assert_eq!(names, ["book/src/a.md", "book/src/b.md"]);
        let found = directives(root.path()).unwrap();
        let found: Vec<_> = found.iter().map(|found| format!("{} {}:{}", found.id, found.file, found.line)).collect();
        assert_eq!(found, ["t.a book/src/a.md:1", "t.b book/src/b.md:3"]);
        let faults = uncovered(root.path(), &["t.a", "t.c"]).unwrap();
        assert_eq!(faults.len(), 2, "{faults:?}");
    }

    #[test]
    fn half_of_an_identifier_is_a_hint() {
        assert_eq!(nearest(&["ab.cde"], "ab."), Some("ab.cde"));
        let ids = ["slot.rows", "slot.friction", "coulomb.yield"];
        for (id, near) in [
            ("slot.frction", Some("slot.friction")),
            ("slider.rows", Some("slot.rows")),
            // Five matching letters of nine are enough, four are not.
            ("slot.", Some("slot.rows")),
            ("slot", None),
            ("coulomb.x", Some("coulomb.yield")),
            ("ujoint", None),
        ] {
            assert_eq!(nearest(&ids, id), near, "{id}");
        }
    }
}
