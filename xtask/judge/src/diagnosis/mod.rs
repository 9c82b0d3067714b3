//! Finds what is wrong as a doctor does: from the answers at ordinary points, with the fewest known mistakes that explain
//! them. Extreme numbers, kinks and invalid inputs have their own parts in the verdict.

mod change;
mod factors;
mod inputs;
mod mistakes;
mod model;
mod permuted;
mod precision;
mod sample;
mod search;
mod state;
mod symmetric;
mod wording;
mod words;

use super::answer::Answer;
use super::question::Wanted;
use super::verdict::{Court, Verdict};
use crate::console::count;
use jointproof::toolkit::graph::Op;
use model::Textbook;
use sample::{Evidence, LEAST, Sample};
use search::{Explanation, Tried};
use words::Words;

/// What is known of the cause.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Diagnosis {
    /// The causes, one line each; empty if none is known.
    pub(super) causes: Vec<String>,
    /// How many points they explain, of how many that were looked at.
    pub(super) explained: [usize; 2],
}

/// The causes of what is wrong at these questions.
pub(super) fn diagnose(
    court: &Court<'_>,
    answers: &[Vec<Answer>; 2],
    verdict: &Verdict,
    ordinary: &[usize],
) -> Diagnosis {
    if !verdict.two_answers.is_empty() {
        return Diagnosis { causes: vec![state::diagnose(court, answers, verdict)], explained: [0; 2] };
    }
    let evidence = Evidence::new(court, &answers[0], ordinary.iter().copied());
    let points = evidence.off_samples(&evidence.off).len();
    if points < LEAST {
        return Diagnosis::default();
    }
    // Products are judged by their numbers alone.
    let has_book = court.wanted != Wanted::Products;
    let book = has_book.then(|| Textbook::of(court.formula, &evidence.samples)).flatten();
    let tried = Tried::new(&evidence, book.as_ref());
    let all = evidence.samples.len();
    let described = |found: Explanation| Diagnosis { causes: found.what, explained: [found.explained, all] };
    tried
        .one()
        .map(described)
        .or_else(|| book.as_ref().and_then(|book| within_branch(&evidence, book)))
        .or_else(|| Some(Diagnosis { causes: vec![precision::cause(&evidence, &evidence.off)?], explained: [all; 2] }))
        .or_else(|| tried.several().map(described))
        .or_else(|| tried.two_results().map(described))
        .or_else(|| by_parts(&evidence, book.as_ref()))
        .unwrap_or_default()
}

/// A mistake in one branch of the formula alone.
fn within_branch(evidence: &Evidence<'_>, book: &Textbook) -> Option<Diagnosis> {
    let words = Words::new(evidence.court.formula, book, &evidence.samples);
    let off = evidence.off_samples(&evidence.off);
    let comparisons = book.needed.iter().filter(|node| matches!(book.graph.op(**node), Op::Compare(..)));
    for &comparison in comparisons {
        let holds = |sample: &Sample| book.holds(comparison, &sample.inputs);
        let side = holds(off.first()?);
        let is_elsewhere = evidence.samples.iter().any(|sample| holds(sample) != side);
        if !is_elsewhere || off.iter().any(|sample| holds(sample) != side) {
            continue;
        }
        let there = evidence.samples.iter().filter(|sample| holds(sample) == side).cloned().collect();
        let there = Evidence::of(evidence.court, there);
        let tried = Tried::new(&there, Some(book));
        if let Some(found) = tried.one().or_else(|| tried.two_results()) {
            let name = words.side(comparison, side);
            let elsewhere = evidence.samples.len() - there.samples.len();
            return Some(Diagnosis {
                causes: found.what.into_iter().map(|what| format!("in {name}: {what}")).collect(),
                explained: [found.explained + elsewhere, evidence.samples.len()],
            });
        }
    }
    None
}

/// One cause for the value, and another one for the rest, as far as they are known.
fn by_parts(evidence: &Evidence<'_>, book: Option<&Textbook>) -> Option<Diagnosis> {
    if evidence.court.wanted != Wanted::Jacobian {
        return None;
    }
    let [value, rest] = evidence.parts();
    let of = |part: &std::ops::Range<usize>| {
        let without = |sample: &Sample| {
            let mut sample = sample.clone();
            (0..sample.found.len()).filter(|place| !part.contains(place)).for_each(|place| sample.found[place] = None);
            sample
        };
        let alone = Evidence::of(evidence.court, evidence.samples.iter().map(without).collect());
        if alone.off_samples(&alone.off).len() < LEAST {
            return None;
        }
        let tried = Tried::new(&alone, book);
        Some(tried.one().or_else(|| tried.several()).map(|found| found.what).ok_or(alone))
    };
    let [value, rest] = [of(&value), of(&rest)];
    // The digits of one part alone tell something if the other part is known.
    let precise = |part: Option<Result<Vec<String>, Evidence<'_>>>, is_other_known: bool| {
        part.map(|part| match part {
            Ok(what) => Some(what),
            Err(alone) if is_other_known => Some(vec![precision::cause(&alone, &alone.off)?]),
            Err(_) => None,
        })
    };
    let [is_value_known, is_rest_known] = [&value, &rest].map(|part| !matches!(part, Some(Err(_))));
    let (value, rest) = (precise(value, is_rest_known), precise(rest, is_value_known));
    if [&value, &rest].iter().all(|part| part.as_ref().is_none_or(Option::is_none)) {
        return None;
    }
    let described = |part: &str, cause: Option<Option<Vec<String>>>| match cause {
        None => Vec::new(),
        Some(None) => vec![format!("{part}: unexplained")],
        Some(Some(what)) => what.into_iter().map(|what| with_part(part, what)).collect(),
    };
    let causes = [described("value", value), described("Jacobian", rest)].concat();
    Some(Diagnosis { causes, explained: [0, evidence.samples.len()] })
}

fn with_part(part: &str, what: String) -> String {
    if what.starts_with(part) { what } else { format!("{part}: {what}") }
}

/// The sum of the formula that loses most digits at a question, in words.
pub(super) fn cancellation(court: &Court<'_>, k: usize) -> Option<String> {
    with_words(court, k, |book, words, inputs| {
        let (node, share) = book.cancellation(inputs)?;
        Some(format!("{} loses {:.1} digits there: its terms cancel", words.name(node), -share.log10()))
    })
}

/// A length whose squares leave the range of doubles at a question, in words.
pub(super) fn length(court: &Court<'_>, k: usize) -> Option<String> {
    with_words(court, k, |book, words, inputs| Some(words.name(book.length_out_of_range(inputs)?)))
}

fn with_words<T>(
    court: &Court<'_>,
    k: usize,
    look: impl FnOnce(&Textbook, &Words<'_>, &[f64]) -> Option<T>,
) -> Option<T> {
    let nothing = Answer::Numbers(vec![None; court.wanted.numbers(super::question::sizes(court.formula))]);
    let samples = [Sample::new(court, &court.questions[k], &nothing)?];
    let book = Textbook::of(court.formula, &samples)?;
    look(&book, &Words::new(court.formula, &book, &samples), &samples[0].inputs)
}

impl Diagnosis {
    /// Lines for a report.
    pub(super) fn lines(&self) -> Vec<String> {
        let [explained, all] = self.explained;
        let mut lines = self.causes.clone();
        if let Some(last) = lines.last_mut().filter(|_| explained > 0) {
            let rest = all - explained;
            let points = count(all, "point");
            let what = match rest {
                0 => format!(": this explains all {points} looked at"),
                rest => format!(": this explains {explained} of {points} looked at, {rest} remain"),
            };
            *last += &what;
        }
        lines
    }
}
