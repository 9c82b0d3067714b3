//! A fault, and where its switch goes.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A change of a source that a test ought to notice.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fault {
    /// Its name: that of the list, or `file:line:column`.
    pub(super) id: String,
    /// The area that it belongs to.
    pub(super) area: String,
    /// The file, from the root, with forward slashes.
    pub(super) file: String,
    /// The line, from 1.
    pub(super) line: usize,
    /// What stands there.
    pub(super) was: String,
    /// What stands there instead.
    pub(super) becomes: String,
    /// Why nothing can notice it, if so.
    pub(super) equivalent: Option<String>,
    /// Where it can be planted, the smallest place first. What the compiler refuses in one place it may take in a larger one.
    pub(super) places: Vec<Place>,
}

impl Fault {
    /// A number that is the same on every machine, and that a change elsewhere in the file leaves as it is (FNV-1a).
    pub(super) fn hash(&self, seed: u64) -> u64 {
        let whole = self.places.last().map_or("", |place| place.text.as_str());
        let words = [self.file.as_str(), self.was.as_str(), self.becomes.as_str(), whole];
        let bytes = words.iter().flat_map(|word| word.bytes().chain([0]));
        bytes.fold(0xcbf2_9ce4_8422_2325 ^ seed, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }
}

/// A part of a source that is there twice, as it was and with the fault.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Place {
    /// The bytes that are replaced.
    pub(super) range: Range<usize>,
    /// The text with the fault.
    pub(super) text: String,
    pub(super) shape: Shape,
}

/// What a part of a source is, which decides how a switch is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// A value.
    Expression,
    /// A value behind which no semicolon stands, as that of a block or of an arm: parentheses could be taken for a call there.
    Bare,
    /// An expression whose value is not used.
    Statement,
    /// The block of a function, with its braces.
    Body,
}

impl Shape {
    /// What stands before the fault, between it and what was, and behind.
    pub(super) fn switch(self, number: usize) -> [String; 3] {
        let asked = format!("if ::planted::at({number}) {{ ");
        let [before, between, after] = match self {
            Self::Expression => ["(", " } else { ", " })"],
            Self::Bare => ["", " } else { ", " }"],
            Self::Statement => ["", " } else { ", "; }"],
            Self::Body => ["{ ", " } else ", " }"],
        };
        [before.to_owned() + &asked, between.to_owned(), after.to_owned()]
    }
}

/// What came of a fault.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum Verdict {
    /// This test failed.
    Killed(String),
    /// This test, or one of those run with it, took far too long or too much memory, or ended without a word.
    Stopped(String),
    /// So many tests that come to it were run, and none failed.
    Survived(usize),
    /// Nothing can notice it, and this is why.
    Equivalent(String),
}

/// A fault and what came of it, as it is kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Judged {
    pub(super) id: String,
    pub(super) area: String,
    pub(super) file: String,
    pub(super) line: usize,
    pub(super) was: String,
    pub(super) becomes: String,
    /// What tells it from the other faults of its file, wherever it has moved to since; 0 where that was not kept.
    #[serde(default)]
    pub(super) hash: u64,
    pub(super) verdict: Verdict,
}

impl Judged {
    pub(super) fn new(fault: &Fault, verdict: Verdict) -> Self {
        let hash = fault.hash(0);
        let Fault { id, area, file, line, was, becomes, .. } = fault.clone();
        Self { id, area, file, line, was, becomes, hash, verdict }
    }

    /// Where it is, and what is changed, in a line.
    pub(super) fn change(&self) -> String {
        let Self { file, line, .. } = self;
        format!("{file}:{line}: {} → {}", short(&self.was), short(&self.becomes))
    }
}

/// The characters of a change that are shown.
const SHOWN: usize = 60;

/// A text in a line, cut where it is long.
fn short(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(SHOWN) {
        _ if line.is_empty() => "nothing".into(),
        Some((end, _)) => format!("`{}…`", &line[..end]),
        None => format!("`{line}`"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(places: &[&str]) -> Fault {
        let place = |text: &&str| Place { range: 0..1, text: (*text).to_owned(), shape: Shape::Expression };
        Fault {
            id: "a.b".into(),
            area: "a".into(),
            file: "src/a.rs".into(),
            line: 3,
            was: "+".into(),
            becomes: "-".into(),
            equivalent: None,
            places: places.iter().map(place).collect(),
        }
    }

    /// The numbers are those of FNV-1a, computed by another program, of the words with a 0 behind each.
    #[test]
    fn a_hash_is_of_the_change_and_of_the_largest_place_that_it_stands_in() {
        let one = fault(&["-", "b - c"]);
        assert_eq!([one.hash(0), one.hash(7)], [0x8d4a_7cfb_315f_1ccc, 0xea74_7c58_ef43_d34d]);
        assert_eq!(fault(&[]).hash(0), 0xa9e7_0d13_a1e9_1338);
        // Wherever it has moved to, and whatever it is called.
        assert_eq!(Fault { id: "c".into(), line: 9, ..one.clone() }.hash(0), one.hash(0));
        let kept = Judged::new(&one, Verdict::Survived(2));
        assert_eq!((kept.hash, kept.line, kept.verdict), (one.hash(0), 3, Verdict::Survived(2)));
    }

    #[test]
    fn a_change_is_shown_in_a_line_that_is_not_too_long() {
        let change = |was: &str| {
            let fault = Fault { was: was.into(), becomes: String::new(), ..fault(&[]) };
            Judged::new(&fault, Verdict::Survived(0)).change()
        };
        assert_eq!(change("a  +\n    b"), "src/a.rs:3: `a + b` → nothing");
        assert_eq!(change(&"é".repeat(60)), format!("src/a.rs:3: `{}` → nothing", "é".repeat(60)));
        assert_eq!(change(&"é".repeat(61)), format!("src/a.rs:3: `{}…` → nothing", "é".repeat(60)));
    }

    #[test]
    fn a_switch_is_written_as_what_it_stands_for() {
        let written = |shape: Shape| {
            let [before, between, after] = shape.switch(4);
            format!("{before}FAULT{between}WAS{after}")
        };
        assert_eq!(written(Shape::Expression), "(if ::planted::at(4) { FAULT } else { WAS })");
        assert_eq!(written(Shape::Bare), "if ::planted::at(4) { FAULT } else { WAS }");
        assert_eq!(written(Shape::Statement), "if ::planted::at(4) { FAULT } else { WAS; }");
        assert_eq!(written(Shape::Body), "{ if ::planted::at(4) { FAULT } else WAS }");
    }
}
