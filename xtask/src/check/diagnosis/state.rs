//! State that is kept between calls: answers that belong to another point.

use super::super::answer::Answer;
use super::super::question::{Own, other_order, sizes};
use super::super::verdict::{Court, Verdict};
use jointproof::verify::Judge;
use std::ops::Range;

/// So many answers are looked at.
const ANSWERS: usize = 80;

/// What the state is, if it tells.
pub(super) fn diagnose(court: &Court<'_>, answers: &[Vec<Answer>; 2], verdict: &Verdict) -> String {
    let count = court.questions.len();
    // Valid questions in the order in which they were asked, each with its turn.
    let turns = (0..count).map(|k| (0, k)).chain(other_order(count).into_iter().map(|k| (1, k)));
    let asked: Vec<_> = turns.filter(|&(_, k)| matches!(court.questions[k].own, Own::Results(_))).collect();
    let judge = court.formula.judge();
    let (m, all) = (sizes(court.formula)[1], court.wanted.numbers(sizes(court.formula)));
    let parts = [("the answer", 0..all), ("the value", 0..m), ("the Jacobian", m..all)];
    for (what, part) in parts.into_iter().filter(|(_, part)| !part.is_empty()) {
        for (whose, other) in [("asked before", -1), ("asked first", 0)] {
            if belongs(court, &judge, answers, verdict, &asked, &part, other) {
                return format!("{what} is that of the point {whose}: state is kept between calls");
            }
        }
    }
    "state is kept between calls; what it is does not show".into()
}

/// Whether every answer that is off belongs to the question before it, or to the first one if `other` is 0.
fn belongs(
    court: &Court<'_>,
    judge: &Judge,
    answers: &[Vec<Answer>; 2],
    verdict: &Verdict,
    asked: &[(usize, usize)],
    part: &Range<usize>,
    other: isize,
) -> bool {
    let off = asked.iter().enumerate().filter(|(_, (_, k))| verdict.off.binary_search(k).is_ok());
    let mut seen = 0;
    for (place, &(turn, k)) in off.filter(|&(place, _)| place > 0).take(ANSWERS) {
        let other = if other == 0 { 0 } else { place - 1 };
        let Answer::Numbers(found) = &answers[turn][k] else { continue };
        let expected = court.expected(judge, asked[other].1).1;
        let fits = part.clone().all(|place| match (found[place], &expected[place]) {
            (Some(found), Some(known)) => known.eta(found) <= court.bound(place) + 16.0,
            _ => true,
        });
        if !fits {
            return false;
        }
        seen += 1;
    }
    seen >= super::LEAST
}
