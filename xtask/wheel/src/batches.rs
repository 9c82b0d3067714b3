//! The batches of every formula, compiled with this crate: optimised for speed, whereas the evidence is optimised for size.

use jointproof::formula::Formula;
use jointproof::toolkit::batch::{self, ArrayView1, ArrayViewMut1};

/// A column per component of the inputs, then of the results.
type Run = fn(&[ArrayView1<f64>], &mut [ArrayViewMut1<f64>]) -> Result<(), batch::Error>;

/// A formula at many points.
pub(crate) struct Batch {
    /// See [`batch::value`].
    pub(crate) value: Run,
    /// See [`batch::value_and_jacobian`]: the columns of the value, then of the entries.
    pub(crate) linearize: Run,
    /// See [`batch::entries`].
    pub(crate) entries: fn() -> Vec<[usize; 2]>,
}

impl Batch {
    const fn of<F: Formula>() -> Self {
        Self { value: batch::value::<F>, linearize: linearize::<F>, entries: batch::entries::<F> }
    }
}

fn linearize<F: Formula>(inputs: &[ArrayView1<f64>], results: &mut [ArrayViewMut1<f64>]) -> Result<(), batch::Error> {
    use jointproof::formula::Fields;
    let (value, jacobian) = results.split_at_mut(F::Outputs::<f64>::LEN.min(results.len()));
    batch::value_and_jacobian::<F>(inputs, value, jacobian)
}

/// In the order of the catalog.
pub(crate) const BATCHES: &[Batch] = include!(concat!(env!("OUT_DIR"), "/batches.rs"));
