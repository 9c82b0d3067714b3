//! Vectors and matrices in 237 bits.

use crate::Octuple;
use nalgebra::{DMatrix, DVector};
use num_dual::DualNum;
use num_traits::Zero;

pub(crate) type Matrix = DMatrix<Octuple>;
pub(crate) type Vector = DVector<Octuple>;

pub(super) fn dot(a: &[Octuple], b: &[Octuple]) -> Octuple {
    a.iter().zip(b).fold(Octuple::zero(), |sum, (&a, &b)| sum + a * b)
}

/// The smallest relative size of the part of a row that is independent of the rows before it.
pub(super) fn independence(rows: &Matrix) -> f64 {
    let mut directions: Vec<Vec<Octuple>> = Vec::new();
    let mut least = f64::INFINITY;
    for row in rows.row_iter() {
        let whole: Vec<_> = row.iter().copied().collect();
        let mut rest = whole.clone();
        for direction in &directions {
            let part = dot(&rest, direction);
            rest.iter_mut().zip(direction).for_each(|(x, &d)| *x -= part * d);
        }
        let [size, left] = [&whole, &rest].map(|v| dot(v, v).sqrt());
        least = least.min((left / size).to_f64());
        directions.push(rest.into_iter().map(|x| x / left).collect());
    }
    if least.is_nan() { 0.0 } else { least }
}

/// Two matrices side by side.
pub(super) fn beside(left: &Matrix, right: &Matrix) -> Matrix {
    Matrix::from_fn(left.nrows(), left.ncols() + right.ncols(), |row, k| {
        if k < left.ncols() { left[(row, k)] } else { right[(row, k - left.ncols())] }
    })
}

/// A vector as a matrix of one column.
pub(super) fn column(vector: &Vector) -> Matrix {
    Matrix::from_column_slice(vector.len(), 1, vector.as_slice())
}
