//! The errata, executed: a literal reading beside the one that is used, both evaluated, and the law that the literal one
//! breaks.
//!
//! The words stand in `book/src/errata.md`; the tables there are made here, so that no number in them is typed.

mod contact;
mod friction;
mod joint;
mod ours;
mod slider;

use jointproof::formula::Formula;
use std::fmt::Write;

/// An erratum, by its anchor in the chapter.
pub(crate) struct Erratum {
    /// The anchor.
    pub(crate) anchor: &'static str,
    /// What was evaluated.
    pub(crate) comparisons: Vec<Comparison>,
}

/// Readings of one place, evaluated at one point, and a law to judge them.
pub(crate) struct Comparison {
    /// The point (Markdown).
    at: &'static str,
    /// The law (Markdown).
    law: &'static str,
    /// How far a reading may be off the law to be called right.
    bound: f64,
    readings: Vec<Reading>,
}

/// One reading.
struct Reading {
    kind: Kind,
    /// Whose it is (Markdown).
    whose: String,
    /// What it says, in LaTeX.
    latex: &'static str,
    values: Vec<f64>,
    /// By how much it is off the law, as a part of the numbers compared.
    off: f64,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Breaks the law.
    Literal,
    /// Obeys it.
    Right,
}

/// How many times the bound a literal reading must be off.
const BROKEN: f64 = 1e3;

/// All errata, in the order of the chapter.
pub(crate) fn all() -> Vec<Erratum> {
    [friction::errata(), joint::errata(), slider::errata(), contact::errata(), ours::errata()]
        .into_iter()
        .flatten()
        .collect()
}

fn erratum(anchor: &'static str, comparisons: Vec<Comparison>) -> Erratum {
    Erratum { anchor, comparisons }
}

/// A comparison at a point; readings follow.
fn at(at: &'static str, law: &'static str) -> Comparison {
    Comparison { at, law, bound: 1e-12, readings: Vec::new() }
}

impl Comparison {
    /// The document read as it stands.
    fn printed(self, latex: &'static str, value: f64, off: f64) -> Self {
        self.reading(Kind::Literal, "as printed".into(), latex, &[value], off)
    }

    /// A literal reading that the library keeps.
    fn kept<F: Formula>(self, whose: &str, latex: &'static str, values: &[f64], off: f64) -> Self {
        self.reading(Kind::Literal, format!("{whose}, and here: `{}`", F::SPEC.id), latex, values, off)
    }

    /// Another literal reading.
    fn literal(self, whose: &str, latex: &'static str, value: f64, off: f64) -> Self {
        self.reading(Kind::Literal, whose.into(), latex, &[value], off)
    }

    /// What the library does.
    fn here<F: Formula>(self, latex: &'static str, value: f64, off: f64) -> Self {
        self.reading(Kind::Right, format!("here: `{}`", F::SPEC.id), latex, &[value], off)
    }

    /// What is right, though no formula of the library.
    fn right(self, whose: &str, latex: &'static str, values: &[f64], off: f64) -> Self {
        self.reading(Kind::Right, whose.into(), latex, values, off)
    }

    /// With another bound.
    fn within(self, bound: f64) -> Self {
        Self { bound, ..self }
    }

    fn reading(mut self, kind: Kind, whose: String, latex: &'static str, values: &[f64], off: f64) -> Self {
        self.readings.push(Reading { kind, whose, latex, values: values.to_vec(), off });
        self
    }

    /// What is not as it should be: a literal reading that obeys the law, or a right one that breaks it.
    fn faults(&self) -> impl Iterator<Item = String> {
        let wrong = |reading: &&Reading| match reading.kind {
            Kind::Literal => !(reading.off > BROKEN * self.bound),
            Kind::Right => !(reading.off <= self.bound),
        };
        self.readings.iter().filter(wrong).map(|reading| match reading.kind {
            Kind::Literal => format!("{}, it obeys the law \"{}\": off by {:e}", reading.whose, self.law, reading.off),
            Kind::Right => format!("{}, it breaks the law \"{}\": off by {:e}", reading.whose, self.law, reading.off),
        })
    }

    /// Whether there is something on both sides.
    fn compares(&self) -> bool {
        [Kind::Literal, Kind::Right].iter().all(|kind| self.readings.iter().any(|reading| reading.kind == *kind))
    }
}

impl Erratum {
    /// What is wrong with it.
    pub(crate) fn faults(&self) -> Vec<String> {
        let mut faults: Vec<_> = self.comparisons.iter().flat_map(Comparison::faults).collect();
        if self.comparisons.is_empty() || !self.comparisons.iter().all(Comparison::compares) {
            faults.push("no literal reading beside a right one".into());
        }
        faults.into_iter().map(|fault| format!("erratum {}: {fault}", self.anchor)).collect()
    }

    /// Its tables (Markdown).
    pub(crate) fn markdown(&self) -> String {
        let mut text = String::new();
        for Comparison { at, law, readings, .. } in &self.comparisons {
            let head = "| Reading | Equation | Value | Off the law by |\n|---|---|---|---|";
            let _ = writeln!(text, "*Point:* {at}. *Law:* {law}.\n\n{head}");
            for Reading { whose, latex, values, off, .. } in readings {
                let _ = writeln!(text, "| {whose} | ${latex}$ | {} | {} |", all_digits(values), digits(*off));
            }
            text.push('\n');
        }
        text
    }
}

/// Four digits of each; what is rounding beside the largest is 0.
fn all_digits(values: &[f64]) -> String {
    let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let shown = values.iter().map(|value| digits(if value.abs() < largest * 1e-12 { 0.0 } else { *value }));
    shown.collect::<Vec<_>>().join(", ")
}

/// Four digits.
fn digits(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => {
            let decimals = (3 - size.log10().floor() as i32).max(0) as usize;
            let text = format!("{x:.decimals$}");
            let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
            short.replace('-', "−")
        }
        _ => {
            let text = format!("{x:.0e}");
            let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
            format!("${mantissa}\\cdot10^{{{power}}}$")
        }
    }
}

/// By how much two numbers differ, as a part of the larger one; 0 where both are 0.
fn apart(a: f64, b: f64) -> f64 {
    let size = a.abs().max(b.abs());
    if size == 0.0 { 0.0 } else { (a - b).abs() / size }
}
