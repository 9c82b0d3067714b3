//! Rows of a formula of simple operations and comparisons, several at a time.
//!
//! A comparison chooses between numbers that are computed anyway, and no row waits for one that is extreme ([`Ordinary`]), so that
//! the compiler takes as many at once as the vectors of a processor hold: four on one with AVX2, for which this is compiled. What
//! it gives has the bits of one row alone.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::error::Refused;
use super::job::Job;
use super::row::one_by_one;
use super::structure::is_guarded;
use crate::formula::{Component, Fields, Formula, Visitor, bits_unless_finite, is_plain};
use crate::ordinary::Ordinary;
use std::marker::PhantomData;
use std::ops::Range;

/// Rows that are computed together: four lines of the cache in every column.
const TOGETHER: usize = 32;

/// So many numbers of a row at most, so that a program with all formulas stays small.
pub(super) const MOST_TOGETHER: usize = 120;

/// What these rows have in one column.
type Line = [f64; TOGETHER];

/// As [`one_by_one`].
pub(super) fn rows<F: Formula, J: Job<F>>(
    inputs: &[&[f64]],
    outputs: &mut [&mut [f64]],
    rows: Range<usize>,
    first: usize,
) -> Refused {
    let stretch = Stretch::<F, J> { inputs, outputs, rows, first, job: PhantomData };
    // A second copy of all formulas, for processors of this kind without vectors of four doubles, would be as large as the first.
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
    job: PhantomData<(F, J)>,
}

impl<F: Formula, J: Job<F>> pulp::WithSimd for Stretch<'_, '_, '_, F, J> {
    type Output = Refused;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Refused {
        let Self { inputs, outputs, rows, first, .. } = self;
        let (mut read, mut written) = (vec![Line::default(); F::Inputs::<f64>::LEN], vec![Line::default(); J::LEN]);
        let mut refused = Refused::default();
        for from in rows.clone().step_by(TOGETHER) {
            let some = from..rows.end.min(from + TOGETHER);
            for (line, column) in read.iter_mut().zip(inputs) {
                copy(&column[some.clone()], line);
            }
            if compute::<F, J>(&read, &mut written, some.len()) {
                for (column, line) in outputs.iter_mut().zip(&written) {
                    copy(line, &mut column[some.clone()]);
                }
            } else {
                refused = refused.and(one_by_one::<F, J>(inputs, outputs, some, first));
            }
        }
        refused
    }
}

/// Copies the rows that both have; where these are all, their number is known here.
#[inline(always)]
fn copy(from: &[f64], to: &mut [f64]) {
    if let (Some(from), Some(to)) = (from.first_chunk::<TOGETHER>(), to.first_chunk_mut::<TOGETHER>()) {
        *to = *from;
    } else {
        to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
    }
}

/// Computes so many rows, and tells whether that could be done; else some may be refused, and all are to be looked at.
#[inline(always)]
fn compute<F: Formula, J: Job<F>>(read: &[Line], written: &mut [Line], count: usize) -> bool {
    // How many columns and rows there are at most is known here, so that none of them is looked up below.
    let (read, lines) = (&read[..F::Inputs::<f64>::LEN], &mut written[..J::LEN]);
    let count = count.min(TOGETHER);
    // Bits, which vectors keep at the width of the numbers: zero as long as every row is as it should be.
    let mut bits = 0;
    for row in 0..count {
        let is_valid = F::validate(&inputs::<F::Inputs<Ordinary>, _>(read, row)).is_ok();
        bits |= u64::from(!(is_plain::<F>(&inputs(read, row)) & is_valid));
    }
    if bits == 0 {
        for row in 0..count {
            let mut place = Place { lines, row, next: 0, bits: 0 };
            J::show(&J::unchecked::<Ordinary>(&inputs(read, row)), &mut place);
            bits |= if const { is_guarded::<F>() } { place.bits } else { 0 };
        }
    }
    bits == 0
}

/// The inputs of a row.
#[inline(always)]
fn inputs<I: Fields<D>, D: Component + From<f64>>(read: &[Line], row: usize) -> I {
    let mut next = 0;
    I::from_components(&mut || {
        next += 1;
        D::from(read[next - 1][row])
    })
}

/// Writes the numbers of a row, each into the next line.
struct Place<'l> {
    lines: &'l mut [Line],
    row: usize,
    next: usize,
    /// Zero as long as all numbers are finite.
    bits: u64,
}

impl Visitor<Ordinary> for Place<'_> {
    #[inline(always)]
    fn visit(&mut self, x: Ordinary) {
        self.lines[self.next][self.row] = x.to_f64();
        self.bits |= bits_unless_finite(x.to_f64());
        self.next += 1;
    }
}
