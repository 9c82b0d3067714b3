//! The sliding constraint in the plane: one condition, and one coordinate eliminated.

#[cfg(feature = "verify")]
mod proof;

use super::constraint::IncrementalConstraint;
use super::line::Line;
use super::pivots::Plane;
use super::place::Place;
use super::slide::Slide;
use super::span::{Span, Station};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    SLIDER_DX1_PLANE, SLIDER_DXM_PLANE, SLIDER_DXMI, SLIDER_DXMK, SLIDER_DXN_PLANE, SLIDER_G, SLIDER_R,
    SLIDER_X1_PLANE, SLIDER_XM_PLANE, SLIDER_XMI_PLANE, SLIDER_XMK, SLIDER_XN_PLANE,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

fields! {
    /// The line, and node m, in the plane.
    pub struct Nodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
    }
}
fields! {
    /// The distance of m from the line in the plane.
    pub struct Distance2d<T> { g: T = SLIDER_G }
}

/// The condition that holds m on the line in the plane: g = (xm − x1)·t = 0, t = s×n = (−n2, n1).
///
/// The other condition, along the normal s of the plane, is satisfied automatically.
#[derive(Clone, Copy, Debug)]
pub struct Constraint2d;

impl Formula for Constraint2d {
    const SPEC: Spec = Spec::new(
        "slider.constraint_2d",
        "Constraint in the plane",
        Document::SLIDER.reconstructed("", "every symbol was lost; the words: in the plane one constraint remains"),
    )
    .equation(
        r"g = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t},\quad \mathbf{t} = \mathbf{s}\times\mathbf{n} = (-n_2, n_1)",
    )
    .given(&[Given::new(r"\mathbf{n}", &Line::SPEC)])
    // The largest η that `audit --attack` found is 2.49 for the value, and 4.67 is possible to first order; for the Jacobian 4.64 and 15.3.
    .eta(5.0, 12.0)
    .scale(1e250)
    .finite(Finite::Between);
    type Inputs<T: Component> = Nodes2d<T>;
    type Outputs<T: Component> = Distance2d<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Nodes2d<D>) -> Distance2d<D> {
        let span = Span::new(&i.x1, &i.xn);
        let offset = Station::new(&span, &i.x1, &i.xn, &i.xm).offset;
        Distance2d { g: span.d.perp(&offset) / span.square.sqrt() }
    }

    /// ∂g/∂xn = −ξ t, ∂g/∂x1 = −(1 − ξ) t: as if m were a point of a rigid bar.
    #[inline]
    fn jacobian<D: Scalar>(i: &Nodes2d<D>) -> Jacobian<Self, D> {
        let span = Span::new(&i.x1, &i.xn);
        let [share, rest] = Station::new(&span, &i.x1, &i.xn, &i.xm).shares();
        let t = Vector2::new(-span.d.y, span.d.x) / span.square.sqrt();
        Distance2d { g: Nodes2d { x1: t * -rest, xn: t * -share, xm: t } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Nodes2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line and node m in the plane, and increments of all three nodes.
    pub struct MovingNodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        dx1: Vector2<T> = SLIDER_DX1_PLANE, dxn: Vector2<T> = SLIDER_DXN_PLANE, dxm: Vector2<T> = SLIDER_DXM_PLANE,
    }
}
fields! {
    /// The residual of the condition for increments in the plane.
    pub struct IncrementalResidual2d<T> { r: T = SLIDER_R }
}

/// The condition on increments in the plane, with the variation of t eliminated:
/// r = t·(dxm − (1−ξ) dx1 − ξ dxn) = 0.
#[derive(Clone, Copy, Debug)]
pub struct IncrementalConstraint2d;

