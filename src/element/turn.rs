//! The angle −atan2(e·p, e·q), by which Cardan's first and third angle are measured, and its derivatives by the spin of e.
//!
//! With i² = −1, P = q + i p and z = e·P, the angle is −Im ln z. Its first derivative by the spin of e is −Im Y with
//! Y = e × P/z, its second one Im(Y Yᵀ − e Wᵀ) with W = P/z. Where p and q are perpendicular and equally long, P·P is 0,
//! and ∂Y/∂e is −W Yᵀ; what P·P adds is kept apart, so that nothing cancels in it.

use super::products::double_cross;
use crate::formula::along;
use crate::scalar::{Scalar, norm_and_direction};
use nalgebra::{Matrix3, Vector3};

/// W = k − i u and Y = h − i v.
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

/// The gradient of a number by e, p and q.
type Gradient<D> = [Vector3<D>; 3];

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
            skewed: [stretch * cos + shear * sin, shear * cos - stretch * sin],
        }
    }

    /// The derivative of the angle by the spin of e.
    #[inline]
    pub(super) fn row(&self) -> Vector3<D> {
        self.v
    }

    /// The gradient of the n-th component of [`row`](Self::row).
    #[inline]
    pub(super) fn row_gradient(&self, n: usize) -> Gradient<D> {
        let Self { e, k, u, h, v, square: [re, im], skewed } = self;
        let (one, twice) = (along(n, D::one()), double_cross(e, e).column(n).into_owned());
        let by_e = -(v * k[n] + h * u[n]) - e.cross(&one) * skewed[1];
        [by_e, -re.cross(&twice), -im.cross(&twice)]
    }

    /// The gradient of the n-th component of h.
    #[inline]
    fn h_gradient(&self, n: usize) -> Gradient<D> {
        let Self { e, k, u, h, v, square: [re, im], skewed } = self;
        let (one, twice) = (along(n, D::one()), double_cross(e, e).column(n).into_owned());
        let by_e = v * u[n] - h * k[n] + e.cross(&one) * skewed[0];
        [by_e, -im.cross(&twice), re.cross(&twice)]
    }

    /// The gradient of the n-th component of u.
    #[inline]
    fn u_gradient(&self, n: usize) -> Gradient<D> {
        let Self { e, k, u, square, .. } = self;
        let [re, im] = square.map(|part| double_cross(&part, e).row(n).transpose());
        [-(u * k[n] + k * u[n]), re, im]
    }

    /// How [`row`](Self::row) changes with the spin of e.
    #[inline]
    pub(super) fn curvature(&self) -> Matrix3<D> {
        let twice = self.v * self.h.transpose();
        self.e * self.u.transpose() - twice - twice.transpose()
    }

    /// The gradient of an entry of [`curvature`](Self::curvature).
    #[inline]
    pub(super) fn curvature_gradient(&self, row: usize, column: usize) -> Gradient<D> {
        let Self { e, u, h, v, .. } = self;
        let [v_row, v_column] = [row, column].map(|n| self.row_gradient(n));
        let [h_row, h_column] = [row, column].map(|n| self.h_gradient(n));
        let by_u = self.u_gradient(column);
        let mut all = std::array::from_fn(|x| {
            let of_v = v_row[x] * h[column] + v_column[x] * h[row];
            by_u[x] * e[row] - of_v - h_row[x] * v[column] - h_column[x] * v[row]
        });
        all[0][row] += u[column];
        all
    }
}
