//! The kinds of elements: what each is given, which formulas it has, and which outputs by which names.
//!
//! The tables say only what nothing else says. Formulas are wired by the names of their fields: an input `x` is read from
//! the output `x` of another formula, or from what the element is given by that name. What a name means, its unit and its
//! allowed values stand with the field's [`Quantity`](crate::formula::quantity::Quantity).

mod check;
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
