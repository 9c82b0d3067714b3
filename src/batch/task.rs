//! The rows of a task, block by block.

use super::block::Block;
use super::column::{ROWS, Source, Target};
use super::error::Refused;
use super::job::Job;
use crate::formula::Formula;
use ndarray::{ArrayView1, ArrayViewMut1, Axis};

/// Some rows of a batch: their columns of inputs, and those of the results that are not zero everywhere.
pub(super) struct Task<'c> {
    /// The place of the first row in the batch.
    pub(super) first: usize,
    pub(super) rows: usize,
    pub(super) inputs: Vec<ArrayView1<'c, f64>>,
    pub(super) outputs: Vec<ArrayViewMut1<'c, f64>>,
}

impl Task<'_> {
    /// Computes all rows, and tells which of them are refused; more rows than a share are divided among the threads.
    pub(super) fn run<F: Formula, J: Job<F>>(self, share: usize) -> Refused {
        if self.rows <= share {
            return self.blocks::<F, J>();
        }
        let [one, other] = self.halves();
        let (one, other) = rayon::join(|| one.run::<F, J>(share), || other.run::<F, J>(share));
        one.and(other)
    }

    /// Both halves, the first of whole blocks.
    fn halves(self) -> [Self; 2] {
        let middle = (self.rows / 2).next_multiple_of(ROWS).min(self.rows);
        let inputs = self.inputs.into_iter().map(|column| column.split_at(Axis(0), middle));
        let (inputs, other_inputs) = inputs.unzip();
        let outputs = self.outputs.into_iter().map(|column| column.split_at(Axis(0), middle));
        let (outputs, other_outputs) = outputs.unzip();
        let other =
            Self { first: self.first + middle, rows: self.rows - middle, inputs: other_inputs, outputs: other_outputs };
        [Self { first: self.first, rows: middle, inputs, outputs }, other]
    }

    fn blocks<F: Formula, J: Job<F>>(self) -> Refused {
        let inputs: Vec<_> = self.inputs.into_iter().map(Source::from).collect();
        let mut outputs: Vec<_> = self.outputs.into_iter().map(Target::from).collect();
        let mut block = Block::<F, J>::new();
        let mut refused = Refused::default();
        for from in (0..self.rows).step_by(ROWS) {
            let count = ROWS.min(self.rows - from);
            for (column, rows) in inputs.iter().zip(&mut block.inputs) {
                column.bring(from, count, rows);
            }
            refused = refused.and(block.compute(count, self.first + from));
            for (column, rows) in outputs.iter_mut().zip(&block.outputs) {
                column.bring(from, count, rows);
            }
        }
        refused
    }
}
