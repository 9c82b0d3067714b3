//! Shares of the points of an audit.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// Which part of an audit: `3/16` is the third of sixteen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    pub(super) index: usize,
    pub(super) of: usize,
}

impl Shard {
    /// All of it.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// The part of this number, counted from 1, of so many.
    ///
    /// # Errors
    /// That there is none of this number.
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
        // Without a product that could overflow.
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

/// Why parts are not those of one audit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartError(pub(super) String);

impl fmt::Display for PartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for PartError {}
