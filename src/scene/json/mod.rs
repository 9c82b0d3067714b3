//! A strict JSON reader that knows where it is.
//!
//! It pulls values of the type that the caller expects, so nothing is kept that is not wanted, and nothing recurses: a
//! scene of any size is read in one pass, and brackets without end meet the depth limit. A value of the wrong type is a
//! [`Fault`] and is stepped over, so that one run finds all mistakes; text that is not JSON ends the reading.

mod fault;
mod reader;
mod token;
mod value;

pub(super) use fault::some_of;
pub use fault::{Fault, Faults};
pub(super) use reader::{Mark, Read, Reader, Stop};
