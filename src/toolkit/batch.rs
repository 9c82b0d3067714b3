//! A formula at many points, with a column for every input and for every result.
//!
//! Rows are distributed among the threads of [rayon](rayon::ThreadPool::install). Every row is checked, and has the same bits as
//! from [`formula::value_and_jacobian`], whatever the number of threads.
//!
//! Formulas of simple operations and comparisons are vectorised over several rows; the feature `batch-avx512` adds wider vectors
//! on processors that have them. If a group contains numbers so large or small that they need a separate branch, its rows are
//! computed one by one.
//!
//! A column is a view of `ndarray`: of a slice, by `into`, or of numbers with any stride. With a stride of 0, as from
//! `broadcast`, one number serves all rows.
//!
//! Contiguous columns are fastest, provided that their starts are not a multiple of 4096 bytes apart, as those of separately
//! allocated large vectors are: such columns compete for the same cache sets. [`columns`] avoids this and aligns each column to a
//! cache line, which is fastest for vector loads and stores.
//!
//! Many Jacobians have mostly entries that are 0 at every point. These have no column; [`entries`] lists those that do.
//!
//! ```
//! use jointproof::toolkit::batch::{entries, value_and_jacobian};
//! use jointproof::connector::slot::ContactForce;
//!
//! let (f2, f3) = ([3.0, 5.0, 8.0], [4.0, 12.0, 15.0]);
//! let (mut fc, mut by_f2, mut by_f3) = ([0.0; 3], [0.0; 3], [0.0; 3]);
//! assert_eq!(entries::<ContactForce>(), [[0, 0], [0, 1]]); // ∂fc/∂f2, ∂fc/∂f3
//! let inputs = [(&f2).into(), (&f3).into()];
//! let jacobian = &mut [(&mut by_f2).into(), (&mut by_f3).into()];
//! value_and_jacobian::<ContactForce>(&inputs, &mut [(&mut fc).into()], jacobian)?;
//! assert_eq!(fc, [5.0, 13.0, 17.0]);
//! assert_eq!(by_f3, [0.8, 12.0 / 13.0, 15.0 / 17.0]);
//! # Ok::<(), jointproof::toolkit::batch::Error>(())
//! ```
//!
//! For a dense Jacobian, allocate an array of zeros and pass the columns of these entries.
//!
//! Errors name the row and the input. All other rows are computed:
//!
//! ```
//! # use jointproof::toolkit::batch::value;
//! # use jointproof::connector::slot::ContactForce;
//! let (f2, f3) = ([3.0, f64::NAN, 8.0], [4.0, 12.0, 15.0]);
//! let mut fc = [0.0; 3];
//! let error = value::<ContactForce>(&[(&f2).into(), (&f3).into()], &mut [(&mut fc).into()]).unwrap_err();
//! assert_eq!(error.to_string(), "row 1: f2 is NaN; allowed is a finite number");
//! assert_eq!([fc[0], fc[2]], [5.0, 17.0]);
//! assert!(fc[1].is_nan());
//! ```
//!
//! [`formula::value_and_jacobian`]: crate::formula::value_and_jacobian

mod column;
mod error;
mod job;
mod row;
mod straight;
mod structure;
mod task;

pub(crate) use job::{Job, Linearized};
#[cfg(feature = "measure")]
pub(crate) use row::{Row, of_components};

pub use error::{Error, Part, RowError};
pub use ndarray::{ArrayView1, ArrayViewMut1};

use crate::formula::{Fields, Formula};
use crate::number::prefetch::LINE;
use job::Value;
use ndarray::{Array2, Axis, Slice};
use task::Task;

/// The least amount of numbers worth a thread: waking one takes as long as computing some thousands.
const WORTH: usize = 1 << 17;
/// The amount of numbers that fits the cache of a core; beyond it, numbers are prefetched.
const AT_HAND: usize = 1 << 17;

