//! The closest point of a smoothed corner between parabolic segments.

#[cfg(feature = "verify")]
mod proof;

use super::foot::moved;
use super::{CornerFoot, Foot, View};
use crate::contact::slide_line::basis::LocalBasis;
use crate::contact::slide_line::check_distinct;
use crate::contact::slide_line::corners::SmoothedParabolicPoint;
use crate::contact::slide_line::shape::{ParabolicCorner, Shape, Sides, weighted};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{FRACTION, X1, X2, X3, X4, X5, XS};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, abs, choice};
use nalgebra::Vector2;

fields! {
    /// The slave point and a smoothed corner between parabolic segments.
    pub struct ParabolicCornerSlave<T> {
        xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, x4: Vector2<T> = X4,
        x5: Vector2<T> = X5, f: T = FRACTION,
    }
}

/// Closest point of a smoothed corner between parabolic segments: the nearest root of (xs − X)·X′ = 0, or an end.
#[derive(Clone, Copy, Debug)]
pub struct ClosestSmoothedParabolic;

impl<D: Scalar> ParabolicCornerSlave<D> {
    fn view(&self) -> View<D, ParabolicCorner, 5> {
        View::new(self.xs, [self.x1, self.x2, self.x3, self.x4, self.x5], self.f)
    }

    /// Y′·∂X/∂f, given ∂X/∂f.
    ///
    /// X is quadratic in f, so ∂X/∂f = (X − x3)/f + ½f ∂²X/∂f², and at the foot Y′·X = Y′·xs: if the terms of
    /// Y′·((xs − x3)/f + ½f ∂²X/∂f²) are the smaller ones, it avoids the cancellation in ∂X/∂f.
    fn bulge(&self, view: &View<D, ParabolicCorner, 5>, foot: &Foot<D, 5>, weights: [D; 5], by_f: Vector2<D>) -> D {
        let terms = |v: Vector2<D>| abs(v.x * foot.rate.x) + abs(v.y * foot.rate.y);
        let arm = view.in_unit(self.xs - self.x3) / self.f;
        let ([s, t], difference) = (foot.parts(), -(foot.u * 2.0) + 1.0 - foot.missing * 2.0);
        let bends = ParabolicCorner::bend_by_fraction(view.nodes, [s, t, difference]);
        let [first, last] = bends.map(|v| view.in_unit(v) * self.f);
        let sides = BESIDE
            .into_iter()
            .fold(D::zero(), |sum, k| sum + abs(weights[k]) * terms(view.in_unit(view.nodes[k] - self.x3)));
        let [x, y] = choice(|| {
            let is_less = terms(arm) + terms(first) + terms(last) < sides;
            (if is_less { arm + first + last } else { by_f }).into()
        });
        Vector2::new(x, y).dot(&foot.rate)
    }

    /// ∂E11/∂f beyond an end: ∂Y′/∂f = ∓8 X″ there, with X″ of the segment that the corner is tangent to.
    fn end_turning(&self, view: &View<D, ParabolicCorner, 5>, foot: &Foot<D, 5>) -> D {
        let (sides, weight) =
            if foot.u < 0.5 { ([self.x1, self.x2, self.x3], 32.0) } else { ([self.x3, self.x4, self.x5], -32.0) };
        Sides::new(sides).turn(foot.speed(view)) * foot.beyond * weight
    }
}

/// The nodes on both sides of the corner.
const BESIDE: [usize; 4] = [0, 1, 3, 4];

/// n·∂X/∂f from these weights of the nodes in ∂X/∂f.
///
/// Since n ⟂ Y′, a multiple of Y′ may be subtracted from ∂X/∂f: the one that cancels it at the nearer end, or the one that
/// eliminates its largest term, if the remainder is smaller. This avoids the cancellation where ∂X/∂f is nearly tangential.
fn across<D: Scalar>(view: &View<D, ParabolicCorner, 5>, foot: &Foot<D, 5>, weights: [D; 5]) -> D {
    let arms = view.nodes.map(|x| x - view.nodes[2]);
    let size = |k: usize| abs(arms[k].x) + abs(arms[k].y);
    let all = |weights: [D; 5]| BESIDE.into_iter().fold(D::zero(), |sum, j| sum + abs(weights[j]) * size(j));
    let without = |k: usize| {
        let multiple = weights[k] / foot.rates[k];
        let left: [D; 5] =
            std::array::from_fn(|j| if j == k { D::zero() } else { weights[j] - multiple * foot.rates[j] });
        let terms = |j: usize| (abs(weights[j]) + abs(multiple * foot.rates[j])) * size(j);
        (left, BESIDE.into_iter().filter(|&j| j != k).fold(D::zero(), |sum, j| sum + terms(j)))
    };
    let at_end = ParabolicCorner::across_by_fraction(view.f, foot.parts());
    let best = choice(|| {
        let mut best = (weights, all(weights));
        let others = BESIDE.into_iter().filter(|&k| foot.rates[k] != 0.0).map(without);
        for other in [(at_end, all(at_end))].into_iter().chain(others) {
            if other.1 < best.1 {
                best = other;
            }
        }
        best.0
    });
    foot.normal().dot(&view.in_unit(weighted(&arms, best)))
}

