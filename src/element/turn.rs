//! The angle −atan2(e·p, e·q), by which Cardan's first and third angle are measured, and its derivative by the spin of e.
//!
//! With i² = −1, P = q + i p and z = e·P, the angle is −Im ln z. Its derivative by the spin of e is −Im Y with Y = e × W and
//! W = P/z. ∂Y/∂P is ([e×] − Y eᵀ)/z. Where p and q are perpendicular and equally long, P·P is 0, and ∂Y/∂e is −W ⊗ Y; what
//! P·P adds is kept apart, so that nothing cancels in it.
//!
//! Turned by a spin φ of p and q and a spin ψ of e, Y changes by (e ⊗ W − I − Y ⊗ Y) ψ + (I − W ⊗ e + Y ⊗ Y) φ. Its imaginary
//! part has no unit matrix left: one matrix, Im(Y ⊗ Y − e ⊗ W), and its transpose say how the derivative turns. By e that matrix
//! changes by −Im W ⊗ (Y ⊗ Y + W ⊗ (e × Y)), in which I + Y ⊗ Y, which cancels, is written as e ⊗ W + W ⊗ (e × Y).
//! By P an entry of Y ⊗ Y − e ⊗ W changes by (Y_r [e×]_c + Y_c [e×]_r − 2 Y_r Y_c e − e_r (i_c − W_c e))/z: by p the imaginary part
//! changes by the real part of that, by q by the imaginary one.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use super::products::{double_cross, symmetric_matrix};
use crate::formula::{cross_gradient, next};
use crate::number::scalar::{Scalar, is_between, norm_and_direction, number_if};
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
        let hv = h * v.transpose();
        e * u.transpose() - hv - hv.transpose()
    }

    /// The gradients of the entries of a number of times [`curvature`](Self::curvature): by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn curving(&self, times: D) -> Curving<D> {
        let Self { e, k, u, h, v, skewed: [real, imaginary], .. } = self;
        let yy @ [re, im] = [symmetric_matrix!(self.yy_real), symmetric_matrix!(self.yy_imaginary)];
        // e × Y = x − i y; its imaginary part is that of −(e·e) W.
        let (xt, yt) = (e.cross(h).transpose(), (u * -e.dot(e)).transpose());
        let [real, imaginary] = [*real * times, *imaginary * times];
        let per @ [per_re, per_im] = self.inverse.map(|part| part * times);
        Curving {
            e: *e,
            w: [k * times, u * times],
            by_w: [im + k * yt + u * xt, re + k * xt - u * yt],
            twice: double_cross(e, e),
            skewed_w: k * imaginary - u * real,
            skewed_y: h * imaginary - v * real,
            by_pq: [ByP::new(self, &yy, per), ByP::new(self, &yy, [-per_im, per_re])],
        }
    }

    /// An entry of Y ⊗ Y, real.
    #[inline(always)]
    fn yy_real(&self, r: usize, c: usize) -> D {
        self.h[r] * self.h[c] - self.v[r] * self.v[c]
    }

    /// As [`yy_real`](Self::yy_real), imaginary with the other sign.
    #[inline(always)]
    fn yy_imaginary(&self, r: usize, c: usize) -> D {
        self.h[r] * self.v[c] + self.v[r] * self.h[c]
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

/// What the gradients of a number of times the curvature of a turn are made of.
pub(super) struct Curving<D> {
    e: Vector3<D>,
    /// W times that number, real, and imaginary with the other sign.
    w: [Vector3<D>; 2],
    /// Y ⊗ Y + W ⊗ (e × Y), imaginary with the other sign, and real.
    by_w: [Matrix3<D>; 2],
    /// e ⊗ e − (e·e) I.
    twice: Matrix3<D>,
    /// W P·P/z² and Y P·P/z², imaginary, times that number.
    skewed_w: Vector3<D>,
    skewed_y: Vector3<D>,
    /// By p with that number, by q with −i times that number.
    by_pq: [ByP<D>; 2],
}

impl<D: Scalar> Curving<D> {
    /// The gradient of an entry: by e, p and q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn gradient(&self, r: usize, c: usize) -> [Vector3<D>; 3] {
        let Self { e, w: [k, u], by_w: [by_k, by_u], twice, skewed_w, skewed_y, by_pq: [by_p, by_q] } = self;
        let ([_, by_r], [_, by_c]) = (cross_gradient(e, e, r), cross_gradient(e, e, c));
        // x_r [e×]_c + x_c [e×]_r, which the compiler finds to be the same for the mirror image.
        let across = |x: &Vector3<D>| by_c.added_to(&by_r.times(x[c]), x[r]);
        let by_e = by_k.row(c).transpose() * k[r] + by_u.row(c).transpose() * u[r];
        let skewed = twice.column(r) * skewed_w[c] - across(skewed_y);
        [by_e + skewed, across(&by_p.y) - by_p.along(e, r, c), across(&by_q.y) - by_q.along(e, r, c)]
    }
}

/// What the real part of a number times ∂(Y ⊗ Y − e ⊗ W)/∂P is made of: the real parts of that number by z times Y, W and 2 Y ⊗ Y.
/// The imaginary part is the real one of −i times that number.
struct ByP<D> {
    y: Vector3<D>,
    w: Vector3<D>,
    yy: Matrix3<D>,
}

impl<D: Scalar> ByP<D> {
    #[inline(always)]
    fn new(turn: &Turn<D>, yy: &[Matrix3<D>; 2], [re, im]: [D; 2]) -> Self {
        let Turn { k, u, h, v, .. } = turn;
        Self { y: h * re - v * im, w: k * re - u * im, yy: yy[0] * (re * 2.0) - yy[1] * (im * 2.0) }
    }

    /// 2 Y_r Y_c e + e_r (i_c − W_c e), by z. On the diagonal 1 − W_c e_c is the sum over the other axes, which does not cancel.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(&self, e: &Vector3<D>, r: usize, c: usize) -> Vector3<D> {
        let (w, yy, [l, m]) = (&self.w, self.yy[(r, c)], next(c));
        let (across, diagonal) = (yy - e[r] * w[c], (e[l] * w[l] + e[m] * w[m]) * e[r]);
        Vector3::from_fn(|k, _| if k == c { e[k] * yy + diagonal } else { e[k] * across })
    }
}
