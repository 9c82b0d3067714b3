//! The connectors and constraints of the documents, one folder each: formulas, friction, element, typed connector, and their
//! evidence. Their building blocks are in [`element`](crate::element).

pub mod align;
pub mod hinge;
pub mod join;
pub mod revolute;
pub mod slider;
pub mod slot;
pub mod translator;
pub mod ujoint;
pub mod universal;

#[cfg(all(test, feature = "verify"))]
mod tests;
