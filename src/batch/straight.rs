//! Rows of a formula of simple operations and comparisons, several at a time.
//!
//! A comparison chooses between numbers that are computed anyway, and no row waits for one that is extreme ([`Ordinary`]), so that
//! the compiler takes as many at once as the vectors of a processor hold: four on one with AVX2, and eight on one with AVX-512,
//! which the feature `batch-avx512` adds. What it gives has the bits of one row alone.
//!
//! Half of the time of a simple formula is that of its columns. Rows that are computed together are whole lines of the cache, in
//! columns and in between; of columns that no cache holds, the next lines are asked for while these are computed.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::error::Refused;
use super::job::Job;
use super::row::one_by_one;
use super::structure::is_guarded;
use crate::formula::{Component, Fields, Formula, Visitor, bits_unless_finite, is_plain};
use crate::ordinary::Ordinary;
use crate::prefetch::{LINE, prefetch};
use std::marker::PhantomData;
use std::ops::{Deref, Range};

/// Rows that are computed together: four lines of the cache in every column. It is always as many, so that the compiler makes no
/// second loop for what is left over.
const TOGETHER: usize = 32;
/// Fewer are faster one by one.
const FEW: usize = 8;

/// So many results of a row at most, so that they stay in the nearest cache, and a program with all formulas small: without vectors of
/// eight, as the Python package is built, still fewer.
pub(super) const MOST_TOGETHER: usize = if cfg!(feature = "batch-avx512") { 145 } else { 98 };

/// What these rows have in one column. It begins with a line of the cache: vectors that lie in two take twice as long.
#[derive(Clone)]
#[repr(align(64))]
struct Column([f64; TOGETHER]);

/// As [`one_by_one`]; what is far is asked for before it is needed.
pub(super) fn rows<F: Formula, J: Job<F>>(
    inputs: &[&[f64]],
    outputs: &mut [&mut [f64]],
    rows: Range<usize>,
    first: usize,
    is_far: bool,
) -> Refused {
    let stretch = Stretch::<F, J> { inputs, outputs, rows, first, is_far, job: PhantomData };
    // One more copy of all formulas, for processors of this kind without vectors of four doubles, would be as large as this one.
    #[cfg(all(target_arch = "x86_64", feature = "batch-avx512"))]
    if let Some(vectors) = pulp::x86::V4::try_new() {
        return pulp::Simd::vectorize(vectors, stretch);
    }
    #[cfg(target_arch = "x86_64")]
    return match pulp::x86::V3::try_new() {
        Some(vectors) => pulp::Simd::vectorize(vectors, stretch),
        None => one_by_one::<F, J>(stretch.inputs, stretch.outputs, stretch.rows, first),
    };
    #[cfg(not(target_arch = "x86_64"))]
    pulp::Arch::new().dispatch(stretch)
}

/// A stretch of rows.
struct Stretch<'r, 'i, 'o, F, J> {
    inputs: &'r [&'i [f64]],
    outputs: &'r mut [&'o mut [f64]],
    rows: Range<usize>,
    first: usize,
    is_far: bool,
    job: PhantomData<(F, J)>,
}

impl<F: Formula, J: Job<F>> pulp::WithSimd for Stretch<'_, '_, '_, F, J> {
    type Output = Refused;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Refused {
        let Self { inputs, outputs, rows, first, is_far, .. } = self;
        let [mut read, mut written] =
            [F::Inputs::<f64>::LEN, J::LEN].map(|columns| vec![Column([0.0; TOGETHER]); columns]);
        let before = outputs.first().map_or(0, |column| column[rows.start..].as_ptr().align_offset(LINE));
        let mut refused = Refused::default();
        for some in together(rows, before) {
            if is_far {
                ask_for(inputs, some.end);
                ask_for(outputs, some.end);
            }
            for (Column(here), column) in read.iter_mut().zip(inputs) {
                take(&column[some.clone()], here);
            }
            if some.len() >= FEW && compute::<F, J>(&read, &mut written) {
                for (column, Column(here)) in outputs.iter_mut().zip(&written) {
                    give(here, &mut column[some.clone()]);
                }
            } else {
                refused = refused.and(one_by_one::<F, J>(inputs, outputs, some, first));
            }
        }
        refused
    }
}

/// Rows that are computed together: first those before a line of the cache begins, of which there are as many, if any.
fn together(rows: Range<usize>, before: usize) -> impl Iterator<Item = Range<usize>> {
    let start = rows.end.min(rows.start.saturating_add(before));
    let some = (start..rows.end).step_by(TOGETHER).map(move |from| from..rows.end.min(from + TOGETHER));
    std::iter::once(rows.start..start).filter(|first| !first.is_empty()).chain(some)
}

