//! Formulas evaluated over registers, a block of elements at a time.

mod lanes;
mod step;

pub(super) use lanes::{Column, LANES, Span};
pub use lanes::{Failure, Lanes, Wiring};
pub use step::{Number, Step};
