//! The direction of the line around a global axis: what t1 and t2 are made of.

use crate::scalar::{Scalar, norm_and_direction};
use nalgebra::Vector3;

/// The part of a vector v across a global axis: (v_a, v_b) = h (c_a, c_b), where axis, a, b are in cyclic order.
///
/// The axis is the one whose unit vector e makes t1 = v×e/|v×e|: axis 1, or axis 3 where v2 = v3 = 0 exactly. In both
/// cases t1 = c_b e_a − c_a e_b.
#[derive(Clone, Copy, Debug)]
pub(super) struct Azimuth<D> {
    pub(super) axis: usize,
    pub(super) a: usize,
    pub(super) b: usize,
    pub(super) h: D,
    pub(super) c: [D; 2],
}

impl<D: Scalar> Azimuth<D> {
    #[inline]
    pub(super) fn new(v: &Vector3<D>) -> Self {
        let along_i = v.y == 0.0 && v.z == 0.0;
        let [axis, a, b] = if along_i { [2, 0, 1] } else { [0, 1, 2] };
        let (h, c) = norm_and_direction([v[a], v[b]]);
        Self { axis, a, b, h, c }
    }

    /// The first direction across.
    #[inline]
    pub(super) fn t1(&self) -> Vector3<D> {
        let [ca, cb] = self.c;
        let mut t1 = Vector3::from_element(D::zero());
        (t1[self.a], t1[self.b]) = (cb, -ca);
        t1
    }

    /// The second direction across, n×t1, for an n of this azimuth with components `sin` across the axis and `cos` along it.
    #[inline]
    pub(super) fn t2(&self, sin: D, cos: D) -> Vector3<D> {
        let [ca, cb] = self.c;
        let mut t2 = Vector3::from_element(-sin);
        (t2[self.a], t2[self.b]) = (cos * ca, cos * cb);
        t2
    }

    /// The component of a vector along t1, and that away from the axis, along (c_a, c_b).
    #[inline]
    pub(super) fn components(&self, v: &Vector3<D>) -> [D; 2] {
        let ([ca, cb], va, vb) = (self.c, v[self.a], v[self.b]);
        [cb * va - ca * vb, ca * va + cb * vb]
    }
}
