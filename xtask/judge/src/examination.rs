//! How kinks of a formula were searched for and which branches were taken, in words.

use crate::console::count;
use jointproof::toolkit::verify::{Coverage, Examination, Search};

/// The number of items of a kind that are named before the rest is only counted.
const NAMED: usize = 4;

/// A summary in a few lines; complete coverage is not itemised.
pub fn lines(examination: &Examination) -> Vec<String> {
    match examination {
        Examination::NamedPoints { why } => vec![format!("kinks were searched at the named points only: {why}")],
        Examination::Graph { search, coverage } => of_search(search).into_iter().chain(of_coverage(coverage)).collect(),
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
    let described =
        format!("{comparisons}, evaluated {asked}, each side that was reached at {least} points at least{sides}");
    [vec![described], named("branches not reached", &coverage.never)].concat()
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

#[cfg(test)]
mod tests {
    use super::*;

    fn names(number: usize) -> Vec<String> {
        (0..number).map(|k| format!("x_{k} = 0")).collect()
    }

    fn search(candidates: usize, not_reached: usize) -> Search {
        let not_reached = names(not_reached);
        Search { candidates, points: 9, smooth: 2, registered: 1, not_reached, found: Vec::new() }
    }

    #[test]
    fn where_nothing_can_jump_that_is_said_and_else_what_was_tested() {
        let nothing = "it has no comparisons and no guarded zeros, so nothing can jump";
        assert_eq!(of_search(&search(0, 0)), [nothing]);
        let one = "1 place where the derivative may not exist, tested at 9 points: 2 smooth, 1 registered";
        assert_eq!(of_search(&search(1, 0)), [one]);
        let two = one.replace("1 place", "2 places");
        assert_eq!(of_search(&search(2, 1)), [&*two, "not reached, 1: x_0 = 0"]);
    }

    #[test]
    fn of_comparisons_it_is_said_how_often_each_side_was_taken() {
        let coverage = |comparisons, never| Coverage { comparisons, asked: 30, least: 7, never: names(never) };
        assert_eq!(of_coverage(&coverage(0, 0)), [""; 0]);
        let one = "1 comparison, evaluated 30 times, each side that was reached at 7 points at least";
        assert_eq!(of_coverage(&coverage(1, 0)), [format!("{one}, both branches of each reached")]);
        assert_eq!(of_coverage(&coverage(1, 1)), [one, "branches not reached, 1: x_0 = 0"]);
    }

    #[test]
    fn of_more_than_four_the_rest_is_counted() {
        assert_eq!(named("left", &names(0)), [""; 0]);
        assert_eq!(named("left", &names(4)), ["left, 4: x_0 = 0; x_1 = 0; x_2 = 0; x_3 = 0"]);
        let more = "x_0 = 0; x_1 = 0; x_2 = 0; x_3 = 0; and";
        assert_eq!(named("left", &names(5)), [format!("left, 5: {more} 1 more, listed with --format json")]);
        assert_eq!(named("left", &names(6)), [format!("left, 6: {more} 2 more, listed with --format json")]);
    }

    #[test]
    fn both_are_told_of_a_graph_and_why_not_of_named_points() {
        let never = Vec::new();
        let coverage = Coverage { comparisons: 2, asked: 30, least: 7, never };
        assert_eq!(lines(&Examination::Graph { search: search(2, 1), coverage }).len(), 3);
        let alone = lines(&Examination::NamedPoints { why: "it is a loop".into() });
        assert_eq!(alone, ["kinks were searched at the named points only: it is a loop"]);
    }
}