/// Columns of zeros, each aligned to a cache line and placed so that they do not compete for the same cache sets: the
/// rows of a table that is slightly wider than the view returned.
///
/// ```
/// use jointproof::toolkit::batch::{ArrayViewMut1, columns};
/// let mut table = columns(3, 4096);
/// let mut views: Vec<ArrayViewMut1<f64>> = table.rows_mut().into_iter().collect();
/// assert_eq!((views.len(), views[2].len()), (3, 4096));
/// views[2][4095] = 1.0;
/// ```
pub fn columns(count: usize, rows: usize) -> Array2<f64> {
    const DOUBLES: usize = LINE / size_of::<f64>();
    // An odd number of cache lines, with space for the padding before the first of them.
    let width = ((rows.div_ceil(DOUBLES) + 1) | 1) * DOUBLES;
    let mut table: Array2<f64> = Array2::zeros((count, width));
    let before = table.as_ptr().align_offset(LINE);
    table.slice_axis_inplace(Axis(1), Slice::from(before..before + rows));
    table
}

/// The entries of the Jacobian of a formula that are not identically zero, each as the indices of an output and an
/// input component. For a formula outside the catalog these are all entries.
pub fn entries<F: Formula>() -> Vec<[usize; 2]> {
    let inputs = F::Inputs::<f64>::LEN;
    structure::places::<F>().map(|k| [k / inputs, k % inputs]).collect()
}

/// The value of a formula at every row, each checked as in [`formula::value`](crate::formula::value). There is a
/// column for every component of the inputs, and one for every component of the value.
///
/// # Errors
/// [`Error::Rows`], naming the first rejected row, the reason, and the number of rejected rows; their results are NaN,
/// all others are computed. The other errors concern the columns, and nothing is computed.
pub fn value<F: Formula>(inputs: &[ArrayView1<f64>], value: &mut [ArrayViewMut1<f64>]) -> Result<(), Error> {
    all::<F, Value>(inputs, value, None)
}

/// Value and Jacobian of a formula at every row, each checked as in
/// [`formula::value_and_jacobian`](crate::formula::value_and_jacobian). The Jacobian has a column for every entry
/// listed by [`entries`].
///
/// # Errors
/// As for [`value`].
pub fn value_and_jacobian<F: Formula>(
    inputs: &[ArrayView1<f64>],
    value: &mut [ArrayViewMut1<f64>],
    jacobian: &mut [ArrayViewMut1<f64>],
) -> Result<(), Error> {
    all::<F, Linearized>(inputs, value, Some(jacobian))
}

fn all<F: Formula, J: Job<F>>(
    inputs: &[ArrayView1<f64>],
    value: &mut [ArrayViewMut1<f64>],
    jacobian: Option<&mut [ArrayViewMut1<f64>]>,
) -> Result<(), Error> {
    let rows = inputs.first().map_or(0, ArrayView1::len);
    error::expect(Part::Inputs, F::Inputs::<f64>::LEN, rows, inputs.iter().map(ArrayView1::len))?;
    error::expect(Part::Value, F::Outputs::<f64>::LEN, rows, value.iter().map(ArrayViewMut1::len))?;
    let mut outputs: Vec<_> = value.iter_mut().map(|column| column.view_mut()).collect();
    if let Some(jacobian) = jacobian {
        error::expect(Part::Jacobian, structure::entries::<F>(), rows, jacobian.iter().map(ArrayViewMut1::len))?;
        outputs.extend(jacobian.iter_mut().map(|column| column.view_mut()));
    }
    let numbers = F::Inputs::<f64>::LEN + J::LEN;
    let share = rows.div_ceil(8 * rayon::current_num_threads()).max(WORTH / numbers);
    let is_far = rows > AT_HAND / numbers;
    Task { first: 0, rows, is_far, inputs: inputs.to_vec(), outputs }.run(task::rows::<F, J>, share).into_result()
}
