//! An executed erratum: a literal reading and the one that is used, both evaluated, and the law that the literal one
//! violates.

use jointproof::formula::Formula;
use std::fmt::Write;

/// An erratum, identified by its anchor in the chapter.
pub(crate) struct Erratum {
    /// The anchor.
    pub(crate) anchor: &'static str,
    /// The evaluated comparisons.
    pub(crate) comparisons: Vec<Comparison>,
}

/// Readings of one passage, evaluated at one point, and a law to judge them.
pub(crate) struct Comparison {
    /// The point (Markdown).
    at: &'static str,
    /// The law (Markdown).
    law: &'static str,
    /// The largest deviation from the law for a reading to count as right.
    bound: f64,
    readings: Vec<Reading>,
}

/// One reading.
struct Reading {
    kind: Kind,
    /// The origin of the reading (Markdown).
    whose: String,
    /// The reading in LaTeX.
    latex: &'static str,
    values: Vec<f64>,
    /// The deviation from the law, relative to the numbers compared.
    off: f64,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A reading that violates the law.
    Literal,
    /// A reading that satisfies the law.
    Right,
}

/// The least deviation of a literal reading, as a multiple of the bound.
const BROKEN: f64 = 1e3;

/// An erratum with these comparisons.
pub(super) fn erratum(anchor: &'static str, comparisons: Vec<Comparison>) -> Erratum {
    Erratum { anchor, comparisons }
}

/// A comparison at a point; readings are added by the methods below.
pub(super) fn at(at: &'static str, law: &'static str) -> Comparison {
    Comparison { at, law, bound: 1e-12, readings: Vec::new() }
}

impl Comparison {
    /// The document read literally.
    pub(super) fn printed(self, latex: &'static str, value: f64, off: f64) -> Self {
        self.reading(Kind::Literal, "as printed".into(), latex, &[value], off)
    }

    /// A literal reading that the library keeps.
    pub(super) fn kept<F: Formula>(self, whose: &str, latex: &'static str, values: &[f64], off: f64) -> Self {
        self.reading(Kind::Literal, format!("{whose}, and here: `{}`", F::SPEC.id), latex, values, off)
    }

    /// Another literal reading.
    pub(super) fn literal(self, whose: &str, latex: &'static str, value: f64, off: f64) -> Self {
        self.reading(Kind::Literal, whose.into(), latex, &[value], off)
    }

    /// The reading of the library.
    pub(super) fn here<F: Formula>(self, latex: &'static str, value: f64, off: f64) -> Self {
        self.reading(Kind::Right, format!("here: `{}`", F::SPEC.id), latex, &[value], off)
    }

    /// A right reading that is not a formula of the library.
    pub(super) fn right(self, whose: &str, latex: &'static str, values: &[f64], off: f64) -> Self {
        self.reading(Kind::Right, whose.into(), latex, values, off)
    }

    /// With another bound.
    pub(super) fn within(self, bound: f64) -> Self {
        Self { bound, ..self }
    }

    fn reading(mut self, kind: Kind, whose: String, latex: &'static str, values: &[f64], off: f64) -> Self {
        self.readings.push(Reading { kind, whose, latex, values: values.to_vec(), off });
        self
    }

    /// The faults: a literal reading that satisfies the law, or a right one that violates it.
    fn faults(&self) -> impl Iterator<Item = String> {
        let wrong = |reading: &&Reading| {
            let (breaks, obeys) = (reading.off > BROKEN * self.bound, reading.off <= self.bound);
            !if reading.kind == Kind::Literal { breaks } else { obeys }
        };
        self.readings.iter().filter(wrong).map(|reading| match reading.kind {
            Kind::Literal => format!("{}, it obeys the law \"{}\": off by {:e}", reading.whose, self.law, reading.off),
            Kind::Right => format!("{}, it breaks the law \"{}\": off by {:e}", reading.whose, self.law, reading.off),
        })
    }

    /// Whether there are readings of both kinds.
    fn compares(&self) -> bool {
        [Kind::Literal, Kind::Right].iter().all(|kind| self.readings.iter().any(|reading| reading.kind == *kind))
    }
}

