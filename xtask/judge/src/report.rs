//! The report of a check.

use super::answer::Heard;
use super::map::{map, names};
use super::parts::{Parts, Standing, is_well};
use super::verdict::{Court, Grade, Verdict, Worst};
use crate::console::{bold, count, figure, green, red, yellow};
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

/// The causes, one line each; what is wrong without a known cause is said to be unexplained.
pub(super) fn causes(verdict: &Parts) -> Vec<String> {
    let causes = verdict.diagnosis.lines();
    let is_wrong = verdict.parts.iter().any(|part| part.standing == Standing::Wrong);
    let named: Vec<_> = verdict.parts.iter().flat_map(|part| part.causes.iter().cloned()).collect();
    // What is wrong on kinks does not explain what is wrong elsewhere.
    let is_unexplained = causes.is_empty() && verdict.parts[0].standing == Standing::Wrong;
    match (is_unexplained || causes.is_empty() && named.is_empty(), is_wrong) {
        (true, true) => match verdict.parts[0].right {
            [right, all] if (1..3).contains(&(all - right)) && all > 3 => {
                vec![format!("unexplained: it is off at {} alone", count(all - right, "point"))]
            }
            _ => vec!["unexplained".into()],
        },
        _ => [causes, named].concat(),
    }
}

/// The full report: a line for each part, and what is to be said about it.
pub(super) fn text(
    court: &Court<'_>,
    program: &[String],
    found: &Verdict,
    verdict: &Parts,
    heard: &Heard,
    slope: Option<&str>,
) -> String {
    let is_well = is_well(found, verdict, court.is_strict);
    let summary = match (is_well, verdict.are_right()) {
        (true, _) if verdict.parts.iter().any(|part| part.standing == Standing::Limited) => "right, with limits",
        (true, _) => "right",
        (false, true) if court.is_strict => "right, but not strictly",
        (false, _) => "not right",
    };
    let questions = count(court.questions.len(), "point");
    let mut text = format!("{} {summary}; {questions}, each asked twice\n", head(court, program, is_well));
    let wide = verdict.parts.iter().map(|part| part.title.chars().count()).max().unwrap_or_default();
    for part in &verdict.parts {
        let says = match part.standing {
            Standing::Right => green(&part.says),
            Standing::Limited => yellow(&part.says),
            Standing::Wrong => red(&part.says),
            Standing::NotAsked => part.says.clone(),
        };
        let _ = writeln!(text, "    {:wide$}  {says}", part.title);
        for detail in &part.details {
            let _ = writeln!(text, "    {:wide$}  {detail}", "");
        }
        if let Some(point) = part.point {
            let _ = writeln!(
                text,
                "    {:wide$}  at the point {}\n      {}",
                "",
                court.questions[point].name,
                self::point(court, point)
            );
        }
    }
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
    if let more @ 1.. = found.refused_wrongly.len().saturating_sub(SHOWN) {
        line(format!("refuses {more} more"));
    }
    if let Some(&question) = found.two_answers.first() {
        line(format!(
            "{} at {}: asked again in another order it answers something else\n      {}",
            red("state is kept between calls"),
            places(court, &found.two_answers),
            point(court, question)
        ));
    }
    text += &entries(court, found, verdict);
    if let Some(slope) = slope {
        let _ = writeln!(text, "    {slope}");
    }
    for cause in causes(verdict) {
        let _ = writeln!(text, "    {} {cause}", bold("diagnosis:"));
    }
    text
}

/// The map, if a number is another one somewhere; judged strictly, also the entries beyond their bounds.
fn entries(court: &Court<'_>, found: &Verdict, verdict: &Parts) -> String {
    let is_off = |grade: &Grade| *grade == Grade::Wrong || court.is_strict && *grade != Grade::Right;
    if !verdict.grades.iter().any(is_off) {
        return String::new();
    }
    let (inputs, outputs) = (court.formula.inputs(), court.formula.outputs());
    let is_absent = |place: usize| found.tallies.get(place).is_some_and(|tally| tally.checked == 0 && tally.is_absent);
    let grades: Vec<_> =
        verdict.grades.iter().enumerate().map(|(place, grade)| (!is_absent(place)).then_some(*grade)).collect();
    let mut text = map(inputs, outputs, court.wanted, &grades);
    text += "    + right  ~ right with limits  x wrong  - not given\n";
    if !court.is_strict {
        return text;
    }
    let names = names(inputs, outputs, court.wanted);
    let mut off: Vec<_> = (0..found.tallies.len()).filter(|&place| found.tallies[place].off > 0).collect();
    off.sort_by_key(|&place| std::cmp::Reverse(found.tallies[place].grade));
    for &place in off.iter().take(SHOWN) {
        let tally = &found.tallies[place];
        let Some(Worst { eta, question, found, exact }) = &tally.worst else { continue };
        let _ = writeln!(
            text,
            "    {} beyond its bound at {} of {}: η {} (bound {}) at {}\n      found {found:?}, exact is {exact:?}\n      {}",
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

/// The inputs of a question, by name.
pub(super) fn inputs(court: &Court<'_>, question: usize) -> serde_json::Value {
    named(court.formula.inputs(), &court.questions[question].inputs).into()
}

/// A point in a form that can be passed back.
pub(super) fn point(court: &Court<'_>, question: usize) -> String {
    format!("--point '{}'", inputs(court, question))
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
