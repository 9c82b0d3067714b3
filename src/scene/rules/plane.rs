//! SLIDER in the plane: what its increments violate, and the coordinate that follows from the one that is kept.

use super::{KeptAxis2d, spec};
use crate::error::Error;
use crate::fields;
use crate::formula::{Component, Formula, Given, Jacobian, Spec};
use crate::quantity::{Quantity, SLIDER_X1_PLANE, SLIDER_XMI, SLIDER_XMK, SLIDER_XN_PLANE};
use crate::scalar::Scalar;
use crate::slider::{Increment2d, Line, Pivots2d};
use nalgebra::Vector2;

/// The coordinate that is eliminated; in the plane there is one.
pub const XMI_PLANE: Quantity =
    Quantity { meaning: "coordinate of node m along the axis i that is eliminated", ..SLIDER_XMI };

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
