//! Values of the expected type, or a fault that reports what was found instead.

use super::reader::{Read, Reader, Segment, excerpt};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use std::borrow::Cow;
use std::fmt::Display;

impl<'t> Reader<'t> {
    /// Skips a value of the wrong type and records the fault.
    fn mistyped(&mut self, allowed: impl Display) -> Read<()> {
        let place = self.place();
        let found = match self.peek() {
            Some(b'{') => "an object".into(),
            Some(b'[') => "an array".into(),
            _ => String::new(),
        };
        self.skip()?;
        let found = if found.is_empty() { excerpt(&self.text[place..self.at]) } else { found };
        self.fault(place, found, allowed.to_string());
        Ok(())
    }

    /// The members of an object, each with the position of its key; `false` if it is something else.
    pub(in crate::scene) fn object(
        &mut self,
        allowed: impl Display,
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
    pub(in crate::scene) fn record(
        &mut self,
        names: &[&str],
        mut member: impl FnMut(&mut Self, usize) -> Read<()>,
    ) -> Read<bool> {
        // No object has more names than there are bits.
        let mut seen = 0_u64;
        self.object("an object", |reader, key, place| match names.iter().position(|&name| name == key) {
            None => {
                reader.fault(place, format!("unknown key {key:?}"), format!("one of {}", names.join(", ")));
                reader.skip()
            }
            Some(index) if seen >> index & 1 == 1 => {
                reader.fault(place, format!("{key:?} for the second time"), "each key once");
                reader.skip()
            }
            Some(index) => {
                seen |= 1 << index;
                member(reader, index)
            }
        })
    }

    /// The items of an array; `false` if it is something else.
    pub(in crate::scene) fn array(
        &mut self,
        allowed: impl Display,
        mut item: impl FnMut(&mut Self, usize) -> Read<()>,
    ) -> Read<bool> {
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
    pub(in crate::scene) fn string(&mut self, allowed: impl Display) -> Read<Option<Cow<'t, str>>> {
        self.blank();
        if self.peek() == Some(b'"') {
            return self.quoted().map(Some);
        }
        self.mistyped(allowed).map(|()| None)
    }

    /// A number in a domain.
    pub(in crate::scene) fn number(&mut self, domain: Domain) -> Read<Option<f64>> {
        let place = self.place();
        let Some(number) = self.numeral()? else {
            return self.mistyped(domain.allowed()).map(|()| None);
        };
        if Error::check("", None, number, domain).is_err() {
            let found = excerpt(&self.text[place..self.at]);
            let beyond = if number.is_finite() { "" } else { ", which no double can hold" };
            self.fault(place, format!("{found}{beyond}"), domain.allowed());
            return Ok(None);
        }
        Ok(Some(if domain == Domain::Angle { self.angles.radians(number) } else { number }))
    }

    /// A rotation vector, axis times angle.
    pub(in crate::scene) fn rotation(&mut self) -> Read<Option<[f64; 3]>> {
        Ok(self.vector()?.map(|rotation| rotation.map(|angle| self.angles.radians(angle))))
    }

    /// An array of exactly `N` finite numbers.
    pub(in crate::scene) fn vector<const N: usize>(&mut self) -> Read<Option<[f64; N]>> {
        let place = self.place();
        let allowed = format_args!("an array of {N} numbers");
        let (mut vector, mut count, mut sound) = ([0.0; N], 0, true);
        let is_array = self.array(allowed, |reader, index| {
            count += 1;
            match reader.number(Domain::Real)? {
                Some(number) => vector.get_mut(index).into_iter().for_each(|slot| *slot = number),
                None => sound = false,
            }
            Ok(())
        })?;
        if is_array && count != N {
            self.fault(place, format!("an array of {count}"), allowed.to_string());
        }
        Ok((is_array && sound && count == N).then_some(vector))
    }

    /// The end of the text.
    pub(in crate::scene) fn end(&mut self) -> Read<()> {
        self.blank();
        if self.at < self.text.len() { self.stop("nothing after the scene") } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three numbers, and the faults that were found.
    fn vector(text: &str) -> (Option<[f64; 3]>, Vec<String>) {
        let mut reader = Reader::new(text);
        let vector = reader.vector().unwrap();
        (vector, reader.faults.list().iter().map(|fault| fault.found.clone()).collect())
    }

    #[test]
    fn a_vector_is_an_array_of_so_many_numbers_or_one_fault() {
        assert_eq!(vector("[1, 2, 3]"), (Some([1.0, 2.0, 3.0]), Vec::new()));
        for (text, found) in [
            ("5", "5"),
            ("{}", "an object"),
            ("[]", "an array of 0"),
            ("[1, 2]", "an array of 2"),
            ("[1, 2, 3, 4]", "an array of 4"),
            ("[1, true, 3]", "true"),
        ] {
            assert_eq!(vector(text), (None, vec![found.into()]), "{text}");
        }
    }

    #[test]
    fn the_members_of_a_record_are_read_once_each() {
        let mut reader = Reader::new(r#"{"b": 1, "x": 2, "a": 3, "b": 4}"#);
        let mut read = Vec::new();
        let is_object = reader.record(&["a", "b"], |reader, key| {
            read.push((key, reader.number(Domain::Real)?));
            Ok(())
        });
        assert!(is_object.unwrap());
        assert_eq!(read, [(1, Some(1.0)), (0, Some(3.0))]);
        let found: Vec<_> = reader.faults.list().iter().map(|fault| (fault.column, &*fault.found)).collect();
        assert_eq!(found, [(10, "unknown key \"x\""), (26, "\"b\" for the second time")]);
    }

    #[test]
    fn a_text_is_over_where_only_blanks_follow() {
        let ends = |text| Reader::new(text).end().is_ok();
        assert!(ends("") && ends(" \t\r\n") && !ends(" x"));
    }
}
