//! What a program does on kinks: any one-sided derivative is right there.

use super::{Deviations, OTHER, Part, Standing, of_points};
use crate::answer::Answer;
use crate::console::count;
use crate::mathematics::as_text;
use crate::question::{Kind, Wanted, sizes};
use crate::scale::scales;
use crate::verdict::{Court, Grade};
use std::collections::BTreeMap;

/// The distances of neighbours from a kink, relative to the size of an input: a rounding, and a little more.
const NEAR: [f64; 2] = [4.0 * f64::EPSILON, 1e-12];

/// The range of every number in the neighbourhood of a point.
struct Range {
    least: Vec<f64>,
    most: Vec<f64>,
}

impl Range {
    fn add(&mut self, numbers: &[f64]) {
        for (k, x) in numbers.iter().enumerate() {
            self.least[k] = self.least[k].min(*x);
            self.most[k] = self.most[k].max(*x);
        }
    }
}

impl Court<'_> {
    /// The part about kinks, and the grade that every number deserves there.
    pub(super) fn on_kinks(
        &self,
        answers: &[Vec<Answer>; 2],
        all: &[Option<Deviations>],
        questions: &[usize],
        is_same: &[bool],
    ) -> (Part, Vec<Grade>) {
        let title = "on kinks";
        let mut grades = vec![Grade::Right; self.wanted.numbers(sizes(self.formula))];
        let (mut wrong, mut other_side) = (Vec::new(), Vec::new());
        let mut nan: BTreeMap<&str, usize> = BTreeMap::new();
        let mut sides: BTreeMap<&str, usize> = BTreeMap::new();
        let asked: Vec<_> =
            questions.iter().copied().filter(|&k| !matches!(answers[0][k], Answer::Skipped(_))).collect();
        for &k in &asked {
            let Kind::Kink(condition) = &self.questions[k].kind else { continue };
            let (Answer::Numbers(found), Some(deviations)) = (&answers[0][k], &all[k]) else {
                wrong.push(k);
                continue;
            };
            let is_nan = |place: usize| found[place].is_some_and(f64::is_nan);
            let is_off = |place: &usize| {
                deviations[*place].is_some_and(|deviation| deviation > OTHER) && (is_same[*place] || is_nan(*place))
            };
            let off: Vec<_> = (0..found.len()).filter(is_off).collect();
            if off.is_empty() {
                continue;
            }
            let outside = self.outside(k, found, &off);
            if outside.is_empty() {
                other_side.push(k);
                *sides.entry(condition).or_default() += 1;
                for &place in &off {
                    grades[place] = grades[place].max(Grade::Inaccurate);
                }
            } else {
                if outside.iter().any(|&place| is_nan(place)) {
                    *nan.entry(condition).or_default() += 1;
                }
                for &place in &outside {
                    grades[place] = Grade::Wrong;
                }
                wrong.push(k);
            }
        }
        let right = [asked.len() - wrong.len(), asked.len()];
        let standing = match (asked.len(), wrong.len(), other_side.len()) {
            (0, ..) => Standing::NotAsked,
            (_, 0, 0) => Standing::Right,
            (_, 0, _) => Standing::Limited,
            _ => Standing::Wrong,
        };
        let says = match standing {
            Standing::NotAsked => "it has none".to_owned(),
            Standing::Right => format!("right at {}, by the convention of the formula", of_points(right, "point")),
            Standing::Limited => {
                format!("right at {}, by another convention at {}", of_points(right, "point"), other_side.len())
            }
            Standing::Wrong => format!("right at {}", of_points(right, "point")),
        };
        let mut details = Vec::new();
        let of_nan = |(condition, times): (&&str, &usize)| {
            format!(
                "NaN on the kink {} ({}): 0/0 without a branch of its own",
                as_text(condition),
                count(*times, "point")
            )
        };
        let causes = nan.iter().map(of_nan).collect();
        for condition in sides.keys() {
            let side = self.side(condition, answers, questions);
            details.push(format!("on the kink {} it takes {side}; the formula takes another one", as_text(condition)));
        }
        let point = self.simplest(if wrong.is_empty() { &other_side } else { &wrong });
        if let Some(k) = point {
            details.extend(self.first_off(k, &answers[0][k], all[k].as_ref()));
        }
        (Part { title, standing, right, says, causes, details, point }, grades)
    }

    /// The side of a kink whose derivatives a program has there, in words.
    fn side(&self, condition: &str, answers: &[Vec<Answer>; 2], questions: &[usize]) -> String {
        let Some(entry) = self.formula.kinks().into_iter().find(|kink| kink.condition == condition) else {
            return "the derivatives of one side".into();
        };
        let on = questions.iter().copied().find(|&k| self.questions[k].inputs == entry.at);
        let Some(Answer::Numbers(found)) = on.map(|k| &answers[0][k]) else {
            return "the derivatives of one side".into();
        };
        let of_side = |sign: f64| {
            let step = |(x, across): (&f64, &f64)| x + sign * 1e-9 * across;
            let there: Vec<f64> = entry.at.iter().zip(&entry.across).map(step).collect();
            let numbers = self.numbers_at(&there)?;
            let fits = |(found, there): (&Option<f64>, &f64)| {
                found.is_none_or(|x| (x - there).abs() <= 1e-6 * (1.0 + there.abs()))
            };
            Some(found.iter().zip(&numbers).all(fits))
        };
        let moved: Vec<String> = self
            .formula
            .inputs()
            .iter()
            .scan(0, |next, field| {
                let places = *next..*next + field.len();
                *next += field.len();
                Some(entry.across[places].iter().any(|x| *x != 0.0).then(|| field.name.to_owned()))
            })
            .flatten()
            .collect();
        let moved = moved.join(", ");
        match (of_side(1.0), of_side(-1.0)) {
            (Some(true), Some(false)) => format!("the derivatives of the side where {moved} is larger"),
            (Some(false), Some(true)) => format!("the derivatives of the side where {moved} is smaller"),
            _ => "derivatives between those of its sides".into(),
        }
    }

    fn numbers_at(&self, inputs: &[f64]) -> Option<Vec<f64>> {
        let (value, jacobian) = self.formula.value_and_jacobian(inputs).ok()?;
        match self.wanted {
            Wanted::Value => Some(value),
            Wanted::Jacobian => Some([value, jacobian].concat()),
            Wanted::Products => None,
        }
    }

    /// Those of these numbers that no neighbour has, and that lie between those of no two.
    pub(super) fn outside(&self, k: usize, found: &[Option<f64>], off: &[usize]) -> Vec<usize> {
        let question = &self.questions[k];
        let x = &question.inputs;
        let Some(right) = question.right(self.formula, self.wanted) else { return off.to_vec() };
        let Some(scale) = scales(self.formula, self.wanted, question, &right) else { return off.to_vec() };
        let mut range = Range { least: right.clone(), most: right };
        let Some(here) = self.neighbour(k, x) else { return off.to_vec() };
        range.add(&here);
        let largest = x.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let size = |j: usize| match x[j].abs() {
            0.0 if largest == 0.0 => 1.0,
            0.0 => largest.min(1.0),
            size => size,
        };
        for near in NEAR {
            for j in 0..x.len() {
                for sign in [1.0, -1.0] {
                    let mut there = x.clone();
                    there[j] += sign * near * size(j);
                    self.neighbour(k, &there).iter().for_each(|numbers| range.add(numbers));
                }
            }
            // Several inputs at once, in turn with other signs.
            for pattern in 0..16_usize {
                let sign =
                    |j: usize| if (pattern * (2 * j + 1) + j * j + pattern * pattern / 3) % 5 < 2 { -1.0 } else { 1.0 };
                let there: Vec<f64> = (0..x.len()).map(|j| x[j] + sign(j) * near * size(j)).collect();
                self.neighbour(k, &there).iter().for_each(|numbers| range.add(numbers));
            }
        }
        let is_outside = |place: &usize| {
            let margin = OTHER * scale[*place];
            found[*place].is_none_or(|x| !(range.least[*place] - margin..=range.most[*place] + margin).contains(&x))
        };
        off.iter().copied().filter(is_outside).collect()
    }

    /// The right numbers at a neighbour of a question.
    fn neighbour(&self, k: usize, inputs: &[f64]) -> Option<Vec<f64>> {
        let (value, jacobian) = self.formula.value_and_jacobian(inputs).ok()?;
        let [n, m] = sizes(self.formula);
        match (self.wanted, &self.questions[k].directions) {
            (Wanted::Value, _) => Some(value),
            (Wanted::Products, Some([v, w])) => {
                let row = |i: usize| (0..n).map(|j| jacobian[i * n + j] * v[j]).sum();
                let column = |j: usize| (0..m).map(|i| jacobian[i * n + j] * w[i]).sum();
                Some(value.iter().copied().chain((0..m).map(row)).chain((0..n).map(column)).collect())
            }
            _ => Some([value, jacobian].concat()),
        }
    }
}
