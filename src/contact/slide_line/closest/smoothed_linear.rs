//! The closest point of a smoothed corner between straight segments.

#[cfg(feature = "verify")]
mod proof;

use super::{Foot, View};
use crate::contact::slide_line::basis::LocalBasis;
use crate::contact::slide_line::check_distinct;
use crate::contact::slide_line::corners::SmoothedLinearPoint;
use crate::contact::slide_line::shape::{LinearCorner, Sides};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{CORNER_T, FRACTION, SEPARATION, X1, X2, X3, XS};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, abs};
use nalgebra::Vector2;

fields! {
    /// The slave point and a smoothed corner between straight segments.
    pub struct LinearCornerSlave<T> {
        xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, f: T = FRACTION,
    }
}
fields! {
    /// The closest point of a smoothed corner, and the separation from it.
    pub struct CornerFoot<T> { t: T = CORNER_T, separation: T = SEPARATION }
}

/// Closest point of a smoothed corner between straight segments: the nearest root of (xs − X)·X′ = 0, or an end.
#[derive(Clone, Copy, Debug)]
pub struct ClosestSmoothedLinear;

impl<D: Scalar> LinearCornerSlave<D> {
    fn view(&self) -> View<D, LinearCorner, 3> {
        View::new(self.xs, [self.x1, self.x2, self.x3], self.f)
    }

    /// Y′·∂X/∂f with ∂X/∂f = s² (x1−x2) + t² (x3−x2).
    ///
    /// ∂X/∂f = (X − x2)/f, and at the foot Y′·X = Y′·xs: if the terms of Y′·(xs − x2)/f are the smaller ones, it avoids the
    /// cancellation in the sum.
    fn bulge(&self, view: &View<D, LinearCorner, 3>, foot: &Foot<D, 3>) -> D {
        let terms = |v: Vector2<D>| abs(v.x * foot.rate.x) + abs(v.y * foot.rate.y);
        let [s, t] = foot.parts();
        let (first, last) = (view.in_unit(self.x1 - self.x2) * (s * s), view.in_unit(self.x3 - self.x2) * (t * t));
        let arm = view.in_unit(self.xs - self.x2);
        let bulge = if terms(arm) < self.f * (terms(first) + terms(last)) { arm / self.f } else { first + last };
        bulge.dot(&foot.rate)
    }
}

impl<D: Scalar> LinearCornerSlave<D> {
    /// The foot, unless two nodes coincide or the curve's derivative vanishes there.
    fn checked_foot(&self) -> Result<(View<D, LinearCorner, 3>, Foot<D, 3>), Error> {
        check_distinct([("x1", self.x1), ("x2", self.x2)])?;
        check_distinct([("x2", self.x2), ("x3", self.x3)])?;
        let view = self.view();
        let foot = Foot::with_tangent(&view, "t")?;
        Ok((view, foot))
    }
}

impl ClosestSmoothedLinear {
    fn value_at<D: Scalar>(view: &View<D, LinearCorner, 3>, foot: &Foot<D, 3>) -> CornerFoot<D> {
        CornerFoot { t: foot.u, separation: foot.separation() * view.binade.unit }
    }

    /// Value and Jacobian at the foot.
    ///
    /// With respect to f: since n ⟂ Y′, n·∂X/∂f = 2st (x2−x1) × (x3−x2)/|Y′|.
    fn linearized_at<D: Scalar>(
        i: &LinearCornerSlave<D>,
        view: &View<D, LinearCorner, 3>,
        foot: &Foot<D, 3>,
    ) -> (CornerFoot<D>, Jacobian<Self, D>) {
        let ([n1, n2, n3], [m1, m2, m3]) = (foot.weights, foot.rates);
        let t = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        let [before, behind] = foot.parts();
        let opening = Sides::new([i.x1, i.x2, i.x3]).turn(foot.speed(view)) * before * behind * -2.0;
        let gradients = CornerFoot {
            t: LinearCornerSlave {
                xs: t(-D::one(), D::zero()),
                x1: t(n1, m1),
                x2: t(n2, m2),
                x3: t(n3, m3),
                f: i.bulge(view, foot) * foot.per_slope,
            },
            separation: LinearCornerSlave {
                xs: normal,
                x1: normal * -n1,
                x2: normal * -n2,
                x3: normal * -n3,
                f: if foot.inside { opening } else { D::zero() },
            },
        };
        (Self::value_at(view, foot), gradients)
    }
}

impl Formula for ClosestSmoothedLinear {
    const SPEC: Spec = Spec::new(
        "slide_line.closest_smoothed_linear",
        "Closest point of a smoothed corner between straight segments",
        Document::SLIDE_LINE.ours(
            "Smoothing the slide line",
            "the section on smoothing that it refers to was not given",
        ),
    )
        .equation(r"t = \operatorname*{arg\,min}_{0 \le t \le 1}\,\lvert\mathbf{x}_s-\mathbf{X}(t)\rvert,\quad E_{11} = \bigl(\mathbf{x}_s-\mathbf{X}(t)\bigr)\cdot\mathbf{n}")
.given(&[Given::new(r"\mathbf{X}(t),\ \mathbf{X}'", &SmoothedLinearPoint::SPEC), Given::new(r"\mathbf{n}", &LocalBasis::SPEC)])
        // Above 8 at a few random points: the derivative of the separation with respect to f, if both segments are nearly
        // collinear.
        // The largest η that `audit --attack` found is 2.64 for the value, and 4.66 is possible to first order; for the Jacobian 25.2
        // and 85.9.
        .eta(4.0, 48.0)
        .normwise(6.0, 96.0)
        .apart(0.01)
        .scale(1e3)
        .finite(Finite::Between);
    type Inputs<T: Component> = LinearCornerSlave<T>;
    type Outputs<T: Component> = CornerFoot<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearCornerSlave<D>) -> CornerFoot<D> {
        let view = i.view();
        Self::value_at(&view, &Foot::on(&view))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearCornerSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &LinearCornerSlave<D>) -> (CornerFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        Self::linearized_at(i, &view, &Foot::on(&view))
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearCornerSlave<D>) -> Result<(), Error> {
        i.checked_foot().map(drop)
    }

    #[inline]
    fn try_eval(i: &LinearCornerSlave<f64>) -> Result<CornerFoot<f64>, Error> {
        i.checked_foot().map(|(view, foot)| Self::value_at(&view, &foot))
    }

    #[inline]
    fn try_linearized(i: &LinearCornerSlave<f64>) -> Result<ValueAndJacobian<Self, f64>, Error> {
        i.checked_foot().map(|(view, foot)| Self::linearized_at(i, &view, &foot))
    }
}
