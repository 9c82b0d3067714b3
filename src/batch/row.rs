//! Rows of a batch one after the other.

#![expect(clippy::inline_always, reason = "a formula and what is done with its results are compiled as one piece")]

use super::error::{Refused, RowError};
use super::job::Job;
use crate::error::Error;
use crate::formula::{Fields, Formula, Visitor};
use std::ops::Range;

/// So many rows are made before the first of them is computed: what was just written number by number, a processor cannot read
/// by pairs without waiting for it.
const AHEAD: usize = 16;

/// So many numbers of a row at most are asked one by one whether they are wanted.
const MOST: usize = 96;

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
    let (mut refused, mut made, mut all) = (Refused::default(), Vec::with_capacity(AHEAD), All::of::<F, J>());
    for from in rows.clone().step_by(AHEAD) {
        let some = from..rows.end.min(from + AHEAD);
        made.clear();
        made.extend(some.clone().map(|row| {
            let mut next = 0;
            F::Inputs::from_components(&mut || {
                next += 1;
                inputs[next - 1][row]
            })
        }));
        for (row, i) in some.clone().zip(&made) {
            match J::of(i) {
                Ok(results) if const { J::LEN <= MOST } => {
                    J::show(&results, &mut Row { columns, at: row, place: 0 });
                }
                Ok(results) => all.keep::<F, J>(&results, row - from),
                Err(error) => {
                    all.rows[row - from].fill(f64::NAN);
                    refuse(columns, row, first, error, &mut refused);
                }
            }
        }
        all.write(columns, some);
    }
    refused
}

/// All numbers of some rows, zeros and all, and which of them are wanted.
///
/// Where there are many, to ask of each whether it is zero everywhere would take far longer than to write it; and column by column
/// they are written faster than row by row.
struct All {
    rows: Vec<Vec<f64>>,
    wanted: Vec<usize>,
}

impl All {
    /// Nothing, if there are few.
    fn of<F: Formula, J: Job<F>>() -> Self {
        let most = if J::LEN <= MOST { 0 } else { F::Outputs::<f64>::LEN * (1 + F::Inputs::<f64>::LEN) };
        let wanted = if J::LEN <= MOST { Vec::new() } else { J::places() };
        Self { rows: vec![vec![0.0; most]; AHEAD], wanted }
    }

    #[inline(always)]
    fn keep<F: Formula, J: Job<F>>(&mut self, results: &J::Results<f64>, row: usize) {
        J::show_all(results, &mut Numbers { row: &mut self.rows[row], next: 0 });
    }

    fn write(&self, columns: &mut [&mut [f64]], to: Range<usize>) {
        for (column, &place) in columns.iter_mut().zip(&self.wanted) {
            column[to.clone()].iter_mut().zip(&self.rows).for_each(|(x, row)| *x = row[place]);
        }
    }
}

/// Writes the numbers of a row, each into the next place.
struct Numbers<'r> {
    row: &'r mut [f64],
    next: usize,
}

impl Visitor<f64> for Numbers<'_> {
    #[inline(always)]
    fn visit(&mut self, x: f64) {
        self.row[self.next] = x;
        self.next += 1;
    }
}

/// Writes the numbers of a row, each into the next column.
pub(crate) struct Row<'b, 'c> {
    pub(crate) columns: &'b mut [&'c mut [f64]],
    pub(crate) at: usize,
    pub(crate) place: usize,
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
