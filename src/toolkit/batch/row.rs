//! Rows of a batch one after the other.

#![expect(clippy::inline_always, reason = "a formula and what is done with its results are compiled as one piece")]

use super::error::{Refused, RowError};
use super::job::Job;
use crate::formula::error::Error;
use crate::formula::{Component, Fields, Formula, Visitor};
use std::ops::Range;

/// The number of rows whose inputs are gathered before the first of them is computed: loading a pair of numbers that
/// were just stored one by one stalls the processor.
const AHEAD: usize = 16;

/// Computes these rows; `first` is the index of the first of all rows within the batch.
#[inline(never)]
pub(super) fn one_by_one<F: Formula, J: Job<F>>(
    inputs: &[&[f64]],
    outputs: &mut [&mut [f64]],
    rows: Range<usize>,
    first: usize,
) -> Refused {
    // The number of columns is known here, so that there are no bounds checks below.
    let inputs = &inputs[..F::Inputs::<f64>::LEN];
    let columns = &mut outputs[..J::LEN];
    let (mut refused, mut made) = (Refused::default(), Vec::with_capacity(AHEAD));
    for from in rows.clone().step_by(AHEAD) {
        let some = from..rows.end.min(from + AHEAD);
        made.clear();
        made.extend(some.clone().map(|row| of_components::<F::Inputs<f64>, _>(|k| inputs[k][row])));
        for (row, i) in some.zip(&made) {
            match J::of(i) {
                Ok(results) => J::show(&results, &mut Row::new(columns, row)),
                Err(error) => refuse(columns, row, first, error, &mut refused),
            }
        }
    }
    refused
}

/// The struct with these components.
#[inline(always)]
pub(crate) fn of_components<I: Fields<D>, D: Component + From<f64>>(component: impl Fn(usize) -> f64) -> I {
    let mut next = 0;
    I::from_components(&mut || {
        next += 1;
        D::from(component(next - 1))
    })
}

/// Writes the numbers of a row, one per column.
pub(crate) struct Row<'b, 'c> {
    columns: &'b mut [&'c mut [f64]],
    at: usize,
    place: usize,
}

impl<'b, 'c> Row<'b, 'c> {
    #[inline(always)]
    pub(crate) fn new(columns: &'b mut [&'c mut [f64]], at: usize) -> Self {
        Self { columns, at, place: 0 }
    }
}

impl Visitor<f64> for Row<'_, '_> {
    #[inline(always)]
    fn visit(&mut self, x: f64) {
        self.columns[self.place][self.at] = x;
        self.place += 1;
    }
}

/// Sets every number of a rejected row to NaN.
#[cold]
#[inline(never)]
fn refuse(columns: &mut [&mut [f64]], row: usize, first: usize, error: Error, refused: &mut Refused) {
    for column in columns {
        column[row] = f64::NAN;
    }
    refused.add(RowError { row: first + row, error });
}
