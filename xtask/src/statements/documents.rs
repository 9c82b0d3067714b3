//! The documents, statement by statement.

mod slide_line;
mod slider;
mod slot;
mod translator;
mod ujoint;

use super::statement::Statement;
use jointproof::formula;

/// A document that formulas were taken from.
pub(crate) struct Document {
    /// What formulas call it.
    pub(crate) source: formula::Document,
    /// The beginning of its statements' anchors.
    pub(crate) anchor: &'static str,
    /// What kind of text it is, and what it is about (Markdown).
    pub(crate) about: &'static str,
    /// How to find it (Markdown).
    pub(crate) found: &'static str,
    /// Its headings, in its own words.
    pub(crate) sections: &'static [&'static str],
    /// The size of the text that was used.
    pub(crate) bytes: usize,
    /// The checksum of that text: what `sha256sum` says of the file as it was handed to us, found once, by hand.
    pub(crate) sha256: &'static str,
    /// What it says.
    pub(crate) statements: Vec<Statement>,
}

impl Document {
    /// The anchor of a statement in the book.
    pub(crate) fn anchor_of(&self, statement: &Statement) -> String {
        format!("{}-{}", self.anchor, statement.id)
    }
}

/// All five.
pub(crate) fn all() -> Vec<Document> {
    vec![slot::document(), ujoint::document(), slider::document(), translator::document(), slide_line::document()]
}
