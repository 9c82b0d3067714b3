//! What is found, and how it is said.

use std::fmt::{Display, Formatter, Result};

/// Something to be mended. The order of findings is that of their places.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Finding {
    /// The file, from the root of the workspace.
    pub(super) file: String,
    /// The line, from 1; 0 where the whole file is meant.
    pub(super) line: usize,
    /// What is wrong; what to do.
    pub(super) what: String,
    /// Lines below it that show more.
    pub(super) details: Vec<String>,
}

impl Finding {
    /// A finding that needs no more than its line.
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
