//! The angle −atan2(e·p, e·q), by which Cardan's first and third angle are measured, and its derivative by the spin of e.
//!
//! With i² = −1, P = q + i p and z = e·P, the angle is −Im ln z. Its derivative by the spin of e is −Im Y with Y = e × W and
//! W = P/z. ∂Y/∂P is ([e×] − Y eᵀ)/z. Where p and q are perpendicular and equally long, P·P is 0, and ∂Y/∂e is −W ⊗ Y; what
//! P·P adds is kept apart, so that nothing cancels in it.
//!
//! Turned by a spin φ of p and q and a spin ψ of e, Y changes by (e ⊗ W − I − Y ⊗ Y) ψ + (I − W ⊗ e + Y ⊗ Y) φ. Its imaginary
//! part has no unit matrix left: one matrix, Im(Y ⊗ Y − e ⊗ W), and its transpose say how the derivative turns. By e that matrix
//! changes by −Im W ⊗ (Y ⊗ Y + W ⊗ (e × Y)), in which I + Y ⊗ Y, which cancels, is written as e ⊗ W + W ⊗ (e × Y).

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use super::products::double_cross;
use crate::formula::{along, cross_gradient};
use crate::scalar::{Scalar, is_between, norm_and_direction, number_if};
use nalgebra::{Matrix3, Vector3};

/// W = k − i u and Y = h − i v.
#[derive(Clone, Copy)]
pub(super) struct Turn<D> {
    e: Vector3<D>,
    k: Vector3<D>,
    u: Vector3<D>,
    h: Vector3<D>,
    v: Vector3<D>,
    /// 1/z = re − i im.
    inverse: [D; 2],
    /// P/z², real and imaginary.
    square: [Vector3<D>; 2],
    /// P·P/z², real and imaginary.
    skewed: [D; 2],
}

impl<D: Scalar> Turn<D> {
    #[inline(always)]
    pub(super) fn new(e: &Vector3<D>, p: &Vector3<D>, q: &Vector3<D>) -> Self {
        let (inverse @ [along, across], [per, more]) = inverse([e.dot(q), e.dot(p)]);
        // The difference q (e·p) − p (e·q), which u is of, would lose the digits of small components.
        let (k, u) = (p * across + q * along, e.cross(&(q * per).cross(&(p * more))));
        let (cos, sin) = ((along - across) * (along + across), along * across * 2.0);
        let (stretch, shear) = ((q - p).dot(&(q + p)), p.dot(q) * 2.0);
        Self {
            e: *e,
            k,
            u,
            h: e.cross(&k),
            v: e.cross(&u),
            inverse,
            square: [q * cos + p * sin, p * cos - q * sin],
            skewed: [stretch * cos + shear * sin, shear * cos - stretch * sin],
        }
    }

    /// The derivative of the angle by the spin of e.
    #[inline(always)]
    pub(super) fn row(&self) -> Vector3<D> {
        self.v
    }

    /// The gradient of a number of times the n-th component of [`row`](Self::row): by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn row_gradient(&self, times: D, n: usize) -> [Vector3<D>; 3] {
        let Self { e, k, u, h, v, inverse, skewed: [_, skewed], .. } = self;
        let ([_, axial], [re, im]) = (cross_gradient(e, e, n), inverse.map(|part| part * times));
        let by_e = v * (k[n] * -times) - h * (u[n] * times);
        let (by_p, by_q) = (e * (h[n] * re - v[n] * im), e * -(h[n] * im + v[n] * re));
        [by_e + axial.times(*skewed * times), by_p + axial.times(-re), by_q + axial.times(im)]
    }

    /// How [`row`](Self::row) changes with the spin of e; with that of p and q it changes by the transpose, negative.
    #[inline(always)]
    pub(super) fn curvature(&self) -> Matrix3<D> {
        let Self { e, u, h, v, .. } = self;
        e * u.transpose() - h * v.transpose() - v * h.transpose()
    }

    /// The gradients of the entries of a number of times [`curvature`](Self::curvature): by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn curving(&self, times: D) -> Curving<D> {
        let Self { e, k, u, h, v, square: [re, im], skewed: [real, imaginary], .. } = self;
        // e × Y = x − i y; its imaginary part is that of −(e·e) W.
        let (x, y) = (e.cross(h), u * -e.dot(e));
        let (ht, vt) = (h.transpose() * times, v.transpose() * times);
        let (xt, yt) = (x.transpose() * times, y.transpose() * times);
        Curving {
            turn: *self,
            times,
            twice: double_cross(e, e),
            by_k: h * vt + v * ht + k * yt + u * xt,
            by_u: h * ht - v * vt + k * xt - u * yt,
            skewed_w: (k * *imaginary - u * *real) * times,
            skewed_y: (h * *imaginary - v * *real) * times,
            by_p: im * vt + re * ht,
            by_q: im * ht - re * vt,
        }
    }

    /// The gradient of the n-th component of u: by p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn u_by_pq(&self, n: usize) -> [Vector3<D>; 2] {
        let across = |g: &Vector3<D>| double_cross(g, &self.e).row(n).transpose();
        [across(&self.square[0]), across(&self.square[1])]
    }
}

