//! A function called directly, judged like a program that is called through a pipe.

use super::answer::{Answer, Heard};
use super::map::names;
use super::parts::Part;
use super::question::{Question, Wanted, other_order, sizes};
use super::taylor::questions;
use super::verdict::{Bounds, Court, Grade};
use crate::console::plain;
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::verify::Options;
use jointproof::toolkit::verify::golden::named;

/// The points at which a function is called twice, the second time in another order.
pub struct Called {
    formula: &'static dyn AnyFormula,
    wanted: Wanted,
    questions: Vec<Question>,
}

/// The judgement of its answers.
pub struct Judged {
    /// Whether nothing is wrong.
    pub is_well: bool,
    /// The full report, without colours.
    pub text: String,
    /// The causes, one line each.
    pub causes: Vec<String>,
    /// The parts of the verdict, in order, with the simplest point of each that is not right.
    pub parts: Vec<(Part, Option<serde_json::Value>)>,
    /// Every number of an answer: outputs, then the Jacobian row by row.
    pub numbers: Vec<Number>,
}

/// The result for one number of the answers.
pub struct Number {
    /// Its name: `fc`, `∂fc/∂f2`.
    pub name: String,
    /// Its grade.
    pub grade: Grade,
    /// How often it was given at ordinary points, and how often it was another number there.
    pub counts: [usize; 2],
    /// The bound of η.
    pub bound: f64,
    /// The largest η, with the computed and the exact number there.
    pub worst: Option<[f64; 3]>,
    /// The inputs there, in the format of golden files.
    pub inputs: Option<serde_json::Value>,
}

impl Called {
    /// The points at which a function for this formula is called. Only programs are asked for products.
    pub fn new(
        formula: &'static dyn AnyFormula,
        with_jacobian: bool,
        options: &Options,
        with_invalid_inputs: bool,
    ) -> Self {
        let wanted = if with_jacobian { Wanted::Jacobian } else { Wanted::Value };
        let mut questions = questions(formula, wanted, options);
        questions.retain(|question| with_invalid_inputs || !question.must_be_refused());
        Self { formula, wanted, questions }
    }

    /// The inputs of every point, by components in order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.questions.iter().map(|question| question.inputs.as_slice())
    }

    /// The indices of the points, in the order in which they are asked for the second time.
    pub fn other_order(&self) -> Vec<usize> {
        other_order(self.questions.len())
    }

    /// The count of numbers in an answer.
    pub fn numbers(&self) -> usize {
        self.wanted.numbers(sizes(self.formula))
    }

    /// Judges both sets of answers, in the order of the points, with remarks on how they came about. `None` if an answer is
    /// missing or has the wrong count of numbers.
    pub fn judge(
        &self,
        name: &str,
        answers: &[Vec<Answer>; 2],
        is_strict: bool,
        noticed: Vec<String>,
    ) -> Option<Judged> {
        let is_whole = |answer: &Answer| match answer {
            Answer::Numbers(numbers) => numbers.len() == self.numbers(),
            _ => true,
        };
        let are_whole = |all: &Vec<Answer>| all.len() == self.questions.len() && all.iter().all(is_whole);
        if !answers.iter().all(are_whole) {
            return None;
        }
        let bounds = Bounds::of(self.formula);
        let court = Court { formula: self.formula, wanted: self.wanted, bounds, questions: &self.questions, is_strict };
        let heard = Heard { noticed, ..Heard::default() };
        let judgement = court.judged(&[name.to_owned()], answers, &heard);
        let names = names(self.formula.inputs(), self.formula.outputs(), self.wanted);
        let tallies = judgement.found.tallies.iter().enumerate().zip(names);
        let numbers = tallies.map(|((place, tally), name)| Number {
            name,
            grade: judgement.verdict.grades[place],
            counts: [judgement.verdict.counts[place][1], judgement.verdict.counts[place][0]],
            bound: court.bound(place),
            worst: tally.worst.as_ref().map(|worst| [worst.eta, worst.found, worst.exact]),
            inputs: tally.worst.as_ref().map(|worst| self.inputs(worst.question)),
        });
        Some(Judged {
            is_well: judgement.is_well(),
            numbers: numbers.collect(),
            parts: judgement.parts().iter().map(|part| (part.clone(), part.point.map(|k| self.inputs(k)))).collect(),
            text: plain(&judgement.text),
            causes: judgement.causes,
        })
    }

    fn inputs(&self, question: usize) -> serde_json::Value {
        named(self.formula.inputs(), &self.questions[question].inputs).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::find;

    #[test]
    fn a_refusal_is_an_answer_and_too_few_numbers_are_none() {
        let formula = find("slot.contact_force").unwrap();
        let called = Called::new(formula, false, &Options { samples: 10, ..Options::default() }, true);
        let answer = |inputs: &[f64]| match formula.value_and_jacobian(inputs) {
            Ok((value, _)) => Answer::Numbers(value.into_iter().map(Some).collect()),
            Err(_) => Answer::Refused(None),
        };
        let right: Vec<_> = called.points().map(answer).collect();
        assert!(right.iter().any(|answer| matches!(answer, Answer::Refused(_))));
        let judged = called.judge("mine", &[right.clone(), right.clone()], true, vec!["it is slow".into()]).unwrap();
        assert!(judged.is_well && judged.text.contains("noticed: it is slow"), "{}", judged.text);
        let with_first = |first| [&[first][..], &right[1..]].concat();
        assert!(
            called
                .judge("mine", &[right.clone(), with_first(Answer::Numbers(Vec::new()))], false, Vec::new())
                .is_none()
        );
        assert!(called.judge("mine", &[right.clone(), right[1..].to_vec()], false, Vec::new()).is_none());
        let refused =
            called.judge("mine", &[with_first(Answer::Refused(None)), right.clone()], false, Vec::new()).unwrap();
        assert!(!refused.is_well, "{}", refused.text);
        let valid = Called::new(formula, false, &Options { samples: 10, ..Options::default() }, false);
        let mut order = called.other_order();
        assert!(!order.is_sorted());
        order.sort_unstable();
        assert!(order.into_iter().eq(0..called.points().len()), "each comes once");
        let is_valid = |inputs: &[f64]| matches!(answer(inputs), Answer::Numbers(_));
        assert!(valid.points().len() > 10 && valid.points().all(is_valid));
    }
}
