//! A strict JSON reader that knows where it is.
//!
//! It pulls values of the type that the caller expects, so nothing is kept that is not wanted, and nothing recurses: a
//! scene of any size is read in one pass, and brackets without end meet the depth limit. A value of the wrong type is a
//! [`Fault`] and is stepped over, so that one run finds all mistakes; text that is not JSON ends the reading.

use super::fault::{Fault, Faults};
use crate::error::Error;
use crate::quantity::Domain;
use std::fmt::Write;

mod token;
use token::excerpt;

/// The text is not JSON from here on; the fault is recorded.
#[derive(Debug)]
pub(super) struct Stop;

pub(super) type Read<T> = Result<T, Stop>;

enum Segment {
    Key(String),
    Index(usize),
}

pub(super) struct Reader<'t> {
    text: &'t str,
    at: usize,
    path: Vec<Segment>,
    pub(super) faults: Faults,
}

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { text: text.strip_prefix('\u{feff}').unwrap_or(text), at: 0, path: Vec::new(), faults: Faults::default() }
    }

    /// Where the next value begins.
    pub(super) fn place(&mut self) -> usize {
        self.blank();
        self.at
    }

    /// Goes to a place that [`place`](Self::place) gave.
    pub(super) fn go(&mut self, place: usize) {
        self.at = place;
    }

    /// Does something below a key of the path.
    pub(super) fn below<T>(&mut self, key: &str, job: impl FnOnce(&mut Self) -> T) -> T {
        self.path.push(Segment::Key(key.into()));
        let result = job(self);
        self.path.pop();
        result
    }

    /// Records a fault at a place.
    pub(super) fn fault(&mut self, place: usize, found: impl Into<String>, allowed: impl Into<String>) {
        if !self.faults.room() {
            return;
        }
        let before = self.text.get(..place).unwrap_or(self.text);
        let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
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
        self.faults.push(Fault { path, line, column, found: found.into(), allowed: allowed.into() });
    }

    /// Records what a typed constructor says.
    pub(super) fn reject(&mut self, place: usize, error: &Error) {
        self.fault(place, error.found(), error.allowed());
    }

    fn stop<T>(&mut self, allowed: &str) -> Read<T> {
        let found = match self.text.get(self.at..).and_then(|rest| rest.chars().next()) {
            None => "the end of the file".into(),
            Some(c) => format!("{c:?}"),
        };
        self.fault(self.at, found, allowed);
        Err(Stop)
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn blank(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    fn take(&mut self, byte: u8) -> bool {
        self.blank();
        let there = self.peek() == Some(byte);
        self.at += usize::from(there);
        there
    }

    /// Steps over a value of the wrong type and says so.
    fn mistyped(&mut self, allowed: &str) -> Read<()> {
        let place = self.place();
        let found = match self.peek() {
            Some(b'{') => "an object".into(),
            Some(b'[') => "an array".into(),
            _ => String::new(),
        };
        self.skip()?;
        let found = if found.is_empty() { excerpt(self.text.get(place..self.at).unwrap_or_default()) } else { found };
        self.fault(place, found, allowed);
        Ok(())
    }

    /// The members of an object, each with the place of its key; `false` if it is something else.
    pub(super) fn object(
        &mut self,
        allowed: &str,
        mut member: impl FnMut(&mut Self, &str, usize) -> Read<()>,
    ) -> Read<bool> {
        if !self.take(b'{') {
            self.mistyped(allowed)?;
            return Ok(false);
        }
        if self.take(b'}') {
            return Ok(true);
        }
        loop {
            let place = self.place();
            if self.peek() != Some(b'"') {
                return self.stop("a name in double quotes");
            }
            let key = self.quoted()?;
            if !self.take(b':') {
                return self.stop("a colon");
            }
            self.path.push(Segment::Key(key.clone()));
            let result = member(self, &key, place);
            self.path.pop();
            result?;
            if self.take(b'}') {
                return Ok(true);
            }
            if !self.take(b',') {
                return self.stop("a comma or a closing brace");
            }
        }
    }

    /// The members of an object with fixed names; `member` is called with the index of the name.
    pub(super) fn record(
        &mut self,
        names: &[&str],
        mut member: impl FnMut(&mut Self, usize) -> Read<()>,
    ) -> Read<bool> {
        let mut seen = vec![false; names.len()];
        self.object("an object", |reader, key, place| match names.iter().position(|&name| name == key) {
            None => {
                reader.fault(place, format!("unknown key {key:?}"), format!("one of {}", names.join(", ")));
                reader.skip()
            }
            Some(index) if seen[index] => {
                reader.fault(place, format!("{key:?} for the second time"), "each key once");
                reader.skip()
            }
            Some(index) => {
                seen[index] = true;
                member(reader, index)
            }
        })
    }

    /// The items of an array; `false` if it is something else.
    pub(super) fn array(&mut self, allowed: &str, mut item: impl FnMut(&mut Self, usize) -> Read<()>) -> Read<bool> {
        if !self.take(b'[') {
            self.mistyped(allowed)?;
            return Ok(false);
        }
        if self.take(b']') {
            return Ok(true);
        }
        for index in 0.. {
            self.path.push(Segment::Index(index));
            let result = item(self, index);
            self.path.pop();
            result?;
            if self.take(b']') {
                break;
            }
            if !self.take(b',') {
                return self.stop("a comma or a closing bracket");
            }
        }
        Ok(true)
    }

    /// A string.
    pub(super) fn string(&mut self, allowed: &str) -> Read<Option<String>> {
        self.blank();
        if self.peek() == Some(b'"') {
            return self.quoted().map(Some);
        }
        self.mistyped(allowed).map(|()| None)
    }

    /// A number of a domain.
    pub(super) fn number(&mut self, domain: Domain) -> Read<Option<f64>> {
        let place = self.place();
        let Some(number) = self.numeral()? else {
            return self.mistyped(&domain.allowed()).map(|()| None);
        };
        if Error::check("", None, number, domain).is_err() {
            let found = excerpt(self.text.get(place..self.at).unwrap_or_default());
            let beyond = if number.is_finite() { "" } else { ", which no double can hold" };
            self.fault(place, format!("{found}{beyond}"), domain.allowed());
            return Ok(None);
        }
        Ok(Some(number))
    }

    /// An array of exactly `N` finite numbers.
    pub(super) fn vector<const N: usize>(&mut self) -> Read<Option<[f64; N]>> {
        let place = self.place();
        let allowed = format!("an array of {N} numbers");
        let (mut vector, mut count, mut sound) = ([0.0; N], 0, true);
        let is_array = self.array(&allowed, |reader, index| {
            count += 1;
            match reader.number(Domain::Real)? {
                Some(number) => vector.get_mut(index).into_iter().for_each(|slot| *slot = number),
                None => sound = false,
            }
            Ok(())
        })?;
        if is_array && count != N {
            self.fault(place, format!("an array of {count}"), allowed);
        }
        Ok((is_array && sound && count == N).then_some(vector))
    }

    /// The end of the text.
    pub(super) fn end(&mut self) -> Read<()> {
        self.blank();
        if self.at < self.text.len() { self.stop("nothing after the scene") } else { Ok(()) }
    }
}
