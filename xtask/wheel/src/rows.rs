//! Rejected rows, as reported to Python.

use jointproof::Error;
use jointproof::toolkit::batch::RowError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The rows of a call that were rejected.
#[derive(Debug, Default)]
pub(crate) struct Refused {
    first: Option<RowError>,
    count: usize,
}

impl Refused {
    pub(crate) fn new(row: usize, error: Error, count: usize) -> Self {
        Self { first: Some(RowError { row, error }), count }
    }

    /// Merges the rejected rows of two parts of a call, independent of which ended first.
    pub(crate) fn and(self, other: Self) -> Self {
        let firsts = [self.first, other.first].into_iter().flatten();
        Self { first: firsts.min_by_key(|first| first.row), count: self.count + other.count }
    }

    /// The error of the first rejected row, as a dictionary; `None` if none is rejected.
    pub(crate) fn into_dict(self, py: Python<'_>) -> PyResult<Option<Bound<'_, PyDict>>> {
        let Some(RowError { row, error }) = self.first else { return Ok(None) };
        let dict = PyDict::new(py);
        let (input, value, allowed) = named(&error);
        dict.set_item("row", row)?;
        dict.set_item("count", self.count)?;
        dict.set_item("kind", error.kind())?;
        dict.set_item("input", input)?;
        dict.set_item("value", value)?;
        dict.set_item("allowed", allowed)?;
        dict.set_item("reason", error.to_string())?;
        Ok(Some(dict))
    }
}

/// The input that an error names first, with its value and what is allowed if the error concerns a single number.
fn named(error: &Error) -> (Option<String>, Option<f64>, Option<String>) {
    let (input, value, allowed) = match error {
        Error::NonFinite { name, value, allowed } | Error::OutOfRange { name, value, allowed } => {
            return (Some(name.to_string()), Some(*value), Some(allowed.clone()));
        }
        Error::OutOfOrder { lower, lower_value, .. } => (*lower, Some(*lower_value), None),
        Error::NotUnit { name, .. } | Error::TooShort { name, .. } => (*name, None, None),
        Error::NotPerpendicular { first, .. } | Error::LeftHanded { first, .. } | Error::TooClose { first, .. } => {
            (*first, None, None)
        }
        _ => return (None, None, None),
    };
    (Some(input.to_owned()), value, allowed)
}
