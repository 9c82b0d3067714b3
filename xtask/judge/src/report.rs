//! The report of a check.

use super::answer::Heard;
use super::map::{map, names};
use super::question::Own;
use super::verdict::{Court, Grade, Verdict, Worst};
use crate::console::{bold, count, figure, green, red};
use jointproof::toolkit::verify::golden::named;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The number of entries reported in full; the map shows the rest.
const SHOWN: usize = 6;

impl Court<'_> {
    /// The report for a program that does not answer.
    pub fn silent(&self, program: &[String], why: &str) -> String {
        format!("{} {why}\n", head(self, program, false))
    }
}

fn head(court: &Court<'_>, program: &[String], well: bool) -> String {
    let mark = if well { green("ok ") } else { red("off") };
    let program = program.join(" ");
    let mut words = program.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((end, _)) = words.char_indices().nth(60) {
        words.replace_range(end.., "…");
    }
    format!("{mark} {} by {words}:", bold(court.formula.spec().id))
}

/// The full report: a line or two if all is well.
pub(super) fn text(
    court: &Court<'_>,
    program: &[String],
    found: &Verdict,
    heard: &Heard,
    slope: Option<&str>,
    causes: &[String],
) -> String {
    let questions = court.questions.len();
    let mut text = format!(
        "{} {}, each asked twice; {} judged in 237 bits, {} have the bits of jointproof, {} refused as they must be\n",
        head(court, program, found.is_well()),
        count(questions, "point"),
        count(found.judged, "number"),
        found.same,
        found.refused,
    );
    let mut line = |what: String| {
        let _ = writeln!(text, "    {what}");
    };
    for (manner, times) in &heard.manners {
        line(format!("understood: {manner}, {}", count(*times, "time")));
    }
    for what in &heard.noticed {
        line(format!("noticed: {what}"));
    }
    if found.refused_by_nan > 0 {
        line(format!("taken for a refusal: NaN or infinity, {}", count(found.refused_by_nan, "time")));
    }
    if found.beside > 0 {
        let answers = count(found.beside, "answer");
        line(format!("{answers} taken for right a rounding of an input beside the point, on the other side of a kink"));
    }
    for (what, questions) in by_what(&found.skipped) {
        line(format!("skipped {}: {what}", places(court, &questions)));
    }
    for (what, questions) in by_what(&found.bad) {
        line(format!("{} {}: {what}", red("no answer"), places(court, &questions)));
    }
    for &question in found.refused_wrongly.iter().take(SHOWN) {
        let at = &court.questions[question].name;
        line(format!("{} what is valid: {at}\n      {}", red("refuses"), point(court, question)));
    }
    for &question in found.accepted.iter().take(SHOWN) {
        let Own::Refused(why) = &court.questions[question].own else { continue };
        line(format!("{} what must be refused: {}: {why}", red("accepts"), court.questions[question].name));
    }
    for (what, all) in [("refuses", found.refused_wrongly.len()), ("accepts", found.accepted.len())] {
        match all.saturating_sub(SHOWN) {
            0 => {}
            more => line(format!("{what} {more} more")),
        }
    }
    if let Some(&question) = found.two_answers.first() {
        line(format!(
            "{} at {}: asked again in another order it answers something else\n      {}",
            red("state is kept between calls"),
            places(court, &found.two_answers),
            point(court, question)
        ));
    }
    text += &entries(court, found);
    if let Some(slope) = slope {
        let _ = writeln!(text, "    {slope}");
    }
    for cause in causes {
        let _ = writeln!(text, "    {} {cause}", bold("diagnosis:"));
    }
    text
}

/// The map, and the wrong entries.
fn entries(court: &Court<'_>, found: &Verdict) -> String {
    let (inputs, outputs) = (court.formula.inputs(), court.formula.outputs());
    let names = names(inputs, outputs, court.wanted);
    let mut off: Vec<_> = (0..found.tallies.len()).filter(|&place| found.tallies[place].off > 0).collect();
    if off.is_empty() {
        let worst = |places: std::ops::Range<usize>| {
            let tallies = found.tallies.get(places).unwrap_or_default();
            let etas = tallies.iter().filter_map(|tally| tally.worst.as_ref()).map(|worst| worst.eta);
            figure(etas.fold(0.0, f64::max))
        };
        let (m, all) = (outputs.iter().map(jointproof::formula::Field::len).sum(), found.tallies.len());
        if all == 0 {
            return String::new();
        }
        let bounds = court.bounds;
        let jacobian = if all > m {
            format!(", of the rest {} (bound {})", worst(m..all), figure(court.bound(all - 1)))
        } else {
            String::new()
        };
        return format!("    η of the value at most {} (bound {}){jacobian}\n", worst(0..m), figure(bounds.value));
    }
    let mut text = map(inputs, outputs, court.wanted, &found.tallies);
    text += "    + right  ~ inaccurate  x wrong  - not given\n";
    off.sort_by_key(|&place| std::cmp::Reverse(found.tallies[place].grade));
    for &place in off.iter().take(SHOWN) {
        let tally = &found.tallies[place];
        let Some(Worst { eta, question, found, exact }) = &tally.worst else { continue };
        let word = if tally.grade == Grade::Wrong { "wrong" } else { "inaccurate" };
        let _ = writeln!(
            text,
            "    {} {word} at {} of {}: η {} (bound {}) at {}\n      found {found:?}, exact is {exact:?}\n      {}",
            bold(&names[place]),
            tally.off,
            count(tally.checked, "answer"),
            figure(*eta),
            figure(court.bound(place)),
            court.questions[*question].name,
            point(court, *question)
        );
    }
    if off.len() > SHOWN {
        let _ = writeln!(text, "    and {} more", off.len() - SHOWN);
    }
    text
}

/// A point in a form that can be passed back.
pub(super) fn point(court: &Court<'_>, question: usize) -> String {
    let inputs = named(court.formula.inputs(), &court.questions[question].inputs);
    format!("--point '{}'", serde_json::Value::from(inputs))
}

fn by_what(list: &[(usize, String)]) -> BTreeMap<&str, Vec<usize>> {
    let mut sorted = BTreeMap::<&str, Vec<usize>>::new();
    for (question, what) in list {
        sorted.entry(what).or_default().push(*question);
    }
    sorted
}

/// Some of the names, and the total number.
fn places(court: &Court<'_>, questions: &[usize]) -> String {
    let names: Vec<_> = questions.iter().take(3).map(|&question| court.questions[question].name.as_str()).collect();
    match questions.len() {
        all if all > 3 => format!("{} ({}, …)", count(all, "point"), names.join(", ")),
        _ => names.join(", "),
    }
}

#[cfg(test)]
mod tests;
