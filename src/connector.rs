//! The connectors and constraints of the documents, a folder each: formulas, typed connector, and the evidence beside them.

pub mod align;
pub mod join;
pub mod slider;
pub mod slot;
pub mod translator;
pub mod ujoint;
pub mod universal;
