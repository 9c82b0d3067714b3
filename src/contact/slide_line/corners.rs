//! Points of a slide line: smoothed corners, which replace the kinks between segments.
//!
//! A fraction f of each segment next to the corner is cut off and replaced by a curve that is tangent to both. The source
//! mentions smoothing and refers elsewhere for its details; these curves are ours.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::points::CurvePoint;
use super::shape::{LinearCorner, ParabolicCorner, Shape, Sides, combination, from_heaviest, gap, weighted};
use crate::fields;
use crate::formula::quantity::{CORNER_T, FRACTION, X1, X2, X3, X4, X5};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Source, Spec, ValueAndJacobian, along};
use crate::number::scalar::{Scalar, choice};
use nalgebra::Vector2;

/// Σ wᵢ xᵢ.
#[inline]
fn point<D: Scalar, const N: usize>(nodes: &[Vector2<D>; N], weights: [D; N]) -> Vector2<D> {
    -gap(Vector2::from_element(D::zero()), nodes, weights)
}

const SOURCE: Source =
    Document::SLIDE_LINE.ours("Smoothing the slide line", "the section on smoothing that it refers to was not given");

fields! {
    /// A smoothed corner between two straight segments, and a point on it.
    pub struct LinearCornerPlace<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, f: T = FRACTION, t: T = CORNER_T,
    }
}

impl<D: Scalar> LinearCornerPlace<D> {
    /// X′/f = 2t (x3−x2) − 2s (x1−x2) = 2 min(s,t) (x3−x1) + 2 |t−s| times the nearer side.
    ///
    /// The last form is evaluated: near t = ½ node x2 hardly matters, but the rounding errors of the sides, which contain it,
    /// would. The comparison only selects factors, without a branch.
    #[inline]
    fn rate(&self) -> Vector2<D> {
        let (s, t) = (-self.t + 1.0, self.t);
        let Sides { before, after, chord } = Sides::new([self.x1, self.x2, self.x3]);
        let [behind] = choice(|| [D::from(if t > s { 1.0 } else { 0.0 })]);
        let ahead = -behind + 1.0;
        let turned = before * ((s - t) * ahead) + after * ((t - s) * behind) + chord * (s * behind + t * ahead);
        turned * D::from(2.0)
    }
}

/// Point of the smoothed corner x2 between straight segments: X = x2 + f ((1−t)² (x1−x2) + t² (x3−x2)).
///
/// That is the parabola tangent to both segments at the distance f·ℓ from the corner.
#[derive(Clone, Copy, Debug)]
pub struct SmoothedLinearPoint;

impl Formula for SmoothedLinearPoint {
    const SPEC: Spec = Spec::new(
        "slide_line.smoothed_linear_point",
        "Point of a smoothed corner between straight segments",
        SOURCE,
    )
    .equation(r"\begin{aligned} \mathbf{X} &= \mathbf{x}_2 + f\bigl[(1-t)^2(\mathbf{x}_1-\mathbf{x}_2) + t^2(\mathbf{x}_3-\mathbf{x}_2)\bigr], \\ \mathbf{X}' &= 2f\bigl[t\,(\mathbf{x}_3-\mathbf{x}_2) - (1-t)(\mathbf{x}_1-\mathbf{x}_2)\bigr] \end{aligned}")
    .eta(3.0, 3.0)
    .scale(1e120)
    .finite(Finite::Between);
    type Inputs<T: Component> = LinearCornerPlace<T>;
    type Outputs<T: Component> = CurvePoint<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearCornerPlace<D>) -> CurvePoint<D> {
        let [n1, _, n3] = LinearCorner::weights(i.f, i.t);
        CurvePoint { x: i.x2 + (i.x1 - i.x2) * n1 + (i.x3 - i.x2) * n3, dx: i.rate() * i.f }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearCornerPlace<D>) -> Jacobian<Self, D> {
        let s = -i.t + 1.0;
        let (bulge, rate) = ((i.x1 - i.x2) * (s * s) + (i.x3 - i.x2) * (i.t * i.t), i.rate());
        let second = Sides::new([i.x1, i.x2, i.x3]).second_derivative() * D::from(2.0);
        let row = |k, [n1, n2, n3]: [D; 3], f, t| LinearCornerPlace {
            x1: along(k, n1),
            x2: along(k, n2),
            x3: along(k, n3),
            f,
            t,
        };
        let rates = LinearCorner::rates(i.f, i.t).map(|rate| rate * i.f);
        let x = |k| row(k, LinearCorner::weights(i.f, i.t), bulge[k], rate[k] * i.f);
        let dx = |k| row(k, rates, rate[k], second[k] * i.f);
        CurvePoint { x: Vector2::new(x(0), x(1)), dx: Vector2::new(dx(0), dx(1)) }
    }
}

