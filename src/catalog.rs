//! Formulas with their types erased; and, with the feature `catalog`, every one of ours in the order of the book.

mod elements;
mod form;
mod formed;
mod formulas;
#[cfg(feature = "catalog")]
mod list;
mod worst;

pub use elements::{AnyElement, Erased};
pub use form::{AnyForm, Form, Rotations};
pub use formulas::{AnyFormula, KinkEntry};
#[cfg(feature = "catalog")]
pub use list::{CATALOG, ELEMENTS};

/// The formula of this identifier.
#[cfg(feature = "catalog")]
pub fn find(id: &str) -> Option<&'static dyn AnyFormula> {
    CATALOG.iter().copied().find(|formula| formula.spec().id == id)
}
