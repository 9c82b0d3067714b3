//! Numbers and sentences in chapters that state their origin: `{{3.7 = \sqrt{13.7}}}`, `{{"it does not depend on x" in a_test}}`.

use super::markdown::{balanced, code, texts};
use std::ops::Range;

/// A number in a chapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Numeral {
    /// The number as written.
    pub(crate) written: String,
    pub(crate) origin: Origin,
    pub(crate) line: usize,
}

/// The origin of a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// `{{3.7 = expression; where}}`: the rounded value of an expression, and what the expression is about.
    Value(String, String),
    /// `{{3.7 in a_test}}`: it appears in a test that computes it, or in a constant.
    Test(String),
    /// `{{"it does not depend on x" in a_test}}`: the test that shows this quotes these words.
    Sentence(String),
    /// `{{given 3.7}}`: the text itself defines it.
    Given,
}

/// The chapter with every such number replaced by its digits, and the numbers.
pub(crate) fn shown(chapter: &str) -> (String, Vec<Numeral>) {
    let (mut out, mut all, mut done) = (String::new(), Vec::new(), 0);
    for (range, numeral) in found(chapter) {
        out.extend([&chapter[done..range.start], &numeral.written]);
        all.push(numeral);
        done = range.end;
    }
    (out + &chapter[done..], all)
}

/// Decimals and percentages that do not state their origin.
pub(crate) fn bare(chapter: &str) -> Vec<(usize, String)> {
    let mut blank = chapter.to_owned();
    for (range, _) in found(chapter) {
        blank.replace_range(range.clone(), &" ".repeat(range.len()));
    }
    let mut all = Vec::new();
    for range in texts(&blank) {
        let text = &blank[range.clone()];
        all.extend(decimals(text).map(|(at, decimal)| (line(&blank, range.start + at), decimal.to_owned())));
    }
    all
}

/// Claims of independence, equality or symmetry that no test shows.
pub(crate) fn unshown(chapter: &str) -> Vec<(usize, &'static str)> {
    let mut blank = chapter.to_owned();
    for (range, _) in found(chapter) {
        blank.replace_range(range.clone(), &" ".repeat(range.len()));
    }
    let claims = texts(&blank).into_iter().flat_map(|range| {
        let text = &blank[range.clone()];
        CLAIMS.iter().flat_map(move |claim| text.match_indices(claim).map(move |(at, _)| (range.start + at, *claim)))
    });
    claims.map(|(at, claim)| (line(&blank, at), claim)).collect()
}

/// Words of such claims.
const CLAIMS: [&str; 11] = [
    "not depend on",
    "depend only on",
    "depends only on",
    "there is no difference",
    "is symmetric",
    "are symmetric",
    "is independent of",
    "lower bound",
    "upper bound",
    "satisfied automatically",
    "beyond the ends of",
];

/// Digits with a point between them, and digits before a percent sign.
fn decimals(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let starts = text.char_indices().filter(move |&(at, c)| c.is_ascii_digit() && !text[..at].ends_with(is_part));
    starts.filter_map(move |(at, _)| {
        let rest = &text[at..];
        let length = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let (number, after) = (rest[..length].trim_end_matches('.'), &rest[length..]);
        let is_version = number.matches('.').count() > 1;
        let is_claim = number.contains('.') && !is_version || after.trim_start().starts_with('%');
        is_claim.then_some((at, number))
    })
}

/// The numbers that state their origin, outside code.
fn found(chapter: &str) -> Vec<(Range<usize>, Numeral)> {
    let opaque = code(chapter);
    let (mut all, mut from) = (Vec::new(), 0);
    while let Some(start) = chapter[from..].find("{{").map(|at| from + at) {
        from = start + 2;
        if opaque.iter().any(|range| range.contains(&start)) {
            continue;
        }
        if let Some(inside) = balanced(&chapter[start + 2..])
            && let Some(numeral) = numeral(inside, line(chapter, start))
        {
            from = start + inside.len() + 4;
            all.push((start..from, numeral));
        }
    }
    all
}

fn numeral(inside: &str, line: usize) -> Option<Numeral> {
    let of = |written: &str, origin| Numeral { written: written.trim().into(), origin, line };
    if let Some(written) = inside.strip_prefix("given ") {
        return Some(of(written, Origin::Given));
    }
    if let Some((words, test)) = inside.strip_prefix('"').and_then(|inside| inside.split_once("\" in ")) {
        return Some(of(words, Origin::Sentence(test.trim().into())));
    }
    if !inside.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    if let Some((written, test)) = inside.split_once(" in ") {
        return Some(of(written, Origin::Test(test.trim().into())));
    }
    let (written, rest) = inside.split_once('=')?;
    let (expression, about) = rest.split_once(';').unwrap_or((rest, ""));
    Some(of(written, Origin::Value(expression.trim().into(), about.trim().into())))
}