impl Formula for IncrementalConstraint2d {
    const SPEC: Spec = Spec::new(
        "slider.incremental_constraint_2d",
        "Incremental constraint in the plane",
        Document::SLIDER.reconstructed("", "every symbol was lost; the words: the derivative of the one constraint"),
    )
    .equation(
        r"r = \mathbf{t}\cdot\bigl(\mathrm{d}\mathbf{x}_m - (1-\xi)\,\mathrm{d}\mathbf{x}_1 - \xi\,\mathrm{d}\mathbf{x}_n\bigr),\quad \mathbf{t} = (-n_2, n_1)",
    )
    .given(&[Given::new(r"\xi", &IncrementalConstraint::SPEC), Given::new(r"\mathbf{n}", &Line::SPEC)])
    // The largest η that `audit --attack` found is 2.32 for the value, and 6.15 is possible to first order; for the Jacobian 11.1 and 20.5.
    .eta(8.5, 22.0)
    .scale(1e50)
    .finite(Finite::Between);
    type Inputs<T: Component> = MovingNodes2d<T>;
    type Outputs<T: Component> = IncrementalResidual2d<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &MovingNodes2d<D>) -> IncrementalResidual2d<D> {
        let span = Span::new(&i.x1, &i.xn);
        let station = Station::new(&span, &i.x1, &i.xn, &i.xm);
        let v = i.dxm - station.blend(&i.dx1, &i.dxn);
        IncrementalResidual2d { r: span.d.perp(&v) / span.square.sqrt() }
    }

    /// With v = dxm − (1−ξ) dx1 − ξ dxn and γ = t·(dxn − dx1), ∂r = v·∂t − γ ∂ξ, and v·∂t = −(v·n)/l t·(∂xn − ∂x1).
    #[inline]
    fn jacobian<D: Scalar>(i: &MovingNodes2d<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &MovingNodes2d<D>) -> ValueAndJacobian<Self, D> {
        let span = Span::new(&i.x1, &i.xn);
        let station = Station::new(&span, &i.x1, &i.xn, &i.xm);
        let ([share, rest], [by_x1, by_xn]) = (station.shares(), station.unscaled_gradients(&span));
        let v = i.dxm - station.blend(&i.dx1, &i.dxn);
        // All terms are multiplied by the length of d, by which the row is divided at the end, so that zeros remain exact.
        let (root, ray) = (span.square.sqrt(), Vector2::new(-span.d.y, span.d.x));
        let per_root = root.recip();
        let (t, factor) = (ray * per_root, span.factor());
        let (gain, turn) = (span.d.perp(&(i.dxn - i.dx1)) * factor, v.dot(&span.d) * factor);
        let by = MovingNodes2d {
            x1: (ray * turn + by_x1 * gain) * per_root,
            xn: (ray * -turn - by_xn * gain) * per_root,
            xm: span.d * -gain * per_root,
            dx1: t * -rest,
            dxn: t * -share,
            dxm: t,
        };
        (IncrementalResidual2d { r: span.d.perp(&v) / root }, IncrementalResidual2d { r: by })
    }

    #[inline]
    fn validate<D: Scalar>(i: &MovingNodes2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line in the plane, and the coordinate of node m that is kept.
    pub struct KeptCoordinate2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xmk: T = SLIDER_XMK,
    }
}
fields! {
    /// The coordinate of node m that is eliminated in the plane.
    pub struct Coordinate2d<T> { xmi: T = SLIDER_XMI_PLANE }
}

/// The position of m on the line from one coordinate, with the axes of [`Pivots2d`](super::Pivots2d):
/// xm_i = x1_i + (n_i/n_k)(xm_k − x1_k).
#[derive(Clone, Copy, Debug)]
pub struct Eliminate2d;

