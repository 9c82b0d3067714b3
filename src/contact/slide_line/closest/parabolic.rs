//! The closest point of a parabolic segment.

#[cfg(feature = "verify")]
mod proof;

use super::{Foot, SegmentFoot, View};
use crate::contact::slide_line::basis::LocalBasis;
use crate::contact::slide_line::check_distinct;
use crate::contact::slide_line::points::ParabolicPoint;
use crate::contact::slide_line::shape::Parabola;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{X1, X2, X3, XS};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;
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

impl<D: Scalar> ParabolicSlave<D> {
    /// The foot, unless two nodes coincide or the curve's derivative vanishes there.
    fn checked_foot(&self) -> Result<(View<D, Parabola, 3>, Foot<D, 3>), Error> {
        check_distinct([("x1", self.x1), ("x2", self.x2), ("x3", self.x3)])?;
        let view = self.view();
        let foot = Foot::with_tangent(&view, "g")?;
        Ok((view, foot))
    }

    /// The coordinate of the foot, and whether the curve has a tangent there: 1, or 0 where its derivative vanishes.
    pub(in crate::contact::slide_line) fn foot_and_tangent(&self) -> [D; 2] {
        let view = self.view();
        let foot = Foot::on(&view);
        [foot.u, if foot.stands_still(&view) { D::zero() } else { D::one() }]
    }
}

impl ClosestParabolic {
    fn value_at<D: Scalar>(view: &View<D, Parabola, 3>, foot: &Foot<D, 3>) -> SegmentFoot<D> {
        SegmentFoot { g: foot.u, separation: foot.separation() * view.binade.unit }
    }

    /// Value and Jacobian at the foot.
    fn linearized_at<D: Scalar>(view: &View<D, Parabola, 3>, foot: &Foot<D, 3>) -> (SegmentFoot<D>, Jacobian<Self, D>) {
        let ([n1, n2, n3], [m1, m2, m3]) = (foot.weights, foot.rates);
        let g = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        let gradients = SegmentFoot {
            g: ParabolicSlave { xs: g(-D::one(), D::zero()), x1: g(n1, m1), x2: g(n2, m2), x3: g(n3, m3) },
            separation: ParabolicSlave { xs: normal, x1: normal * -n1, x2: normal * -n2, x3: normal * -n3 },
        };
        (Self::value_at(view, foot), gradients)
    }
}

impl Formula for ClosestParabolic {
    const SPEC: Spec = Spec::new(
        "slide_line.closest_parabolic",
        "Closest point of a parabolic segment",
        Document::SLIDE_LINE.ours("Element output", "the section says separation, and prints no equation"),
    )
        .equation(r"g = \operatorname*{arg\,min}_{-1 \le g \le 1}\,\lvert\mathbf{x}_s-\mathbf{X}(g)\rvert,\quad E_{11} = \bigl(\mathbf{x}_s-\mathbf{X}(g)\bigr)\cdot\mathbf{n}")
.given(&[Given::new(r"\mathbf{X}(g),\ \mathbf{X}'", &ParabolicPoint::SPEC), Given::new(r"\mathbf{n}", &LocalBasis::SPEC)])
        // The largest η that `audit --attack` found is 2.6 for the value, and 7.18 is possible to first order; for the Jacobian 13.7
        // and 30.9.
        .eta(4.0, 12.0)
        .normwise(6.5, 24.0)
        .apart(0.01)
        .scale(1e3)
        .finite(Finite::Between);
    type Inputs<T: Component> = ParabolicSlave<T>;
    type Outputs<T: Component> = SegmentFoot<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicSlave<D>) -> SegmentFoot<D> {
        let view = i.view();
        Self::value_at(&view, &Foot::on(&view))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ParabolicSlave<D>) -> (SegmentFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        Self::linearized_at(&view, &Foot::on(&view))
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicSlave<D>) -> Result<(), Error> {
        i.checked_foot().map(drop)
    }

    #[inline]
    fn try_eval(i: &ParabolicSlave<f64>) -> Result<SegmentFoot<f64>, Error> {
        i.checked_foot().map(|(view, foot)| Self::value_at(&view, &foot))
    }

    #[inline]
    fn try_linearized(i: &ParabolicSlave<f64>) -> Result<ValueAndJacobian<Self, f64>, Error> {
        i.checked_foot().map(|(view, foot)| Self::linearized_at(&view, &foot))
    }
}
