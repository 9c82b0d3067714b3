//! Columns of the caller, seen as slices.
//!
//! A column in one piece is read and written where it is: its rows follow each other, so that the processor fetches the next
//! while it computes. Of a column with a stride some rows at a time are kept at hand.

use ndarray::{ArrayView1, ArrayViewMut1};
use std::ops::Range;

/// So many rows of a column with a stride are kept at hand.
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
    /// These rows.
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
    /// Where these rows are written; [`Target::bring`] ends it.
    pub(super) fn rows(&mut self, rows: Range<usize>) -> &mut [f64] {
        match self {
            Self::Whole(column) => &mut column[rows],
            Self::Kept(_, kept) => &mut kept[..rows.len()],
        }
    }

    /// Brings these rows to where they are wanted.
    pub(super) fn bring(&mut self, rows: Range<usize>) {
        let Self::Kept(column, kept) = self else { return };
        for (row, x) in rows.zip(kept) {
            column[row] = *x;
        }
    }
}
