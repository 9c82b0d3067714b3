//! Answers of a program at a point, parsed from plain lines.

use judge::{Answer, Manners, Question};

/// The notation of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Digits {
    Decimal,
    /// The bits, as 16 hexadecimal digits.
    Hex,
}

impl Digits {
    /// A question as a plain line.
    pub(super) fn line(self, question: &Question) -> String {
        let directions = question.directions.iter().flatten().flatten();
        let numbers: Vec<_> = question.inputs.iter().chain(directions).map(|&x| self.show(x)).collect();
        numbers.join(" ")
    }

    /// A number as written in questions, which reads back as the same number.
    pub(super) fn show(self, x: f64) -> String {
        match self {
            Self::Hex => format!("{:016X}", x.to_bits()),
            Self::Decimal => match x {
                f64::INFINITY => "Infinity".into(),
                f64::NEG_INFINITY => "-Infinity".into(),
                x => format!("{x:?}"),
            },
        }
    }
}

/// Parses a line that should contain `expected` numbers.
pub(super) fn read(line: &str, expected: usize, digits: Digits, manners: &mut Manners) -> Answer {
    if let Some(numbers) = plain(line).filter(|numbers| digits == Digits::Decimal && numbers.len() == expected) {
        return Answer::Numbers(numbers);
    }
    if let Some(name) = refusal(line) {
        return Answer::Refused(name);
    }
    if let Some(what) = fault(line) {
        return Answer::Bad(what.to_owned());
    }
    let mut seen = Manners::new();
    let mut numbers = Vec::new();
    for token in tokens(line) {
        match number(token, digits, &mut seen) {
            Some(number) => numbers.push(number),
            None => return Answer::Bad(format!("`{}` is no number", shortened(token))),
        }
    }
    if numbers.len() != expected {
        return Answer::Bad(count_is(numbers.len(), expected));
    }
    for (manner, count) in seen {
        *manners.entry(manner).or_default() += count;
    }
    Answer::Numbers(numbers)
}

/// Parses numbers separated only by blanks, as in nearly every line: this is several times faster than the general case.
fn plain(line: &str) -> Option<Vec<Option<f64>>> {
    let mut numbers = Vec::new();
    for token in line.split(' ') {
        if !token.is_empty() {
            numbers.push(Some(token.parse().ok()?));
        }
    }
    Some(numbers)
}

/// Whether a line is a rejection, and the input it names.
#[expect(clippy::option_option, reason = "no refusal, and one that names nothing")]
fn refusal(line: &str) -> Option<Option<String>> {
    let mut words = line.split_whitespace();
    let first = words.next()?.to_ascii_lowercase();
    let name = || Some(words.next().map(str::to_owned));
    matches!(first.as_str(), "refuse" | "refused" | "refuses").then(name).flatten()
}

/// The mistake that a driver has found in how a routine uses its interface.
fn fault(line: &str) -> Option<&str> {
    line.trim_start().strip_prefix("fault ").map(str::trim)
}

/// Whether a line is an answer without numbers.
pub(super) fn is_without_numbers(line: &str) -> bool {
    refusal(line).is_some() || fault(line).is_some()
}

/// The tokens of a line, whatever separates them.
pub(super) fn tokens(line: &str) -> impl Iterator<Item = &str> {
    let parts = line.split(|c: char| c.is_whitespace() || c == ';' || c == '\0');
    parts.map(|token| token.trim_end_matches(',')).filter(|token| !token.is_empty())
}

/// Whether a token can be parsed as a number.
pub(super) fn is_number(token: &str, digits: Digits) -> bool {
    number(token, digits, &mut Manners::new()).is_some()
}

/// Parses a number in any unambiguous notation; `Some(None)` for one that is not computed.
#[expect(clippy::option_option, reason = "no number, and a number that is not given")]
fn number(token: &str, digits: Digits, seen: &mut Manners) -> Option<Option<f64>> {
    if matches!(token, "-" | "skip" | "skipped") {
        return Some(None);
    }
    if digits == Digits::Hex {
        let bits = token.trim_start_matches("0x");
        let bits = (bits.len() <= 16).then(|| u64::from_str_radix(bits, 16).ok()).flatten()?;
        return Some(Some(f64::from_bits(bits)));
    }
    if let Ok(x) = token.parse() {
        return Some(Some(x));
    }
    let mut note = |manner| *seen.entry(manner).or_default() += 1;
    let mut text = token.to_ascii_lowercase();
    if let Some(x) = special(&text) {
        note("NaN or infinity in a spelling of its own");
        return Some(Some(x));
    }
    if text.contains('d') {
        note("D exponents");
        text = text.replace('d', "e");
    }
    if text.matches(',').count() == 1 && !text.contains('.') {
        note("a comma as decimal point");
        text = text.replace(',', ".");
    }
    if let Ok(x) = text.parse() {
        return Some(Some(x));
    }
    // Fortran omits the letter if the exponent has three digits.
    let sign = text.rfind(['+', '-']).filter(|&at| at > 0)?;
    let (mantissa, exponent) = text.split_at(sign);
    let x = format!("{mantissa}e{exponent}").parse().ok()?;
    note("exponents without a letter");
    Some(Some(x))
}

