//! The position of node m on the line from one of its coordinates, in space and in the plane.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::pivots::Order;
use super::span::Span;
use crate::number::scalar::{Scalar, abs};
use nalgebra::SVector;

/// The point of the line whose k-th coordinate has a given value: ahead of an end of the line by `ahead`, measured along k.
///
/// The nearer end is used, so that no distance is larger than necessary.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<D, O, const N: usize> {
    order: O,
    /// In the order of the axes, and in units of the line's size.
    d: [D; N],
    end: [D; N],
    ahead: D,
    nearer_to_n: bool,
    per_unit: D,
}

impl<D: Scalar, O: Order<N>, const N: usize> Place<D, O, N> {
    #[inline(always)]
    pub(super) fn new(x1: &SVector<D, N>, xn: &SVector<D, N>, order: O, xmk: D) -> Self {
        let Span { d, binade, .. } = Span::new(x1, xn);
        let [d, x1, xn] = [d, *x1, *xn].map(|v| order.arranged(v.into()));
        let (from_1, from_n) = (xmk - x1[N - 1], xmk - xn[N - 1]);
        let nearer_to_n = abs(from_n) < abs(from_1);
        let (end, ahead) = if nearer_to_n { (xn, from_n) } else { (x1, from_1) };
        Self { order, d, end, ahead: order.if_known(ahead), nearer_to_n, per_unit: binade.per_unit }
    }

    /// The coordinate along the first, second, … axis in the order.
    #[inline(always)]
    pub(super) fn coordinate(&self, axis: usize) -> D {
        self.end[axis] + self.d[axis] * self.ahead / self.d[N - 1]
    }

    /// n_axis/n_k, the derivative of the coordinate with respect to the given one.
    #[inline(always)]
    pub(super) fn slope(&self, axis: usize) -> D {
        self.d[axis] / self.d[N - 1]
    }

    /// The gradients of the coordinate with respect to x1 and xn: those of x_axis − slope x_k times the weights 1 − ζ and ζ of
    /// the nodes.
    #[inline(always)]
    pub(super) fn gradients(&self, axis: usize) -> [SVector<D, N>; 2] {
        let tau = self.ahead * self.per_unit / self.d[N - 1];
        let (rest, share) = if self.nearer_to_n { (-tau, tau + 1.0) } else { (-tau + 1.0, tau) };
        let slope = self.slope(axis);
        [rest, share].map(|share| off_slope(self.order, axis, slope, share))
    }
}

/// The gradient of x_axis − slope x_k, times a factor.
#[inline(always)]
pub(super) fn off_slope<D: Scalar, O: Order<N>, const N: usize>(
    order: O,
    axis: usize,
    slope: D,
    factor: D,
) -> SVector<D, N> {
    let component = |c: usize| match c {
        c if c == axis => factor,
        c if c == N - 1 => -slope * factor,
        _ => D::zero(),
    };
    order.by_axis(std::array::from_fn(component)).into()
}
