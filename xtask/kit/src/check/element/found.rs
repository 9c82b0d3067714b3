//! What is wrong with the answers of a routine that should be an element.

use super::point::Point;
use crate::console::count;
use crate::uel::Interface;
use judge::Answer;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The results that are listed.
const SHOWN: usize = 6;

/// What is wrong with the answers.
pub(super) struct Found {
    /// The points at which something is.
    pub(super) off: usize,
    /// The way of `WAYS` that is nearest.
    pub(super) way: usize,
    /// What is wrong with whole answers.
    pub(super) faults: Vec<Fault>,
    pub(super) wrong: Vec<Wrong>,
}

#[derive(serde::Serialize)]
pub(super) struct Fault {
    what: String,
    points: usize,
    first: String,
}

/// A number that is not the element's, at the first point at which it is not.
#[derive(serde::Serialize)]
pub(super) struct Wrong {
    number: String,
    found: f64,
    expected: f64,
    first: String,
    points: usize,
}

impl Found {
    pub(super) fn new(mapping: &Interface, points: &[Point], answers: Vec<Answer>, is_strict: bool) -> Self {
        let off_by = |way: usize| -> usize {
            let off = |(point, answer): (&Point, &Answer)| match answer {
                Answer::Numbers(found) => point.off(found, way).len(),
                _ => 0,
            };
            points.iter().zip(&answers).map(off).sum()
        };
        let ways =
            if is_strict { 1 } else { points.iter().map(|point| point.expected.len()).min().unwrap_or_default() };
        let way = (0..ways).min_by_key(|&way| off_by(way)).unwrap_or_default();
        let mut faults: BTreeMap<String, Fault> = BTreeMap::new();
        let mut wrong: BTreeMap<usize, Wrong> = BTreeMap::new();
        let mut off = 0;
        for (point, answer) in points.iter().zip(answers) {
            let first = || point.name.clone();
            let what = match answer {
                Answer::Numbers(_) if point.must_be_refused() => "not refused, though it is not allowed".to_owned(),
                Answer::Refused(_) if point.must_be_refused() => continue,
                Answer::Numbers(found) => {
                    let wrong_here = point.off(&found, way);
                    off += usize::from(!wrong_here.is_empty());
                    for place in wrong_here {
                        let (Some(found), Some(expected)) = (found[place], point.expected[way][place]) else {
                            continue;
                        };
                        let number = mapping.name(place);
                        // What is compared is minus AMATRX.
                        let sign = if number.starts_with('A') { -1.0 } else { 1.0 };
                        let [found, expected] = [found, expected].map(|x| sign * x);
                        let new = || Wrong { number, found, expected, first: first(), points: 0 };
                        wrong.entry(place).or_insert_with(new).points += 1;
                    }
                    continue;
                }
                Answer::Refused(_) => "refused by PNEWDT".to_owned(),
                Answer::Bad(what) | Answer::Skipped(what) => what,
            };
            off += 1;
            let new = || Fault { what: what.clone(), points: 0, first: first() };
            faults.entry(what.clone()).or_insert_with(new).points += 1;
        }
        Self { off, way, faults: faults.into_values().collect(), wrong: wrong.into_values().collect() }
    }

    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        for Fault { what, points, first } in &self.faults {
            let _ = writeln!(text, "    {what}: {}, first {first}", count(*points, "point"));
        }
        for Wrong { number, found, expected, first, points } in self.wrong.iter().take(SHOWN) {
            let points = count(*points, "point");
            let _ =
                writeln!(text, "    {number} is {found:.9e} instead of {expected:.9e} at {first}; wrong at {points}");
        }
        if self.wrong.len() > SHOWN {
            let _ = writeln!(text, "    and {} more", count(self.wrong.len() - SHOWN, "number"));
        }
        text
    }
}
