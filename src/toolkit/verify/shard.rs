//! Shares of the points of an audit.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// A part of an audit: `3/16` is the third of sixteen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    pub(super) index: usize,
    pub(super) of: usize,
}

impl Shard {
    /// The whole audit.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// Part `index`, counted from 1, of `of` parts.
    ///
    /// # Errors
    /// If there is no part with this index.
    pub fn new(index: usize, of: usize) -> Result<Self, PartError> {
        if (1..=of).contains(&index) {
            return Ok(Self { index, of });
        }
        Err(PartError(format!("there is no part {index} of {of}: parts are counted from 1")))
    }

    pub(super) fn is_first(self) -> bool {
        self.index == 1
    }

    /// Its share of the random points.
    pub(super) fn range(self, samples: usize) -> Range<usize> {
        // Avoids a product that could overflow.
        let (each, rest) = (samples / self.of, samples % self.of);
        let start = |index: usize| each * index + rest.min(index);
        start(self.index - 1)..start(self.index)
    }
}

/// `3/16`.
impl FromStr for Shard {
    type Err = PartError;

    fn from_str(text: &str) -> Result<Self, PartError> {
        let numbers = text.split_once('/').and_then(|(index, of)| Some((index.parse().ok()?, of.parse().ok()?)));
        let (index, of) = numbers.ok_or_else(|| PartError(format!("'{text}' is not a part as 3/16 is one")))?;
        Self::new(index, of)
    }
}

/// Why parts do not belong to one audit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartError(pub(super) String);

impl fmt::Display for PartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for PartError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_follow_one_another_and_the_first_have_one_more() {
        let ranges = |of: usize, samples| (1..=of).map(|k| Shard { index: k, of }.range(samples)).collect::<Vec<_>>();
        assert_eq!(ranges(3, 11), [0..4, 4..8, 8..11]);
        assert_eq!(ranges(3, 2), [0..1, 1..2, 2..2]);
        assert_eq!(Shard::WHOLE.range(7), 0..7);
        assert_eq!(Shard { index: 2, of: 2 }.range(usize::MAX).end, usize::MAX);
    }

    #[test]
    fn parts_are_counted_from_one_and_written_as_they_are_read() {
        assert_eq!("3/16".parse(), Ok(Shard { index: 3, of: 16 }));
        assert!("1/16".parse::<Shard>().unwrap().is_first() && !"2/16".parse::<Shard>().unwrap().is_first());
        for (wrong, why) in [
            ("0/4", "there is no part 0 of 4: parts are counted from 1"),
            ("5/4", "there is no part 5 of 4: parts are counted from 1"),
            ("3", "'3' is not a part as 3/16 is one"),
            ("a/4", "'a/4' is not a part as 3/16 is one"),
        ] {
            assert_eq!(wrong.parse::<Shard>().unwrap_err().to_string(), why);
        }
        assert_eq!(Shard::new(4, 4), Ok(Shard { index: 4, of: 4 }));
    }
}
