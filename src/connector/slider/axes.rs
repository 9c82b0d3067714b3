//! The axes that a SLIDER eliminates, and the coordinate that it keeps.

#![expect(clippy::inline_always, reason = "a call would write the inputs to memory, and wait for them there")]

mod proof;

use super::{Eliminate, Eliminate2d, Increment2d, Pivots, Pivots2d};
use crate::contact::increments::spec;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    Domain, Quantity, SLIDER_DXM, SLIDER_DXM_PLANE, SLIDER_DXMK, SLIDER_X1, SLIDER_X1_PLANE, SLIDER_XM,
    SLIDER_XM_PLANE, SLIDER_XMK, SLIDER_XN, SLIDER_XN_PLANE, Shape, Unit,
};
use crate::formula::{Component, Document, Formula, Given, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::{Vector2, Vector3};

/// The eliminated coordinates.
pub const AXES: Quantity = Quantity::new(
    r"\mathbf{a}",
    Shape::Vec2,
    Unit::ONE,
    Domain::Real,
    "the axes i and j of the eliminated coordinates XMI and XMJ, as 1, 2 or 3",
);

/// The eliminated coordinate in the plane.
pub const AXIS: Quantity = Quantity::new(
    r"a",
    Shape::Scalar,
    Unit::ONE,
    Domain::Real,
    "the axis i of the eliminated coordinate XMI, as 1 or 2",
);

fields! {
    /// The line.
    pub struct LineNodes<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN }
}
fields! {
    /// The axes that the documented pivots eliminate.
    pub struct EliminatedAxes<T> { axes: Vector2<T> = AXES }
}

/// The axes i and j that the documented pivots eliminate, in this state: 1, 2 or 3.
#[derive(Clone, Copy, Debug)]
pub struct PivotAxes;

impl Formula for PivotAxes {
    const SPEC: Spec = Spec {
        objective: false,
        ..Spec::new(
            "scene.pivot_axes",
            "The axes that are eliminated",
            Document::SLIDER.ours("", "the document numbers them by its pivots; that a state shows them is ours"),
        )
        .equation(r"\mathbf{a} = (i, j)")
        .given(&[Given::new(r"i,\ j", &Eliminate::SPEC)])
        .eta(4.0, 4.0)
    };
    type Inputs<T: Component> = LineNodes<T>;
    type Outputs<T: Component> = EliminatedAxes<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &LineNodes<D>) -> EliminatedAxes<D> {
        let pivots = Pivots::new(&i.x1, &i.xn);
        EliminatedAxes { axes: Vector2::new(axis_number(pivots.i), axis_number(pivots.j)) }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &LineNodes<D>) -> Jacobian<Self, D> {
        let zero = Vector3::from_element(D::zero());
        EliminatedAxes { axes: Vector2::from_element(LineNodes { x1: zero, xn: zero }) }
    }

    #[inline]
    fn validate<D: Scalar>(i: &LineNodes<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line in the plane.
    pub struct LineNodes2d<T> { x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE }
}
fields! {
    /// The axis that the documented pivot eliminates.
    pub struct EliminatedAxis<T> { axis: T = AXIS }
}

/// The axis i that the documented pivot eliminates in the plane, in this state: 1 or 2.
#[derive(Clone, Copy, Debug)]
pub struct PivotAxis2d;

