//! What is wrong with a table, and where.

use std::fmt;

/// A mistake in a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableFault {
    /// The name of the table.
    pub table: String,
    /// Line in the table, from 1; 0 if it cannot be read at all.
    pub line: u64,
    /// The number of the column, from 1, and its name if it has one.
    pub column: (usize, String),
    /// What was found there.
    pub found: String,
    /// What is allowed there.
    pub allowed: String,
}

impl TableFault {
    /// The place and what was found there: the first part of the message.
    pub(in crate::scene) fn found(&self) -> String {
        let Self { table, line, column: (column, name), found, .. } = self;
        match (line, &**name) {
            (0, _) => format!("{table}: {found}"),
            (line, "") => format!("{table}, line {line}, column {column}: {found}"),
            (line, name) => format!("{table}, line {line}, column {column} ({name:?}): {found}"),
        }
    }
}

impl fmt::Display for TableFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; allowed is {}", self.found(), self.allowed)
    }
}

impl std::error::Error for TableFault {}
