//! The directions normal to the line as quotients: a vector of polynomials, divided by a root.

#![expect(clippy::inline_always, reason = "where components stand is known where it is compiled in place")]

use super::span::Span;
use crate::formula::{Formula, Jacobian, ValueAndJacobian};
use crate::number::binade::Binade;
use crate::number::scalar::{Scalar, cold_path, number_if};
use nalgebra::{Vector2, Vector3};

/// A vector d in terms of the axis e in the cross product of t1 = d×e/|d×e|: axis 1, or axis 3 where d2 = d3 = 0 exactly.
///
/// With e, a, b in cyclic order and c = (d_a, d_b): t1 ∥ (0, c_b, −c_a) and t2 ∥ (−c·c, d_e c_a, d_e c_b), their components along e, a, b.
/// These vectors, the rays, are scaled by powers of two, one for c and one for d_e, since the two may differ greatly in size.
/// With exact arithmetic the sums of the rays are exact; only the division by their lengths rounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Across<D> {
    axis: Axis,
    /// c with its square and its unit: the projection of the line along e, as used by t1.
    pub(super) projected: Span<D, 2>,
    /// d_e.
    pub(super) along: D,
    /// The unit of c in that of d_e.
    ratio: D,
    /// The lengths of the rays; the first is |c|.
    pub(super) roots: [D; 2],
}

/// The axis e, for a line along d.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    /// Whether it is axis 3.
    along_i: bool,
}

impl Axis {
    #[inline]
    pub(crate) fn of<D: Scalar>(d: &Vector3<D>) -> Self {
        Self { along_i: d.y == 0.0 && d.z == 0.0 }
    }

    /// The component of a vector along e, and those along a and b.
    #[inline]
    pub(crate) fn split<D: Scalar>(self, v: &Vector3<D>) -> (D, Vector2<D>) {
        if self.along_i { (v.z, Vector2::new(v.x, v.y)) } else { (v.x, Vector2::new(v.y, v.z)) }
    }

    /// The vector with these components along e, a and b.
    #[inline]
    pub(crate) fn vector<T>(self, by_axis: T, by_a: T, by_b: T) -> Vector3<T> {
        if self.along_i { Vector3::new(by_a, by_b, by_axis) } else { Vector3::new(by_axis, by_a, by_b) }
    }
}

/// A formula of the directions normal to a line.
pub(super) trait AcrossLine: Formula {
    /// The direction of the line.
    fn line<D: Scalar>(i: &Self::Inputs<D>) -> Vector3<D>;
    fn value<D: Scalar>(i: &Self::Inputs<D>, across: &Across<D>) -> Self::Outputs<D>;
    fn gradients<D: Scalar>(i: &Self::Inputs<D>, across: &Across<D>) -> Jacobian<Self, D>;
}

// One function is compiled per axis, so that the positions of components are known at compile time: inlined for axis 1, as a call
// for axis 3, which is rare. A closure for both would not be inlined.

/// The value of such a formula.
#[inline(always)]
pub(super) fn value<F: AcrossLine, D: Scalar>(i: &F::Inputs<D>) -> F::Outputs<D> {
    #[cold]
    #[inline(never)]
    fn about_k<F: AcrossLine, D: Scalar>(i: &F::Inputs<D>, across: &Across<D>) -> F::Outputs<D> {
        F::value(i, across)
    }
    let line = F::line(i);
    if let Some(across) = Across::about_k(&line) {
        about_k::<F, D>(i, &across)
    } else {
        F::value(i, &Across::about_i(&line))
    }
}

/// Value and Jacobian of such a formula.
#[inline(always)]
pub(super) fn linearized<F: AcrossLine, D: Scalar>(i: &F::Inputs<D>) -> ValueAndJacobian<F, D> {
    #[cold]
    #[inline(never)]
    fn about_k<F: AcrossLine, D: Scalar>(i: &F::Inputs<D>, across: &Across<D>) -> ValueAndJacobian<F, D> {
        (F::value(i, across), F::gradients(i, across))
    }
    let line = F::line(i);
    if let Some(across) = Across::about_k(&line) {
        return about_k::<F, D>(i, &across);
    }
    let across = Across::about_i(&line);
    (F::value(i, &across), F::gradients(i, &across))
}

impl<D: Scalar> Across<D> {
    #[inline]
    pub(super) fn new(d: &Vector3<D>) -> Self {
        Self::about(Axis::of(d), d)
    }

    /// About axis 3, if it applies.
    #[inline(always)]
    fn about_k(d: &Vector3<D>) -> Option<Self> {
        let axis = Axis::of(d);
        (axis.along_i && (D::has_extremes() || D::ignores_extremes())).then(|| {
            cold_path();
            Self::about(Axis { along_i: true }, d)
        })
    }

    /// About axis 1; NaN if axis 3 applies.
    #[inline(always)]
    fn about_i(d: &Vector3<D>) -> Self {
        let Axis { along_i } = Axis::of(d);
        Self::about(Axis { along_i: false }, &d.map(|x| number_if(!along_i, x)))
    }

    #[inline]
    fn about(axis: Axis, d: &Vector3<D>) -> Self {
        let (along, c) = axis.split(d);
        let (projected, whole) = (Span::along(c), Binade::of(d.iter().copied()));
        let along = along * whole.per_unit;
        let ratio = projected.binade.unit * whole.per_unit;
        let square = projected.square;
        let roots = [square.sqrt(), (square * (along * along + square * (ratio * ratio))).sqrt()];
        Self { axis, projected, along, ratio, roots }
    }

    /// The component of a vector along the axis, and those along a and b.
    #[inline]
    pub(super) fn split(&self, v: &Vector3<D>) -> (D, Vector2<D>) {
        self.axis.split(v)
    }

    /// The vector with these components along the axis, a and b.
    #[inline]
    pub(super) fn vector<T>(&self, by_axis: T, by_a: T, by_b: T) -> Vector3<T> {
        self.axis.vector(by_axis, by_a, by_b)
    }

    /// c as a unit vector.
    #[inline]
    pub(super) fn azimuth(&self) -> [D; 2] {
        let c = self.projected.d / self.roots[0];
        [c.x, c.y]
    }

    /// h = |(d_a, d_b)|.
    #[inline]
    pub(super) fn distance(&self) -> D {
        self.roots[0] * self.projected.binade.unit
    }

    /// The rays along t1 and t2.
    #[inline]
    pub(super) fn rays(&self) -> [Vector3<D>; 2] {
        let Span { d: c, square, .. } = self.projected;
        [self.vector(D::zero(), c.y, -c.x), self.vector(-square * self.ratio, self.along * c.x, self.along * c.y)]
    }

    /// The scalar products of the rays with v.
    #[inline]
    pub(super) fn along_rays(&self, v: &Vector3<D>) -> [D; 2] {
        let ((v_axis, v), Span { d: c, square, .. }) = (self.split(v), self.projected);
        [v.perp(&c), self.along * c.dot(&v) - square * (v_axis * self.ratio)]
    }

    /// The variation of the second ray's product with v due to the rotation of d about the axis, per product of the first ray
    /// with v: κ t1, κ = d_e/(l h), times the length of the ray.
    #[inline]
    pub(super) fn twist(&self, sideward: D) -> Vector3<D> {
        let c = self.projected.d;
        let size = self.along * sideward * self.projected.factor();
        self.vector(D::zero(), c.y * size, -c.x * size)
    }

    /// v·c/(c·c), in units of d.
    #[inline]
    pub(super) fn share_outward(&self, v: &Vector3<D>) -> D {
        self.projected.d.dot(&self.split(v).1) * self.projected.factor()
    }
}
