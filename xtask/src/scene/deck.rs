//! Decks: input files of keywords, and what of them a scene does not have.

use crate::console::say;
use jointproof::scene::{Deck, LeftOut, deck};
use kit::Table;
use std::path::Path;

/// The maximum number of lines that a message names.
const SHOWN: usize = 5;

/// Whether a file is a deck: by its name, or because it begins as one.
pub(super) fn is_deck(path: &Path, bytes: &[u8]) -> bool {
    let named = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("inp"));
    named || bytes.trim_ascii_start().starts_with(b"*")
}

/// Says what is left out of a deck, and returns what connectors depend on.
pub(super) fn left_out(shown: &str, deck: &Deck) -> Vec<String> {
    let (matters, rest): (Vec<_>, Vec<_>) = deck.left_out().iter().partition(|left_out| left_out.matters);
    for line in grouped(&rest) {
        say(&format!("{shown}: left out: {line}"));
    }
    grouped(&matters)
}

/// A line for all of one keyword that are left out for one reason.
fn grouped(all: &[&LeftOut]) -> Vec<String> {
    let mut groups: Vec<Vec<&LeftOut>> = Vec::new();
    for &left_out in all {
        let same = |group: &&mut Vec<&LeftOut>| {
            (&group[0].file, &group[0].keyword, &group[0].what) == (&left_out.file, &left_out.keyword, &left_out.what)
        };
        match groups.iter_mut().find(same) {
            Some(group) => group.push(left_out),
            None => groups.push(vec![left_out]),
        }
    }
    let line = |group: &Vec<&LeftOut>| {
        let LeftOut { file, keyword, what, .. } = group[0];
        let lines: Vec<_> = group.iter().take(SHOWN).map(|left_out| left_out.line.to_string()).collect();
        let more = group.len().checked_sub(SHOWN).filter(|more| *more > 0);
        let lines = lines.join(", ") + &more.map(|more| format!(" and {more} more")).unwrap_or_default();
        let plural = if group.len() > 1 { "lines" } else { "line" };
        let file = file.as_ref().map(|file| format!("{file}, ")).unwrap_or_default();
        format!("{keyword} ({file}{plural} {lines}): {what}")
    };
    groups.iter().map(line).collect()
}

/// The book's table of keywords, `keywords`.
pub(crate) fn tables() -> Vec<(String, Vec<Table>)> {
    let head = ["Keyword", "There", "In the scene", "Unit"].map(String::from).into();
    let code = |keyword: String| format!("`{keyword}`");
    let rows =
        deck::table().into_iter().map(|[keyword, there, key, unit]| vec![code(keyword), there, key, unit]).collect();
    vec![("keywords".into(), vec![Table { head, rows, ..Table::default() }])]
}
