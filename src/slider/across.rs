//! The directions across the line as quotients: a vector of polynomials, divided by a root.

use super::binade::Binade;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A vector d in terms of the axis e whose cross product makes t1 = d×e/|d×e|: axis 1, or axis 3 where d2 = d3 = 0 exactly.
///
/// With e, a, b in cyclic order and c = (d_a, d_b): t1 ∥ (0, c_b, −c_a) and t2 ∥ (−c·c, d_e c_a, d_e c_b), their components along e, a, b.
/// These vectors, the rays, are told in units that are powers of two, one for c and one for d_e, since the two may
/// be of very different size. Where arithmetic is exact, sums of them are; only the division by their lengths rounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Across<D> {
    pub(super) axis: usize,
    pub(super) a: usize,
    pub(super) b: usize,
    pub(super) c: [D; 2],
    /// c·c.
    pub(super) square: D,
    /// The unit of c.
    pub(super) sideways: Binade,
    /// d_e.
    pub(super) along: D,
    /// The unit of c in that of d_e.
    ratio: f64,
    /// The lengths of the rays; the first is |c|.
    pub(super) roots: [D; 2],
}

impl<D: Scalar> Across<D> {
    #[inline]
    pub(super) fn new(d: &Vector3<D>) -> Self {
        let along_i = d.y == 0.0 && d.z == 0.0;
        let [axis, a, b] = if along_i { [2, 0, 1] } else { [0, 1, 2] };
        let (sideways, whole) = (Binade::of(&[d[a], d[b]]), Binade::of(d.as_slice()));
        let c = [d[a], d[b]].map(|x| x * sideways.per_unit);
        let square = c[0] * c[0] + c[1] * c[1];
        let along = d[axis] * whole.per_unit;
        let ratio = sideways.unit * whole.per_unit;
        let roots = [square, square * (along * along + square * (ratio * ratio))].map(|square| square.sqrt());
        Self { axis, a, b, c, square, sideways, along, ratio, roots }
    }

    /// The vector with these components along the axis, a and b.
    #[inline]
    pub(super) fn vector(&self, by_axis: D, by_a: D, by_b: D) -> Vector3<D> {
        let mut v = Vector3::from_element(by_axis);
        (v[self.a], v[self.b]) = (by_a, by_b);
        v
    }

    /// The rays along t1 and t2.
    #[inline]
    pub(super) fn rays(&self) -> [Vector3<D>; 2] {
        let [ca, cb] = self.c;
        [self.vector(D::zero(), cb, -ca), self.vector(-self.square * self.ratio, self.along * ca, self.along * cb)]
    }

    /// The scalar products of the rays with v.
    #[inline]
    pub(super) fn along_rays(&self, v: &Vector3<D>) -> [D; 2] {
        let (va, vb) = (v[self.a], v[self.b]);
        [self.sideward(va, vb), self.along * self.outward(va, vb) - self.square * (v[self.axis] * self.ratio)]
    }

    /// How the second ray's product with v varies with d because d turns about the axis, per sideward component of v:
    /// κ t1, κ = d_e/(l h), with the ray's length.
    #[inline]
    pub(super) fn twist(&self, sideward: D) -> Vector3<D> {
        let [ca, cb] = self.c;
        let size = self.along * sideward / self.square * self.sideways.per_unit;
        self.vector(D::zero(), cb * size, -ca * size)
    }

    /// v·c/(c·c), in units of d.
    #[inline]
    pub(super) fn share_outward(&self, v: &Vector3<D>) -> D {
        self.outward(v[self.a], v[self.b]) * self.sideways.per_unit / self.square
    }

    #[inline]
    fn outward(&self, va: D, vb: D) -> D {
        let [ca, cb] = self.c;
        ca * va + cb * vb
    }

    /// The scalar product of the first ray with a vector of these components along a and b.
    #[inline]
    pub(super) fn sideward(&self, va: D, vb: D) -> D {
        let [ca, cb] = self.c;
        cb * va - ca * vb
    }
}
