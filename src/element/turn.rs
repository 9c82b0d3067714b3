//! The angle −atan2(e·p, e·q), by which Cardan's first and third angle are measured, and its derivative by the spin of e.
//!
//! With i² = −1, P = q + i p and z = e·P, the angle is −Im ln z. Its derivative by the spin of e is −Im Y with Y = e × W and
//! W = P/z. Where p and q are perpendicular and equally long, P·P is 0, and ∂Y/∂e is −W Yᵀ; what P·P adds is kept apart,
//! so that nothing cancels in it.
//!
//! Turned by a spin φ of p and q and a spin ψ of e, Y changes by (e ⊗ W − I − Y ⊗ Y) ψ + (I − W ⊗ e + Y ⊗ Y) φ. Its imaginary
//! part has no unit matrix left: one matrix and its transpose say how the derivative turns.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use super::products::double_cross;
use crate::formula::along;
use crate::scalar::{Scalar, norm_and_direction};
use nalgebra::{Matrix3, Vector3};

/// W = k − i u and Y = h − i v.
#[derive(Clone, Copy)]
pub(super) struct Turn<D> {
    e: Vector3<D>,
    k: Vector3<D>,
    u: Vector3<D>,
    h: Vector3<D>,
    v: Vector3<D>,
    /// P/z², real and imaginary.
    square: [Vector3<D>; 2],
    /// P·P/z², real and imaginary.
    skewed: [D; 2],
}

impl<D: Scalar> Turn<D> {
    #[inline(always)]
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
            skewed: [stretch * cos + shear * sin, shear * cos - stretch * sin],
        }
    }

    /// The derivative of the angle by the spin of e.
    #[inline(always)]
    pub(super) fn row(&self) -> Vector3<D> {
        self.v
    }

    /// The gradient of the n-th component of [`row`](Self::row): by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn row_gradient(&self, n: usize) -> [Vector3<D>; 3] {
        let Self { e, k, u, h, v, square: [re, im], skewed: [_, skewed] } = self;
        let twice = double_cross(e, e).column(n).into_owned();
        let by_e = -(v * k[n] + h * u[n]) - e.cross(&unit(n)) * *skewed;
        [by_e, -re.cross(&twice), -im.cross(&twice)]
    }

    /// How [`row`](Self::row) changes with the spin of e; with that of p and q it changes by the transpose, negative.
    #[inline(always)]
    pub(super) fn curvature(&self) -> Matrix3<D> {
        let Self { e, u, h, v, .. } = self;
        e * u.transpose() - h * v.transpose() - v * h.transpose()
    }

    /// What the gradients of [`curvature`](Self::curvature) are made of.
    #[inline(always)]
    pub(super) fn curving(self) -> Curving<D> {
        Curving {
            by_u: [self.u_gradient(0), self.u_gradient(1), self.u_gradient(2)],
            by_h: [self.h_gradient(0), self.h_gradient(1), self.h_gradient(2)],
            by_v: [self.row_gradient(0), self.row_gradient(1), self.row_gradient(2)],
            turn: self,
        }
    }

    /// As [`row_gradient`](Self::row_gradient), of u.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn u_gradient(&self, n: usize) -> [Vector3<D>; 3] {
        let Self { e, k, u, square: [re, im], .. } = self;
        let across = |g: &Vector3<D>| double_cross(g, e).row(n).transpose();
        [-(u * k[n] + k * u[n]), across(re), across(im)]
    }

    /// As [`row_gradient`](Self::row_gradient), of h.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn h_gradient(&self, n: usize) -> [Vector3<D>; 3] {
        let Self { e, k, u, h, v, square: [re, im], skewed: [skewed, _] } = self;
        let twice = double_cross(e, e).column(n).into_owned();
        let by_e = v * u[n] - h * k[n] + e.cross(&unit(n)) * *skewed;
        [by_e, -im.cross(&twice), re.cross(&twice)]
    }
}

/// A turn with the gradients of its vectors: by e, p and q, component by component.
pub(super) struct Curving<D> {
    turn: Turn<D>,
    by_u: [[Vector3<D>; 3]; 3],
    by_h: [[Vector3<D>; 3]; 3],
    by_v: [[Vector3<D>; 3]; 3],
}

impl<D: Scalar> Curving<D> {
    /// The gradient of an entry of the curvature: by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn gradient(&self, r: usize, c: usize) -> [Vector3<D>; 3] {
        let (Turn { e, u, h, v, .. }, Self { by_u, by_h, by_v, .. }) = (&self.turn, self);
        let turned = |k: usize| by_h[r][k] * v[c] + by_v[c][k] * h[r] + by_v[r][k] * h[c] + by_h[c][k] * v[r];
        let by = |k: usize| by_u[c][k] * e[r] - turned(k);
        [by(0) + along(r, u[c]), by(1), by(2)]
    }
}

/// The n-th axis.
#[inline(always)]
fn unit<D: Scalar>(n: usize) -> Vector3<D> {
    along(n, D::one())
}
