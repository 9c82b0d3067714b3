//! The errors of a batch.

use std::fmt;

/// A set of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Part {
    /// A column per component of the inputs.
    Inputs,
    /// A column per component of the value.
    Value,
    /// A column per requested entry of the Jacobian.
    Jacobian,
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Inputs => "inputs",
            Self::Value => "value",
            Self::Jacobian => "Jacobian",
        })
    }
}

/// The error of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct RowError {
    /// The row, from 0.
    pub row: usize,
    /// What is wrong: which input, its value, and what is allowed.
    pub error: crate::Error,
}

/// An error of a batch.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// Some rows were rejected. All others were computed; the results of the rejected ones are NaN.
    Rows {
        /// The first rejected row.
        first: RowError,
        /// The number of rejected rows.
        count: usize,
    },
    /// There are more or fewer columns than the formula has.
    Columns {
        /// The set of columns.
        part: Part,
        /// The number of columns given.
        found: usize,
        /// The number of columns of the formula.
        expected: usize,
    },
    /// A column's length differs from that of the first input column.
    Length {
        /// The set the column belongs to.
        part: Part,
        /// The column, from 0.
        column: usize,
        /// Its number of rows.
        found: usize,
        /// The number of rows of the first column.
        expected: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rows { first: RowError { row, error }, count: 1 } => write!(f, "row {row}: {error}"),
            Self::Rows { first: RowError { row, error }, count } => {
                write!(f, "row {row}, the first of {count} that are refused: {error}")
            }
            Self::Columns { part, found, expected } => write!(f, "{part}: {found} columns; allowed are {expected}"),
            Self::Length { part, column, found, expected } => {
                write!(f, "{part}, column {column}: {found} rows; allowed are {expected}, as in the first column")
            }
        }
    }
}

impl std::error::Error for Error {}

/// The rows that were rejected.
#[derive(Debug, Default)]
pub(super) struct Refused {
    first: Option<RowError>,
    count: usize,
}

impl Refused {
    pub(super) fn add(&mut self, row: RowError) {
        self.count += 1;
        self.first.get_or_insert(row);
    }

    /// The rejected rows of two tasks, independent of which ended first.
    pub(super) fn and(self, other: Self) -> Self {
        let firsts = [self.first, other.first].into_iter().flatten();
        Self { first: firsts.min_by_key(|first| first.row), count: self.count + other.count }
    }

    pub(super) fn into_result(self) -> Result<(), Error> {
        self.first.map_or(Ok(()), |first| Err(Error::Rows { first, count: self.count }))
    }
}

/// Rejects a wrong number of columns, or of rows in one of them.
pub(super) fn expect(
    part: Part,
    columns: usize,
    rows: usize,
    lengths: impl ExactSizeIterator<Item = usize>,
) -> Result<(), Error> {
    if lengths.len() != columns {
        return Err(Error::Columns { part, found: lengths.len(), expected: columns });
    }
    match lengths.enumerate().find(|&(_, found)| found != rows) {
        Some((column, found)) => Err(Error::Length { part, column, found, expected: rows }),
        None => Ok(()),
    }
}
