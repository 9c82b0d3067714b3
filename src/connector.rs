//! The connectors and constraints of the documents, a folder each: formulas, typed connector, and the evidence
//! beside them; and what they measure rotations by, triads ([`frame`]) and Cardan angles ([`cardan`]).

pub mod align;
pub mod cardan;
pub mod frame;
pub mod join;
pub mod slider;
pub mod slot;
pub mod translator;
pub mod ujoint;
pub mod universal;
