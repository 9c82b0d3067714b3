//! The rows of a task.

use super::column::{ROWS, Source, Target};
use super::error::Refused;
use super::job::Job;
use super::row::one_by_one;
use super::straight;
use crate::formula::Formula;
use ndarray::{ArrayView1, ArrayViewMut1, Axis};

/// Computes rows of these inputs, the first of which has this index in the batch, into columns of the same length; the
/// flag tells whether they exceed the cache. It is a function pointer, so that the distribution among threads is
/// compiled only once: one copy per formula would be a tenth of the Python package.
type Compute = fn(&[&[f64]], &mut [&mut [f64]], usize, bool) -> Refused;

/// Some rows of a batch: their input columns, and their columns of results that are not identically zero.
pub(super) struct Task<'c> {
    /// The index of the first row in the batch.
    pub(super) first: usize,
    pub(super) rows: usize,
    /// Whether the batch is larger than a cache.
    pub(super) is_far: bool,
    pub(super) inputs: Vec<ArrayView1<'c, f64>>,
    pub(super) outputs: Vec<ArrayViewMut1<'c, f64>>,
}

impl Task<'_> {
    /// Computes all rows and returns which are rejected; more rows than `share` are divided among the threads.
    pub(super) fn run(self, rows: Compute, share: usize) -> Refused {
        if self.rows <= share {
            return self.compute(rows);
        }
        let [one, other] = self.halves();
        let (one, other) = rayon::join(|| one.run(rows, share), || other.run(rows, share));
        one.and(other)
    }

    fn halves(self) -> [Self; 2] {
        let (middle, is_far) = (self.rows / 2, self.is_far);
        let inputs = self.inputs.into_iter().map(|column| column.split_at(Axis(0), middle));
        let (inputs, other_inputs) = inputs.unzip();
        let outputs = self.outputs.into_iter().map(|column| column.split_at(Axis(0), middle));
        let (outputs, other_outputs) = outputs.unzip();
        let (first, rows) = (self.first + middle, self.rows - middle);
        let other = Self { first, rows, is_far, inputs: other_inputs, outputs: other_outputs };
        [Self { first: self.first, rows: middle, is_far, inputs, outputs }, other]
    }

    /// Computes the rows, a few at a time if columns are buffered.
    fn compute(self, rows: Compute) -> Refused {
        let mut inputs: Vec<_> = self.inputs.into_iter().map(Source::from).collect();
        let mut outputs: Vec<_> = self.outputs.into_iter().map(Target::from).collect();
        let gathers = inputs.iter().any(|column| matches!(column, Source::Kept(..)));
        let scatters = outputs.iter().any(|column| matches!(column, Target::Kept(..)));
        let some = if gathers || scatters { ROWS } else { self.rows.max(1) };
        let mut refused = Refused::default();
        for from in (0..self.rows).step_by(some) {
            let range = from..self.rows.min(from + some);
            let read: Vec<_> = inputs.iter_mut().map(|column| column.rows(range.clone())).collect();
            let mut written: Vec<_> = outputs.iter_mut().map(|column| column.rows(range.clone())).collect();
            refused = refused.and(rows(&read, &mut written, self.first + from, self.is_far));
            for column in &mut outputs {
                column.bring(range.clone());
            }
        }
        refused
    }
}

/// The function that computes the rows of a formula.
pub(super) fn rows<F: Formula, J: Job<F>>(
    inputs: &[&[f64]],
    outputs: &mut [&mut [f64]],
    first: usize,
    is_far: bool,
) -> Refused {
    let all = 0..inputs.first().map_or(0, |column| column.len());
    if const { J::IS_STRAIGHT } {
        return straight::rows::<F, J>(inputs, outputs, all, first, is_far);
    }
    one_by_one::<F, J>(inputs, outputs, all, first)
}
