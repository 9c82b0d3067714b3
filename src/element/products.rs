//! Gradients of products of vectors.

use crate::scalar::Scalar;
use nalgebra::Vector3;

/// The gradients of the k-th component of a × b: by a, and by b.
#[inline]
pub(super) fn cross_gradient<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>, k: usize) -> [Vector3<D>; 2] {
    [across(b, k), -across(a, k)]
}

/// v times the k-th axis.
#[inline]
pub(super) fn across<D: Scalar>(v: &Vector3<D>, k: usize) -> Vector3<D> {
    let zero = D::zero();
    match k {
        0 => Vector3::new(zero, v.z, -v.y),
        1 => Vector3::new(-v.z, zero, v.x),
        _ => Vector3::new(v.y, -v.x, zero),
    }
}
