//! Columns of the caller, and blocks of their rows.

use ndarray::{ArrayView1, ArrayViewMut1};

/// Rows in a block: five lines of the cache. So columns of a block, one after the other, do not push each other out of it.
pub(super) const ROWS: usize = 40;

/// The rows of a block of one column.
pub(super) type Rows = [f64; ROWS];

/// A column of inputs.
pub(super) enum Source<'c> {
    Whole(&'c [f64]),
    Strided(ArrayView1<'c, f64>),
}

impl<'c> From<ArrayView1<'c, f64>> for Source<'c> {
    fn from(column: ArrayView1<'c, f64>) -> Self {
        column.to_slice().map_or(Self::Strided(column), Self::Whole)
    }
}

impl Source<'_> {
    /// Brings so many rows from this one on into a block.
    #[inline]
    pub(super) fn bring(&self, from: usize, count: usize, block: &mut Rows) {
        match self {
            Self::Whole(column) => match column[from..].first_chunk() {
                Some(rows) => *block = *rows,
                None => block[..count].copy_from_slice(&column[from..from + count]),
            },
            Self::Strided(column) => {
                for (k, x) in block[..count].iter_mut().enumerate() {
                    *x = column[from + k];
                }
            }
        }
    }
}

/// A column of results.
pub(super) enum Target<'c> {
    Whole(&'c mut [f64]),
    Strided(ArrayViewMut1<'c, f64>),
}

impl<'c> From<ArrayViewMut1<'c, f64>> for Target<'c> {
    fn from(column: ArrayViewMut1<'c, f64>) -> Self {
        if !column.is_standard_layout() {
            return Self::Strided(column);
        }
        Self::Whole(column.into_slice().expect("a standard layout is in one piece"))
    }
}

impl Target<'_> {
    /// Brings so many rows of a block to where they are wanted.
    #[inline]
    pub(super) fn bring(&mut self, from: usize, count: usize, block: &Rows) {
        match self {
            Self::Whole(column) => match column[from..].first_chunk_mut() {
                Some(rows) => *rows = *block,
                None => column[from..from + count].copy_from_slice(&block[..count]),
            },
            Self::Strided(column) => {
                for (k, x) in block[..count].iter().enumerate() {
                    column[from + k] = *x;
                }
            }
        }
    }
}
