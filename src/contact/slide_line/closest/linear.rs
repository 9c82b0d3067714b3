//! The closest point of a straight segment.

#[cfg(feature = "verify")]
mod proof;

use crate::contact::slide_line::basis::LocalBasis;
use crate::contact::slide_line::basis::length_and_tangent;
use crate::contact::slide_line::points::LinearPoint;
use crate::contact::slide_line::{check_distinct, left};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{SEGMENT_G, SEPARATION, X1, X2, XS};
use crate::formula::{Component, Document, Fields, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

fields! {
    /// The slave point and a straight segment.
    pub struct LinearSlave<T> { xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2 }
}
fields! {
    /// The closest point of a segment, and the separation from it.
    pub struct SegmentFoot<T> { g: T = SEGMENT_G, separation: T = SEPARATION }
}

/// Closest point of a straight segment: (xs − X)·X′ = 0, or the nearer end; E11 = (xs − X)·n.
///
/// The separation is the distance from the whole straight line, also beyond the ends, so an end is a kink of g only.
#[derive(Clone, Copy, Debug)]
pub struct ClosestLinear;

/// The common part of value and Jacobian.
#[derive(Clone, Copy, Debug)]
struct Projection<D> {
    /// 1/ℓ.
    per_length: D,
    t: Vector2<D>,
    /// The distance of the slave point from the straight line, positive to its left.
    separation: D,
    /// The weights of the nodes at the foot on the whole line: it is inside the segment if both are positive.
    weights: [D; 2],
}

impl<D: Scalar> Projection<D> {
    #[inline]
    fn new(i: &LinearSlave<D>) -> Self {
        let (length, t) = length_and_tangent(i.x2 - i.x1);
        let per_length = length.recip();
        let (from_1, from_2) = (i.xs - i.x1, i.xs - i.x2);
        let (n1, n2) = (-from_2.dot(&t) * per_length, from_1.dot(&t) * per_length);
        // Measured from the nearer node, so that rounding errors of the far one have no effect.
        let gap = if n1 > n2 { from_1 } else { from_2 };
        Self { per_length, t, separation: t.perp(&gap), weights: [n1, n2] }
    }

    /// −1 or 1 at an end, 0 inside.
    #[inline]
    fn end(&self) -> f64 {
        let [n1, n2] = self.weights;
        f64::from(n1 <= 0.0) - f64::from(n2 <= 0.0)
    }

    /// The foot on the whole line, also past the ends of the segment.
    #[inline]
    fn foot_on_line(&self) -> SegmentFoot<D> {
        let [n1, n2] = self.weights;
        // Computed from the smaller weight, which keeps g between the ends: the rounded weights do not add up to 1.
        let g = if n1 > n2 { n2 * 2.0 - 1.0 } else { -(n1 * 2.0) + 1.0 };
        SegmentFoot { g, separation: self.separation }
    }

    #[inline]
    fn foot(&self) -> SegmentFoot<D> {
        let (on_line, end) = (self.foot_on_line(), self.end());
        if end == 0.0 { on_line } else { SegmentFoot { g: D::from(end), ..on_line } }
    }

    #[inline]
    fn gradients(&self) -> SegmentFoot<LinearSlave<D>> {
        if self.end() == 0.0 {
            return self.gradients_on_line();
        }
        SegmentFoot { g: LinearSlave::filled(D::zero()), separation: self.gradient_of_separation() }
    }

    #[inline]
    fn gradient_of_separation(&self) -> LinearSlave<D> {
        let ([n1, n2], n) = (self.weights, left(self.t));
        LinearSlave { xs: n, x1: n * -n1, x2: n * -n2 }
    }

    /// ∂g/∂xs = 2t/ℓ, and a rotation of the segment moves the foot by the separation.
    #[inline]
    fn gradients_on_line(&self) -> SegmentFoot<LinearSlave<D>> {
        let ([n1, n2], n) = (self.weights, left(self.t));
        let rate = self.per_length * 2.0;
        let along = self.t * rate;
        let across = n * (self.separation * self.per_length * rate);
        let g = LinearSlave { xs: along, x1: along * -n1 - across, x2: across - along * n2 };
        SegmentFoot { g, separation: self.gradient_of_separation() }
    }
}

impl ClosestLinear {
    /// Value and Jacobian of the closest point of the whole line, also past the ends of the segment.
    #[inline]
    pub(crate) fn on_line<D: Scalar>(i: &LinearSlave<D>) -> ValueAndJacobian<Self, D> {
        let projection = Projection::new(i);
        (projection.foot_on_line(), projection.gradients_on_line())
    }
}

impl Formula for ClosestLinear {
    const SPEC: Spec = Spec::new(
        "slide_line.closest_linear",
        "Closest point of a straight segment",
        Document::SLIDE_LINE.ours("Element output", "the section says separation, and prints no equation"),
    )
        .equation(r"g = \operatorname*{arg\,min}_{-1 \le g \le 1}\,\lvert\mathbf{x}_s-\mathbf{X}(g)\rvert,\quad E_{11} = \bigl(\mathbf{x}_s-\mathbf{X}(g)\bigr)\cdot\mathbf{n}")
.given(&[Given::new(r"\mathbf{X}(g),\ \mathbf{X}'", &LinearPoint::SPEC), Given::new(r"\mathbf{n}", &LocalBasis::SPEC)])
        // The largest η that `audit --attack` found is 8.79 for the value, and 11 is possible to first order; for the Jacobian 10.9
        // and 17.4.
        .eta(11.0, 18.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = LinearSlave<T>;
    type Outputs<T: Component> = SegmentFoot<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearSlave<D>) -> SegmentFoot<D> {
        Projection::new(i).foot()
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearSlave<D>) -> Jacobian<Self, D> {
        Projection::new(i).gradients()
    }

    #[inline]
    fn linearized<D: Scalar>(i: &LinearSlave<D>) -> (SegmentFoot<D>, Jacobian<Self, D>) {
        let projection = Projection::new(i);
        (projection.foot(), projection.gradients())
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearSlave<D>) -> Result<(), Error> {
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}