/// Whether a number, rounded to the written digits, is the written one. Trailing zeros of an integer need not be
/// exact.
pub(crate) fn is_rounded(written: &str, value: f64) -> bool {
    let plain: String = written.chars().filter(|c| !c.is_whitespace()).collect();
    let Ok(number) = plain.parse::<f64>() else { return false };
    let places = match plain.split_once('.') {
        Some((_, decimals)) => i32::try_from(decimals.len()).unwrap_or(i32::MAX),
        None => -i32::try_from(plain.len() - plain.trim_end_matches('0').len()).unwrap_or(0),
    };
    (value - number).abs() <= 0.5 * 10.0_f64.powi(-places) * (1.0 + 1e-12)
}

fn line(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count() + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_as_they_are_written() {
        let chapter =
            "About {{3.7 = \\sqrt{\\frac{a}{2}}; let a = 27}} of {{given 0.5}},\n$x = {{9.15 in areas}}$, `{{1 = 1}}`.";
        let (text, numerals) = shown(chapter);
        assert_eq!(text, "About 3.7 of 0.5,\n$x = 9.15$, `{{1 = 1}}`.");
        let value = Origin::Value(r"\sqrt{\frac{a}{2}}".into(), "let a = 27".into());
        let origins: Vec<_> = numerals.iter().map(|numeral| (numeral.line, numeral.origin.clone())).collect();
        assert_eq!(origins, [(1, value), (1, Origin::Given), (2, Origin::Test("areas".into()))]);
    }

    #[test]
    fn numbers_are_found_from_the_first_letter_on_and_outside_all_code() {
        assert_eq!(shown("{{given 3}}").0, "3");
        assert_eq!(shown("{{{{given 3}} x").0, "{{3 x");
        let code = "`{{given 1}}` {{given 2}} `{{given 3}}`";
        assert_eq!(shown(code).0, "`{{given 1}}` 2 `{{given 3}}`");
    }

    #[test]
    fn claims_are_found_with_their_lines_beside_what_is_none() {
        let chapter = "# Of 1.5\n\n[2.5](x.md) then 3.5\n\n```\n4.5\n```\n\na\nb 5.5 of {{given 6.5}}, version 1.2.3\n";
        assert_eq!(bare(chapter), [(3, "3.5".to_owned()), (10, "5.5".to_owned())]);
    }

    #[test]
    fn of_directives_captions_make_claims() {
        let chapter = "{{#speed 1.5}}\n\n{{#presentation 2.5 of it}}\n\n{{#figure a It is 3.5 wide.}}\n";
        assert_eq!(bare(chapter), [(5, "3.5".to_owned())]);
    }

    #[test]
    fn decimals_and_percentages_are_found_where_they_are_claims() {
        let found = |text| bare(text).into_iter().map(|(_, decimal)| decimal).collect::<Vec<_>>();
        assert_eq!(found("1.5 or $f = 0.2$, 20 % and {{given 3.5}} in 3 steps; `0.7`. At 3."), ["1.5", "0.2", "20"]);
        assert!(found("# Version 2.5\n\n[1.5](x.md) {{#formula a.b}}\n\n```\n1.5\n```\n\n$$\n1.5\n$$\n").is_empty());
    }

    #[test]
    fn a_number_is_what_it_is_rounded_to() {
        for (written, value, is_so) in [
            ("3.7", 3.732, true),
            ("3.8", 3.732, false),
            ("3.70", 3.704, true),
            ("1100", 1146.0, true),
            ("1200", 1146.0, false),
            ("23", 22.9, true),
            // Either rounding of a midpoint, though 0.3 − 0.25 is not exactly 0.05.
            ("0.2", 0.25, true),
            ("0.3", 0.25, true),
            ("2.68", 2.675, true),
            ("0.3", 0.2499, false),
            ("3.7", 3.76, false),
            ("1 100", 1146.0, true),
            ("1\u{a0}100", 1146.0, true),
            ("1 100", 1151.0, false),
            ("x", 1.0, false),
        ] {
            assert_eq!(is_rounded(written, value), is_so, "{written} for {value}");
        }
    }
}
