//! The tokens of JSON, and the skipping of values.

use super::reader::{Read, Reader, Stop, excerpt};
use std::borrow::Cow;

/// The maximum nesting depth of a value; a scene needs 5.
const DEPTH: usize = 32;

impl<'t> Reader<'t> {
    /// Skips any value, without recursion.
    pub(in crate::scene) fn skip(&mut self) -> Read<()> {
        let mut open: Vec<u8> = Vec::new();
        loop {
            self.blank();
            match self.peek() {
                Some(bracket @ (b'{' | b'[')) => {
                    if open.len() + self.path.len() >= DEPTH {
                        self.fault(self.at, "one more level of nesting", format!("a depth of {DEPTH}"));
                        return Err(Stop);
                    }
                    self.at += 1;
                    // The codes of an ASCII bracket and of its closing bracket differ by two.
                    open.push(bracket + 2);
                    self.blank();
                    if self.peek() != open.last().copied() {
                        self.name_in(&open)?;
                        continue;
                    }
                }
                Some(b'"') => drop(self.quoted()?),
                _ => self.plain()?,
            }
            // A value has ended; the enclosing values may end as well.
            while let Some(&close) = open.last() {
                if self.take(b',') {
                    self.name_in(&open)?;
                    break;
                }
                if !self.take(close) {
                    return self.stop("a comma or the closing bracket");
                }
                open.pop();
            }
            if open.is_empty() {
                return Ok(());
            }
        }
    }

    /// Skips the name of the next member if the innermost bracket is a brace.
    fn name_in(&mut self, open: &[u8]) -> Read<()> {
        if open.last() != Some(&b'}') {
            return Ok(());
        }
        self.blank();
        if self.peek() != Some(b'"') {
            return self.stop("a name in double quotes");
        }
        self.quoted()?;
        if self.take(b':') { Ok(()) } else { self.stop("a colon") }
    }

    /// Skips a number, `true`, `false` or `null`.
    fn plain(&mut self) -> Read<()> {
        for word in ["true", "false", "null"] {
            if self.text[self.at..].starts_with(word) {
                self.at += word.len();
                return Ok(());
            }
        }
        if self.numeral()?.is_some() { Ok(()) } else { self.stop("a JSON value") }
    }

    /// A number in JSON notation: −, digits without leading zeros, fraction, exponent.
    pub(super) fn numeral(&mut self) -> Read<Option<f64>> {
        self.blank();
        let start = self.at;
        self.at += usize::from(self.peek() == Some(b'-'));
        let whole = self.digits();
        if whole == 0 {
            if self.at > start {
                return self.stop("a digit after the minus sign");
            }
            return Ok(None);
        }
        if whole > 1 && self.text.as_bytes().get(self.at - whole) == Some(&b'0') {
            self.at -= whole - 1;
            return self.stop("a number without leading zeros");
        }
        if self.peek() == Some(b'.') {
            self.at += 1;
            if self.digits() == 0 {
                return self.stop("a digit after the point");
            }
        }
        if matches!(self.peek(), Some(b'e' | b'E')) {
            self.at += 1;
            self.at += usize::from(matches!(self.peek(), Some(b'+' | b'-')));
            if self.digits() == 0 {
                return self.stop("a digit in the exponent");
            }
        }
        Ok(Some(self.text[start..self.at].parse().expect("Rust reads every numeral that JSON writes")))
    }

    fn digits(&mut self) -> usize {
        let start = self.at;
        while matches!(self.peek(), Some(b'0'..=b'9')) {
            self.at += 1;
        }
        self.at - start
    }

    /// A string, whose opening quote is next. The text between the quotes is decoded by `serde_json`.
    pub(super) fn quoted(&mut self) -> Read<Cow<'t, str>> {
        let start = self.at;
        let mut has_escapes = false;
        self.at += 1;
        loop {
            match self.peek() {
                Some(b'"') => break,
                // Whatever the escape means, a quote after it does not close the string.
                Some(b'\\') => {
                    has_escapes = true;
                    self.at += if self.at + 1 < self.text.len() { 2 } else { 1 };
                }
                Some(byte) if byte >= b' ' => self.at += 1,
                _ => return self.stop("a closing quote"),
            }
        }
        self.at += 1;
        let inside = &self.text[start + 1..self.at - 1];
        if !has_escapes {
            return Ok(Cow::Borrowed(inside));
        }
        let quoted = &self.text[start..self.at];
        serde_json::from_str(quoted).map(Cow::Owned).map_err(|_| {
            self.fault(start, excerpt(quoted), "a string with JSON's escapes");
            Stop
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The position at which the reading of a value stops, and what is allowed there; `None` if the value is complete.
    fn stops<'t>(text: &'t str, read: impl Fn(&mut Reader<'t>) -> Read<()>) -> Option<(usize, usize, String)> {
        let mut reader = Reader::new(text);
        let stopped = read(&mut reader).is_err();
        assert_eq!(reader.faults.len(), usize::from(stopped), "{text}");
        reader.faults.list().first().map(|fault| (fault.line, fault.column, fault.allowed.clone()))
    }

    #[test]
    fn values_are_nested_so_deep_and_no_deeper() {
        let nested = |depth: usize| format!("{}{}", "[".repeat(depth), "]".repeat(depth));
        assert_eq!(stops(&nested(32), Reader::skip), None);
        assert_eq!(stops(&nested(33), Reader::skip), Some((1, 33, "a depth of 32".into())));
        let below = |reader: &mut Reader| reader.below("a", |reader| reader.below("b", Reader::skip));
        assert_eq!(stops(&nested(30), below), None);
        assert_eq!(stops(&nested(31), below), Some((1, 31, "a depth of 32".into())));
    }

    #[test]
    fn what_is_no_json_is_said_where_it_stands() {
        for (text, column, allowed) in [
            ("01", 2, "a number without leading zeros"),
            ("-0012", 3, "a number without leading zeros"),
            ("-x", 2, "a digit after the minus sign"),
            ("1.x", 3, "a digit after the point"),
            ("1e+x", 4, "a digit in the exponent"),
            ("\"ab", 4, "a closing quote"),
            ("\"a\\", 4, "a closing quote"),
            ("\"a\u{1f}\"", 3, "a closing quote"),
            ("{\"a\" 1}", 6, "a colon"),
            ("{\"a\": 1, 2}", 10, "a name in double quotes"),
            ("{1}", 2, "a name in double quotes"),
            ("[1 2]", 4, "a comma or the closing bracket"),
            ("[1}", 3, "a comma or the closing bracket"),
            ("tru", 1, "a JSON value"),
        ] {
            assert_eq!(stops(text, Reader::skip), Some((1, column, allowed.into())), "{text}");
        }
    }

    #[test]
    fn what_is_json_is_stepped_over() {
        for text in [
            "0",
            "-0",
            "0.5",
            "-10.25e-3",
            "1E+2",
            "true",
            "null",
            "[]",
            "{}",
            "[[], {}]",
            "\"a b\"",
            "\"a\\\"b\"",
            "{\"a\": [1, {\"b\": false}], \"c\": \"\"}",
        ] {
            let mut reader = Reader::new(text);
            assert!(reader.skip().is_ok() && reader.end().is_ok(), "{text}");
        }
    }
}
