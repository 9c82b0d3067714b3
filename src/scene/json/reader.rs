//! The position of a reader in the text, and the faults that it has found.

use super::fault::{Fault, Faults};
use crate::formula::error::Error;
use crate::scene::angles::AngleUnit;
use std::borrow::Cow;
use std::fmt::Write;

/// Reading ends, as the text is not JSON from here on; the fault has been recorded.
#[derive(Debug)]
pub(in crate::scene) struct Stop;

pub(in crate::scene) type Read<T> = Result<T, Stop>;

/// A position in the text with its JSON path.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Mark {
    pub(in crate::scene) path: String,
    place: usize,
}

/// A component of the path to a value.
pub(super) enum Segment<'t> {
    Key(Cow<'t, str>),
    Index(usize),
}

pub(in crate::scene) struct Reader<'t> {
    pub(super) text: &'t str,
    pub(super) at: usize,
    pub(super) path: Vec<Segment<'t>>,
    pub(in crate::scene) faults: Faults,
    /// The unit of the angles in the text; they are read in radians.
    pub(in crate::scene) angles: AngleUnit,
}

impl<'t> Reader<'t> {
    pub(in crate::scene) fn new(text: &'t str) -> Self {
        Self {
            text: text.strip_prefix('\u{feff}').unwrap_or(text),
            at: 0,
            path: Vec::new(),
            faults: Faults::default(),
            angles: AngleUnit::default(),
        }
    }

    /// The position at which the next value begins.
    pub(in crate::scene) fn place(&mut self) -> usize {
        self.blank();
        self.at
    }

    /// Moves to a position returned by [`place`](Self::place).
    pub(in crate::scene) fn go(&mut self, place: usize) {
        self.at = place;
    }

    /// Whether the next value begins with this byte.
    pub(in crate::scene) fn begins_with(&mut self, byte: u8) -> bool {
        self.blank();
        self.peek() == Some(byte)
    }

    /// Runs a job below a key of the path.
    pub(in crate::scene) fn below<T>(&mut self, key: &'static str, job: impl FnOnce(&mut Self) -> T) -> T {
        self.path.push(Segment::Key(key.into()));
        let result = job(self);
        self.path.pop();
        result
    }

    /// A position with its path, for a fault that is found later.
    pub(in crate::scene) fn mark(&self, place: usize) -> Mark {
        Mark { path: self.path(), place }
    }

    /// Records a fault at a position.
    pub(in crate::scene) fn fault(&mut self, place: usize, found: impl Into<String>, allowed: impl Into<String>) {
        if self.faults.has_room() {
            self.record_fault(self.path(), place, found.into(), allowed.into());
        }
    }

    /// Records a fault at a marked position.
    pub(in crate::scene) fn fault_at(&mut self, mark: Mark, found: impl Into<String>, allowed: impl Into<String>) {
        if self.faults.has_room() {
            self.record_fault(mark.path, mark.place, found.into(), allowed.into());
        }
    }

    fn record_fault(&mut self, path: String, place: usize, found: String, allowed: String) {
        let before = &self.text[..place];
        let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
        self.faults.push(Fault { path, line, column, found, allowed });
    }

    /// The JSON path of the current value.
    fn path(&self) -> String {
        let mut path = String::new();
        for segment in &self.path {
            let dot = if path.is_empty() { "" } else { "." };
            let plain = |key: &str| key.chars().all(|c| c.is_alphanumeric() || c == '_');
            // Writing to a string cannot fail.
            let _ = match segment {
                Segment::Key(key) if plain(key) => write!(path, "{dot}{key}"),
                Segment::Key(key) => write!(path, "{dot}{key:?}"),
                Segment::Index(index) => write!(path, "[{index}]"),
            };
        }
        path
    }

    /// Records the error of a typed constructor.
    pub(in crate::scene) fn reject(&mut self, place: usize, error: &Error) {
        self.fault(place, error.found(), error.allowed());
    }

    pub(super) fn stop<T>(&mut self, allowed: &str) -> Read<T> {
        let found = match self.text[self.at..].chars().next() {
            None => "the end of the file".into(),
            Some(c) => format!("{c:?}"),
        };
        self.fault(self.at, found, allowed);
        Err(Stop)
    }

    pub(super) fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    pub(super) fn blank(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    pub(super) fn take(&mut self, byte: u8) -> bool {
        self.blank();
        let there = self.peek() == Some(byte);
        self.at += usize::from(there);
        there
    }
}

/// A value as written in the file, shortened.
pub(super) fn excerpt(value: &str) -> String {
    const SHOWN: usize = 40;
    match value.char_indices().nth(SHOWN) {
        None => value.to_owned(),
        Some((cut, _)) => format!("{}…", &value[..cut]),
    }
}
