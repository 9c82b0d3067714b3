//! Faults of a scene, and their locations.

use std::fmt;

/// The maximum number of faults that are listed; further ones are only counted.
const LISTED: usize = 100;

/// The maximum number of names in a fault.
const SHOWN: usize = 8;

/// One mistake in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The JSON path, such as `elements."slot 1".mu` or `frames[2].time`; in a deck the keyword, such as `*NODE`, and the included
    /// file. Empty for the whole file.
    pub path: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// What was found there.
    pub found: String,
    /// What is allowed there.
    pub allowed: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, line, column, found, allowed } = self;
        let path = if path.is_empty() { "scene" } else { path };
        write!(f, "{path} (line {line}, column {column}): {found}; allowed is {allowed}")
    }
}

/// All faults of a scene, in the order in which they were found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    list: Vec<Fault>,
    unlisted: usize,
}

impl Faults {
    pub(in crate::scene) fn push(&mut self, fault: Fault) {
        self.list.push(fault);
    }

    /// Whether the next fault will be listed; it is counted if not.
    pub(in crate::scene) fn has_room(&mut self) -> bool {
        let fits = self.list.len() < LISTED;
        self.unlisted += usize::from(!fits);
        fits
    }

    /// Counts faults that are not listed.
    pub(in crate::scene) fn count_more(&mut self, more: usize) {
        self.unlisted += more;
    }

    /// The faults; at most a hundred.
    pub fn list(&self) -> &[Fault] {
        &self.list
    }

    /// The number of faults.
    #[expect(clippy::len_without_is_empty, reason = "faults are an error: there is at least one")]
    pub fn len(&self) -> usize {
        self.list.len() + self.unlisted
    }

    pub(in crate::scene) fn none(&self) -> bool {
        self.list.is_empty()
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, fault) in self.list.iter().enumerate() {
            write!(f, "{}{fault}", if k == 0 { "" } else { "\n" })?;
        }
        if self.unlisted > 0 {
            write!(f, "\n… and {} more", self.unlisted)?;
        }
        Ok(())
    }
}

impl std::error::Error for Faults {}

/// Names as listed in an error: the first ones, and whether there are more.
pub(in crate::scene) fn some_of(names: impl Iterator<Item = impl fmt::Debug>) -> String {
    let mut names: Vec<_> = names.take(SHOWN + 1).map(|name| format!("{name:?}")).collect();
    if names.len() > SHOWN {
        names[SHOWN] = "…".into();
    }
    names.join(", ")
}
