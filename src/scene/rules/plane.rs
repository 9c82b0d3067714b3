//! SLIDER in the plane: what its increments violate, and the coordinate that follows from the one that is kept.

use super::{DXM_PLANE, KeptAxis2d, scalar, spec};
use crate::error::Error;
use crate::fields;
use crate::formula::{Component, Formula, Given, Jacobian, Spec};
use crate::quantity::{
    Domain, Quantity, SLIDER_DX1_PLANE, SLIDER_DXN_PLANE, SLIDER_X1_PLANE, SLIDER_XM_PLANE, SLIDER_XMI, SLIDER_XMK,
    SLIDER_XN_PLANE, Unit,
};
use crate::scalar::{Scalar, norm_and_direction};
use crate::slider::{Increment2d, Line, Pivots2d};
use nalgebra::Vector2;

/// By how much increments violate the condition.
pub const RESIDUAL: Quantity = scalar(
    "r",
    Unit::L,
    Domain::Real,
    "by how much the increments violate the condition, positive to the left of the line",
);
/// The coordinate that is eliminated; in the plane there is one.
pub const XMI_PLANE: Quantity =
    Quantity { meaning: "coordinate of node m along the axis i that is eliminated", ..SLIDER_XMI };

fields! {
    /// The line and node m in the plane, and increments of all three nodes.
    pub struct MovingNodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        dx1: Vector2<T> = SLIDER_DX1_PLANE, dxn: Vector2<T> = SLIDER_DXN_PLANE, dxm: Vector2<T> = DXM_PLANE,
    }
}
fields! {
    /// By how much increments violate the condition in the plane.
    pub struct Residual<T> { r: T = RESIDUAL }
}

/// What the condition in the plane demands of increments: r = t·(dxm − (1−ξ) dx1 − ξ dxn) = 0.
#[derive(Clone, Copy, Debug)]
pub struct IncrementalConstraint2d;

/// The line, and where m is: n, t, l, ξ, and how far m is from it.
struct View<D> {
    n: Vector2<D>,
    t: Vector2<D>,
    l: D,
    share: D,
    aside: D,
}

impl<D: Scalar> View<D> {
    #[inline(always)]
    fn new(i: &MovingNodes2d<D>) -> Self {
        let d = i.xn - i.x1;
        let (l, [n1, n2]) = norm_and_direction([d.x, d.y]);
        let (n, t) = (Vector2::new(n1, n2), Vector2::new(-n2, n1));
        let offset = i.xm - i.x1;
        Self { n, t, l, share: offset.dot(&n) / l, aside: offset.dot(&t) }
    }

    /// dxm − (1−ξ) dx1 − ξ dxn.
    #[inline(always)]
    fn motion(&self, i: &MovingNodes2d<D>) -> Vector2<D> {
        i.dxm - i.dx1 - (i.dxn - i.dx1) * self.share
    }
}

impl Formula for IncrementalConstraint2d {
    const SPEC: Spec = spec(
        "scene.incremental_constraint_2d",
        "Incremental constraint in the plane",
        r"r = \mathbf{t}\cdot\bigl(\mathrm{d}\mathbf{x}_m - (1-\xi)\,\mathrm{d}\mathbf{x}_1 - \xi\,\mathrm{d}\mathbf{x}_n\bigr),\quad \xi = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{n}/l,\quad \mathbf{t} = (-n_2, n_1)",
    )
    .given(&[Given::new(r"\mathbf{n},\ l", &Line::SPEC)]);
    type Inputs<T: Component> = MovingNodes2d<T>;
    type Outputs<T: Component> = Residual<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &MovingNodes2d<D>) -> Residual<D> {
        let view = View::new(i);
        Residual { r: view.t.dot(&view.motion(i)) }
    }

    /// The line turns by t·δd/l, which changes t by −n times that, and moves ξ.
    #[inline]
    fn jacobian<D: Scalar>(i: &MovingNodes2d<D>) -> Jacobian<Self, D> {
        let view = View::new(i);
        let View { n, t, l, share, aside } = view;
        let gain = t.dot(&(i.dxn - i.dx1));
        let by_offset = n * (-gain / l);
        let by_line = -(t * n.dot(&view.motion(i)) + (t * (aside / l) - n * share) * gain) / l;
        Residual {
            r: MovingNodes2d {
                x1: -by_line - by_offset,
                xn: by_line,
                xm: by_offset,
                dx1: t * (share - 1.0),
                dxn: t * -share,
                dxm: t,
            },
        }
    }

    #[inline]
    fn validate(i: &MovingNodes2d<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line in the plane, and the coordinate of node m that is kept.
    pub struct KeptCoordinate2d<T> { x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xmk: T = SLIDER_XMK }
}
fields! {
    /// The coordinate of node m that is eliminated.
    pub struct Coordinate2d<T> { xmi: T = XMI_PLANE }
}

/// The place of m on the line from one coordinate: xm_i = x1_i + (n_i/n_k)(xm_k − x1_k).
#[derive(Clone, Copy, Debug)]
pub struct Eliminate2d;

impl Formula for Eliminate2d {
    const SPEC: Spec = Spec {
        objective: false,
        ..spec(
            "scene.eliminate_2d",
            "The eliminated coordinate in the plane",
            r"x_{m,i} = x_{1,i} + \frac{n_i}{n_k}(x_{m,k}-x_{1,k})",
        )
        .given(&[
            Given::new(r"i,\ k", &Increment2d::SPEC),
            Given::new(r"\mathbf{n}", &Line::SPEC),
            Given::new(r"x_{m,k}", &KeptAxis2d::SPEC),
        ])
    };
    type Inputs<T: Component> = KeptCoordinate2d<T>;
    type Outputs<T: Component> = Coordinate2d<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptCoordinate2d<D>) -> Coordinate2d<D> {
        let Pivots2d { i: along, k, .. } = Pivots2d::new(&i.x1, &i.xn);
        let d = i.xn - i.x1;
        Coordinate2d { xmi: i.x1[along] + d[along] * ((i.xmk - i.x1[k]) / d[k]) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptCoordinate2d<D>) -> Jacobian<Self, D> {
        let Pivots2d { i: along, k, .. } = Pivots2d::new(&i.x1, &i.xn);
        let d = i.xn - i.x1;
        let (share, ratio) = ((i.xmk - i.x1[k]) / d[k], d[along] / d[k]);
        let (mut x1, mut xn) = (Vector2::from_element(D::zero()), Vector2::from_element(D::zero()));
        x1[along] = -share + 1.0;
        x1[k] = ratio * (share - 1.0);
        xn[along] = share;
        xn[k] = -ratio * share;
        Coordinate2d { xmi: KeptCoordinate2d { x1, xn, xmk: ratio } }
    }

    #[inline]
    fn validate(i: &KeptCoordinate2d<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
