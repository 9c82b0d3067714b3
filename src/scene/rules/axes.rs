//! The axes that a SLIDER eliminates.

#![expect(clippy::inline_always, reason = "a call would write the inputs to memory, and wait for them there")]

use crate::connector::slider::{Eliminate, Eliminate2d, Pivots, Pivots2d};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{Domain, Quantity, SLIDER_X1, SLIDER_X1_PLANE, SLIDER_XN, SLIDER_XN_PLANE, Shape, Unit};
use crate::formula::{Component, Document, Formula, Given, Jacobian, Spec};
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