/// Has as many rows brought to the cache as are computed together.
#[inline(never)]
fn ask_for(columns: &[impl Deref<Target = [f64]>], from: usize) {
    for rows in columns.iter().filter_map(|column| column.get(from..from + TOGETHER)) {
        rows.iter().step_by(LINE / size_of::<f64>()).for_each(prefetch);
    }
}

/// Takes these rows of a column; the first of them stands for those that are missing to as many as are computed.
#[inline(always)]
fn take(from: &[f64], to: &mut [f64; TOGETHER]) {
    if let Some(all) = from.first_chunk() {
        *to = *all;
    } else {
        let (some, missing) = to.split_at_mut(from.len());
        some.copy_from_slice(from);
        missing.fill(from[0]);
    }
}

/// Gives as many rows to a column as it has.
#[inline(always)]
fn give(from: &[f64; TOGETHER], to: &mut [f64]) {
    if let Some(all) = to.first_chunk_mut() {
        *all = *from;
    } else {
        to.copy_from_slice(&from[..to.len()]);
    }
}

/// Computes all rows, and tells whether that could be done; else some may be refused, and all are to be looked at.
#[inline(always)]
fn compute<F: Formula, J: Job<F>>(read: &[Column], written: &mut [Column]) -> bool {
    // How many columns there are is known here, so that none of them is looked up below.
    let (read, columns) = (&read[..F::Inputs::<f64>::LEN], &mut written[..J::LEN]);
    // Bits, which vectors keep at the width of the numbers: zero as long as every row is as it should be. What a formula checks
    // itself may take branches, which would keep the compiler from vectors in one pass with all else.
    let mut bits = 0;
    for row in 0..TOGETHER {
        bits |= u64::from(F::validate(&inputs::<F::Inputs<Ordinary>, _>(read, row)).is_err());
    }
    for row in 0..TOGETHER {
        bits |= u64::from(!is_plain::<F>(&inputs(read, row)));
        let mut place = Place { columns, row, next: 0, bits: 0 };
        J::show(&J::unchecked::<Ordinary>(&inputs(read, row)), &mut place);
        bits |= if const { is_guarded::<F>() } { place.bits } else { 0 };
    }
    bits == 0
}

/// The inputs of a row.
#[inline(always)]
fn inputs<I: Fields<D>, D: Component + From<f64>>(read: &[Column], row: usize) -> I {
    let mut next = 0;
    I::from_components(&mut || {
        next += 1;
        D::from(read[next - 1].0[row])
    })
}

/// Writes the numbers of a row, each into the next column.
struct Place<'l> {
    columns: &'l mut [Column],
    row: usize,
    next: usize,
    /// Zero as long as all numbers are finite.
    bits: u64,
}

impl Visitor<Ordinary> for Place<'_> {
    #[inline(always)]
    fn visit(&mut self, x: Ordinary) {
        self.columns[self.next].0[self.row] = x.to_f64();
        self.bits |= bits_unless_finite(x.to_f64());
        self.next += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_before_a_line_of_the_cache_are_by_themselves() {
        let ends = |rows, before| together(rows, before).map(|some| [some.start, some.end]).collect::<Vec<_>>();
        assert_eq!(ends(3..80, 5), [[3, 8], [8, 40], [40, 72], [72, 80]]);
        assert_eq!(ends(0..64, 0), [[0, 32], [32, 64]]);
        assert_eq!(ends(2..4, 7), [[2, 4]]);
        assert_eq!(ends(1..3, usize::MAX), [[1, 3]]);
        assert!(ends(5..5, 3).is_empty());
    }

    #[test]
    fn the_first_row_stands_for_those_that_are_missing() {
        let column: [f64; 40] = std::array::from_fn(|k| f64::from(u8::try_from(k).unwrap()));
        let (mut here, mut back) = ([-1.0; TOGETHER], [-1.0; 40]);
        take(&column[1..4], &mut here);
        assert!(here[..3] == [1.0, 2.0, 3.0] && here[3..] == [1.0; TOGETHER - 3]);
        give(&here, &mut back[5..8]);
        assert!(back[..5] == [-1.0; 5] && back[5..8] == [1.0, 2.0, 3.0] && back[8..] == [-1.0; 32]);
        take(&column[2..34], &mut here);
        give(&here, &mut back[4..36]);
        assert_eq!(back[4..36], column[2..34]);
    }
}
