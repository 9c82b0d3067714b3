//! Files are short enough to be read in one sitting.

use super::finding::Finding;
use super::tree::{Tree, texts_below};
use std::collections::BTreeMap;
use std::path::Path;

/// The most lines that a file may have.
const MOST: usize = 500;

/// The upper bound of the median length of files with formulas; `None` if it is not limited.
const MEDIAN_BELOW: Option<usize> = Some(150);

/// Every file of a workspace member that is too long, and the number of files checked.
pub(super) fn too_long(root: &Path, tree: &Tree) -> anyhow::Result<(Vec<Finding>, usize)> {
    let mut texts = Vec::new();
    for folder in ["src", "tests"].into_iter().chain(tree.members.iter().map(String::as_str)) {
        texts_below(root, folder, &mut texts)?;
    }
    // A member may be nested in another.
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

/// The median, the larger one of two middle values; 0 if there are none.
fn middle(mut lengths: Vec<usize>) -> usize {
    lengths.sort_unstable();
    lengths.get(lengths.len() / 2).copied().unwrap_or(0)
}

/// A finding if the median is limited and too large.
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
