//! Judges answers: every number by its backward error η, and rejections.

use super::answer::Answer;
use super::question::{Kind, Own, Question, Wanted, sizes};
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::verify::{Judge, Known, Truth};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// From this η on a number is wrong rather than inaccurate: one part in 10⁴ of the size it is judged by.
const WRONG: f64 = 1e-4 / (f64::EPSILON / 2.0);

/// The quality of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grade {
    /// Within its bound wherever it was requested.
    #[default]
    Right,
    /// Beyond its bound, due to excessive rounding.
    Inaccurate,
    /// A different number.
    Wrong,
}

/// The bounds that every number must satisfy.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// For the value.
    pub value: f64,
    /// For the Jacobian.
    pub jacobian: f64,
}

/// The bound for formulas with an automatic Jacobian, which state none: a closed form is inaccurate if it loses more
/// than two digits.
const UNSTATED: f64 = 128.0;

impl Bounds {
    /// The bounds that a formula states for itself.
    pub fn of(formula: &dyn AnyFormula) -> Self {
        let spec = formula.spec();
        Self { value: spec.eta.value, jacobian: spec.eta.jacobian.unwrap_or(UNSTATED) }
    }
}

/// The result for one number of the answers.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    pub(super) checked: usize,
    pub(super) off: usize,
    /// Whether it was missing somewhere.
    pub(super) is_absent: bool,
    pub(super) grade: Grade,
    pub(super) worst: Option<Worst>,
}

/// The worst case of a number.
#[derive(Clone, Debug)]
pub(super) struct Worst {
    pub(super) eta: f64,
    /// The index of the question.
    pub(super) question: usize,
    pub(super) found: f64,
    pub(super) exact: f64,
}

/// The result for all answers.
#[derive(Clone, Debug, Default)]
pub(super) struct Verdict {
    /// Outputs, then entries of the Jacobian or products.
    pub(super) tallies: Vec<Tally>,
    /// Numbers judged in 237 bits, and those with the same bits as this program's.
    pub(super) judged: usize,
    pub(super) same: usize,
    /// Questions that must be rejected, and were; among these, those rejected by NaN or infinity.
    pub(super) refused: usize,
    pub(super) refused_by_nan: usize,
    /// Valid questions that were rejected.
    pub(super) refused_wrongly: Vec<usize>,
    /// Questions that must be rejected, but were answered.
    pub(super) accepted: Vec<usize>,
    /// Questions without a valid answer, and what came instead.
    pub(super) bad: Vec<(usize, String)>,
    /// Questions skipped, and why.
    pub(super) skipped: Vec<(usize, String)>,
    /// Questions with two different answers.
    pub(super) two_answers: Vec<usize>,
    /// Answers that are right for inputs within a rounding error of the question, on the other side of a kink.
    pub(super) beside: usize,
    /// Questions with a number beyond its bound.
    pub(super) off: Vec<usize>,
    /// The backward errors of the answers that were judged in 237 bits.
    pub(super) etas: Vec<Etas>,
    /// Questions whose answers have the bits of this program's.
    pub(super) same_questions: usize,
}

/// The backward errors of all numbers at a question; `None` for those that are not judged.
#[derive(Clone, Debug)]
pub(super) struct Etas {
    pub(super) question: usize,
    pub(super) found: Vec<Option<f64>>,
    /// Of this program's own numbers.
    pub(super) own: Vec<Option<f64>>,
}

impl Verdict {
    /// Whether every number is within its bound, at all sizes and by our convention on kinks, and every input refused that is not
    /// allowed.
    pub(super) fn is_strictly_right(&self) -> bool {
        let faults = [self.refused_wrongly.len(), self.accepted.len(), self.bad.len(), self.two_answers.len()];
        self.judged + self.same > 0 && self.off.is_empty() && faults.iter().all(|&faults| faults == 0)
    }

