//! A strict JSON reader that keeps track of its location.
//!
//! It reads values of the type that the caller expects, so nothing unwanted is stored, and it does not recurse: a scene of any
//! size is read in one pass, and unlimited nesting meets the depth limit. A value of the wrong type is a [`Fault`] and is
//! skipped, so that one run finds all mistakes; text that is not JSON ends the reading.

mod fault;
mod reader;
mod token;
mod value;

pub(super) use fault::some_of;
pub use fault::{Fault, Faults};
pub(super) use reader::{Mark, Read, Reader, Stop};