impl<D: Scalar> ParabolicCornerSlave<D> {
    /// The foot, unless two nodes coincide or the curve's derivative vanishes there.
    fn checked_foot(&self) -> Result<(View<D, ParabolicCorner, 5>, Foot<D, 5>), Error> {
        check_distinct([("x1", self.x1), ("x2", self.x2), ("x3", self.x3)])?;
        check_distinct([("x3", self.x3), ("x4", self.x4), ("x5", self.x5)])?;
        let view = self.view();
        let foot = Foot::with_tangent(&view, "t")?;
        Ok((view, foot))
    }
}

impl ClosestSmoothedParabolic {
    fn value_at<D: Scalar>(view: &View<D, ParabolicCorner, 5>, foot: &Foot<D, 5>) -> CornerFoot<D> {
        CornerFoot { t: foot.u, separation: foot.separation() * view.binade.unit }
    }

    /// Value and Jacobian at the foot.
    ///
    /// With respect to f an end moves along its own tangent, so that only the rotation of the tangent matters there.
    fn linearized_at<D: Scalar>(
        i: &ParabolicCornerSlave<D>,
        view: &View<D, ParabolicCorner, 5>,
        foot: &Foot<D, 5>,
    ) -> (CornerFoot<D>, Jacobian<Self, D>) {
        let ([n1, n2, n3, n4, n5], [m1, m2, m3, m4, m5]) = (foot.weights, foot.rates);
        let t = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        // The derivatives with respect to f of X, Y′ and Y″, and of X′, which is f Y′ and hence quadratic in f.
        let [by_f, rates, second_derivatives] = ParabolicCorner::by_fraction(i.f, foot.u);
        let by_f = moved(by_f, ParabolicCorner::rates(i.f * 2.0, foot.u), foot.missing);
        let (point, rate) = (view.combination(by_f), view.combination(moved(rates, second_derivatives, foot.missing)));
        let gradients = CornerFoot {
            t: ParabolicCornerSlave {
                xs: t(-D::one(), D::zero()),
                x1: t(n1, m1),
                x2: t(n2, m2),
                x3: t(n3, m3),
                x4: t(n4, m4),
                x5: t(n5, m5),
                f: (i.bulge(view, foot, by_f, point) - foot.gap.dot(&rate)) * foot.per_slope,
            },
            separation: ParabolicCornerSlave {
                xs: normal,
                x1: normal * -n1,
                x2: normal * -n2,
                x3: normal * -n3,
                x4: normal * -n4,
                x5: normal * -n5,
                f: if foot.inside { -(across(view, foot, by_f) * view.binade.unit) } else { i.end_turning(view, foot) },
            },
        };
        (Self::value_at(view, foot), gradients)
    }
}

impl Formula for ClosestSmoothedParabolic {
    const SPEC: Spec = Spec::new(
        "slide_line.closest_smoothed_parabolic",
        "Closest point of a smoothed corner between parabolic segments",
        Document::SLIDE_LINE.ours(
            "Smoothing the slide line",
            "the section on smoothing that it refers to was not given",
        ),
    )
        .equation(r"t = \operatorname*{arg\,min}_{0 \le t \le 1}\,\lvert\mathbf{x}_s-\mathbf{X}(t)\rvert,\quad E_{11} = \bigl(\mathbf{x}_s-\mathbf{X}(t)\bigr)\cdot\mathbf{n}")
.given(&[Given::new(r"\mathbf{X}(t),\ \mathbf{X}'", &SmoothedParabolicPoint::SPEC), Given::new(r"\mathbf{n}", &LocalBasis::SPEC)])
        // Derivatives with respect to f are the largest, between nodes whose distances differ by factors of 1e6, where the ends move
        // nearly along the tangent.
        // The largest η that `audit --attack` found is 5.33 for the value, and 13.1 is possible to first order; for the Jacobian 108
        // and 436.
        .eta(4.0, 512.0)
        .normwise(8.0, 512.0)
        .apart(0.01)
        .scale(1e3)
        .finite(Finite::Between);
    type Inputs<T: Component> = ParabolicCornerSlave<T>;
    type Outputs<T: Component> = CornerFoot<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicCornerSlave<D>) -> CornerFoot<D> {
        let view = i.view();
        Self::value_at(&view, &Foot::on(&view))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicCornerSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ParabolicCornerSlave<D>) -> (CornerFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        Self::linearized_at(i, &view, &Foot::on(&view))
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicCornerSlave<D>) -> Result<(), Error> {
        i.checked_foot().map(drop)
    }

    #[inline]
    fn try_eval(i: &ParabolicCornerSlave<f64>) -> Result<CornerFoot<f64>, Error> {
        i.checked_foot().map(|(view, foot)| Self::value_at(&view, &foot))
    }

    #[inline]
    fn try_linearized(i: &ParabolicCornerSlave<f64>) -> Result<ValueAndJacobian<Self, f64>, Error> {
        i.checked_foot().map(|(view, foot)| Self::linearized_at(i, &view, &foot))
    }
}
