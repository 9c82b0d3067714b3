//! The sliding constraint in the plane: one condition, and one coordinate eliminated.

#[cfg(feature = "verify")]
mod proof;

use super::Pivots2d;
use super::constraint::IncrementalConstraint;
use super::line::Line;
use super::slide::Slide;
use super::span::{Span, Station};
use crate::error::Error;
use crate::fields;
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec};
use crate::quantity::{
    SLIDER_DX1_PLANE, SLIDER_DXMI, SLIDER_DXMK, SLIDER_DXN_PLANE, SLIDER_G, SLIDER_X1_PLANE, SLIDER_XM_PLANE,
    SLIDER_XN_PLANE,
};
use crate::scalar::Scalar;
use nalgebra::Vector2;

fields! {
    /// The line, and node m, in the plane.
    pub struct Nodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
    }
}
fields! {
    /// How far m is off the line in the plane.
    pub struct Distance2d<T> { g: T = SLIDER_G }
}

/// The condition that holds m on the line in the plane: g = (xm − x1)·t = 0, t = s×n = (−n2, n1).
///
/// The other condition, along the normal s of the plane, holds by itself.
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
    .eta(3.0, 5.0)
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
    fn validate(i: &Nodes2d<f64>) -> Result<(), Error> {
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

/// The eliminated increment of m in the plane, with the axes of [`Pivots2d`]: w = (1−ξ) dx1 + ξ dxn,
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
        .eta(3.0, 5.0)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = KeptIncrement2d<T>;
    type Outputs<T: Component> = Increment2dOutput<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptIncrement2d<D>) -> Increment2dOutput<D> {
        let pivots = Pivots2d::new(&i.x1, &i.xn);
        let slide = Slide::new(&i.x1, &i.xn, &i.xm, pivots.k);
        let [dxmi] = slide.increments([pivots.i], &i.dx1, &i.dxn, i.dxmk);
        Increment2dOutput { dxmi }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptIncrement2d<D>) -> Jacobian<Self, D> {
        let pivots = Pivots2d::new(&i.x1, &i.xn);
        let row = Slide::new(&i.x1, &i.xn, &i.xm, pivots.k).gradients(&i.dx1, &i.dxn, i.dxmk).row(pivots.i);
        Increment2dOutput {
            dxmi: KeptIncrement2d { x1: row.x1, xn: row.xn, xm: row.xm, dx1: row.dx1, dxn: row.dxn, dxmk: row.dxmk },
        }
    }

    #[inline]
    fn validate(i: &KeptIncrement2d<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
