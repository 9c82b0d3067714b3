//! Rows of a batch one after the other.

#![expect(clippy::inline_always, reason = "a formula and what is done with its results are compiled as one piece")]

use super::error::{Refused, RowError};
use super::job::Job;
use crate::formula::error::Error;
use crate::formula::{Component, Fields, Formula, Visitor};
use std::ops::Range;

/// So many rows are made before the first of them is computed: what was just written number by number, a processor cannot read
/// by pairs without waiting for it.
const AHEAD: usize = 16;

/// These rows; `first` is the place of the first of all in the batch.
#[inline(never)]
pub(super) fn one_by_one<F: Formula, J: Job<F>>(
    inputs: &[&[f64]],
    outputs: &mut [&mut [f64]],
    rows: Range<usize>,
    first: usize,
) -> Refused {
    // How many columns there are is known here, so that none of them is looked up below.
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

/// What has these components.
#[inline(always)]
pub(crate) fn of_components<I: Fields<D>, D: Component + From<f64>>(component: impl Fn(usize) -> f64) -> I {
    let mut next = 0;
    I::from_components(&mut || {
        next += 1;
        D::from(component(next - 1))
    })
}

/// Writes the numbers of a row, each into the next column.
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

/// Of a row that is refused every number is NaN.
#[cold]
#[inline(never)]
fn refuse(columns: &mut [&mut [f64]], row: usize, first: usize, error: Error, refused: &mut Refused) {
    for column in columns {
        column[row] = f64::NAN;
    }
    refused.add(RowError { row: first + row, error });
}