/// The real part of 1/(c + i s), and the imaginary one with the other sign; then two numbers whose product is 1/(c² + s²).
#[inline(always)]
fn inverse<D: Scalar>([c, s]: [D; 2]) -> ([D; 2], [D; 2]) {
    let square = c * c + s * s;
    let is_usual = is_between(square, 1e-280, 1e280);
    if !is_usual && D::has_extremes() {
        return extreme_inverse([c, s]);
    }
    let per_square = number_if(is_usual, square.recip());
    ([c * per_square, s * per_square], [per_square, D::one()])
}

/// [`inverse`] where squares under- or overflow.
#[cold]
fn extreme_inverse<D: Scalar>(z: [D; 2]) -> ([D; 2], [D; 2]) {
    let (size, direction) = norm_and_direction(z);
    (direction.map(|part| part / size), [size.recip(); 2])
}

/// A turn with what the gradients of its curvature are made of; all that follows `twice` is multiplied by `times`.
pub(super) struct Curving<D> {
    turn: Turn<D>,
    times: D,
    /// e ⊗ e − (e·e) I.
    twice: Matrix3<D>,
    /// Y ⊗ Y + W ⊗ (e × Y), imaginary with the other sign, and real.
    by_k: Matrix3<D>,
    by_u: Matrix3<D>,
    /// W P·P/z² and Y P·P/z², imaginary.
    skewed_w: Vector3<D>,
    skewed_y: Vector3<D>,
    by_p: Matrix3<D>,
    by_q: Matrix3<D>,
}

impl<D: Scalar> Curving<D> {
    /// The gradient of an entry of the curvature: by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn gradient(&self, r: usize, c: usize) -> [Vector3<D>; 3] {
        let [by_p, by_q] = self.turn.u_by_pq(c).map(|by| by * (self.turn.e[r] * self.times));
        let [turned_p, turned_q] = self.turned(r, c);
        [self.by_e(r, c) + self.skewed(r, c), by_p + turned_p, by_q + turned_q]
    }

    /// By e where P·P is 0.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn by_e(&self, r: usize, c: usize) -> Vector3<D> {
        let (Turn { k, u, .. }, Self { by_k, by_u, .. }) = (&self.turn, self);
        by_k.row(c).transpose() * k[r] + by_u.row(c).transpose() * u[r]
    }

    /// What P·P adds.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn skewed(&self, r: usize, c: usize) -> Vector3<D> {
        let (Turn { e, .. }, Self { twice, skewed_w, skewed_y, .. }) = (&self.turn, self);
        e.cross(&along(r, skewed_y[c])) + e.cross(&along(c, skewed_y[r])) + twice.column(r) * skewed_w[c]
    }

    /// The gradient of an entry of −h ⊗ v − v ⊗ h by p and q. The sums are such that the compiler finds that of the mirror image
    /// equal.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn turned(&self, r: usize, c: usize) -> [Vector3<D>; 2] {
        let Self { twice, by_p, by_q, .. } = self;
        let across = |m: &Matrix3<D>| m.column(c).cross(&twice.column(r)) + m.column(r).cross(&twice.column(c));
        [across(by_p), across(by_q)]
    }
}