impl Formula for PivotAxis2d {
    const SPEC: Spec = Spec {
        objective: false,
        ..Spec::new(
            "scene.pivot_axis_2d",
            "The axis that is eliminated in the plane",
            Document::SLIDER.ours("", "the document numbers it by its pivot; that a state shows it is ours"),
        )
        .equation(r"a = i")
        .given(&[Given::new(r"i", &Eliminate2d::SPEC)])
        .eta(4.0, 4.0)
    };
    type Inputs<T: Component> = LineNodes2d<T>;
    type Outputs<T: Component> = EliminatedAxis<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &LineNodes2d<D>) -> EliminatedAxis<D> {
        EliminatedAxis { axis: axis_number(Pivots2d::new(&i.x1, &i.xn).i) }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &LineNodes2d<D>) -> Jacobian<Self, D> {
        let zero = Vector2::from_element(D::zero());
        EliminatedAxis { axis: LineNodes2d { x1: zero, xn: zero } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &LineNodes2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

/// An axis counted from 0, as a number from 1.
fn axis_number<D: Scalar>(axis: usize) -> D {
    D::from([1.0, 2.0, 3.0][axis])
}

fields! {
    /// The coordinate that is kept, and its increment.
    pub struct Kept<T> { xmk: T = SLIDER_XMK, dxmk: T = SLIDER_DXMK }
}
fields! {
    /// The line, node m and its increment.
    pub struct KeptNodes<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM, dxm: Vector3<T> = SLIDER_DXM,
    }
}

/// The coordinate of node m along the axis that the documented pivots keep, and its increment.
#[derive(Clone, Copy, Debug)]
pub struct KeptAxis;

impl Formula for KeptAxis {
    const SPEC: Spec = Spec {
        objective: false,
        ..spec(
            "scene.kept_axis",
            "The coordinate that is kept",
            r"x_{m,k} = \mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathrm{d}x_{m,k} = \mathrm{d}\mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathbf{e}_k = \begin{cases} \mathbf{i} & k = 1 \\ \mathbf{j} & k = 2 \\ \mathbf{k} & k = 3 \end{cases}",
        )
        .given(&[Given::new("k", &Eliminate::SPEC)])
    };
    type Inputs<T: Component> = KeptNodes<T>;
    type Outputs<T: Component> = Kept<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptNodes<D>) -> Kept<D> {
        let k = Pivots::new(&i.x1, &i.xn).k;
        Kept { xmk: i.xm[k], dxmk: i.dxm[k] }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptNodes<D>) -> Jacobian<Self, D> {
        let k = Pivots::new(&i.x1, &i.xn).k;
        let zero = Vector3::from_element(D::zero());
        let axis = along(k, D::one());
        let none = KeptNodes { x1: zero, xn: zero, xm: zero, dxm: zero };
        Kept { xmk: KeptNodes { xm: axis, ..none }, dxmk: KeptNodes { dxm: axis, ..none } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptNodes<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line, node m and its increment, in the plane.
    pub struct KeptNodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        dxm: Vector2<T> = SLIDER_DXM_PLANE,
    }
}

/// As [`KeptAxis`], in the plane.
#[derive(Clone, Copy, Debug)]
pub struct KeptAxis2d;

impl Formula for KeptAxis2d {
    const SPEC: Spec = Spec {
        id: "scene.kept_axis_2d",
        given: &[Given::new("k", &Increment2d::SPEC)],
        latex: r"x_{m,k} = \mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathrm{d}x_{m,k} = \mathrm{d}\mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathbf{e}_k = \begin{cases} (1, 0) & k = 1 \\ (0, 1) & k = 2 \end{cases}",
        ..KeptAxis::SPEC
    };
    type Inputs<T: Component> = KeptNodes2d<T>;
    type Outputs<T: Component> = Kept<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptNodes2d<D>) -> Kept<D> {
        let k = Pivots2d::new(&i.x1, &i.xn).k;
        Kept { xmk: i.xm[k], dxmk: i.dxm[k] }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptNodes2d<D>) -> Jacobian<Self, D> {
        let k = Pivots2d::new(&i.x1, &i.xn).k;
        let (zero, axis) = (Vector2::from_element(D::zero()), along(k, D::one()));
        let none = KeptNodes2d { x1: zero, xn: zero, xm: zero, dxm: zero };
        Kept { xmk: KeptNodes2d { xm: axis, ..none }, dxmk: KeptNodes2d { dxm: axis, ..none } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptNodes2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
