//! Gradients of products of vectors: hardly any of their components is not zero.

#![expect(clippy::inline_always, reason = "the compiler sees the places, and where the zeros are")]

use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// A vector of which at most two components are not zero everywhere: their places and values.
///
/// The zeros are no numbers that are multiplied, so that nobody computes with them, and none gets a sign.
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
    /// The vector of what is made of these components.
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
    /// v + factor times this.
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

/// The places that follow one in turn.
#[inline(always)]
pub(crate) fn next(k: usize) -> [usize; 2] {
    [(k + 1) % 3, (k + 2) % 3]
}

/// The gradients of the k-th component of a × b: by a, and by b.
#[inline(always)]
pub(crate) fn cross_gradient<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>, k: usize) -> [Few<D>; 2] {
    let [l, m] = next(k);
    [Few::two((l, b[m]), (m, -b[l])), Few::two((l, -a[m]), (m, a[l]))]
}
