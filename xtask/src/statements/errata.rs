//! The errata, executed.
//!
//! The text is in `book/src/errata.md`; its tables are generated here, so that no number in them is typed by hand.

mod contact;
mod friction;
mod joint;
mod ours;
mod slider;

use super::erratum::Erratum;

/// All errata, in the order of the chapter.
pub(crate) fn all() -> Vec<Erratum> {
    [friction::errata(), joint::errata(), slider::errata(), contact::errata(), ours::errata()]
        .into_iter()
        .flatten()
        .collect()
}
