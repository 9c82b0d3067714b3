//! Fields between commas: labels and numbers.

use super::source::Place;
use std::borrow::Cow;

/// A field of a line, without the blanks around it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field<'t> {
    pub(super) text: &'t str,
    pub(super) place: Place,
}

/// The fields of a line that begins at a place. A comma at the end is followed by nothing.
pub(super) fn fields(text: &str, place: Place) -> impl Iterator<Item = Field<'_>> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let line = rest?;
        let start = text.len() - line.len();
        let mut quoted = false;
        let comma = line.bytes().position(|byte| {
            quoted ^= byte == b'"';
            byte == b',' && !quoted
        });
        let field = &line[..comma.unwrap_or(line.len())];
        rest = comma.map(|comma| &line[comma + 1..]).filter(|rest| !rest.trim().is_empty());
        let trimmed = field.trim_start();
        let place = place.after(start + field.len() - trimmed.len());
        Some(Field { text: trimmed.trim_end(), place })
    })
}

/// A name: as it is written, and as it is compared. Only a name in quotes has blanks, and upper and lower case.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Label {
    pub(super) shown: String,
    pub(super) key: String,
}

impl Label {
    /// `None` if it is empty, or if a quote is not closed. A name in an instance, `instance.name`, may have quotes around each.
    pub(super) fn new(text: &str) -> Option<Self> {
        let Some((instance, rest)) = Self::split(text) else {
            return Self::one(text).filter(|_| !text.trim_start().starts_with('.'));
        };
        let rest = Self::one(rest)?;
        let [shown, key] = [(instance.shown, rest.shown), (instance.key, rest.key)].map(|(a, b)| format!("{a}.{b}"));
        Some(Self { shown, key })
    }

    fn one(text: &str) -> Option<Self> {
        let quoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        let shown = quoted.map_or_else(|| without_blanks(text), Cow::Borrowed);
        let key = if quoted.is_some() { shown.clone().into() } else { shown.to_uppercase() };
        (!shown.is_empty() && !shown.contains('"')).then(|| Self { shown: shown.into(), key })
    }

    /// The name of an instance and that of something in it, separated by the first period that is not in quotes.
    pub(super) fn split(text: &str) -> Option<(Self, &str)> {
        let mut quoted = false;
        let period = text.bytes().position(|byte| {
            quoted ^= byte == b'"';
            byte == b'.' && !quoted
        })?;
        Some((Self::one(text[..period].trim())?, text[period + 1..].trim()))
    }
}

/// The text without blanks.
pub(super) fn without_blanks(text: &str) -> Cow<'_, str> {
    if text.contains(char::is_whitespace) { text.split_whitespace().collect::<String>().into() } else { text.into() }
}

/// A number, whose exponent may be marked by D as in Fortran; infinite if no double can hold it.
pub(super) fn number(text: &str) -> Option<f64> {
    if !text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eEdD".contains(&byte)) {
        return None;
    }
    if text.contains(['d', 'D']) { text.replace(['d', 'D'], "e").parse().ok() } else { text.parse().ok() }
}

/// The number of a node or an element.
pub(super) fn identifier(text: &str) -> Option<u32> {
    if text.bytes().all(|byte| byte.is_ascii_digit()) { text.parse().ok().filter(|&number| number > 0) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_what_is_between_commas_that_are_not_in_quotes() {
        let all = |text| {
            let all = fields(text, Place { file: 0, at: 10 });
            all.map(|field| (field.text.to_owned(), field.place.at - 10)).collect::<Vec<_>>()
        };
        let of = |fields: &[(&str, u32)]| fields.iter().map(|&(text, at)| (text.to_owned(), at)).collect::<Vec<_>>();
        assert_eq!(all(" 1, 2.5,,\t4 ,"), of(&[("1", 1), ("2.5", 4), ("", 8), ("4", 10)]));
        assert_eq!(all("\"a, b\", c, "), of(&[("\"a, b\"", 0), ("c", 8)]));
        assert_eq!(all(""), of(&[("", 0)]));
        assert_eq!(all(" , 2"), of(&[("", 1), ("2", 3)]));
    }

    #[test]
    fn only_names_in_quotes_have_blanks_and_cases() {
        let label = |text: &str| Label::new(text).map(|label| (label.shown, label.key));
        assert_eq!(label("Rail 1"), Some(("Rail1".into(), "RAIL1".into())));
        assert_eq!(label("\"Rail 1\""), Some(("Rail 1".into(), "Rail 1".into())));
        assert_eq!([label(""), label("\"a"), label("a\""), label("\"\""), label("\"a\"b\"")], [const { None }; 5]);
        let (instance, rest) = Label::split("\"Door. 1\" . 7").unwrap();
        assert_eq!((&*instance.shown, rest), ("Door. 1", "7"));
        assert!(Label::split("\"a.b\"").is_none());
        assert_eq!(label("\"Door 1\".pins"), Some(("Door 1.pins".into(), "Door 1.PINS".into())));
        assert_eq!([label("\"Door 1\"."), label(".pins")], [const { None }; 2]);
    }

    #[test]
    fn numbers_may_have_exponents_of_fortran() {
        for (text, value) in
            [("1", 1.0), ("-.5", -0.5), ("2.", 2.0), ("1d3", 1000.0), ("-2.5D-1", -0.25), ("+1E2", 100.0)]
        {
            assert_eq!(number(text), Some(value), "{text}");
        }
        assert_eq!(number("1e999"), Some(f64::INFINITY));
        assert_eq!(["", "x", "nan", "inf", "1,", "1 2", "0x1", "1.2.3", "d"].map(number), [None; 9]);
        assert_eq!(["7", "0", "-1", "1.0", "", "4294967296"].map(identifier), [Some(7), None, None, None, None, None]);
    }
}
