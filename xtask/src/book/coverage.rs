//! Every formula of the catalog has its entry in the book, and has it once.

use super::fault::Fault;
use std::collections::BTreeMap;

/// A `{{#formula id}}` in a chapter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Directive<'a> {
    /// The formula it names.
    pub(crate) id: &'a str,
    /// The chapter.
    pub(crate) file: &'a str,
    /// Its line, from 1.
    pub(crate) line: usize,
}

/// Directives that name no formula or one that has its entry already, and formulas without an entry.
pub(crate) fn faults<'a>(ids: &[&str], directives: impl IntoIterator<Item = Directive<'a>>) -> Vec<Fault> {
    let mut first = BTreeMap::new();
    let mut faults = Vec::new();
    for directive in directives {
        let Directive { id, file, line } = directive;
        let message = if !ids.contains(&id) {
            let hint = nearest(ids, id).map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
            format!("no formula `{id}` in the catalog{hint}")
        } else if let Some(Directive { file, line, .. }) = first.get(id) {
            format!("formula `{id}` has its entry already, at {file}:{line}")
        } else {
            first.insert(id, directive);
            continue;
        };
        faults.push(Fault { file: file.to_owned(), line, message });
    }
    for id in ids.iter().filter(|id| !first.contains_key(*id)) {
        let message = format!("formula `{id}` is in the catalog but in no chapter; add `{{{{#formula {id}}}}}`");
        faults.push(Fault { file: "book/src".to_owned(), line: 0, message });
    }
    faults
}

/// The id that begins or ends like `id`, for a hint.
fn nearest<'a>(ids: &[&'a str], id: &str) -> Option<&'a str> {
    let alike = |known: &str| {
        let front = known.chars().zip(id.chars()).take_while(|(a, b)| a == b).count();
        let back = known.chars().rev().zip(id.chars().rev()).take_while(|(a, b)| a == b).count();
        front + back
    };
    let scored = ids.iter().map(|known| (alike(known), *known));
    scored.filter(|(score, known)| score * 2 >= known.len()).max().map(|(_, known)| known)
}
