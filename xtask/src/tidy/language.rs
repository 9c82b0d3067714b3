//! Phrases of the chapters, and of the strings that programs and entries print, for which English has others.

use super::finding::Finding;
use super::tree::Tree;
use std::path::Path;

/// A phrase, and what to write; `…` is anything within a clause.
const PHRASES: [(&str, &str); 23] = [
    ("derivative by ", "derivative with respect to"),
    ("derivatives by ", "derivatives with respect to"),
    ("derivative of … by the translation", "derivative of … with respect to the translation"),
    ("derivative of … by the spin", "derivative of … with respect to the spin"),
    ("columns by $", "columns for"),
    ("across the line", "normal to the line"),
    ("across the cross", "normal to the cross"),
    ("by vectors", "normwise"),
    ("is asked about", "is questioned"),
    ("hat is wrong names", "errors name"),
    ("stands beside", "is next to"),
    ("the bits that it has alone", "the same bits as a single evaluation"),
    ("closest place", "closest point"),
    ("at one place", "at one point"),
    ("place of node", "position of node"),
    ("turn of node", "rotation of node"),
    ("turned against", "rotated relative to"),
    ("sign is turned", "wrong sign"),
    ("sign of … is turned", "sign of … is reversed"),
    ("Given are ", "Inputs:"),
    ("does the work of the moment", "conjugate to"),
    ("no document says", "no document states"),
    ("our text", "our copy"),
];

/// What names the phrases.
const HERE: &str = "tidy/language.rs";

/// The phrases in the chapters of a book, outside code, and in the strings of the code, outside tests.
pub(super) fn foreign(root: &Path, tree: &Tree) -> anyhow::Result<Vec<Finding>> {
    let mut findings = Vec::new();
    for entry in std::fs::read_dir(root.join("book/src"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "md") {
            let file = format!("book/src/{}", path.file_name().unwrap_or_default().to_string_lossy());
            findings.extend(in_chapter(&file, &std::fs::read_to_string(&path)?));
        }
    }
    for module in &tree.modules {
        let path = tree.sources[module.file].path.as_str();
        let strings = module.words.strings.iter().filter(|_| !path.ends_with(HERE));
        findings.extend(strings.flat_map(|(text, line)| in_line(path, *line, text)));
    }
    for source in &tree.sources {
        let strings = source.formulas.iter().flat_map(|formula| &formula.spec);
        findings.extend(strings.flat_map(|(text, line)| in_line(&source.path, *line, text)));
    }
    Ok(findings)
}

fn in_chapter(file: &str, text: &str) -> Vec<Finding> {
    let (mut found, mut is_code) = (Vec::new(), false);
    for (line, number) in text.lines().zip(1..) {
        is_code ^= line.starts_with("```");
        found.extend(Some(line).filter(|_| !is_code).into_iter().flat_map(|line| in_line(file, number, line)));
    }
    found
}

fn in_line(file: &str, number: usize, line: &str) -> Vec<Finding> {
    let phrases = PHRASES.iter().filter(|(phrase, _)| has(line, phrase));
    let found = phrases
        .map(|(phrase, instead)| Finding::new(file, number, format!("\"{}\": write \"{instead}\"", phrase.trim())));
    found.collect()
}

/// Whether a text has the parts of a phrase, in their order and in one clause.
fn has(text: &str, phrase: &str) -> bool {
    let (first, rest) = phrase.split_once('…').unwrap_or((phrase, ""));
    text.match_indices(first).any(|(at, _)| {
        let behind = &text[at + first.len()..];
        let clause = behind.split(['.', ',', ';', ':']).next().unwrap_or_default();
        rest.is_empty() || clause.contains(rest)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phrases_are_found_outside_code() {
        let found =
            in_chapter("a.md", "The derivative by x.\n\n```text\nthe derivatives by mu\n```\n\nIt is normwise.\n");
        let said: Vec<_> = found.iter().map(ToString::to_string).collect();
        assert_eq!(said, ["a.md:1: \"derivative by\": write \"derivative with respect to\""]);
    }

    #[test]
    fn a_phrase_with_a_gap_is_found_within_a_clause() {
        let phrase = "derivative of … by the ";
        assert!(has("the derivative of a force by the spin", phrase));
        assert!(!has("the derivative of a force, by the rule of a product", phrase));
        assert!(!has("the derivative of a force with respect to the spin", phrase));
        assert!(has("the sign of {1} is turned in {}", "sign of … is turned"));
        // The second of two beginnings counts, too.
        assert!(has("the derivative of one. The derivative of two by the third", "erivative of … by the "));
    }
}
