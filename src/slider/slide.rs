//! The direct route to increments, in space and in the plane: slopes n/n_k instead of directions across the line.

use super::station::Station;
use crate::scalar::Scalar;
use nalgebra::SVector;

/// The line in units of its k-th component: slope = d/d_k, with `slope[k]` = 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide<D, const N: usize> {
    d: SVector<D, N>,
    k: usize,
    pub(super) slope: SVector<D, N>,
    /// d·d/d_k, so that ξ = (xm − x1)·slope / length.
    length: D,
    pub(super) station: Station<D, N>,
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
    pub(super) fn new(x1: SVector<D, N>, xn: SVector<D, N>, xm: SVector<D, N>, k: usize) -> Self {
        let d = xn - x1;
        let slope = d / d[k];
        let length = slope.dot(&slope) * d[k];
        Self { d, k, slope, length, station: Station::new([&x1, &xn, &xm], &slope, length) }
    }

    /// What the gradients of all increments share.
    #[inline]
    pub(super) fn gradients(self, dx1: &SVector<D, N>, dxn: &SVector<D, N>, dxmk: D) -> Gradients<D, N> {
        let [share, rest] = self.station.shares();
        let (per_length, per_dk) = (self.length.recip(), self.d[self.k].recip());
        let aside = self.station.aside(&self.d) * per_dk;
        Gradients {
            share,
            rest,
            relative: dxn - dx1,
            share_x1: (aside + self.slope * rest) * -per_length,
            share_xn: (aside - self.slope * share) * per_length,
            share_xm: self.slope * per_length,
            lever: (dxmk - self.station.blend(dx1, dxn)[self.k]) * per_dk,
            slide: self,
        }
    }
}

/// ξ, 1 − ξ and the gradient of ξ; dxn − dx1; and (dxm_k − w_k)/d_k, by which an increment grows with d_i.
pub(super) struct Gradients<D, const N: usize> {
    slide: Slide<D, N>,
    share: D,
    rest: D,
    relative: SVector<D, N>,
    share_x1: SVector<D, N>,
    share_xn: SVector<D, N>,
    share_xm: SVector<D, N>,
    lever: D,
}

impl<D: Scalar, const N: usize> Gradients<D, N> {
    /// The gradient of dxm_axis = w_axis + slope_axis (dxm_k − w_k).
    #[inline]
    pub(super) fn row(&self, axis: usize) -> Row<D, N> {
        let (k, slope) = (self.slide.k, self.slide.slope[axis]);
        // The gradient of x_axis − slope_axis x_k, times a factor.
        let off_slope = |factor: D| {
            let mut v = SVector::from_element(D::zero());
            (v[axis], v[k]) = (factor, -slope * factor);
            v
        };
        let gain = self.relative[axis] - slope * self.relative[k];
        Row {
            x1: self.share_x1 * gain - off_slope(self.lever),
            xn: self.share_xn * gain + off_slope(self.lever),
            xm: self.share_xm * gain,
            dx1: off_slope(self.rest),
            dxn: off_slope(self.share),
            dxmk: slope,
        }
    }
}
