//! Every formula of the catalog has its entry in the book, once.

use super::finding::Finding;
use crate::book::coverage::{self, Directive};
use crate::book::markdown::{Found, Piece, scan};
use anyhow::Context;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The folder of the chapters.
const CHAPTERS: &str = "book/src";

/// Directives that name no formula or one that has its entry already, and formulas without an entry.
pub(super) fn faults(root: &Path, formulas: &[&str]) -> anyhow::Result<Vec<Finding>> {
    let chapters = chapters(root)?;
    let pieces = chapters.iter().flat_map(|(file, text)| scan(text).0.into_iter().map(move |found| (file, found)));
    let entries: Vec<_> = pieces
        .filter_map(|(file, Found { piece, line, .. })| match piece {
            Piece::Directive { name, argument } if name == "formula" => Some((argument, file, line)),
            _ => None,
        })
        .collect();
    let directives = entries.iter().map(|(id, file, line)| Directive { id, file, line: *line });
    let faults = coverage::faults(formulas, directives).into_iter();
    Ok(faults.map(|fault| Finding::new(fault.file, fault.line, fault.message)).collect())
}

/// The chapters in the order of their names, with their paths from the root.
fn chapters(root: &Path) -> anyhow::Result<BTreeMap<String, String>> {
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
