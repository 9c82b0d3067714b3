//! A verdict in parts, so that no part hides another: whether it is the same function, how accurate it is, up to which
//! sizes, what it does on kinks, and what it does with inputs that are not allowed.

mod accuracy;
mod kinks;
mod limits;

use super::answer::Answer;
use super::diagnosis::{self, Diagnosis};
use super::question::{Kind, Own, sizes};
use super::scale::scales;
use super::verdict::{Court, Grade, Verdict};
use crate::console::count;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// What is concluded in a part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Standing {
    /// As the formula.
    Right,
    /// Right, with a limit or another convention than the formula's.
    Limited,
    /// Wrong.
    Wrong,
    /// Nothing was asked that belongs here.
    #[default]
    NotAsked,
}

impl Standing {
    /// A word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Limited => "limited",
            Self::Wrong => "wrong",
            Self::NotAsked => "not asked",
        }
    }
}

/// A part of a verdict.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// The question that it answers.
    pub title: &'static str,
    /// The conclusion.
    pub standing: Standing,
    /// How many points are right, and how many there are.
    pub right: [usize; 2],
    /// The conclusion in words.
    pub says: String,
    /// The causes of what is wrong, as far as they show in this part, a line each.
    pub causes: Vec<String>,
    /// More about it, a line each.
    pub details: Vec<String>,
    /// The simplest point at which it is not right, by its index.
    pub(super) point: Option<usize>,
}

/// All parts, and what follows from them.
#[derive(Clone, Debug)]
#[expect(clippy::struct_field_names, reason = "parts are what they are called")]
pub(super) struct Parts {
    pub(super) parts: Vec<Part>,
    pub(super) diagnosis: Diagnosis,
    /// The grade of every number of an answer.
    pub(super) grades: Vec<Grade>,
    /// How often every number was wrong at ordinary points, and how often it was given there.
    pub(super) counts: Vec<[usize; 2]>,
}

/// From this deviation on, relative to its scale, a number at an ordinary point is another one: 8 digits are right at least.
pub(super) const OTHER: f64 = 1e-8;
/// A number that deviates by this at half of all points is another one, though more of its digits are right.
const TYPICAL: f64 = 1e-11;
/// Deviations above this are looked into: they may be more than rounding.
const SUSPECT: f64 = 2e-12;

/// The deviations of an answer from the right numbers, relative to their scales; `None` for those that are not given.
pub(super) type Deviations = Vec<Option<f64>>;

