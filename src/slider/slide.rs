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
        let per_dk = self.span.d[self.k].recip();
        let excess = dxmk - self.station.blend(dx1, dxn)[self.k];
        Gradients {
            d: self.span.d,
            k: self.k,
            per_dk,
            shares: self.station.shares(),
            by_share: self.station.gradients(&self.span),
            relative: dxn - dx1,
            lever: excess * per_dk * self.span.binade.per_unit,
        }
    }
}

/// d, k and 1/d_k in units of the line's size; ξ and 1 − ξ; the gradients of ξ; dxn − dx1; and (dxm_k − w_k)/d_k, by which an
/// increment grows with the component of d along its axis.
pub(super) struct Gradients<D, const N: usize> {
    d: SVector<D, N>,
    k: usize,
    per_dk: D,
    shares: [D; 2],
    by_share: [SVector<D, N>; 3],
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
        let gain = (relative[axis] * d[k] - d[axis] * relative[k]) * self.per_dk;
        let [share, rest] = self.shares;
        let [by_x1, by_xn, by_xm] = self.by_share;
        Row {
            x1: by_x1 * gain - off_slope(self.lever),
            xn: by_xn * gain + off_slope(self.lever),
            xm: by_xm * gain,
            dx1: off_slope(rest),
            dxn: off_slope(share),
            dxmk: slope,
        }
    }
}
