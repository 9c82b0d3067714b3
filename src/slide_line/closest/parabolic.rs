//! The closest point of a parabolic segment.

#[cfg(feature = "verify")]
mod proof;

use super::{Foot, SegmentFoot, View, check_tangent};
use crate::error::Error;
use crate::fields;
use crate::formula::{Component, Document, Formula, Jacobian, Spec};
use crate::quantity::{X1, X2, X3, XS};
use crate::scalar::Scalar;
use crate::slide_line::check_distinct;
use crate::slide_line::shape::Parabola;
use nalgebra::Vector2;

fields! {
    /// The slave point and a parabolic segment.
    pub struct ParabolicSlave<T> {
        xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3,
    }
}

/// Closest point of a parabolic segment: the nearest root of (xs − X)·X′ = 0, or an end; E11 = (xs − X)·n.
#[derive(Clone, Copy, Debug)]
pub struct ClosestParabolic;

impl<D: Scalar> ParabolicSlave<D> {
    fn view(&self) -> View<D, Parabola, 3> {
        View::new(self.xs, [self.x1, self.x2, self.x3], D::zero())
    }
}

impl Formula for ClosestParabolic {
    const SPEC: Spec = Spec::new(
        "slide_line.closest_parabolic",
        "Closest point of a parabolic segment",
        Document::SLIDE_LINE.ours("Element output", "the section says separation, and prints no equation"),
    )
        .equation(r"(\mathbf{x}_s-\mathbf{X}(g))\cdot\mathbf{X}'(g) = 0,\quad -1 \le g \le 1,\qquad E_{11} = (\mathbf{x}_s-\mathbf{X})\cdot\mathbf{n}")
        .eta(4.0, 12.0);
    type Inputs<T: Component> = ParabolicSlave<T>;
    type Outputs<T: Component> = SegmentFoot<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicSlave<D>) -> SegmentFoot<D> {
        let view = i.view();
        let foot = Foot::on(&view);
        SegmentFoot { g: foot.u, separation: foot.separation() * view.binade.unit }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ParabolicSlave<D>) -> (SegmentFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        let foot = Foot::on(&view);
        let value = SegmentFoot { g: foot.u, separation: foot.separation() * view.binade.unit };
        let ([n1, n2, n3], [m1, m2, m3]) = (foot.weights, foot.rates);
        let g = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        let gradients = SegmentFoot {
            g: ParabolicSlave { xs: g(-D::one(), D::zero()), x1: g(n1, m1), x2: g(n2, m2), x3: g(n3, m3) },
            separation: ParabolicSlave { xs: normal, x1: normal * -n1, x2: normal * -n2, x3: normal * -n3 },
        };
        (value, gradients)
    }

    fn validate(i: &ParabolicSlave<f64>) -> Result<(), Error> {
        check_distinct(&[("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])?;
        check_tangent(&i.view(), "g")
    }
}
