//! Finds cyclic dependencies between files or folders.

use super::edges::{Edges, Place};
use super::finding::Finding;
use super::graph::{Graph, Tangle};
use super::tree::Tree;
use std::collections::{BTreeMap, BTreeSet};

/// The cyclic dependencies.
pub(super) struct Circles {
    /// One finding for each set of mutually dependent files or folders.
    pub(super) findings: Vec<Finding>,
    /// The number of those sets consisting of files.
    pub(super) of_files: usize,
    /// The number of those sets containing a folder.
    pub(super) of_folders: usize,
}

/// Finds cyclic dependencies.
pub(super) fn circles(tree: &Tree, edges: &Edges) -> Circles {
    let path = |file: usize| tree.sources[file].path.as_str();
    let uses: Uses<'_> =
        edges.iter().map(|(&(from, to), place)| ((path(from), path(to)), (path(from), place))).collect();
    let mut findings: Vec<Finding> = tangles(&uses).iter().map(|tangle| finding("files", tangle, &uses)).collect();
    let of_files = findings.len();
    for uses in levels(&uses).values() {
        let tangles = tangles(uses).into_iter().filter(|tangle| tangle.nodes.iter().any(|node| node.ends_with('/')));
        findings.extend(tangles.map(|tangle| finding("folders or files", &tangle, uses)));
    }
    Circles { of_folders: findings.len() - of_files, of_files, findings }
}

/// For pairs of nodes, one use and its file.
type Uses<'a> = BTreeMap<(&'a str, &'a str), (&'a str, &'a Place)>;

fn tangles<'a>(uses: &Uses<'a>) -> Vec<Tangle<&'a str>> {
    Graph::new(uses.keys().copied()).tangles()
}

/// The uses between the entries of each folder: its files, and its folders taken as a whole.
///
/// A use counts once, in the folder where the paths to both files diverge. A folder's name ends in `/`.
fn levels<'a>(uses: &Uses<'a>) -> BTreeMap<&'a str, Uses<'a>> {
    let folders: BTreeSet<&str> = uses.keys().flat_map(|&(from, to)| [from, to]).flat_map(folders_of).collect();
    let mut levels = BTreeMap::<_, Uses<'_>>::new();
    for (&(from, to), &place) in uses {
        let (from, to) = (path(from, &folders), path(to, &folders));
        let Some(part) = from.iter().zip(&to).position(|(from, to)| from != to) else { continue };
        let level = if part == 0 { "" } else { from[part - 1] };
        levels.entry(level).or_default().entry((from[part], to[part])).or_insert(place);
    }
    levels
}

/// The folders around a file, the outermost first.
fn folders_of(file: &str) -> impl Iterator<Item = &str> {
    file.match_indices('/').map(|(slash, _)| &file[..=slash])
}

/// The folders around a file, and the file. `a.rs` is in the folder `a/` if there is one.
fn path<'a>(file: &'a str, folders: &BTreeSet<&'a str>) -> Vec<&'a str> {
    let own = file.strip_suffix(".rs").and_then(|stem| folders.get(format!("{stem}/").as_str()));
    folders_of(file).chain(own.copied()).chain([file]).collect()
}

/// A set of mutually dependent nodes and its cycles, with a location for each use in them.
fn finding(what: &str, tangle: &Tangle<&str>, uses: &Uses<'_>) -> Finding {
    let mut details = Vec::new();
    for circle in &tangle.circles {
        details.push(format!("circle of {}: {} → {}", circle.len(), circle.join(" → "), circle[0]));
        for (&from, &to) in circle.iter().zip(circle.iter().cycle().skip(1)) {
            let (file, Place { line, text }) = uses[&(from, to)];
            details.push(format!("  {file}:{line}: {text}"));
        }
    }
    let first = &tangle.circles[0];
    let (file, place) = uses[&(first[0], first[1])];
    let nodes: Vec<_> = tangle.nodes.iter().copied().collect();
    let (number, nodes) = (nodes.len(), nodes.join(", "));
    let what = format!("{number} {what} use one another: {nodes}; move what both sides need below both, or hand it in");
    Finding { file: file.to_owned(), line: place.line, what, details }
}
