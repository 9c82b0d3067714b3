//! The text of a scene, and which place of the deck each part of it is from.

use super::source::Place;

#[derive(Default)]
pub(super) struct Text {
    pub(super) json: String,
    /// Offsets in the text, ascending, and the place from which what follows is.
    marks: Vec<(usize, Place)>,
}

/// What opens and closes an object or an array.
pub(super) type Brackets = [char; 2];
pub(super) const OBJECT: Brackets = ['{', '}'];
pub(super) const ARRAY: Brackets = ['[', ']'];

impl Text {
    /// What follows is from this place.
    pub(super) fn from(&mut self, place: Place) -> &mut Self {
        self.marks.push((self.json.len(), place));
        self
    }

    /// A string in quotes.
    pub(super) fn string(&mut self, text: &str) {
        let plain = text.bytes().all(|byte| (b' '..=b'~').contains(&byte) && byte != b'"' && byte != b'\\');
        if plain {
            self.json.push('"');
            self.json.push_str(text);
            self.json.push('"');
        } else {
            self.json.push_str(&serde_json::Value::from(text).to_string());
        }
    }

    /// A number with as many digits as give it back. One that is not finite is written so that the reader of scenes refuses it.
    pub(super) fn number(&mut self, number: f64) {
        use std::fmt::Write;
        let number = if number.is_nan() { 0.0 } else { number };
        // Writing to a string cannot fail.
        let _ = match number {
            f64::INFINITY => self.json.write_str("1e999"),
            f64::NEG_INFINITY => self.json.write_str("-1e999"),
            _ => write!(self.json, "{number:?}"),
        };
    }

    pub(super) fn key(&mut self, key: &str) {
        self.string(key);
        self.json.push_str(": ");
    }

    /// Items in brackets, each in a line of its own if `lines`.
    pub(super) fn list<T>(
        &mut self,
        [open, close]: Brackets,
        lines: bool,
        items: impl IntoIterator<Item = T>,
        mut each: impl FnMut(&mut Self, T),
    ) {
        self.json.push(open);
        let mut any = false;
        for item in items {
            self.json.push_str(match (lines, any) {
                (true, true) => ",\n    ",
                (true, false) => "\n    ",
                (false, true) => ", ",
                (false, false) if open == '{' => " ",
                (false, false) => "",
            });
            any = true;
            each(self, item);
        }
        self.json.push_str(match (lines, any) {
            (true, true) => "\n  ",
            (false, true) if open == '{' => " ",
            _ => "",
        });
        self.json.push(close);
    }

    /// The place from which the character at a line and column of the text is, if it is from one.
    pub(super) fn origin(&self, line: usize, column: usize) -> Option<Place> {
        let start = match line.checked_sub(2) {
            None => 0,
            Some(before) => self.json.match_indices('\n').nth(before)?.0 + 1,
        };
        let offset = self.json[start..].char_indices().nth(column - 1).map_or(self.json.len(), |(at, _)| start + at);
        let next = self.marks.partition_point(|&(at, _)| at <= offset);
        Some(self.marks[next.checked_sub(1)?].1)
    }
}
