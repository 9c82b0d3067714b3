//! Arrays in a file: `.npz`, the archive of `.npy` arrays that `numpy.load` opens and `numpy.savez` writes.
//!
//! Arrays are of little-endian 64-bit floats in C order, uncompressed or compressed. The same arrays give the same bytes: no time
//! is written.

mod header;
mod read;
mod rows;
mod unfit;
mod write;

/// The count of numbers that are read, checked or written at once, small enough to stay in the cache meanwhile.
pub(super) const PIECE: usize = 1 << 14;

pub(super) use read::{Archive, Array};
pub(super) use rows::Rows;
pub(super) use unfit::Unfit;
pub use write::Writer;