/// NaN and infinities as written by C libraries and Fortran, in addition to the common spellings.
fn special(text: &str) -> Option<f64> {
    let (infinity, text) = text.strip_prefix('-').map_or((f64::INFINITY, text), |text| (f64::NEG_INFINITY, text));
    let text = text.trim_start_matches('+');
    if text.starts_with("nan") || text.starts_with("snan") || text.starts_with("qnan") {
        return Some(f64::NAN);
    }
    match text.strip_prefix("1.#")? {
        infinite if infinite.starts_with("inf") => Some(infinity),
        _ => Some(f64::NAN),
    }
}

fn shortened(token: &str) -> String {
    if token.chars().count() <= 30 { token.to_owned() } else { token.chars().take(30).chain(['…']).collect() }
}

/// The fault of an answer with another count of numbers.
pub(super) fn count_is(found: usize, expected: usize) -> String {
    format!("{found} numbers instead of {expected}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(line: &str) -> (Answer, Manners) {
        let mut manners = Manners::new();
        (read(line, 2, Digits::Decimal, &mut manners), manners)
    }

    #[track_caller]
    fn reads(line: &str, [x, y]: [f64; 2], manner: Option<&'static str>) {
        let (answer, manners) = numbers(line);
        let Answer::Numbers(found) = answer else { panic!("{line}: {answer:?}") };
        let bits = |x: f64| if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() };
        let found: Vec<_> = found.into_iter().flatten().map(bits).collect();
        assert_eq!(found, [bits(x), bits(y)], "{line}");
        assert_eq!(manners.into_keys().collect::<Vec<_>>(), manner.into_iter().collect::<Vec<_>>(), "{line}");
    }

    #[test]
    fn numbers_are_read_in_every_spelling_without_doubt() {
        reads("1.5 -2e3", [1.5, -2e3], None);
        reads("  1.5,  -0.0 ", [1.5, -0.0], None);
        reads("1.5D+02 2", [150.0, 2.0], Some("D exponents"));
        reads("1.5-102 2", [1.5e-102, 2.0], Some("exponents without a letter"));
        reads("1+300 -2-300", [1e300, -2e-300], Some("exponents without a letter"));
        reads("0,5 2", [0.5, 2.0], Some("a comma as decimal point"));
        reads("NaN +Infinity", [f64::NAN, f64::INFINITY], None);
        reads("-nan(ind) 1.#INF", [f64::NAN, f64::INFINITY], Some("NaN or infinity in a spelling of its own"));
        reads("-1.#INF 1.#QNAN", [f64::NEG_INFINITY, f64::NAN], Some("NaN or infinity in a spelling of its own"));
    }

    #[test]
    fn what_is_no_answer_is_named() {
        let bad = |line: &str| match numbers(line).0 {
            Answer::Bad(what) => what,
            answer => panic!("{line}: {answer:?}"),
        };
        assert_eq!(bad("1 2 3"), "3 numbers instead of 2");
        assert_eq!(bad(""), "0 numbers instead of 2");
        assert_eq!(bad("1 ********"), "`********` is no number");
        assert_eq!(bad("1,5,2 3"), "`1,5,2` is no number");
        assert_eq!(bad("f = 1"), "`f` is no number");
        assert_eq!(bad(" fault DSLIP is not the slip "), "DSLIP is not the slip");
        let long = "x".repeat(31);
        assert_eq!(bad(&format!("{} 1", &long[..30])), format!("`{}` is no number", &long[..30]));
        assert_eq!(bad(&format!("{long} 1")), format!("`{}…` is no number", &long[..30]));
    }

    #[test]
    fn a_refusal_may_name_an_input() {
        assert_eq!(numbers("refuse").0, Answer::Refused(None));
        assert_eq!(numbers(" REFUSED mu").0, Answer::Refused(Some("mu".into())));
        assert_eq!(numbers("- 2").0, Answer::Numbers(vec![None, Some(2.0)]));
    }

    #[test]
    fn how_often_a_manner_is_seen_is_counted() {
        let mut manners = Manners::new();
        for (line, count) in [("1.5D+02 2d0", 2), ("1 2D0", 3), ("1 2", 3), ("3D0 what", 3)] {
            read(line, 2, Digits::Decimal, &mut manners);
            assert_eq!(manners, Manners::from([("D exponents", count)]), "{line}");
        }
    }

    #[test]
    fn numbers_are_apart_by_blanks_commas_semicolons_and_what_ends_a_text() {
        for line in ["1;2", "1\t2", "1, 2", "1\0 2", ";1;;2;"] {
            reads(line, [1.0, 2.0], None);
        }
    }

    #[test]
    fn numbers_are_asked_so_that_every_language_reads_them() {
        let shown = [0.1, -2.0, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(|x| Digits::Decimal.show(x));
        assert_eq!(shown, ["0.1", "-2.0", "1e300", "Infinity", "-Infinity", "NaN"]);
    }

    #[test]
    fn bits_are_read_and_written() {
        let mut manners = Manners::new();
        assert!(is_number("0x3ff0000000000000", Digits::Hex) && !is_number("0x03ff0000000000000", Digits::Hex));
        for x in [0.1, -0.0, f64::INFINITY, 5e-324] {
            let line = Digits::Hex.show(x);
            let Answer::Numbers(found) = read(&line, 1, Digits::Hex, &mut manners) else { panic!("{line}") };
            assert_eq!(found[0].map(f64::to_bits), Some(x.to_bits()));
        }
    }
}
