//! Rows of a formula of simple operations and comparisons, several at a time.
//!
//! Comparisons select between numbers that are both computed, and no row branches for extreme numbers ([`Ordinary`]),
//! so that the compiler vectorises over rows: four with AVX2, and eight with AVX-512, which the feature `batch-avx512`
//! adds. The results have the same bits as for a single row.
//!
//! Half of the time of a simple formula goes into its columns. Rows that are computed together fill whole cache lines,
//! in columns and in buffers. While they are computed, the next lines of the results are prefetched, and those of the
//! inputs if the columns exceed the cache.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::error::Refused;
use super::job::Job;
use super::row::{of_components, one_by_one};
use super::structure::is_guarded;
use crate::formula::{Fields, Formula, Visitor, are_allowed, bits_unless_finite, is_plain};
use crate::number::ordinary::Ordinary;
use crate::number::prefetch::{LINE, prefetch};
use std::marker::PhantomData;
use std::ops::{Deref, Range};

/// The number of rows computed together: two cache lines in every column. It is constant, so that the compiler needs
/// no second loop for a remainder.
const TOGETHER: usize = 16;
/// With more columns than this, longer pieces are prefetched less often, which makes better use of the memory.
const MANY: usize = 32;

/// The values of these rows in one column, aligned to a cache line: vectors that straddle two lines take twice as long.
#[derive(Clone)]
#[repr(align(64))]
struct Column([f64; TOGETHER]);

/// Like [`one_by_one`], but with prefetching if the columns exceed the cache.
pub(super) fn rows<F: Formula, J: Job<F>>(
    inputs: &[&[f64]],
    outputs: &mut [&mut [f64]],
    rows: Range<usize>,
    first: usize,
    is_far: bool,
) -> Refused {
    let stretch = Stretch::<F, J> { inputs, outputs, rows, first, is_far, job: PhantomData };
    // x86-64 processors without vectors of four doubles fall back to one row at a time: a copy of all formulas for
    // them would be as large as this one.
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
        if rows.len() < TOGETHER {
            return one_by_one::<F, J>(inputs, outputs, rows, first);
        }
        let times = if inputs.len() + outputs.len() > MANY { 2 } else { 1 };
        // One table of inputs and results: with two tables of more than 250 columns, the compiler fails to prove that
        // they do not overlap and would not vectorise.
        let mut columns = vec![Column([0.0; TOGETHER]); F::Inputs::<f64>::LEN + J::LEN];
        let before = outputs.first().map_or(0, |column| column[rows.start..].as_ptr().align_offset(LINE));
        let mut refused = Refused::default();
        for (k, some) in together(rows.clone(), before).enumerate() {
            // Incomplete groups, before the first cache line and at the end, are computed together with their neighbours.
            let from = some.start.min(rows.end - TOGETHER);
            if is_far && k.is_multiple_of(times) {
                ask_for(inputs, from + 2 * TOGETHER, times * TOGETHER);
                ask_for(outputs, from + 2 * TOGETHER, times * TOGETHER);
            }
            take(inputs, from, &mut columns);
            if compute::<F, J>(&mut columns) {
                give(&columns[F::Inputs::<f64>::LEN..], from, outputs);
            } else {
                refused = refused.and(one_by_one::<F, J>(inputs, outputs, some, first));
            }
        }
        refused
    }
}

/// Groups of rows that are computed together: first the `before` rows ahead of a cache line, if any, then full groups.
fn together(rows: Range<usize>, before: usize) -> impl Iterator<Item = Range<usize>> {
    let start = rows.end.min(rows.start.saturating_add(before));
    let some = (start..rows.end).step_by(TOGETHER).map(move |from| from..rows.end.min(from + TOGETHER));
    std::iter::once(rows.start..start).filter(|first| !first.is_empty()).chain(some)
}

/// Prefetches `count` rows of all columns.
#[inline(never)]
fn ask_for(columns: &[impl Deref<Target = [f64]>], from: usize, count: usize) {
    columns.iter().filter_map(|column| column.get(from..from + count)).for_each(bring);
}

/// Prefetches rows of a column.
#[inline(always)]
fn bring(rows: &[f64]) {
    rows.iter().step_by(LINE / size_of::<f64>()).for_each(prefetch);
}

/// Copies a group of rows from the inputs.
#[inline(always)]
fn take(from: &[&[f64]], row: usize, to: &mut [Column]) {
    for (column, Column(here)) in from.iter().zip(to) {
        *here = *column[row..].first_chunk().expect("so many rows are there");
    }
}

/// Copies a group of rows to the results, and prefetches the next.
#[inline(always)]
fn give(from: &[Column], row: usize, to: &mut [&mut [f64]]) {
    for (Column(here), column) in from.iter().zip(to) {
        let (rows, next) = column[row..].split_first_chunk_mut().expect("so many rows are there");
        *rows = *here;
        if let Some(next) = next.first_chunk::<TOGETHER>() {
            bring(next);
        }
    }
}

/// Computes all rows, whose inputs come first, and returns whether all are valid; if not, the caller computes them one by one.
#[inline(always)]
fn compute<F: Formula, J: Job<F>>(columns: &mut [Column]) -> bool {
    // The number of columns is known here, so that there are no bounds checks below.
    let columns = &mut columns[..F::Inputs::<f64>::LEN + J::LEN];
    // Bits of the width of the numbers, for vectorisation: zero if every row is valid. A formula's own `validate` may
    // branch, which would prevent vectorisation of a common loop.
    let mut bits = 0;
    for row in 0..TOGETHER {
        bits |= u64::from(F::validate(&of_components::<F::Inputs<Ordinary>, _>(|k| columns[k].0[row])).is_err());
    }
    for row in 0..TOGETHER {
        let is_guarded = const { is_guarded::<F>() };
        let i = of_components(|k| columns[k].0[row]);
        bits |= u64::from(!if is_guarded { are_allowed(&i) } else { is_plain::<F>(&i) });
        let i = of_components(|k| columns[k].0[row]);
        let mut place = Place { columns, row, next: F::Inputs::<f64>::LEN, bits: 0 };
        J::show(&J::unchecked::<Ordinary>(&i), &mut place);
        bits |= if is_guarded { place.bits } else { 0 };
    }
    bits == 0
}

/// Writes the numbers of a row, one per column.
struct Place<'l> {
    columns: &'l mut [Column],
    row: usize,
    next: usize,
    /// Zero if all numbers are finite.
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
        assert_eq!(ends(3..50, 5), [[3, 8], [8, 24], [24, 40], [40, 50]]);
        assert_eq!(ends(0..32, 0), [[0, 16], [16, 32]]);
        assert_eq!(ends(2..4, 7), [[2, 4]]);
        assert_eq!(ends(1..3, usize::MAX), [[1, 3]]);
        assert!(ends(5..5, 3).is_empty());
    }

    #[test]
    fn rows_are_taken_and_given_where_they_are() {
        let column: [f64; 40] = std::array::from_fn(|k| f64::from(u8::try_from(k).unwrap()));
        let (mut here, mut back) = ([Column([-1.0; TOGETHER])], [-1.0; 40]);
        take(&[&column], 3, &mut here);
        assert_eq!(here[0].0, column[3..19]);
        give(&here, 24, &mut [&mut back]);
        assert!(back[..24] == [-1.0; 24] && back[24..] == column[3..19]);
    }
}
