//! Errors in an equation.

use super::name::Name;
use std::fmt;

/// Why an equation cannot be executed, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    at: usize,
    what: String,
    entry: Option<(String, &'static str)>,
    unknown: Option<String>,
}

impl Error {
    pub(super) fn new(at: usize, what: impl Into<String>) -> Self {
        Self { at, what: what.into(), entry: None, unknown: None }
    }

    /// A symbol that nobody defines.
    pub(super) fn unknown(at: usize, name: &Name) -> Self {
        Self { unknown: Some(name.to_string()), ..Self::new(at, format!("{name} is nobody's symbol")) }
    }

    /// A symbol that is no output, where one should be defined.
    pub(super) fn undefined(at: usize, name: &Name) -> Self {
        Self { unknown: Some(name.to_string()), ..Self::new(at, format!("{name} is no output")) }
    }

    /// Adds the entry and the part of it, unless they are known already.
    pub(super) fn of_entry(self, id: &str, part: &'static str) -> Self {
        Self { entry: self.entry.or_else(|| Some((id.into(), part))), ..self }
    }

    /// Adds that the error is in the symbol of a field.
    pub(super) fn of_symbol(self, latex: &str) -> Self {
        Self { what: format!("the symbol `{latex}`: {}", self.what), ..self }
    }

    /// The symbol, as plain text, if the reason is that it is not known.
    pub fn symbol(&self) -> Option<&str> {
        self.unknown.as_deref()
    }

    /// The byte offset in the LaTeX at which it was found.
    pub fn at(&self) -> usize {
        self.at
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((id, part)) = &self.entry {
            write!(f, "the {part} of {id}, ")?;
        }
        write!(f, "byte {}: {}", self.at, self.what)
    }
}

impl std::error::Error for Error {}
