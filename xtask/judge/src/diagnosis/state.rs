//! State kept between calls: answers that belong to another point.

use super::super::answer::Answer;
use super::super::map::names;
use super::super::question::{Own, other_order};
use super::super::verdict::{Court, Verdict};
use super::factors::list;
use super::sample::LEAST;
use jointproof::toolkit::verify::Judge;
use std::collections::BTreeSet;

/// The number of answers examined.
const ANSWERS: usize = 80;

/// A description of the state, if it can be identified.
pub(super) fn diagnose(court: &Court<'_>, answers: &[Vec<Answer>; 2], verdict: &Verdict) -> String {
    let count = court.questions.len();
    // Valid questions in the order in which they were asked, each with its pass.
    let turns = (0..count).map(|k| (0, k)).chain(other_order(count).into_iter().map(|k| (1, k)));
    let asked: Vec<_> = turns.filter(|&(_, k)| matches!(court.questions[k].own, Own::Results(_))).collect();
    let judge = court.formula.judge();
    let off: BTreeSet<_> = (0..verdict.tallies.len()).filter(|&place| verdict.tallies[place].off > 0).collect();
    let names = names(court.formula.inputs(), court.formula.outputs(), court.wanted);
    for (whose, is_first) in [("asked before", false), ("asked first", true)] {
        if belongs(court, &judge, answers, &asked, &off, is_first) {
            return format!("{} is that of the point {whose}: state is kept between calls", list(&names, &off));
        }
    }
    "state is kept between calls; what it is does not show".into()
}

/// Whether every wrong answer belongs to the previous question, or to the first one.
fn belongs(
    court: &Court<'_>,
    judge: &Judge,
    answers: &[Vec<Answer>; 2],
    asked: &[(usize, usize)],
    places: &BTreeSet<usize>,
    is_first: bool,
) -> bool {
    let mut seen = 0;
    for (place, &(turn, k)) in asked.iter().enumerate().skip(1).take(ANSWERS) {
        let other = if is_first { 0 } else { place - 1 };
        let Answer::Numbers(found) = &answers[turn][k] else { continue };
        let expected = court.expected(judge, asked[other].1).1;
        let fits = places.iter().all(|&place| match (found[place], &expected[place]) {
            (Some(found), Some(known)) => known.eta(found) <= court.bound(place) + 16.0,
            _ => true,
        });
        if !fits {
            return false;
        }
        seen += 1;
    }
    seen >= LEAST
}