impl Formula for Eliminate2d {
    const SPEC: Spec = Spec::new(
        "slider.eliminate_2d",
        "Elimination in the plane",
        Document::SLIDER
            .ours("", "the condition is there, its symbols lost; to solve it for the larger component is ours"),
    )
    .equation(r"x_{m,i} = x_{1,i} + \frac{n_i}{n_k}(x_{m,k}-x_{1,k})")
    .given(&[Given::new(r"i,\ k", &Increment2d::SPEC), Given::new(r"\mathbf{n}", &Line::SPEC)])
    // The largest η that `audit --attack` found is 2.12 for the value, and 3.5 is possible to first order; for the Jacobian 2.1 and 7.
    .eta(4.0, 7.0)
    .scale(1e150)
    .finite(Finite::Between)
    .not_objective();
    type Inputs<T: Component> = KeptCoordinate2d<T>;
    type Outputs<T: Component> = Coordinate2d<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptCoordinate2d<D>) -> Coordinate2d<D> {
        Coordinate2d { xmi: Place::new(&i.x1, &i.xn, Plane::new(&i.x1, &i.xn), i.xmk).coordinate(0) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptCoordinate2d<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &KeptCoordinate2d<D>) -> ValueAndJacobian<Self, D> {
        let place = Place::new(&i.x1, &i.xn, Plane::new(&i.x1, &i.xn), i.xmk);
        let [x1, xn] = place.gradients(0);
        let by = KeptCoordinate2d { x1, xn, xmk: place.slope(0) };
        (Coordinate2d { xmi: place.coordinate(0) }, Coordinate2d { xmi: by })
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptCoordinate2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line and node m in the plane, increments of nodes 1 and n, and the increment of m that is kept.
    pub struct KeptIncrement2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        dx1: Vector2<T> = SLIDER_DX1_PLANE, dxn: Vector2<T> = SLIDER_DXN_PLANE, dxmk: T = SLIDER_DXMK,
    }
}
fields! {
    /// The increment of node m that is eliminated in the plane.
    pub struct Increment2dOutput<T> { dxmi: T = SLIDER_DXMI }
}

/// The eliminated increment of m in the plane, with the axes of [`Pivots2d`](super::Pivots2d): w = (1−ξ) dx1 + ξ dxn,
/// dxm_i = w_i + (n_i/n_k)(dxm_k − w_k).
#[derive(Clone, Copy, Debug)]
pub struct Increment2d;

impl Formula for Increment2d {
    const SPEC: Spec = Spec::new(
        "slider.increment_2d",
        "Eliminated increment in the plane",
        Document::SLIDER.ours(
            "",
            "the derivative is there, its symbols lost; to solve it for the larger component is ours",
        ),
    )
        .equation(r"\mathrm{d}x_{m,i} = w_i + \frac{n_i}{n_k}(\mathrm{d}x_{m,k}-w_k),\quad \mathbf{w} = (1-\xi)\,\mathrm{d}\mathbf{x}_1 + \xi\,\mathrm{d}\mathbf{x}_n,\quad (i, k) = \begin{cases} (2, 1) & \lvert d_1\rvert \ge \lvert d_2\rvert \\ (1, 2) & \text{otherwise} \end{cases},\quad \mathbf{d} = \mathbf{x}_n-\mathbf{x}_1")
.given(&[Given::new(r"\xi", &IncrementalConstraint::SPEC), Given::new(r"\mathbf{n}", &Line::SPEC)])
        // The largest η that `audit --attack` found is 3.65 for the value, and 8 is possible to first order; for the Jacobian 13.3 and 23.
        .eta(8.0, 27.0)
        .scale(1e120)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = KeptIncrement2d<T>;
    type Outputs<T: Component> = Increment2dOutput<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptIncrement2d<D>) -> Increment2dOutput<D> {
        let slide = Slide::new(&i.x1, &i.xn, &i.xm, Plane::new(&i.x1, &i.xn));
        let [dxmi] = slide.increments(&i.dx1, &i.dxn, i.dxmk);
        Increment2dOutput { dxmi }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptIncrement2d<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &KeptIncrement2d<D>) -> ValueAndJacobian<Self, D> {
        let slide = Slide::new(&i.x1, &i.xn, &i.xm, Plane::new(&i.x1, &i.xn));
        let [dxmi] = slide.increments(&i.dx1, &i.dxn, i.dxmk);
        let row = slide.gradients(&i.dx1, &i.dxn, i.dxmk).row(0);
        let by = KeptIncrement2d { x1: row.x1, xn: row.xn, xm: row.xm, dx1: row.dx1, dxn: row.dxn, dxmk: row.dxmk };
        (Increment2dOutput { dxmi }, Increment2dOutput { dxmi: by })
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptIncrement2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
