//! One statement of a document, where it stands, and what covers it.

use jointproof::catalog::AnyFormula;
use std::any::type_name;

/// Something that a document says, in our words.
pub(crate) struct Statement {
    /// The line of the document's text, and the sentence in it where it has several: `L22-s1`.
    pub(crate) id: &'static str,
    /// A paraphrase.
    pub(crate) says: &'static str,
    /// Where it stands.
    pub(crate) status: Status,
    /// What covers it.
    pub(crate) covers: Vec<Cover>,
}

/// Where a statement stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// What covers it says the same.
    Covered,
    /// The document is wrong, unclear or has lost symbols here; an erratum says what is done.
    Erratum,
    /// Nothing to code, and why.
    Outside(&'static str),
}

/// Something that covers a statement. Formulas and functions are checked by the compiler, everything else by
/// [`check`](super::check).
pub(crate) enum Cover {
    /// A formula of the catalog.
    Formula(Formula),
    /// A law of a formula, by the beginning of its words.
    Law(Formula, &'static str),
    /// A golden case of a formula, by its id.
    Case(Formula, &'static str),
    /// A typed function, or a type, by its Rust path.
    Item(&'static str),
    /// An output of an element of a scene, as `slot/U1`, or `slider@2d/G` in one dimension only.
    Output(&'static str),
    /// A test, as `ujoint::a_name` of `tests/ujoint.rs`.
    Test(&'static str),
    /// A place in the book, as `slot.md#forces`.
    Chapter(&'static str),
    /// An erratum, by its anchor.
    Erratum(&'static str),
}

/// A formula of the catalog.
pub(crate) type Formula = &'static dyn AnyFormula;

/// A statement that is covered by what follows.
pub(super) fn covered(id: &'static str, says: &'static str) -> Statement {
    Statement { id, says, status: Status::Covered, covers: Vec::new() }
}

/// A statement that is wrong or unclear, and the erratum about it.
pub(super) fn mended(id: &'static str, says: &'static str, erratum: &'static str) -> Statement {
    Statement { id, says, status: Status::Erratum, covers: Vec::new() }.erratum(erratum)
}

/// A statement without anything to code, and why.
pub(super) fn outside(id: &'static str, says: &'static str, why: &'static str) -> Statement {
    Statement { id, says, status: Status::Outside(why), covers: Vec::new() }
}

impl Statement {
    /// Formulas.
    pub(super) fn formulas(self, formulas: &[Formula]) -> Self {
        self.and(formulas.iter().map(|formula| Cover::Formula(*formula)))
    }

    /// A law of a formula, by the beginning of its words.
    pub(super) fn law(self, formula: Formula, words: &'static str) -> Self {
        self.and([Cover::Law(formula, words)])
    }

    /// Golden cases of a formula.
    pub(super) fn cases(self, formula: Formula, ids: &[&'static str]) -> Self {
        self.and(ids.iter().map(|id| Cover::Case(formula, id)))
    }

    /// A typed function.
    pub(super) fn method<F>(self, _: F) -> Self {
        self.and([Cover::Item(type_name::<F>())])
    }

    /// A type.
    pub(super) fn item<T>(self) -> Self {
        self.and([Cover::Item(type_name::<T>())])
    }

    /// Outputs of scenes.
    pub(super) fn outputs(self, outputs: &[&'static str]) -> Self {
        self.and(outputs.iter().map(|output| Cover::Output(output)))
    }

    /// A test.
    pub(super) fn test(self, test: &'static str) -> Self {
        self.and([Cover::Test(test)])
    }

    /// A place in the book.
    pub(super) fn chapter(self, place: &'static str) -> Self {
        self.and([Cover::Chapter(place)])
    }

    /// An erratum.
    pub(super) fn erratum(self, anchor: &'static str) -> Self {
        self.and([Cover::Erratum(anchor)])
    }

    fn and(mut self, covers: impl IntoIterator<Item = Cover>) -> Self {
        self.covers.extend(covers);
        self
    }

    /// Whether a formula is named.
    pub(super) fn names(&self, id: &str) -> bool {
        self.covers.iter().any(|cover| matches!(cover, Cover::Formula(formula) if formula.spec().id == id))
    }
}