    /// Merges the results of two sets of questions.
    fn and(mut self, other: Self) -> Self {
        if self.tallies.is_empty() {
            self.tallies = other.tallies;
        } else {
            self.tallies.iter_mut().zip(other.tallies).for_each(|(tally, other)| tally.add(other));
        }
        self.judged += other.judged;
        self.same += other.same;
        self.beside += other.beside;
        self.refused += other.refused;
        self.refused_by_nan += other.refused_by_nan;
        self.refused_wrongly.extend(other.refused_wrongly);
        self.accepted.extend(other.accepted);
        self.bad.extend(other.bad);
        self.skipped.extend(other.skipped);
        self.two_answers.extend(other.two_answers);
        self.off.extend(other.off);
        self.etas.extend(other.etas);
        self.same_questions += other.same_questions;
        self
    }
}

impl Tally {
    fn add(&mut self, other: Self) {
        self.checked += other.checked;
        self.off += other.off;
        self.is_absent |= other.is_absent;
        self.grade = self.grade.max(other.grade);
        if other.worst.as_ref().is_some_and(|worst| self.worst.as_ref().is_none_or(|mine| worst.eta > mine.eta)) {
            self.worst = other.worst;
        }
    }

    fn record(&mut self, question: usize, found: f64, known: &Known, bound: f64) -> bool {
        let eta = known.eta(found);
        self.checked += 1;
        let is_off = eta > bound;
        self.off += usize::from(is_off);
        if is_off {
            self.grade = self.grade.max(if eta >= WRONG { Grade::Wrong } else { Grade::Inaccurate });
        }
        if self.worst.as_ref().is_none_or(|worst| eta > worst.eta) {
            self.worst = Some(Worst { eta, question, found, exact: known.exact.to_f64() });
        }
        is_off
    }
}

/// The questions about a formula, and the criteria for judging the answers.
pub struct Court<'a> {
    /// The formula.
    pub formula: &'static dyn AnyFormula,
    /// The requested results.
    pub wanted: Wanted,
    /// The bounds of η.
    pub bounds: Bounds,
    /// The points.
    pub questions: &'a [Question],
    /// Whether our bounds are asked for at all sizes, and our convention on kinks.
    pub is_strict: bool,
}

/// Random points that are judged in 237 bits if bounds are asked for at none of them: these tell how accurate a program is.
const EXACTLY: usize = 200;