impl Court<'_> {
    /// The deviations of a valid answer.
    pub(super) fn deviations(&self, k: usize, answer: &Answer) -> Option<Deviations> {
        let Answer::Numbers(found) = answer else { return None };
        let question = &self.questions[k];
        let right = question.right(self.formula, self.wanted)?;
        let scale = scales(self.formula, self.wanted, question, &right)?;
        let deviation = |place: usize| {
            let found = found[place]?;
            let deviation = (found - right[place]).abs() / scale[place];
            Some(if deviation.is_nan() { f64::INFINITY } else { deviation })
        };
        Some((0..found.len()).map(deviation).collect())
    }

    /// The parts of the verdict, from the answers of both passes and what is known of them in 237 bits.
    pub(super) fn parts(&self, answers: &[Vec<Answer>; 2], verdict: &Verdict) -> Parts {
        let all: Vec<Option<Deviations>> =
            (0..self.questions.len()).into_par_iter().map(|k| self.deviations(k, &answers[0][k])).collect();
        let of = |is: &dyn Fn(&Kind) -> bool| -> Vec<usize> {
            let valid = (0..self.questions.len()).filter(|&k| matches!(self.questions[k].own, Own::Results(_)));
            valid.filter(|&k| is(&self.questions[k].kind)).collect()
        };
        let ordinary = of(&|kind| matches!(kind, Kind::Ordinary | Kind::Special));
        // Where a rounding decides on which side of a kink a point is, its answer tells nothing about the rest.
        let is_told = |k: &usize| self.questions[*k].kind != Kind::Special || self.other_sides(*k).next().is_none();
        let told: Vec<usize> = ordinary.iter().copied().filter(is_told).collect();
        let numbers = self.wanted.numbers(sizes(self.formula));
        let counts: Vec<[usize; 2]> = (0..numbers)
            .map(|place| {
                let given = told.iter().filter_map(|&k| all[k].as_ref()?[place]);
                let off = given.clone().filter(|deviation| *deviation > OTHER).count();
                [off, given.count()]
            })
            .collect();
        let (same, diagnosis) = self.same(answers, verdict, &all, [&ordinary, &told]);
        let on_kinks = of(&|kind| matches!(kind, Kind::Kink(_)));
        // Numbers that are others anyway tell nothing about limits.
        let is_same: Vec<bool> = (0..numbers).map(|place| counts[place][0] == 0).collect();
        let (kinks, kink_grades) = self.on_kinks(answers, &all, &on_kinks, &is_same);
        let diagnosis = match same.standing {
            // What is smoothed shows near kinks alone.
            Standing::Right if kinks.standing == Standing::Wrong => {
                let near: Vec<_> = on_kinks
                    .iter()
                    .copied()
                    .filter(|&k| self.formula.judge().kink(&self.questions[k].inputs).is_none())
                    .collect();
                diagnosis::diagnose(self, answers, verdict, &near)
            }
            _ => diagnosis,
        };
        let extreme = of(&|kind| matches!(kind, Kind::Extreme | Kind::Rung(_)));
        let parts = vec![
            same,
            self.accuracy(verdict, &all, &ordinary, &is_same),
            self.limits(answers, &all, &extreme, &is_same),
            kinks,
            self.not_allowed(answers, verdict),
        ];
        let grades = (0..numbers).map(|place| {
            let of_kinks = kink_grades.get(place).copied().unwrap_or_default();
            let of_numbers =
                verdict.tallies.get(place).map(|tally| tally.grade.min(Grade::Inaccurate)).unwrap_or_default();
            let of_function = if counts[place][0] > 0 { Grade::Wrong } else { Grade::Right };
            of_function.max(of_kinks).max(of_numbers)
        });
        Parts { grades: grades.collect(), parts, diagnosis, counts }
    }

    /// Whether it is the same function, at ordinary points.
    fn same(
        &self,
        answers: &[Vec<Answer>; 2],
        verdict: &Verdict,
        all: &[Option<Deviations>],
        [ordinary, told]: [&[usize]; 2],
    ) -> (Part, Diagnosis) {
        let title = "the same function?";
        let worst =
            |k: usize| all[k].iter().flatten().flatten().fold(0.0_f64, |worst, deviation| worst.max(*deviation));
        let is_answered = |k: &usize| matches!(answers[0][*k], Answer::Numbers(_));
        let is_special = |k: usize| self.questions[k].kind == Kind::Special;
        // A point chosen for its difficulty may cost digits, but not all of them.
        let limit = |k: usize| if is_special(k) { 1e-2 } else { OTHER };
        // A rounding of the inputs decides on which side of a kink some special points are.
        let is_on_a_side = |k: usize| match (&answers[0][k], &all[k]) {
            (Answer::Numbers(found), Some(deviations)) if is_special(k) => {
                let is_off = |place: &usize| deviations[*place].is_some_and(|deviation| deviation > OTHER);
                self.outside(k, found, &(0..found.len()).filter(is_off).collect::<Vec<_>>()).is_empty()
            }
            _ => false,
        };
        let mut off: Vec<usize> = ordinary
            .iter()
            .copied()
            .filter(|&k| {
                !matches!(answers[0][k], Answer::Skipped(_))
                    && (!is_answered(&k) || worst(k) > limit(k) && !is_on_a_side(k))
            })
            .collect();
        if off.is_empty() {
            let numbers = self.wanted.numbers(sizes(self.formula));
            let is_off = |place: usize| {
                let mut given: Vec<f64> = ordinary.iter().filter_map(|&k| all[k].as_ref()?[place]).collect();
                given.sort_by(f64::total_cmp);
                given.get(given.len() / 2).is_some_and(|half| *half > TYPICAL)
            };
            if (0..numbers).any(is_off) {
                off = ordinary.iter().copied().filter(|&k| worst(k) > SUSPECT).collect();
            }
        }
        let suspects = told.iter().filter(|&&k| worst(k) > SUSPECT).count();
        let mut diagnosis = Diagnosis::default();
        if !off.is_empty() || suspects > 0 || !verdict.two_answers.is_empty() {
            diagnosis = diagnosis::diagnose(self, answers, verdict, told);
            if off.is_empty() && !diagnosis.causes.is_empty() && verdict.two_answers.is_empty() {
                // It is more than rounding if a mistake gives the same digits.
                off = ordinary.iter().copied().filter(|&k| worst(k) > SUSPECT).collect();
            }
        }
        off.extend(verdict.two_answers.iter().copied().filter(|k| !off.contains(k)).collect::<Vec<_>>());
        let asked = ordinary.iter().filter(|k| !matches!(answers[0][**k], Answer::Skipped(_))).count();
        let right = [asked.saturating_sub(off.len()), asked];
        let standing = match (asked, off.is_empty()) {
            (0, _) => Standing::NotAsked,
            (_, true) => Standing::Right,
            (_, false) => Standing::Wrong,
        };
        let says = match standing {
            Standing::NotAsked => "no answer at an ordinary point".to_owned(),
            Standing::Right => format!("yes: right at {}", of_points(right, "ordinary point")),
            _ => format!("no: right at {}", of_points(right, "ordinary point")),
        };
        let point = self.simplest(&off);
        let mut details = Vec::new();
        if let Some(k) = point {
            details.extend(self.first_off(k, &answers[0][k], all[k].as_ref()));
        }
        (Part { title, standing, right, says, details, point, ..Part::default() }, diagnosis)
    }

    /// What it does with inputs that are not allowed.
    fn not_allowed(&self, answers: &[Vec<Answer>; 2], verdict: &Verdict) -> Part {
        let asked = (0..self.questions.len()).filter(|&k| self.questions[k].must_be_refused());
        let asked = asked.filter(|&k| !matches!(answers[0][k], Answer::Skipped(_) | Answer::Bad(_))).count();
        let right = [asked - verdict.accepted.len().min(asked), asked];
        let standing = match (asked, verdict.accepted.is_empty()) {
            (0, _) => Standing::NotAsked,
            (_, true) => Standing::Right,
            _ => Standing::Limited,
        };
        let says = match standing {
            Standing::NotAsked => "not asked".to_owned(),
            Standing::Right => format!("refuses {}", of_points(right, "point")),
            _ => format!("refuses {}, and computes the others", of_points(right, "point")),
        };
        let point = self.simplest(&verdict.accepted);
        let why = |k: usize| match &self.questions[k].own {
            Own::Refused(why) => Some(format!("computes what is not allowed: {why}")),
            _ => None,
        };
        let details = point.and_then(why).into_iter().collect();
        Part { title: "inputs that are not allowed", standing, right, says, details, point, ..Part::default() }
    }

    /// The point whose inputs are written with the fewest characters.
    pub(super) fn simplest(&self, questions: &[usize]) -> Option<usize> {
        let length = |k: usize| self.questions[k].inputs.iter().map(|x| format!("{x:?}").len()).sum::<usize>();
        questions.iter().copied().min_by_key(|&k| (length(k), k))
    }

    /// The number that is off most at a point, or what came instead of numbers.
    pub(super) fn first_off(&self, k: usize, answer: &Answer, deviations: Option<&Deviations>) -> Option<String> {
        match answer {
            Answer::Refused(_) => Some("refuses what is allowed".into()),
            Answer::Bad(what) => Some(format!("no answer: {what}")),
            Answer::Skipped(_) => None,
            Answer::Numbers(found) => {
                let deviations = deviations?;
                let place = (0..found.len()).filter(|&place| deviations[place].is_some()).max_by(|&a, &b| {
                    deviations[a].unwrap_or_default().total_cmp(&deviations[b].unwrap_or_default()).then(b.cmp(&a))
                })?;
                let right = self.questions[k].right(self.formula, self.wanted)?;
                let names = super::map::names(self.formula.inputs(), self.formula.outputs(), self.wanted);
                Some(format!("{} is {:?}, right is {:?}", names[place], found[place]?, right[place]))
            }
        }
    }
}

impl Parts {
    /// Whether it is the formula: right at ordinary points and on kinks, whatever the limits.
    pub(super) fn are_right(&self) -> bool {
        self.parts.iter().all(|part| part.standing != Standing::Wrong) && self.parts[0].standing == Standing::Right
    }
}

/// Whether it is the formula, judged strictly or not.
pub(super) fn is_well(found: &Verdict, verdict: &Parts, is_strict: bool) -> bool {
    let is_right = verdict.are_right() && found.bad.is_empty();
    if is_strict { is_right && found.is_strictly_right() } else { is_right }
}

/// `all 12 ordinary points`, `3 of 12 ordinary points`.
pub(super) fn of_points([right, all]: [usize; 2], noun: &str) -> String {
    match (right, all) {
        (1, 1) => format!("the {noun}"),
        (right, all) if right == all => format!("all {}", count(all, noun)),
        (right, all) => format!("{right} of {}", count(all, noun)),
    }
}
