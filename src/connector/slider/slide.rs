//! The direct route to increments, in space and in the plane: ratios n_i/n_k instead of directions normal to the line.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::pivots::Order;
use super::place::off_slope;
use super::span::{Span, Station};
use crate::number::scalar::Scalar;
use nalgebra::SVector;

/// The line, the position of node m, and the order of the axes, of which the last is kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide<D, O, const N: usize> {
    span: Span<D, N>,
    station: Station<D, N>,
    order: O,
}

/// The gradient of one eliminated increment.
pub(super) struct Row<D, const N: usize> {
    pub(super) x1: SVector<D, N>,
    pub(super) xn: SVector<D, N>,
    pub(super) xm: SVector<D, N>,
    pub(super) dx1: SVector<D, N>,
    pub(super) dxn: SVector<D, N>,
    pub(super) dxmk: D,
}

impl<D: Scalar, O: Order<N>, const N: usize> Slide<D, O, N> {
    #[inline(always)]
    pub(super) fn new(x1: &SVector<D, N>, xn: &SVector<D, N>, xm: &SVector<D, N>, order: O) -> Self {
        let span = Span::new(x1, xn);
        Self { span, station: Station::new(&span, x1, xn, xm), order }
    }

    /// The components of a vector in the order of the axes.
    #[inline(always)]
    fn arranged(&self, v: SVector<D, N>) -> SVector<D, N> {
        self.order.arranged(v.into()).into()
    }

    /// The increments dxm_axis = w_axis + (n_axis/n_k)(dxm_k − w_k) of the first axes, for w = (1−ξ) dx1 + ξ dxn.
    #[inline(always)]
    pub(super) fn increments<const M: usize>(&self, dx1: &SVector<D, N>, dxn: &SVector<D, N>, dxmk: D) -> [D; M] {
        let (d, w) = (self.arranged(self.span.d), self.arranged(self.station.blend(dx1, dxn)));
        let excess = self.order.if_known(dxmk) - w[N - 1];
        std::array::from_fn(|axis| w[axis] + d[axis] * excess / d[N - 1])
    }

    /// The common part of the gradients of all increments.
    #[inline(always)]
    pub(super) fn gradients(&self, dx1: &SVector<D, N>, dxn: &SVector<D, N>, dxmk: D) -> Gradients<D, O, N> {
        let Self { span, station, order } = *self;
        let d = self.arranged(span.d);
        let per_dk = d[N - 1].recip();
        let excess = dxmk - self.arranged(station.blend(dx1, dxn))[N - 1];
        Gradients {
            order,
            along: span.d,
            d,
            per_dk,
            shares: station.shares(),
            by_share: station.unscaled_gradients(&span),
            factor: span.factor() * per_dk,
            relative: self.arranged(dxn - dx1),
            lever: excess * per_dk * span.binade.per_unit,
        }
    }
}

/// d by axis, and in the order of the axes, and 1/d_k in units of the line's size; ξ and 1 − ξ; the gradients of ξ without their
/// factor, and that factor divided by d_k; dxn − dx1 in the order of the axes; and (dxm_k − w_k)/d_k, the derivative of an
/// increment with respect to the component of d along its axis.
pub(super) struct Gradients<D, O, const N: usize> {
    order: O,
    along: SVector<D, N>,
    d: SVector<D, N>,
    per_dk: D,
    shares: [D; 2],
    by_share: [SVector<D, N>; 2],
    factor: D,
    relative: SVector<D, N>,
    lever: D,
}

impl<D: Scalar, O: Order<N>, const N: usize> Gradients<D, O, N> {
    /// The gradient of the increment along the first, second, … axis in the order.
    #[inline(always)]
    pub(super) fn row(&self, axis: usize) -> Row<D, N> {
        let (d, relative) = (&self.d, self.relative);
        let slope = d[axis] * self.per_dk;
        let off_slope = |factor: D| off_slope(self.order, axis, slope, factor);
        let gain = (relative[axis] * d[N - 1] - d[axis] * relative[N - 1]) * self.factor;
        let ([share, rest], [by_x1, by_xn]) = (self.shares, self.by_share);
        let leaning = off_slope(self.lever);
        Row {
            x1: by_x1 * -gain - leaning,
            xn: by_xn * gain + leaning,
            xm: self.along * gain,
            dx1: off_slope(rest),
            dxn: off_slope(share),
            dxmk: slope,
        }
    }
}
