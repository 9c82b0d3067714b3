//! A document and its statements.

use super::statement::{Statement, Status};
use jointproof::formula;

/// A document that formulas were taken from.
pub(crate) struct Document {
    /// Its identity as used by formulas.
    pub(crate) source: formula::Document,
    /// The prefix of its statements' anchors.
    pub(crate) anchor: &'static str,
    /// The kind of text and its subject (Markdown).
    pub(crate) about: &'static str,
    /// How to find it (Markdown).
    pub(crate) found: &'static str,
    /// Its headings, in its own words.
    pub(crate) sections: &'static [&'static str],
    /// The size and the checksum of the text that was used, if we received one: the output of `sha256sum` for the file, determined
    /// once, by hand.
    pub(crate) text: Option<(usize, &'static str)>,
    /// Its statements.
    pub(crate) statements: Vec<Statement>,
}

impl Document {
    /// The anchor of a statement in the book.
    pub(crate) fn anchor_of(&self, statement: &Statement) -> String {
        format!("{}-{}", self.anchor, statement.id)
    }
}

/// The number of statements by status.
pub(super) struct Counts {
    pub(super) all: usize,
    pub(super) covered: usize,
    pub(super) errata: usize,
    pub(super) outside: usize,
}

impl Counts {
    pub(super) fn of(documents: &[Document]) -> Self {
        let statuses: Vec<_> = documents.iter().flat_map(|document| &document.statements).map(|s| s.status).collect();
        let number = |is: fn(&Status) -> bool| statuses.iter().filter(|status| is(status)).count();
        Self {
            all: statuses.len(),
            covered: number(|status| *status == Status::Covered),
            errata: number(|status| *status == Status::Erratum),
            outside: number(|status| matches!(status, Status::Outside(_))),
        }
    }
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { all, covered, errata, outside } = self;
        write!(f, "{all} statements: {covered} covered, {errata} errata, {outside} outside")
    }
}
