//! Functions with planted mistakes, and the full reports on them, kept in `tests/printed/check.txt`.

mod plants;
mod rule;

use super::answer::{Answer, Heard};
use super::question::Wanted::{self, Jacobian};
use super::question::{Own, Question, other_order, sizes};
use super::taylor::questions;
use super::verdict::{Bounds, Court};
use crate::console::plain;
use expect_test::expect_file;
use jointproof::catalog::{AnyFormula, find};
use jointproof::toolkit::verify::Options;
use plants::PLANTS;
use plants::Plant::{self, Nothing};

/// The results of a formula, as components; `None` if it rejects the inputs.
fn own(formula: &dyn AnyFormula, wanted: Wanted, question: &Question, inputs: &[f64]) -> Option<Vec<f64>> {
    let (value, jacobian) = formula.value_and_jacobian(inputs).ok()?;
    let [n, m] = sizes(formula);
    let entry = |i: usize, j: usize| jacobian[i * n + j];
    let more = match (wanted, &question.directions) {
        (Wanted::Value, _) => Vec::new(),
        (Wanted::Products, Some([v, w])) => {
            let row = |i: usize| (0..n).map(|j| entry(i, j) * v[j]).sum();
            let column = |j: usize| (0..m).map(|i| entry(i, j) * w[i]).sum();
            (0..m).map(row).chain((0..n).map(column)).collect()
        }
        _ => jacobian,
    };
    Some([value, more].concat())
}

/// The report on a function with these answers, in the order of the questions.
fn said(
    id: &str,
    wanted: Wanted,
    samples: usize,
    mut answer: impl FnMut(&dyn AnyFormula, &Question) -> Answer,
) -> String {
    let formula = find(id).unwrap();
    let options = Options { samples, ..Options::default() };
    let questions = questions(formula, wanted, &options);
    let court = Court { formula, wanted, bounds: Bounds::of(formula), questions: &questions, is_strict: false };
    let first: Vec<_> = questions.iter().map(|question| answer(formula, question)).collect();
    let mut second = first.clone();
    for k in other_order(questions.len()) {
        second[k] = answer(formula, &questions[k]);
    }
    plain(&court.judged(&["mine".to_owned()], &[first, second], &Heard::default()).text)
}

fn numbers(numbers: Vec<f64>) -> Answer {
    Answer::Numbers(numbers.into_iter().map(Some).collect())
}

/// The answer of the formula with a mistake in it.
fn planted(plant: Plant, wanted: Wanted, formula: &dyn AnyFormula, question: &Question) -> Answer {
    let mut inputs = question.inputs.clone();
    if let (Plant::Before(change) | Plant::Both(change, _) | Plant::Gaps(change, _), Own::Results(_)) =
        (plant, &question.own)
    {
        change(&mut inputs);
    }
    let Some(mut answer) = own(formula, wanted, question, &inputs) else { return Answer::Refused(None) };
    if let Plant::After(change) | Plant::Both(_, change) | Plant::Gaps(_, change) = plant {
        change(&question.inputs, &mut answer);
    }
    let is_gap = matches!(plant, Plant::Gaps(..)) && (question.inputs[0].to_bits() >> 40).is_multiple_of(2);
    let last = answer.len() - usize::from(is_gap);
    Answer::Numbers(answer.into_iter().enumerate().map(|(k, x)| (k < last).then_some(x)).collect())
}

#[test]
fn all_that_is_said_of_planted_mistakes() {
    let all = PLANTS.iter().map(|&(class, id, wanted, plant)| {
        let said = said(id, wanted, 20, |formula, question| planted(plant, wanted, formula, question));
        format!("{class}\n{said}\n")
    });
    expect_file!["../tests/printed/check.txt"].assert_eq(&all.collect::<String>());
}

/// An answer given instead of the right one.
type Odd = fn(&Question) -> Option<Answer>;

/// Unusual answers that are not just other numbers.
const ODD: &[(&str, Odd)] = &[
    ("refuses what is valid", |question| is_slip(question).then_some(Answer::Refused(None))),
    ("refuses every random point", |question| is_random(question).then_some(Answer::Refused(None))),
    ("accepts all", |question| question.must_be_refused().then(|| numbers(vec![1.0; 4]))),
    ("refuses by NaN", |question| question.must_be_refused().then(|| numbers(vec![f64::NAN; 4]))),
    ("leaves points out", |question| is_slip(question).then(|| Answer::Skipped("later".into()))),
    ("says something else", |question| is_slip(question).then(|| Answer::Bad("no number".into()))),
    ("no refusal", |question| question.must_be_refused().then(|| Answer::Bad("nothing".into()))),
    ("no refusal yet", |question| question.must_be_refused().then(|| Answer::Skipped("later".into()))),
    ("skips all", |_| Some(Answer::Skipped("never".into()))),
];

fn is_slip(question: &Question) -> bool {
    question.name.starts_with("slip")
}

fn is_random(question: &Question) -> bool {
    question.name.starts_with("random ")
}

/// For a rejection by numbers, a single output that is not a number suffices, at any position.
#[test]
fn one_nan_among_the_outputs_refuses() {
    let refused_by = |place: usize, x: f64| {
        said("slot.friction", Jacobian, 5, |formula, question| match planted(Nothing, Jacobian, formula, question) {
            Answer::Refused(_) => numbers((0..18).map(|k| if k == place { x } else { 1.0 }).collect()),
            right => right,
        })
    };
    for place in 0..3 {
        let said = refused_by(place, f64::INFINITY);
        assert!(said.starts_with("ok") && said.contains(" refuses all 16 points"), "{said}");
    }
    let said = refused_by(3, f64::NAN);
    assert!(said.starts_with("ok") && said.contains(" refuses 0 of 16 points, and computes the others"), "{said}");
}

#[test]
fn all_that_is_said_of_odd_answers() {
    let right = |formula: &dyn AnyFormula, question: &Question| planted(Nothing, Jacobian, formula, question);
    let of = |what: &str, answer: &mut dyn FnMut(&dyn AnyFormula, &Question) -> Answer| {
        format!("{what}\n{}\n", said("coulomb.return_map", Jacobian, 100, answer))
    };
    let odd = |&(what, odd): &(&str, Odd)| {
        of(what, &mut |formula, question| odd(question).unwrap_or_else(|| right(formula, question)))
    };
    let mut text: String = ODD.iter().map(odd).collect();
    // Answers with one number that is missing, kept from another question, or incremented.
    let mut with = |what: &str, place: usize, mut other: Box<dyn FnMut(f64) -> Option<f64>>| {
        text += &of(what, &mut |formula, question| match right(formula, question) {
            Answer::Numbers(mut numbers) => {
                numbers[place] = numbers[place].and_then(&mut other);
                Answer::Numbers(numbers)
            }
            refused => refused,
        });
    };
    let (mut before, mut first, mut calls, mut count) = (None, None, 0, 0.0);
    with("leaves a derivative out", 1, Box::new(|_| None));
    with("holds what was before", 3, Box::new(move |own| before.replace(own).or(Some(own))));
    let started = move |own| {
        // A process that answers a hundred points, and is then replaced by another one.
        first = first.filter(|_| calls % 100 > 0);
        calls += 1;
        Some(*first.get_or_insert(own))
    };
    with("holds what was first", 0, Box::new(started));
    let counted = move |own| {
        count += 1.0;
        Some(own + count)
    };
    with("counts", 0, Box::new(counted));
    expect_file!["../tests/printed/check_odd.txt"].assert_eq(&text);
}
