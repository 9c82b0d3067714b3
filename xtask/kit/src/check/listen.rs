//! Asks all questions, and reads the answers.

use super::json;
use super::line::{self, Digits};
use super::peer::{Peer, Replies, Reply};
use jointproof::catalog::AnyFormula;
use judge::{Answer, Heard, Manners, Question, Wanted, other_order, sizes};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use std::time::Duration;

/// How to communicate with a program.
pub(super) struct Manner<'a> {
    pub(super) program: &'a [String],
    pub(super) wanted: Wanted,
    pub(super) is_json: bool,
    pub(super) is_hex: bool,
    pub(super) limit: Duration,
}

/// The answers of the program in both passes, or why there are none.
pub(super) type Listened = Result<([Vec<Answer>; 2], Heard), String>;

/// Asks all questions twice, the second time in another order.
///
/// # Errors
/// If the program cannot be started.
pub(super) fn listen(
    formula: &dyn AnyFormula,
    manner: &Manner<'_>,
    questions: &[Question],
) -> anyhow::Result<Listened> {
    let again = other_order(questions.len());
    let order: Vec<usize> = (0..questions.len()).chain(again).collect();
    let digits = if manner.is_hex { Digits::Hex } else { Digits::Decimal };
    let numbers = manner.wanted.numbers(sizes(formula));
    let line = |(k, &place): (usize, &usize)| {
        if manner.is_json { json::question(formula, k, &questions[place]) } else { digits.line(&questions[place]) }
    };
    let lines: Vec<_> = order.iter().enumerate().map(line).collect();
    let head = manner.is_json.then(|| json::head(formula, manner.wanted));
    let peer = Peer { command: manner.program, limit: manner.limit, head, numbers, digits };
    let Replies { replies, noticed } = match peer.ask(&lines)? {
        Ok(replies) => replies,
        Err(why) => return Ok(Err(why)),
    };
    let mut heard = Heard { manners: Manners::new(), noticed: noticed.into_iter().collect() };
    let mut answers = [(); 2].map(|()| vec![Answer::Skipped(String::new()); questions.len()]);
    let read = |(k, reply): (usize, Reply)| {
        let mut manners = Manners::new();
        let answer = reply.answer(|line| {
            if manner.is_json {
                json::read(formula, manner.wanted, k, line)
            } else {
                line::read(line, numbers, digits, &mut manners)
            }
        });
        (answer, manners)
    };
    let read: Vec<_> = replies.into_par_iter().enumerate().map(read).collect();
    let both = Wanted::Jacobian.numbers(sizes(formula));
    let is_of_both = |answer: &Answer| *answer == Answer::Bad(line::count_is(both, numbers));
    if matches!(manner.wanted, Wanted::Value) && read.iter().all(|(answer, _)| is_of_both(answer)) {
        let why = format!("it answers {both} numbers, outputs and Jacobian, but {numbers}, the outputs, are asked for");
        return Ok(Err(format!("{why}: with --wanted jacobian both are judged")));
    }
    for (k, ((answer, manners), &place)) in read.into_iter().zip(&order).enumerate() {
        answers[usize::from(k >= questions.len())][place] = answer;
        for (manner, count) in manners {
            *heard.manners.entry(manner).or_default() += count;
        }
    }
    Ok(Ok((answers, heard)))
}
