//! The angle −atan2(e·p, e·q), used for the first and third Cardan angles, and its derivative with respect to the spin of e.
//!
//! With i² = −1, P = q + i p and z = e·P, the angle is −Im ln z. Its derivative with respect to the spin of e is −Im Y with Y = e
//! × W and W = P/z.
//!
//! Under a spin φ of p and q and a spin ψ of e, Y changes by (e ⊗ W − I − Y ⊗ Y) ψ + (I − W ⊗ e + Y ⊗ Y) φ. The unit matrix
//! vanishes from its imaginary part: one matrix, Im(Y ⊗ Y − e ⊗ W), and its transpose give the change of the derivative.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use crate::number::scalar::{Scalar, is_between, norm_and_direction, number_if};
use nalgebra::{Matrix3, Vector3};

/// W = k − i u and Y = h − i v.
#[derive(Clone, Copy)]
pub(super) struct Turn<D> {
    e: Vector3<D>,
    u: Vector3<D>,
    h: Vector3<D>,
    v: Vector3<D>,
}

impl<D: Scalar> Turn<D> {
    #[inline(always)]
    pub(super) fn new(e: &Vector3<D>, p: &Vector3<D>, q: &Vector3<D>) -> Self {
        let ([along, across], [per, more]) = inverse([e.dot(q), e.dot(p)]);
        // The difference q (e·p) − p (e·q), from which u is formed, would lose the digits of small components.
        let (k, u) = (p * across + q * along, e.cross(&(q * per).cross(&(p * more))));
        Self { e: *e, u, h: e.cross(&k), v: e.cross(&u) }
    }

    /// The derivative of the angle with respect to the spin of e.
    #[inline(always)]
    pub(super) fn row(&self) -> Vector3<D> {
        self.v
    }

    /// The derivative of [`row`](Self::row) with respect to the spin of e; that with respect to the spin of p and q is the
    /// negative transpose.
    #[inline(always)]
    pub(super) fn curvature(&self) -> Matrix3<D> {
        let Self { e, u, h, v, .. } = self;
        let hv = h * v.transpose();
        e * u.transpose() - hv - hv.transpose()
    }
}

/// The real part of 1/(c + i s), and the negative of its imaginary part; then two numbers whose product is 1/(c² + s²).
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
