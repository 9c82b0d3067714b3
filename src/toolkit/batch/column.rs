//! The caller's columns, as slices.
//!
//! A contiguous column is read and written in place, so that the processor prefetches the next rows. A column with a
//! stride is buffered a few rows at a time.

use ndarray::{ArrayView1, ArrayViewMut1};
use std::ops::Range;

/// The number of buffered rows of a column with a stride.
pub(super) const ROWS: usize = 128;

/// A column of inputs.
pub(super) enum Source<'c> {
    Whole(&'c [f64]),
    Kept(ArrayView1<'c, f64>, Vec<f64>),
}

impl<'c> From<ArrayView1<'c, f64>> for Source<'c> {
    fn from(column: ArrayView1<'c, f64>) -> Self {
        column.to_slice().map_or_else(|| Self::Kept(column, Vec::new()), Self::Whole)
    }
}

impl Source<'_> {
    /// The input values of these rows.
    pub(super) fn rows(&mut self, rows: Range<usize>) -> &[f64] {
        match self {
            Self::Whole(column) => &column[rows],
            Self::Kept(column, kept) => {
                kept.clear();
                kept.extend(rows.map(|row| column[row]));
                kept
            }
        }
    }
}

/// A column of results.
pub(super) enum Target<'c> {
    Whole(&'c mut [f64]),
    Kept(ArrayViewMut1<'c, f64>, Vec<f64>),
}

impl<'c> From<ArrayViewMut1<'c, f64>> for Target<'c> {
    fn from(column: ArrayViewMut1<'c, f64>) -> Self {
        if !column.is_standard_layout() {
            return Self::Kept(column, vec![0.0; ROWS]);
        }
        Self::Whole(column.into_slice().expect("a standard layout is in one piece"))
    }
}

impl Target<'_> {
    /// The buffer for the results of these rows; call [`Target::bring`] when it is filled.
    pub(super) fn rows(&mut self, rows: Range<usize>) -> &mut [f64] {
        match self {
            Self::Whole(column) => &mut column[rows],
            Self::Kept(_, kept) => &mut kept[..rows.len()],
        }
    }

    /// Copies these rows from the buffer to their destination.
    pub(super) fn bring(&mut self, rows: Range<usize>) {
        let Self::Kept(column, kept) = self else { return };
        for (row, x) in rows.zip(kept) {
            column[row] = *x;
        }
    }
}
