//! Up to which sizes of its inputs a program is right, and what over- or underflows beyond.

use super::{Deviations, OTHER, Part, Standing, of_points};
use crate::answer::Answer;
use crate::console::count;
use crate::diagnosis;
use crate::question::Kind;
use crate::verdict::Court;

/// A rung: its exponent, whether it is off, and its question.
type Step = (i32, bool, usize);

/// The decades of doubles above 1, and below.
const LARGEST: f64 = 308.25;
const SMALLEST: f64 = 323.3;

impl Court<'_> {
    /// The part about sizes.
    pub(super) fn limits(
        &self,
        answers: &[Vec<Answer>; 2],
        all: &[Option<Deviations>],
        questions: &[usize],
        is_same: &[bool],
    ) -> Part {
        let title = "up to which sizes?";
        let is_asked = |k: &usize| !matches!(answers[0][*k], Answer::Skipped(_));
        let asked: Vec<_> = questions.iter().copied().filter(is_asked).collect();
        let is_off = |k: &usize| match &all[*k] {
            Some(deviations) => {
                let mut all = deviations.iter().zip(is_same);
                all.any(|(x, same)| x.is_some_and(|x| x > OTHER && *same || x.is_infinite()))
            }
            None => true,
        };
        let off: Vec<_> = asked.iter().copied().filter(is_off).collect();
        let right = [asked.len() - off.len(), asked.len()];
        let mut ladders: Vec<(&[&str], Vec<Step>)> = Vec::new();
        for &k in &asked {
            let Kind::Rung(rung) = &self.questions[k].kind else { continue };
            let step = (rung.exponent, is_off(&k), k);
            match ladders.iter_mut().find(|(fields, _)| *fields == rung.fields) {
                Some((_, steps)) => steps.push(step),
                None => ladders.push((&rung.fields, vec![step])),
            }
        }
        let mut details = Vec::new();
        for (fields, mut steps) in ladders {
            steps.sort_by_key(|(exponent, ..)| exponent.abs());
            let first = |sign: i32| steps.iter().find(|(exponent, off, _)| exponent.signum() == sign && *off);
            for (sign, word) in [(1, "from"), (-1, "below")] {
                let Some(&(exponent, _, k)) = first(sign) else { continue };
                let before = steps.iter().filter(|(other, ..)| other.signum() == sign && other.abs() < exponent.abs());
                let before = before.map(|(other, ..)| *other).next_back().unwrap_or_default();
                let what = what_is_lost(self, k, exponent, before, &answers[0][k]);
                let limit = if sign > 0 { exponent } else { before };
                details.push(format!("{word} {} = 1e{limit} {what}", fields.join(", ")));
            }
        }
        let others: Vec<_> = off.iter().filter(|k| self.questions[**k].kind == Kind::Extreme).copied().collect();
        let standing = match (asked.len(), off.len()) {
            (0, _) => Standing::NotAsked,
            (_, 0) => Standing::Right,
            _ => Standing::Limited,
        };
        let says = match standing {
            Standing::NotAsked => "no extreme numbers were asked".to_owned(),
            Standing::Right => format!("all that doubles hold: right at {}", of_points(right, "point")),
            _ if details.is_empty() => {
                format!("right at {} with numbers of very different sizes", of_points(right, "point"))
            }
            _ => details.remove(0),
        };
        let point = self.simplest(if others.is_empty() { &off } else { &others });
        if !others.is_empty() && standing == Standing::Limited {
            details.push(format!("off at {} with extreme numbers", count(others.len(), "other point")));
        }
        if let Some(k) = point {
            details.extend(self.first_off(k, &answers[0][k], all[k].as_ref()));
        }
        Part { title, standing, right, says, details, point, ..Part::default() }
    }
}

/// What happens beyond a limit: which power leaves the range of doubles.
fn what_is_lost(court: &Court<'_>, k: usize, exponent: i32, before: i32, answer: &Answer) -> String {
    let numbers = match answer {
        Answer::Numbers(numbers) => numbers.iter().flatten().copied().collect(),
        Answer::Refused(_) => return "it refuses".into(),
        _ => return "it does not answer".into(),
    };
    let numbers: Vec<f64> = numbers;
    let has = |is: fn(&f64) -> bool| numbers.iter().any(is);
    let result = match (has(|x| x.is_nan()), has(|x| x.is_infinite())) {
        (true, true) => "infinity and NaN",
        (true, false) => "NaN",
        (false, true) => "infinity",
        _ if exponent < 0 => "digits are lost, or 0",
        _ => "0, or lost digits",
    };
    let range = if exponent > 0 { LARGEST } else { SMALLEST };
    // A power p over- or underflows between the two sizes if the range divided by it does; near the limit of
    // underflow digits are lost first, from 1e-308 on.
    let least = if exponent > 0 { range } else { 307.6 };
    let is_power = |power: &&(f64, &str)| {
        let (low, high) = (least / power.0, range / power.0);
        f64::from(before.abs()) < high + 2.5 && f64::from(exponent.abs()) > low - 1.0
    };
    let powers = [(2.0, "a square"), (3.0, "a product of three"), (4.0, "a fourth power"), (1.0, "a sum or product")];
    let flows = if exponent > 0 { "overflows" } else { "underflows" };
    match powers.iter().find(is_power) {
        Some((power, name)) => match diagnosis::length(court, k).filter(|_| *power == 2.0) {
            Some(length) => format!("a square in {length} {flows}: {result}"),
            None => format!("{name} {flows}: {result}"),
        },
        None => format!("{result}: numbers of very different sizes meet"),
    }
}
