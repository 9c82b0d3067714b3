//! A file is read in one sitting.

use super::finding::Finding;
use super::tree::{Tree, texts_below};
use std::collections::BTreeMap;
use std::path::Path;

/// The most lines that a file may have.
const MOST: usize = 500;

/// Below this is the median of the files with formulas. `None` until the evidence has moved out of them: then 150.
const MEDIAN_BELOW: Option<usize> = Some(150);

/// Every file of a member of the workspace that is too long, and the number of files looked at.
pub(super) fn too_long(root: &Path, tree: &Tree) -> anyhow::Result<(Vec<Finding>, usize)> {
    let mut texts = Vec::new();
    for folder in ["src", "tests"].into_iter().chain(tree.members.iter().map(String::as_str)) {
        texts_below(root, folder, &mut texts)?;
    }
    // A member may lie within another.
    let lengths: BTreeMap<_, _> = texts.iter().map(|(path, text)| (path, text.lines().count())).collect();
    let finding = |(path, lines): (&&String, &usize)| {
        Finding::new(*path, 0, format!("{lines} lines, allowed are {MOST}; divide it by what it is about"))
    };
    Ok((lengths.iter().filter(|(_, lines)| **lines > MOST).map(finding).collect(), lengths.len()))
}

/// The number of files with formulas in `src`, and their median length.
pub(super) fn median(tree: &Tree) -> (usize, usize) {
    let with_formulas =
        tree.sources.iter().filter(|source| source.path.starts_with("src/") && !source.formulas.is_empty());
    let lengths: Vec<usize> = with_formulas.map(|source| source.lines).collect();
    (lengths.len(), middle(lengths))
}

/// What as many are above as below; of two in the middle the larger. 0 where there is none.
fn middle(mut lengths: Vec<usize>) -> usize {
    lengths.sort_unstable();
    lengths.get(lengths.len() / 2).copied().unwrap_or(0)
}

/// That the median is too great, if it is bounded.
pub(super) fn median_too_long(median: usize) -> Option<Finding> {
    over(median, MEDIAN_BELOW)
}

fn over(median: usize, below: Option<usize>) -> Option<Finding> {
    let below = below.filter(|below| median >= *below)?;
    let what = format!(
        "the files with formulas have a median of {median} lines, allowed are fewer than {below}; move evidence beside them"
    );
    Some(Finding::new("src", 0, what))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_must_be_below_its_bound() {
        assert!(over(149, Some(150)).is_none() && over(150, Some(150)).is_some() && over(1000, None).is_none());
    }

    #[test]
    fn as_many_are_above_the_middle_as_below() {
        let middles = [vec![], vec![7], vec![9, 7], vec![50, 10, 40, 20, 30]].map(middle);
        assert_eq!(middles, [0, 7, 9, 30]);
    }

    #[test]
    fn the_median_has_to_be_below_its_bound() {
        assert!(over(149, Some(150)).is_none() && over(900, None).is_none());
        assert_eq!(over(150, Some(150)).map(|finding| finding.file), Some("src".to_owned()));
    }
}
