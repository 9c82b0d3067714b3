//! The angle −atan2(e·p, e·q), by which Cardan's first and third angle are measured, and its derivative by the spin of e.
//!
//! With i² = −1, P = q + i p and z = e·P, the angle is −Im ln z. Its derivative by the spin of e is −Im Y with Y = e × W and
//! W = P/z. Where p and q are perpendicular and equally long, P·P is 0, and ∂Y/∂e is −W Yᵀ; what P·P adds is kept apart,
//! so that nothing cancels in it.

use super::products::double_cross;
use crate::formula::along;
use crate::scalar::{Scalar, norm_and_direction};
use nalgebra::Vector3;

/// W = k − i u and Y = h − i v.
pub(super) struct Turn<D> {
    e: Vector3<D>,
    k: Vector3<D>,
    u: Vector3<D>,
    h: Vector3<D>,
    v: Vector3<D>,
    /// P/z², real and imaginary.
    square: [Vector3<D>; 2],
    /// P·P/z², imaginary.
    skewed: D,
}

impl<D: Scalar> Turn<D> {
    #[inline]
    pub(super) fn new(e: &Vector3<D>, p: &Vector3<D>, q: &Vector3<D>) -> Self {
        let (r, [c, s]) = norm_and_direction([e.dot(q), e.dot(p)]);
        let (along, across) = (c / r, s / r);
        let (k, u) = (p * across + q * along, q * across - p * along);
        let (cos, sin) = ((c - s) * (c + s) / r / r, c * s * 2.0 / r / r);
        let (stretch, shear) = ((q - p).dot(&(q + p)), p.dot(q) * 2.0);
        Self {
            e: *e,
            k,
            u,
            h: e.cross(&k),
            v: e.cross(&u),
            square: [q * cos + p * sin, p * cos - q * sin],
            skewed: shear * cos - stretch * sin,
        }
    }

    /// The derivative of the angle by the spin of e.
    #[inline]
    pub(super) fn row(&self) -> Vector3<D> {
        self.v
    }

    /// The gradient of the n-th component of [`row`](Self::row): by e, p and q.
    #[inline]
    pub(super) fn row_gradient(&self, n: usize) -> [Vector3<D>; 3] {
        let Self { e, k, u, h, v, square: [re, im], skewed } = self;
        let (one, twice) = (along(n, D::one()), double_cross(e, e).column(n).into_owned());
        let by_e = -(v * k[n] + h * u[n]) - e.cross(&one) * *skewed;
        [by_e, -re.cross(&twice), -im.cross(&twice)]
    }
}
