//! A block of rows: checked at once, and computed row by row.

#![expect(clippy::inline_always, reason = "what is looked at in all rows of a block is looked at in vectors")]

use super::column::{ROWS, Rows};
use super::error::{Refused, RowError};
use super::job::Job;
use crate::error::Error;
use crate::formula::{Fields, Finite, Formula, check};
use crate::quantity::Domain;
use std::marker::PhantomData;
use std::ops::Range;

/// Columns of inputs and results.
pub(super) struct Block<F, J> {
    pub(super) inputs: Vec<Rows>,
    pub(super) outputs: Vec<Rows>,
    job: PhantomData<(F, J)>,
}

impl<F: Formula, J: Job<F>> Block<F, J> {
    pub(super) fn new() -> Self {
        let columns = |count| vec![[0.0; ROWS]; count];
        Self { inputs: columns(F::Inputs::<f64>::LEN), outputs: columns(J::LEN), job: PhantomData }
    }

    /// Computes so many rows, of which the first has this place in the batch, and tells which are refused.
    pub(super) fn compute(&mut self, count: usize, first: usize) -> Refused {
        let covered = are_covered(F::SPEC.finite, &self.inputs);
        if are_in_domain::<F>(&self.inputs) & (covered || are_finite(&self.inputs)) {
            let refused = self.compute_rows(0..count, first);
            if covered || are_finite(&self.outputs) {
                return refused;
            }
        }
        self.look_at_rows(count, first)
    }

    /// Computes rows whose inputs are allowed, each number by itself.
    #[inline(never)]
    fn compute_rows(&mut self, rows: Range<usize>, first: usize) -> Refused {
        // Their numbers are known here, so that none of them is looked up below.
        let inputs = &self.inputs[..F::Inputs::<f64>::LEN];
        let outputs = &mut self.outputs[..J::LEN];
        let mut refused = Refused::default();
        for row in rows.start..rows.end.min(ROWS) {
            match J::of_allowed(&inputs_of::<F>(inputs, row)) {
                Ok(results) => {
                    let mut place = 0;
                    J::hand_out(&results, &mut |x| {
                        outputs[place][row] = x;
                        place += 1;
                    });
                }
                Err(error) => refuse(outputs, row, first, error, &mut refused),
            }
        }
        refused
    }

    /// Computes rows of which one is not as it should be.
    #[cold]
    #[inline(never)]
    fn look_at_rows(&mut self, count: usize, first: usize) -> Refused {
        let mut refused = Refused::default();
        for row in 0..count {
            let inputs = inputs_of::<F>(&self.inputs, row);
            if let Err(error) = self.look_at_row(&inputs, row) {
                refuse(&mut self.outputs, row, first, error, &mut refused);
            }
        }
        refused
    }

    fn look_at_row(&mut self, inputs: &F::Inputs<f64>, row: usize) -> Result<(), Error> {
        check::<F>(inputs)?;
        self.compute_rows(row..row + 1, 0);
        let is_finite = self.outputs.iter().all(|column| column[row].is_finite());
        if is_finite { Ok(()) } else { J::check(inputs) }
    }
}

/// The inputs of a row.
#[inline(always)]
fn inputs_of<F: Formula>(columns: &[Rows], row: usize) -> F::Inputs<f64> {
    let mut next = 0;
    F::Inputs::from_components(&mut || {
        next += 1;
        columns[next - 1][row]
    })
}

/// Of a row that is refused every number is NaN.
#[cold]
#[inline(never)]
fn refuse(outputs: &mut [Rows], row: usize, first: usize, error: Error, refused: &mut Refused) {
    for column in outputs {
        column[row] = f64::NAN;
    }
    refused.add(RowError { row: first + row, error });
}

/// Whether all inputs are in their domains.
#[inline(always)]
fn are_in_domain<F: Formula>(inputs: &[Rows]) -> bool {
    let fields = F::Inputs::<f64>::FIELDS.iter();
    let domains = fields.flat_map(|field| std::iter::repeat_n(field.quantity.domain, field.len()));
    inputs.iter().zip(domains).fold(true, |allowed, (column, domain)| allowed & is_in_domain(column, domain))
}

/// Which domain it is, is asked once for all numbers.
#[inline(always)]
fn is_in_domain(column: &Rows, domain: Domain) -> bool {
    match domain {
        Domain::NonNegative => all(column, |x| Domain::NonNegative.allows(x)),
        Domain::Positive => all(column, |x| Domain::Positive.allows(x)),
        Domain::Between(low, high) => all(column, |x| Domain::Between(low, high).allows(x)),
        Domain::Within(low, high) => all(column, |x| Domain::Within(low, high).allows(x)),
        Domain::HalfOpen(low, high) => all(column, |x| Domain::HalfOpen(low, high).allows(x)),
        _ => true,
    }
}

/// Whether these are inputs of all rows at which nothing overflows.
#[inline(always)]
fn are_covered(finite: Finite, inputs: &[Rows]) -> bool {
    match finite {
        Finite::Unknown => false,
        Finite::Below => all(inputs.as_flattened(), Finite::is_below),
        Finite::Between => all(inputs.as_flattened(), Finite::is_between),
    }
}

#[inline(always)]
fn are_finite(columns: &[Rows]) -> bool {
    all(columns.as_flattened(), f64::is_finite)
}

/// Whether it holds for all numbers; without a branch, so that the compiler may take several at once.
#[inline(always)]
fn all(numbers: &[f64], holds: impl Fn(f64) -> bool) -> bool {
    numbers.iter().fold(true, |all, &x| all & holds(x))
}
