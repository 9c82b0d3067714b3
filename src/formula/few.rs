//! Sparse gradients of products of vectors.

#![expect(clippy::inline_always, reason = "the compiler sees the places, and where the zeros are")]

use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// A vector with at most two components that are not identically zero: their indices and values.
///
/// The zeros are not stored, so that no operations are spent on them and none of them acquires a sign.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Few<D>([(usize, D); 2]);

impl<D: Scalar> Few<D> {
    #[inline(always)]
    pub(crate) fn two(one: (usize, D), other: (usize, D)) -> Self {
        Self([one, other])
    }
    #[inline(always)]
    pub(crate) fn vector(self) -> Vector3<D> {
        self.times(D::one())
    }
    #[inline(always)]
    pub(crate) fn times(self, factor: D) -> Vector3<D> {
        self.made(|x| x * factor)
    }
    /// The vector with `make` applied to these components.
    #[inline(always)]
    fn made(self, make: impl Fn(D) -> D) -> Vector3<D> {
        let [one, other] = self.0;
        let at = |k: usize| match k {
            _ if k == one.0 => make(one.1),
            _ if k == other.0 => make(other.1),
            _ => D::zero(),
        };
        Vector3::new(at(0), at(1), at(2))
    }
    /// v + factor times this vector.
    #[inline(always)]
    pub(crate) fn added_to(self, v: &Vector3<D>, factor: D) -> Vector3<D> {
        let [one, other] = self.0;
        let at = |k: usize| match k {
            _ if k == one.0 => v[k] + one.1 * factor,
            _ if k == other.0 => v[k] + other.1 * factor,
            _ => v[k],
        };
        Vector3::new(at(0), at(1), at(2))
    }
}

/// The two cyclic successors of an index.
#[inline(always)]
pub(crate) fn next(k: usize) -> [usize; 2] {
    [(k + 1) % 3, (k + 2) % 3]
}

/// The gradients of the k-th component of a × b, with respect to a and to b.
#[inline(always)]
pub(crate) fn cross_gradient<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>, k: usize) -> [Few<D>; 2] {
    let [l, m] = next(k);
    [Few::two((l, b[m]), (m, -b[l])), Few::two((l, -a[m]), (m, a[l]))]
}
