//! A formula over arrays of any shape and strides, without copies.
//!
//! All arrays have the shape of the call. Axes that are contiguous in all of them are merged; rows along the longest
//! remaining axis are passed to a batch, and the other axes are distributed among the threads.

use crate::batches::Batch;
use crate::rows::Refused;
use jointproof::toolkit::batch::{ArrayView1, ArrayViewMut1, Error};
use ndarray::{ArrayViewD, ArrayViewMutD, Axis, Ix1};

/// A function that computes columns of results from columns of inputs.
type Run = fn(&[ArrayView1<f64>], &mut [ArrayViewMut1<f64>]) -> Result<(), Error>;

/// The amount of numbers below which a call stays on its thread.
const SMALL: usize = 1 << 15;

/// An array per component of the inputs and of the results, all of one shape.
pub(crate) struct Call<'a> {
    /// The row index of the first element.
    first: usize,
    /// The increment of the row index along each axis.
    steps: Vec<usize>,
    shape: Vec<usize>,
    inputs: Vec<ArrayViewD<'a, f64>>,
    results: Vec<ArrayViewMutD<'a, f64>>,
}

impl<'a> Call<'a> {
    /// A call with arrays of this shape; `None` if an array has another shape.
    pub(crate) fn new(
        shape: &[usize],
        inputs: Vec<ArrayViewD<'a, f64>>,
        results: Vec<ArrayViewMutD<'a, f64>>,
    ) -> Option<Self> {
        let mut shapes = inputs.iter().map(ArrayViewD::shape).chain(results.iter().map(ArrayViewMutD::shape));
        shapes.all(|found| found == shape).then_some(())?;
        let steps = (0..shape.len()).map(|axis| shape[axis + 1..].iter().product()).collect();
        Some(Self { first: 0, steps, shape: shape.to_vec(), inputs, results }.merged().longest_last())
    }

    /// Whether it takes less time than to wake threads.
    pub(crate) fn is_small(&self) -> bool {
        self.shape.iter().product::<usize>() * (self.inputs.len() + self.results.len()) < SMALL
    }

    /// Computes the value, and the Jacobian if requested.
    pub(crate) fn run(self, batch: &Batch, with_jacobian: bool) -> Result<Refused, Error> {
        self.share(if with_jacobian { batch.linearize } else { batch.value })
    }

    fn share(self, run: Run) -> Result<Refused, Error> {
        match self.shape[..] {
            [] => self.wrapped().compute(run),
            [_] => self.compute(run),
            [0, ..] => Ok(Refused::default()),
            [1, ..] => self.without(0).share(run),
            _ => {
                let is_small = self.is_small();
                let [one, other] = self.halves();
                let (one, other) = if is_small {
                    (one.share(run), other.share(run))
                } else {
                    rayon::join(|| one.share(run), || other.share(run))
                };
                Ok(one?.and(other?))
            }
        }
    }

    /// Computes all rows along the only axis.
    fn compute(self, run: Run) -> Result<Refused, Error> {
        fn column<T>(array: Result<T, ndarray::ShapeError>) -> T {
            array.expect("one axis is left")
        }
        let inputs: Vec<_> = self.inputs.into_iter().map(|array| column(array.into_dimensionality::<Ix1>())).collect();
        let results = self.results.into_iter().map(|array| column(array.into_dimensionality::<Ix1>()));
        match run(&inputs, &mut results.collect::<Vec<_>>()) {
            Ok(()) => Ok(Refused::default()),
            Err(Error::Rows { first, count }) => {
                Ok(Refused::new(self.first + first.row * self.steps[0], first.error, count))
            }
            Err(error) => Err(error),
        }
    }

    /// Adds an axis to a single point, which becomes a row.
    fn wrapped(self) -> Self {
        let inputs = self.inputs.into_iter().map(|array| array.insert_axis(Axis(0))).collect();
        let results = self.results.into_iter().map(|array| array.insert_axis(Axis(0))).collect();
        Self { steps: vec![1], shape: vec![1], inputs, results, ..self }
    }

    /// Merges adjacent axes wherever all arrays allow it.
    fn merged(mut self) -> Self {
        for axis in (1..self.shape.len()).rev() {
            let [outer, inner] = [self.shape[axis - 1], self.shape[axis]];
            let fits = |strides: &[isize]| strides[axis - 1] == strides[axis] * isize::try_from(inner).unwrap_or(0);
            let all = self.inputs.iter().all(|array| fits(array.strides()))
                && self.results.iter().all(|array| fits(array.strides()));
            if all && outer > 0 && inner > 0 {
                for array in &mut self.inputs {
                    array.merge_axes(Axis(axis - 1), Axis(axis));
                }
                for array in &mut self.results {
                    array.merge_axes(Axis(axis - 1), Axis(axis));
                }
                self.shape[axis] = outer * inner;
                self = self.without(axis - 1);
            }
        }
        self
    }

    /// Removes an axis of length 1.
    fn without(mut self, axis: usize) -> Self {
        self.shape.remove(axis);
        self.steps.remove(axis);
        let inputs = self.inputs.into_iter().map(|array| array.index_axis_move(Axis(axis), 0)).collect();
        let results = self.results.into_iter().map(|array| array.index_axis_move(Axis(axis), 0)).collect();
        Self { inputs, results, ..self }
    }

    /// Moves the longest axis to the end.
    fn longest_last(mut self) -> Self {
        let Some(longest) = (0..self.shape.len()).max_by_key(|&axis| self.shape[axis]) else { return self };
        let last = self.shape.len() - 1;
        self.shape.swap(longest, last);
        self.steps.swap(longest, last);
        self.inputs.iter_mut().for_each(|array| array.swap_axes(longest, last));
        self.results.iter_mut().for_each(|array| array.swap_axes(longest, last));
        self
    }

    /// Splits the call along the first axis.
    fn halves(self) -> [Self; 2] {
        let middle = self.shape[0] / 2;
        let (inputs, other_inputs) = self.inputs.into_iter().map(|array| array.split_at(Axis(0), middle)).unzip();
        let (results, other_results) = self.results.into_iter().map(|array| array.split_at(Axis(0), middle)).unzip();
        let of_length = |length| [&[length], &self.shape[1..]].concat();
        let other = Self {
            first: self.first + middle * self.steps[0],
            steps: self.steps.clone(),
            shape: of_length(self.shape[0] - middle),
            inputs: other_inputs,
            results: other_results,
        };
        [Self { shape: of_length(middle), inputs, results, ..self }, other]
    }
}

/// The components of a field, whose axes are the last ones, each as an array, in order.
pub(crate) fn components(array: ArrayViewD<'_, f64>, axes: usize) -> Vec<ArrayViewD<'_, f64>> {
    if axes == 0 {
        return vec![array];
    }
    let axis = Axis(array.ndim() - axes);
    let one = |k| components(array.clone().index_axis_move(axis, k), axes - 1);
    (0..array.len_of(axis)).flat_map(one).collect()
}

/// Like [`components`], for writing.
pub(crate) fn components_mut(mut array: ArrayViewMutD<'_, f64>, axes: usize) -> Vec<ArrayViewMutD<'_, f64>> {
    if axes == 0 {
        return vec![array];
    }
    let axis = Axis(array.ndim() - axes);
    let mut all = Vec::new();
    for _ in 0..array.len_of(axis) {
        let (first, rest) = array.split_at(axis, 1);
        all.extend(components_mut(first.index_axis_move(axis, 0), axes - 1));
        array = rest;
    }
    all
}
