//! Arrays in a file: `.npz`, the archive of `.npy` arrays that `numpy.load` opens and `numpy.savez` writes.
//!
//! Arrays are of little-endian 64-bit floats in C order, as they are or compressed. The same arrays have the same bytes: no
//! time is written.

mod header;
mod read;
mod rows;
mod unfit;
mod write;

pub(super) use read::{Archive, Array};
pub(super) use rows::Rows;
pub(super) use unfit::Unfit;
pub use write::Writer;
