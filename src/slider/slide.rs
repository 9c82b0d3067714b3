//! The direct route to increments, in space and in the plane: ratios n_i/n_k instead of directions across the line.

use super::place::off_slope;
use super::span::{Span, Station};
use crate::scalar::Scalar;
use nalgebra::SVector;

/// The line, the place of node m, and the axis k whose coordinate is kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide<D, const N: usize> {
    span: Span<D, N>,
    station: Station<D, N>,
    k: usize,
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

impl<D: Scalar, const N: usize> Slide<D, N> {
    #[inline]
    pub(super) fn new(x1: &SVector<D, N>, xn: &SVector<D, N>, xm: &SVector<D, N>, k: usize) -> Self {
        let span = Span::new(x1, xn);
        Self { span, station: Station::new(&span, x1, xn, xm), k }
    }

    /// The increments dxm_axis = w_axis + (n_axis/n_k)(dxm_k − w_k) of some axes, for w = (1−ξ) dx1 + ξ dxn.
    #[inline]
    pub(super) fn increments<const M: usize>(
        &self,
        axes: [usize; M],
        dx1: &SVector<D, N>,
        dxn: &SVector<D, N>,
        dxmk: D,
    ) -> [D; M] {
        let (d, w) = (&self.span.d, self.station.blend(dx1, dxn));
        axes.map(|axis| w[axis] + d[axis] * (dxmk - w[self.k]) / d[self.k])
    }

    /// What the gradients of all increments share.
    #[inline]
    pub(super) fn gradients(&self, dx1: &SVector<D, N>, dxn: &SVector<D, N>, dxmk: D) -> Gradients<D, N> {
        let Self { span, station, k } = *self;
        let (per_dk, per_unit) = (span.d[k].recip(), span.binade.per_unit);
        let excess = dxmk - station.blend(dx1, dxn)[k];
        Gradients {
            d: span.d,
            k,
            per_dk,
            shares: station.shares(),
            by_share: station.unscaled_gradients(&span),
            factor: span.factor() * per_dk,
            relative: dxn - dx1,
            lever: excess * per_dk * per_unit,
        }
    }
}

/// d, k and 1/d_k in units of the line's size; ξ and 1 − ξ; the gradients of ξ without their factor, and the factor over d_k;
/// dxn − dx1; and (dxm_k − w_k)/d_k, by which an increment grows with the component of d along its axis.
pub(super) struct Gradients<D, const N: usize> {
    d: SVector<D, N>,
    k: usize,
    per_dk: D,
    shares: [D; 2],
    by_share: [SVector<D, N>; 2],
    factor: D,
    relative: SVector<D, N>,
    lever: D,
}

impl<D: Scalar, const N: usize> Gradients<D, N> {
    /// The gradient of dxm_axis.
    #[inline]
    pub(super) fn row(&self, axis: usize) -> Row<D, N> {
        let (d, k, relative) = (&self.d, self.k, &self.relative);
        let slope = d[axis] * self.per_dk;
        let off_slope = |factor: D| off_slope(axis, k, slope, factor);
        let gain = (relative[axis] * d[k] - d[axis] * relative[k]) * self.factor;
        let ([share, rest], [by_x1, by_xn]) = (self.shares, self.by_share);
        let leaning = off_slope(self.lever);
        Row {
            x1: by_x1 * -gain - leaning,
            xn: by_xn * gain + leaning,
            xm: d * gain,
            dx1: off_slope(rest),
            dxn: off_slope(share),
            dxmk: slope,
        }
    }
}