impl Court<'_> {
    /// Judges the answers of the first and of the second pass.
    pub(super) fn judge(&self, answers: &[Vec<Answer>; 2]) -> Verdict {
        let questions = (0..self.questions.len()).into_par_iter();
        let one = |judge: &mut Judge, k: usize| self.one(judge, k, [&answers[0][k], &answers[1][k]]);
        // Only neighbours are merged, so that all lists stay in order.
        questions.map_init(|| self.formula.judge(), one).reduce(Verdict::default, Verdict::and)
    }

    fn one(&self, judge: &Judge, k: usize, answers: [&Answer; 2]) -> Verdict {
        let mut verdict = Verdict::default();
        let own = match &self.questions[k].own {
            Own::TooLarge => return verdict,
            Own::Refused(_) => {
                self.refusal(k, answers, &mut verdict);
                return verdict;
            }
            Own::Results(own) => own,
        };
        let [first, second] = answers;
        let differ = !is_same(first, second);
        if differ && matches!((first, second), (Answer::Numbers(_), Answer::Numbers(_))) {
            verdict.two_answers.push(k);
        }
        let mut truth = None;
        for answer in [Some(first), Some(second).filter(|_| differ)].into_iter().flatten() {
            match answer {
                Answer::Bad(what) => verdict.bad.push((k, what.clone())),
                Answer::Skipped(why) => verdict.skipped.push((k, why.clone())),
                Answer::Refused(_) => verdict.refused_wrongly.push(k),
                Answer::Numbers(found) if self.may_be_own(k) && has_bits(found, own) => {
                    verdict.same += found.len();
                    verdict.same_questions += 1;
                }
                Answer::Numbers(_) if !self.is_judged_exactly(k, answer) => {}
                Answer::Numbers(found) => {
                    let (truth, known) = truth.get_or_insert_with(|| self.expected(judge, k));
                    // On the kink itself a convention applies.
                    if truth.kink.is_none()
                        && !self.are_right(found, known)
                        && let Some(beside) = self.beside(judge, k, found)
                    {
                        verdict.beside += 1;
                        self.numbers(k, found, &beside, &mut verdict);
                    } else {
                        self.numbers(k, found, known, &mut verdict);
                    }
                    let eta = |x: Option<f64>, known: &Option<Known>| Some(known.as_ref()?.eta(x?));
                    let etas = found.iter().zip(known.iter()).map(|(x, known)| eta(*x, known)).collect();
                    let own = own.iter().zip(known.iter()).map(|(x, known)| eta(Some(*x), known)).collect();
                    verdict.etas.push(Etas { question: k, found: etas, own });
                }
            }
        }
        verdict
    }

    /// Whether results with the same bits as this program's are accepted. The audit checks these at random points; at
    /// all others they are judged here too.
    fn may_be_own(&self, k: usize) -> bool {
        self.wanted != Wanted::Products && self.questions[k].name.starts_with("random ")
    }

    /// Whether this answer is judged in 237 bits: every one where bounds are asked for, else those that tell how accurate
    /// a program is and where it loses digits.
    fn is_judged_exactly(&self, k: usize, answer: &Answer) -> bool {
        let number = self.questions[k].name.strip_prefix("random ").and_then(|name| name.split(' ').next());
        let is_among_first = number.and_then(|number| number.parse().ok()).is_none_or(|number: usize| number < EXACTLY);
        let is_suspect = || {
            let deviations = self.deviations(k, answer);
            deviations.is_some_and(|all| all.iter().flatten().any(|deviation| (1e-13..1e-3).contains(deviation)))
        };
        let is_rung = matches!(self.questions[k].kind, Kind::Rung(_));
        self.is_strict || !is_rung && (is_among_first || is_suspect())
    }

    fn refusal(&self, k: usize, answers: [&Answer; 2], verdict: &mut Verdict) {
        let outputs = sizes(self.formula)[1];
        match answers[0] {
            Answer::Refused(_) => verdict.refused += 1,
            Answer::Numbers(found) if found[..outputs].iter().flatten().any(|y| !y.is_finite()) => {
                verdict.refused += 1;
                verdict.refused_by_nan += 1;
            }
            Answer::Numbers(_) => verdict.accepted.push(k),
            Answer::Skipped(why) => verdict.skipped.push((k, why.clone())),
            Answer::Bad(what) => verdict.bad.push((k, what.clone())),
        }
    }

    fn numbers(&self, k: usize, found: &[Option<f64>], known: &[Option<Known>], verdict: &mut Verdict) {
        verdict.tallies.resize(found.len(), Tally::default());
        let mut is_off = false;
        for (place, ((found, known), tally)) in found.iter().zip(known).zip(&mut verdict.tallies).enumerate() {
            match (found, known) {
                (Some(found), Some(known)) => {
                    verdict.judged += 1;
                    is_off |= tally.record(k, *found, known, self.bound(place));
                }
                (None, _) => tally.is_absent = true,
                (_, None) => {}
            }
        }
        if is_off && verdict.off.is_empty() {
            verdict.off.push(k);
        }
    }

    /// Whether no number is wrong.
    fn are_right(&self, found: &[Option<f64>], known: &[Option<Known>]) -> bool {
        let pairs = found.iter().zip(known).enumerate();
        pairs.into_iter().all(|(place, pair)| match pair {
            (Some(found), Some(known)) => known.eta(*found) <= self.bound(place),
            _ => true,
        })
    }

    /// The expected numbers at inputs within a rounding error of a named question, if another branch is taken there
    /// and the answer is right for it: a program that rounds cannot know on which side it is.
    fn beside(&self, judge: &Judge, k: usize, found: &[Option<f64>]) -> Option<Vec<Option<Known>>> {
        self.other_sides(k).find_map(|inputs| {
            let expected = self.expected_at(judge, &inputs, self.questions[k].directions.as_ref())?.1;
            self.are_right(found, &expected).then_some(expected)
        })
    }

    /// Inputs that differ from a named question by a rounding error of one input, and at which value or derivative has jumped.
    pub(super) fn other_sides(&self, k: usize) -> impl Iterator<Item = Vec<f64>> {
        let question = &self.questions[k];
        let results = |inputs: &[f64]| {
            let (value, jacobian) = self.formula.value_and_jacobian(inputs).ok()?;
            Some([value, jacobian].concat())
        };
        let here = if question.name.starts_with("random ") { None } else { results(&question.inputs) };
        let both = |(place, x): (usize, &f64)| [x.next_up(), x.next_down()].map(|beside| (place, beside - x));
        let steps = question.inputs.iter().enumerate().flat_map(both);
        here.into_iter().flat_map(move |here| {
            steps.clone().filter_map(move |(place, step)| {
                let moved = |by: f64| {
                    let mut inputs = question.inputs.clone();
                    inputs[place] += by * step;
                    inputs
                };
                let beside = moved(1.0);
                let there = results(&beside)?;
                let farther = results(&moved(FARTHER)).unwrap_or_else(|| there.clone());
                let mut numbers = here.iter().zip(&there).zip(&farther);
                numbers.any(|((&x, &y), &z)| is_jump(x, y, z)).then_some(beside)
            })
        })
    }

    /// The bound of the number at this index. A product is a sum of as many terms as the vector has components, each
    /// of which may be rounded.
    pub(super) fn bound(&self, place: usize) -> f64 {
        let [n, m] = sizes(self.formula);
        match self.wanted {
            _ if place < m => self.bounds.value,
            Wanted::Products => self.bounds.jacobian + f64::from(u32::try_from(n.max(m)).unwrap_or(u32::MAX)),
            _ => self.bounds.jacobian,
        }
    }

    /// The exact results at a valid question, and the expected value of every number of an answer; `None` if there is
    /// nothing to judge it by.
    pub(super) fn expected(&self, judge: &Judge, k: usize) -> (Truth, Vec<Option<Known>>) {
        let question = &self.questions[k];
        let expected = self.expected_at(judge, &question.inputs, question.directions.as_ref());
        expected.expect("a question with results is valid")
    }

    fn expected_at(
        &self,
        judge: &Judge,
        inputs: &[f64],
        directions: Option<&[Vec<f64>; 2]>,
    ) -> Option<(Truth, Vec<Option<Known>>)> {
        let truth = judge.at(inputs, self.wanted != Wanted::Value).ok()?;
        let [n, m] = sizes(self.formula);
        let mut expected: Vec<_> = truth.value.iter().copied().map(Some).collect();
        match (&truth.jacobian, directions) {
            (Some(jacobian), Some([v, w])) => {
                let row = |i: usize| Known::combined((0..n).map(|j| (jacobian[i * n + j], v[j])));
                let column = |j: usize| Known::combined((0..m).map(|i| (jacobian[i * n + j], w[i])));
                expected.extend((0..m).map(row).chain((0..n).map(column)).map(Some));
            }
            (Some(jacobian), None) => expected.extend(jacobian.iter().copied().map(Some)),
            (None, _) => expected.resize(self.wanted.numbers([n, m]), None),
        }
        Some((truth, expected))
    }
}

fn has_bits(found: &[Option<f64>], own: &[f64]) -> bool {
    found.iter().zip(own).all(|(found, own)| found.map(f64::to_bits) == Some(own.to_bits()))
}

/// Whether two answers are the same; all NaNs are equal.
fn is_same(first: &Answer, second: &Answer) -> bool {
    let bits = |x: &Option<f64>| x.map(|x| if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() });
    match (first, second) {
        (Answer::Numbers(first), Answer::Numbers(second)) => first.iter().map(bits).eq(second.iter().map(bits)),
        (first, second) => first == second,
    }
}

/// The distance, in roundings, of a third point used to detect a jump.
const FARTHER: f64 = 8.0;

/// Whether something jumps between x and y, and does not continue to z like a number that passes through 0.
fn is_jump(x: f64, y: f64, z: f64) -> bool {
    let step = (x - y).abs();
    step > 1e-6 * (x.abs() + y.abs()) && (z - y).abs() < step
}

#[cfg(test)]
mod tests;
