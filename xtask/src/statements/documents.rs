//! The documents, statement by statement.

mod hinge;
mod slide_line;
mod slider;
mod slot;
mod translator;
mod ujoint;

use super::document::Document;

/// All documents.
pub(crate) fn all() -> Vec<Document> {
    vec![
        slot::document(),
        ujoint::document(),
        slider::document(),
        translator::document(),
        slide_line::document(),
        hinge::revolute(),
        hinge::hinge(),
    ]
}
