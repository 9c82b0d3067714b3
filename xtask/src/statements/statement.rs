//! One statement of a document, its status, and what covers it.

use jointproof::catalog::AnyFormula;
use std::any::type_name;

/// A statement of a document, paraphrased.
pub(crate) struct Statement {
    /// The line of the document's text, and the sentence if the line has several: `L22-s1`.
    pub(crate) id: &'static str,
    /// A paraphrase.
    pub(crate) says: &'static str,
    /// Its status.
    pub(crate) status: Status,
    /// What covers it.
    pub(crate) covers: Vec<Cover>,
}

/// The status of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// It agrees with what covers it.
    Covered,
    /// The document is wrong, unclear or has lost symbols here; an erratum says how this is resolved.
    Erratum,
    /// There is nothing to implement, for the reason given here.
    Outside(&'static str),
}

/// Something that covers a statement. Formulas and functions are checked by the compiler, everything else by
/// [`check`](super::check).
pub(crate) enum Cover {
    /// A formula of the catalog.
    Formula(Formula),
    /// A law of a formula, identified by the beginning of its text.
    Law(Formula, &'static str),
    /// A golden case of a formula, by its id.
    Case(Formula, &'static str),
    /// A typed function, or a type, by its Rust path.
    Item(&'static str),
    /// An output of an element of a scene, as `slot/U1`, or `slider@2d/G` in one dimension only.
    Output(&'static str),
    /// A test, as `ujoint::a_name` of `tests/ujoint.rs`.
    Test(&'static str),
    /// A location in the book, as `slot.md#forces`.
    Chapter(&'static str),
    /// An erratum, by its anchor.
    Erratum(&'static str),
}

/// A formula of the catalog.
pub(crate) type Formula = &'static dyn AnyFormula;

/// A statement covered by the items added below.
pub(super) fn covered(id: &'static str, says: &'static str) -> Statement {
    Statement { id, says, status: Status::Covered, covers: Vec::new() }
}

/// A statement that is wrong or unclear, and the erratum about it.
pub(super) fn mended(id: &'static str, says: &'static str, erratum: &'static str) -> Statement {
    Statement { id, says, status: Status::Erratum, covers: Vec::new() }.erratum(erratum)
}

/// A statement with nothing to implement, and the reason.
pub(super) fn outside(id: &'static str, says: &'static str, why: &'static str) -> Statement {
    Statement { id, says, status: Status::Outside(why), covers: Vec::new() }
}

impl Statement {
    /// Adds formulas.
    pub(super) fn formulas(self, formulas: &[Formula]) -> Self {
        self.and(formulas.iter().map(|formula| Cover::Formula(*formula)))
    }

    /// Adds a law of a formula, identified by the beginning of its text.
    pub(super) fn law(self, formula: Formula, words: &'static str) -> Self {
        self.and([Cover::Law(formula, words)])
    }

    /// Adds golden cases of a formula.
    pub(super) fn cases(self, formula: Formula, ids: &[&'static str]) -> Self {
        self.and(ids.iter().map(|id| Cover::Case(formula, id)))
    }

    /// Adds a typed function.
    pub(super) fn method<F>(self, _: F) -> Self {
        self.and([Cover::Item(type_name::<F>())])
    }

    /// Adds a type.
    pub(super) fn item<T>(self) -> Self {
        self.and([Cover::Item(type_name::<T>())])
    }

    /// Adds outputs of scenes.
    pub(super) fn outputs(self, outputs: &[&'static str]) -> Self {
        self.and(outputs.iter().map(|output| Cover::Output(output)))
    }

    /// Adds a test.
    pub(super) fn test(self, test: &'static str) -> Self {
        self.and([Cover::Test(test)])
    }

    /// Adds a location in the book.
    pub(super) fn chapter(self, place: &'static str) -> Self {
        self.and([Cover::Chapter(place)])
    }

    /// Adds an erratum.
    pub(super) fn erratum(self, anchor: &'static str) -> Self {
        self.and([Cover::Erratum(anchor)])
    }

    fn and(mut self, covers: impl IntoIterator<Item = Cover>) -> Self {
        self.covers.extend(covers);
        self
    }

    /// Whether it names a formula.
    pub(super) fn names(&self, id: &str) -> bool {
        self.covers.iter().any(|cover| matches!(cover, Cover::Formula(formula) if formula.spec().id == id))
    }
}
