//! In words: how kinks of a formula were looked for, and which sides of its comparisons were taken.

use crate::console::count;
use jointproof::verify::{Coverage, Looked, Search};

/// So many of a kind are named before the rest is only counted.
const NAMED: usize = 4;

/// What was found, in a few lines; nothing of what was covered wholly is listed.
pub(crate) fn lines(looked: &Looked) -> Vec<String> {
    match looked {
        Looked::NamedPoints { why } => vec![format!("kinks were searched at the named points only: {why}")],
        Looked::Graph { search, coverage } => of_search(search).into_iter().chain(of_coverage(coverage)).collect(),
    }
}

fn of_search(search: &Search) -> Vec<String> {
    let Search { candidates, points, smooth, registered, not_reached, .. } = search;
    if *candidates == 0 {
        return vec!["it has no comparisons and no guarded zeros, so nothing can jump".into()];
    }
    let [candidates, points] = [(*candidates, "place"), (*points, "point")].map(|(number, noun)| count(number, noun));
    let found = format!(
        "{candidates} where the derivative may not exist, tested at {points}: {smooth} smooth, {registered} registered"
    );
    [vec![found], named("not reached", not_reached)].concat()
}

fn of_coverage(coverage: &Coverage) -> Vec<String> {
    if coverage.comparisons == 0 {
        return Vec::new();
    }
    let [comparisons, asked] =
        [(coverage.comparisons, "comparison"), (coverage.asked, "time")].map(|(number, noun)| count(number, noun));
    let sides = if coverage.never.is_empty() { ", both branches of each reached" } else { "" };
    let least = coverage.least;
    let told =
        format!("{comparisons}, evaluated {asked}, each side that was reached at {least} points at least{sides}");
    [vec![told], named("branches not reached", &coverage.never)].concat()
}

fn named(what: &str, texts: &[String]) -> Vec<String> {
    if texts.is_empty() {
        return Vec::new();
    }
    let more = texts.len().saturating_sub(NAMED);
    let listed = texts.iter().take(NAMED).cloned();
    let rest = (more > 0).then(|| format!("and {more} more, listed with --format json"));
    vec![format!("{what}, {}: {}", texts.len(), listed.chain(rest).collect::<Vec<_>>().join("; "))]
}
