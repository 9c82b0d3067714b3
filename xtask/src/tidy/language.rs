//! Phrases of the chapters for which English has others.

use super::finding::Finding;
use std::path::Path;

/// A phrase, and what to write.
const PHRASES: [(&str, &str); 8] = [
    ("derivative by ", "derivative with respect to"),
    ("derivatives by ", "derivatives with respect to"),
    ("across the line", "normal to the line"),
    ("by vectors", "normwise"),
    ("is asked about", "is questioned"),
    ("hat is wrong names", "errors name"),
    ("stands beside", "is next to"),
    ("the bits that it has alone", "the same bits as a single evaluation"),
];

/// The phrases in the chapters of a book, outside code.
pub(super) fn foreign(root: &Path) -> anyhow::Result<Vec<Finding>> {
    let mut findings = Vec::new();
    for entry in std::fs::read_dir(root.join("book/src"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "md") {
            let file = format!("book/src/{}", path.file_name().unwrap_or_default().to_string_lossy());
            findings.extend(in_chapter(&file, &std::fs::read_to_string(&path)?));
        }
    }
    Ok(findings)
}

fn in_chapter(file: &str, text: &str) -> Vec<Finding> {
    let (mut found, mut is_code) = (Vec::new(), false);
    for (line, number) in text.lines().zip(1..) {
        is_code ^= line.starts_with("```");
        let phrases = PHRASES.iter().filter(|(phrase, _)| !is_code && line.contains(phrase));
        found.extend(phrases.map(|(phrase, instead)| {
            Finding::new(file, number, format!("\"{}\": write \"{instead}\"", phrase.trim()))
        }));
    }
    found
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
}
