//! The kinds of elements: the given quantities of each, its formulas, and its outputs with their names.
//!
//! The tables contain only what is not defined elsewhere. Formulas are wired by the names of their fields: an input `x` is read
//! from the output `x` of another formula, or from a given quantity of the element with that name. The meaning of a name, its
//! unit and its allowed values are defined by the field's [`Quantity`](crate::formula::quantity::Quantity).

mod dimension;
mod isl;
mod parts;
mod shared;
mod slider;
mod slot;
mod table;
mod tables;
mod translator;
mod ujoint;

pub use dimension::Dimension;
pub use table::{Fallback, Kind, Origin, Use, When};
