//! Matrices of products of vectors.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// \[v×\]: the matrix that maps w to v × w.
#[inline(always)]
pub(crate) fn skew<D: Scalar>(v: &Vector3<D>) -> Matrix3<D> {
    let zero = D::zero();
    Matrix3::new(zero, -v.z, v.y, v.z, zero, -v.x, -v.y, v.x, zero)
}

/// a ⊗ b − (a·b) I = \[b×\] \[a×\]: the matrix that maps w to b × (a × w).
///
/// Its diagonal is a sum over the other two axes, without the product that would cancel.
#[inline(always)]
pub(crate) fn double_cross<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> Matrix3<D> {
    let diagonal = |j: usize, k: usize| -(a[j] * b[j] + a[k] * b[k]);
    let mut m = a * b.transpose();
    m[(0, 0)] = diagonal(1, 2);
    m[(1, 1)] = diagonal(2, 0);
    m[(2, 2)] = diagonal(0, 1);
    m
}