fields! {
    /// A smoothed corner between two parabolic segments, and a point on it.
    pub struct ParabolicCornerPlace<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, x4: Vector2<T> = X4, x5: Vector2<T> = X5,
        f: T = FRACTION, t: T = CORNER_T,
    }
}

/// Point of the smoothed corner x3 between the parabolas (x1, x2, x3) and (x3, x4, x5).
///
/// The cubic Bézier curve from A = X12(1−2f) to B = X34(−1+2f) with the inner control points A + (4f/3) A′ and B − (4f/3) B′,
/// collected by nodes.
#[derive(Clone, Copy, Debug)]
pub struct SmoothedParabolicPoint;

impl Formula for SmoothedParabolicPoint {
    const SPEC: Spec = Spec::new("slide_line.smoothed_parabolic_point", "Point of a smoothed corner between parabolic segments", SOURCE)
        .equation(r"\begin{aligned} \mathbf{X} &= (1-t)^3\mathbf{A} + 3(1-t)^2 t\,\bigl(\mathbf{A}+\tfrac{4f}{3}\mathbf{A}'\bigr) + 3(1-t)t^2\bigl(\mathbf{B}-\tfrac{4f}{3}\mathbf{B}'\bigr) + t^3\mathbf{B}, \\ \mathbf{X}' &= 4f\bigl[(1-t)^2\mathbf{A}' + t^2\mathbf{B}'\bigr] + 6(1-t)t\,\bigl[\mathbf{B}-\mathbf{A}-\tfrac{4f}{3}(\mathbf{A}'+\mathbf{B}')\bigr], \\ \mathbf{A} &= -f(1-2f)\,\mathbf{x}_1 + 4f(1-f)\,\mathbf{x}_2 + (1-f)(1-2f)\,\mathbf{x}_3, & \mathbf{A}' &= (\tfrac12-2f)\,\mathbf{x}_1 - 2(1-2f)\,\mathbf{x}_2 + (\tfrac32-2f)\,\mathbf{x}_3, \\ \mathbf{B} &= (1-f)(1-2f)\,\mathbf{x}_3 + 4f(1-f)\,\mathbf{x}_4 - f(1-2f)\,\mathbf{x}_5, & \mathbf{B}' &= (2f-\tfrac32)\,\mathbf{x}_3 + 2(1-2f)\,\mathbf{x}_4 + (2f-\tfrac12)\,\mathbf{x}_5 \end{aligned}")
        // The largest η that `audit --attack` found is 3.76 for the value, and 11.8 is possible to first order; for the Jacobian 28
        // and 60.4.
        .eta(10.0, 5.0)
        .normwise(12.0, 64.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = ParabolicCornerPlace<T>;
    type Outputs<T: Component> = CurvePoint<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicCornerPlace<D>) -> CurvePoint<D> {
        let nodes = [i.x1, i.x2, i.x3, i.x4, i.x5];
        CurvePoint {
            x: point(&nodes, ParabolicCorner::weights(i.f, i.t)),
            dx: combination(&nodes, ParabolicCorner::rates(i.f, i.t)) * i.f,
        }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicCornerPlace<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &ParabolicCornerPlace<D>) -> ValueAndJacobian<Self, D> {
        let (f, nodes) = (i.f, [i.x1, i.x2, i.x3, i.x4, i.x5]);
        let (weights, rates) = (ParabolicCorner::weights(f, i.t), ParabolicCorner::rates(f, i.t));
        let seen = from_heaviest(&nodes, rates);
        let value = CurvePoint { x: point(&nodes, weights), dx: weighted(&seen, rates) * f };
        let (rates, rate) = (rates.map(|rate| rate * f), value.dx);
        let second = weighted(&seen, ParabolicCorner::second_derivatives(f, i.t)) * f;
        let [weights_by_f, ..] = ParabolicCorner::by_fraction(f, i.t);
        let x_by_f = weighted(&seen, weights_by_f);
        // The rates are linear in f: the derivative of f times the rates equals the rates at 2f.
        let rate_by_f = weighted(&seen, ParabolicCorner::rates(f * 2.0, i.t));
        let row = |k, [n1, n2, n3, n4, n5]: [D; 5], f, t| ParabolicCornerPlace {
            x1: along(k, n1),
            x2: along(k, n2),
            x3: along(k, n3),
            x4: along(k, n4),
            x5: along(k, n5),
            f,
            t,
        };
        let x = |k| row(k, weights, x_by_f[k], rate[k]);
        let dx = |k| row(k, rates, rate_by_f[k], second[k]);
        (value, CurvePoint { x: Vector2::new(x(0), x(1)), dx: Vector2::new(dx(0), dx(1)) })
    }
}