impl Erratum {
    /// Its faults.
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

/// Four digits of each; a value that is rounding error compared with the largest is 0.
fn all_digits(values: &[f64]) -> String {
    let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let shown = values.iter().map(|value| digits(if value.abs() < largest * 1e-12 { 0.0 } else { *value }));
    shown.collect::<Vec<_>>().join(", ")
}

/// Four digits.
fn digits(x: f64) -> String {
    let scientific = format!("{x:.3e}");
    let (mantissa, power) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let power: i32 = power.parse().unwrap_or_default();
    match power {
        _ if x == 0.0 => "0".into(),
        -3..=4 => {
            let decimals = usize::try_from(3 - power).unwrap_or_default();
            without_zeros(&format!("{x:.decimals$}")).replace('-', "−")
        }
        _ => format!("${}\\cdot10^{{{power}}}$", without_zeros(&mantissa[..mantissa.len() - 2])),
    }
}

/// Without trailing zeros.
fn without_zeros(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

/// The difference of two numbers relative to the larger one; 0 if both are 0.
pub(super) fn apart(a: f64, b: f64) -> f64 {
    let size = a.abs().max(b.abs());
    if size == 0.0 { 0.0 } else { (a - b).abs() / size }
}

#[cfg(test)]
mod tests {
    use super::{Comparison, Erratum, Kind, Reading, all_digits, apart, at, digits};

    #[test]
    fn numbers_have_four_digits_and_differences_a_size() {
        let shown = [0.0, 1.0, 100.0, 0.5, -12.345_678, 12_345.6, 1e-3, 1.2e-4, 99_999.0, 1.5e5].map(digits);
        assert_eq!(
            shown,
            [
                "0",
                "1",
                "100",
                "0.5",
                "−12.35",
                "12346",
                "0.001",
                "$1.2\\cdot10^{-4}$",
                "$1\\cdot10^{5}$",
                "$1.5\\cdot10^{5}$"
            ]
        );
        assert_eq!(
            [apart(0.0, 0.0), apart(1.0, -1.0), apart(2.0, 1.0)],
            [0.0, 2.0, 0.5],
            "the difference of the two sides of the law, divided by the larger of them, so 0 if it holds and 2 if they are opposite"
        );
        assert_eq!([apart(-2.0, 1.0), apart(1.0, -2.0), apart(1.0, 2.0), apart(-0.5, -0.25)], [1.5, 1.5, 0.5, 0.5]);
    }

    #[test]
    fn what_is_rounding_beside_the_largest_is_0() {
        assert_eq!(all_digits(&[1.0, 1e-13, -1e-13, 0.5]), "1, 0, 0, 0.5");
        assert_eq!(all_digits(&[-2.0, 1.5e-12, 2.5e-12]), "−2, 0, $2.5\\cdot10^{-12}$");
        assert_eq!(all_digits(&[0.5, 0.75e-12]), "0.5, $7.5\\cdot10^{-13}$");
        assert_eq!(all_digits(&[-1e-3, 0.0]), "−0.001, 0");
        assert_eq!(all_digits(&[1.0, 1e-12]), "1, $1\\cdot10^{-12}$");
    }

    fn reading(kind: Kind, off: f64) -> Reading {
        Reading { kind, whose: "x".into(), latex: "", values: vec![1.0], off }
    }

    fn comparison(readings: &[(Kind, f64)]) -> Comparison {
        let readings = readings.iter().map(|&(kind, off)| reading(kind, off)).collect();
        Comparison { readings, ..at("", "law").within(0.5) }
    }

    #[test]
    fn right_is_up_to_the_bound_and_broken_far_beyond_it() {
        use Kind::{Literal, Right};
        let faults = |readings: &[(Kind, f64)]| comparison(readings).faults().count();
        assert_eq!([faults(&[(Right, 0.5)]), faults(&[(Right, 0.75)])], [0, 1]);
        assert_eq!([faults(&[(Literal, 501.0)]), faults(&[(Literal, 500.0)]), faults(&[(Literal, 3.0)])], [0, 1, 1]);
    }

    #[test]
    fn every_comparison_has_a_literal_reading_beside_a_right_one() {
        use Kind::{Literal, Right};
        let [both, literal, right] =
            [[(Literal, 1e9), (Right, 0.0)].as_slice(), &[(Literal, 1e9), (Literal, 1e9)], &[(Right, 0.0)]];
        let faults = |all: &[&[(Kind, f64)]]| {
            let comparisons = all.iter().map(|readings| comparison(readings)).collect();
            Erratum { anchor: "a", comparisons }.faults()
        };
        assert!(faults(&[both]).is_empty() && faults(&[both, both]).is_empty());
        for lacking in [[both, literal], [right, both]] {
            assert_eq!(faults(&lacking), ["erratum a: no literal reading beside a right one"]);
        }
        assert_eq!(faults(&[]).len(), 1);
    }

    #[test]
    fn an_erratum_is_shown_as_a_table_a_comparison() {
        let readings = vec![Reading { latex: "a = b", values: vec![1.0, 2.5], ..reading(Kind::Right, 0.125) }];
        let comparison = Comparison { readings, ..at("$a = 1$", "law") };
        let head =
            "*Point:* $a = 1$. *Law:* law.\n\n| Reading | Equation | Value | Off the law by |\n|---|---|---|---|\n";
        let expected = format!("{head}| x | $a = b$ | 1, 2.5 | 0.125 |\n\n");
        assert_eq!(Erratum { anchor: "a", comparisons: vec![comparison] }.markdown(), expected);
    }
}
