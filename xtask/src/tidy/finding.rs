//! Findings, and their wording.

use std::fmt::{Display, Formatter, Result};

/// A fault to be fixed. Findings are ordered by location.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Finding {
    /// The file, from the root of the workspace.
    pub(super) file: String,
    /// The line, from 1; 0 for the whole file.
    pub(super) line: usize,
    /// What is wrong; what to do.
    pub(super) what: String,
    /// Additional lines with details.
    pub(super) details: Vec<String>,
}

impl Finding {
    /// A finding without details.
    pub(super) fn new(file: impl Into<String>, line: usize, what: impl Into<String>) -> Self {
        Self { file: file.into(), line, what: what.into(), details: Vec::new() }
    }
}

impl From<kit::Fault> for Finding {
    fn from(fault: kit::Fault) -> Self {
        Self::new(fault.file, fault.line, fault.message)
    }
}

impl Display for Finding {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.line {
            0 => write!(f, "{}: {}", self.file, self.what)?,
            line => write!(f, "{}:{line}: {}", self.file, self.what)?,
        }
        self.details.iter().try_for_each(|detail| write!(f, "\n    {detail}"))
    }
}
