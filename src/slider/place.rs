//! The place of node m on the line from one of its coordinates, in space and in the plane.

use super::span::Span;
use crate::scalar::{Scalar, abs};
use nalgebra::SVector;

/// Where on the line the k-th coordinate has a given value: ahead of an end of the line by `ahead`, measured along k.
///
/// The end is the one that is nearer, so that no distance is formed that is larger than it must be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<D, const N: usize> {
    k: usize,
    /// In units of the line's size.
    d: SVector<D, N>,
    end: SVector<D, N>,
    ahead: D,
    nearer_to_n: bool,
    per_unit: D,
}

impl<D: Scalar, const N: usize> Place<D, N> {
    #[inline]
    pub(super) fn new(x1: &SVector<D, N>, xn: &SVector<D, N>, k: usize, xmk: D) -> Self {
        let Span { d, binade, .. } = Span::new(x1, xn);
        let (from_1, from_n) = (xmk - x1[k], xmk - xn[k]);
        let nearer_to_n = abs(from_n) < abs(from_1);
        let (end, ahead) = if nearer_to_n { (*xn, from_n) } else { (*x1, from_1) };
        Self { k, d, end, ahead, nearer_to_n, per_unit: binade.per_unit }
    }

    /// The coordinate along another axis.
    #[inline]
    pub(super) fn coordinate(&self, axis: usize) -> D {
        self.end[axis] + self.d[axis] * self.ahead / self.d[self.k]
    }

    /// n_axis/n_k, the derivative of the coordinate by the given one.
    #[inline]
    pub(super) fn slope(&self, axis: usize) -> D {
        self.d[axis] / self.d[self.k]
    }

    /// The gradients of the coordinate with respect to x1 and xn: the shares 1 − ζ and ζ of the nodes, across the slope.
    #[inline]
    pub(super) fn gradients(&self, axis: usize) -> [SVector<D, N>; 2] {
        let tau = self.ahead * self.per_unit / self.d[self.k];
        let (rest, share) = if self.nearer_to_n { (-tau, tau + 1.0) } else { (-tau + 1.0, tau) };
        let slope = self.slope(axis);
        [off_slope(axis, self.k, slope, rest), off_slope(axis, self.k, slope, share)]
    }
}

/// The gradient of x_axis − slope x_k, times a factor.
#[inline]
pub(super) fn off_slope<D: Scalar, const N: usize>(axis: usize, k: usize, slope: D, factor: D) -> SVector<D, N> {
    let component = |c: usize| match c {
        c if c == axis => factor,
        c if c == k => -slope * factor,
        _ => D::zero(),
    };
    SVector::from_fn(|c, _| component(c))
}
