//! Elimination: two coordinates of node m, and two of its increments, from the third.

pub mod documented;
#[cfg(feature = "verify")]
mod proof;

use super::constraint::IncrementalConstraint;
use super::line::Line;
use super::pivots::Spatial;
use super::place::Place;
use super::slide::Slide;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    SLIDER_DX1, SLIDER_DXMI, SLIDER_DXMJ, SLIDER_DXMK, SLIDER_DXN, SLIDER_X1, SLIDER_XM, SLIDER_XMI, SLIDER_XMJ,
    SLIDER_XMK, SLIDER_XN,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The line, and the coordinate of node m that is kept.
    pub struct KeptCoordinate<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xmk: T = SLIDER_XMK }
}
fields! {
    /// The coordinates of node m that are eliminated.
    pub struct Coordinates<T> { xmi: T = SLIDER_XMI, xmj: T = SLIDER_XMJ }
}

/// The position of m on the line from one coordinate: xm_i = x1_i + (n_i/n_k)(xm_k − x1_k), and the same for j.
///
/// The axes are those of [`Pivots`](super::Pivots). Any point of the line may replace x1; the nearer of nodes 1 and n is used.
#[derive(Clone, Copy, Debug)]
pub struct Eliminate;

impl<D: Scalar> KeptCoordinate<D> {
    /// The position of m on the line.
    #[inline(always)]
    fn place(&self) -> Place<D, Spatial, 3> {
        Place::new(&self.x1, &self.xn, Spatial::new(&self.x1, &self.xn), self.xmk)
    }
}

impl<D: Scalar> Place<D, Spatial, 3> {
    #[inline(always)]
    fn coordinates(&self) -> Coordinates<D> {
        Coordinates { xmi: self.coordinate(0), xmj: self.coordinate(1) }
    }
}

impl Formula for Eliminate {
    const SPEC: Spec = Spec::new(
        "slider.eliminate",
        "Elimination",
        Document::SLIDER.reconstructed(
            "",
            "every symbol was lost; the words: eliminate i and j, the axes of the largest projections of the normals",
        ),
    )
        .equation(r"\begin{aligned} x_{m,i} &= x_{1,i} + \frac{n_i}{n_k}(x_{m,k}-x_{1,k}),\quad x_{m,j} = x_{1,j} + \frac{n_j}{n_k}(x_{m,k}-x_{1,k}), \\ (i, j, k) &= \begin{cases} (2, 1, 3) & \lvert d_3\rvert \ge \lvert d_2\rvert,\ d_2^2 + d_3^2 \ge \lvert d_1 d_3\rvert,\ d_3 \ne 0 \\ (2, 3, 1) & \lvert d_3\rvert \ge \lvert d_2\rvert \\ (3, 1, 2) & d_2^2 + d_3^2 \ge \lvert d_1 d_2\rvert \\ (3, 2, 1) & \text{otherwise} \end{cases},\quad \mathbf{d} = \mathbf{x}_n-\mathbf{x}_1 \end{aligned}")
.given(&[Given::new(r"\mathbf{n}", &Line::SPEC)])
        // The largest η that `audit --attack` found is 2.08 for the value, and 3.5 is possible to first order; for the Jacobian 2.07
        // and 4.5.
        .eta(4.0, 7.0)
        .scale(1e150)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = KeptCoordinate<T>;
    type Outputs<T: Component> = Coordinates<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptCoordinate<D>) -> Coordinates<D> {
        i.place().coordinates()
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptCoordinate<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &KeptCoordinate<D>) -> (Coordinates<D>, Jacobian<Self, D>) {
        let place = i.place();
        let row = |axis: usize| {
            let [x1, xn] = place.gradients(axis);
            KeptCoordinate { x1, xn, xmk: place.slope(axis) }
        };
        (place.coordinates(), Coordinates { xmi: row(0), xmj: row(1) })
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptCoordinate<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line and node m, increments of nodes 1 and n, and the increment of m that is kept.
    pub struct KeptIncrement<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM,
        dx1: Vector3<T> = SLIDER_DX1, dxn: Vector3<T> = SLIDER_DXN, dxmk: T = SLIDER_DXMK,
    }
}
fields! {
    /// The increments of node m that are eliminated.
    pub struct Increments<T> { dxmi: T = SLIDER_DXMI, dxmj: T = SLIDER_DXMJ }
}

/// The eliminated increments of m: with w = (1−ξ) dx1 + ξ dxn and ξ = (xm − x1)·n/l,
/// dxm_i = w_i + (n_i/n_k)(dxm_k − w_k), and the same for j.
///
/// No direction normal to the line is needed, and nothing grows without bound as n approaches ±i.
#[derive(Clone, Copy, Debug)]
pub struct Increment;

impl<D: Scalar> KeptIncrement<D> {
    #[inline(always)]
    fn slide(&self) -> Slide<D, Spatial, 3> {
        Slide::new(&self.x1, &self.xn, &self.xm, Spatial::new(&self.x1, &self.xn))
    }
}

impl Formula for Increment {
    const SPEC: Spec = Spec::new(
        "slider.increment",
        "Eliminated increments",
        Document::SLIDER.reconstructed(
            "",
            "every symbol was lost; the words: the incremental constraints, solved for the eliminated increments",
        ),
    )
        .equation(r"\mathrm{d}x_{m,i} = w_i + \frac{n_i}{n_k}(\mathrm{d}x_{m,k}-w_k),\quad \mathrm{d}x_{m,j} = w_j + \frac{n_j}{n_k}(\mathrm{d}x_{m,k}-w_k),\quad \mathbf{w} = (1-\xi)\,\mathrm{d}\mathbf{x}_1 + \xi\,\mathrm{d}\mathbf{x}_n")
.given(&[Given::new(r"i,\ j,\ k", &Eliminate::SPEC), Given::new(r"\xi", &IncrementalConstraint::SPEC), Given::new(r"\mathbf{n}", &Line::SPEC)])
        // The largest η that `audit --attack` found is 2.37 for the value, and 6.9 is possible to first order; for the Jacobian 8.36
        // and 26.5.
        .eta(8.0, 24.0)
        .scale(1e120)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = KeptIncrement<T>;
    type Outputs<T: Component> = Increments<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptIncrement<D>) -> Increments<D> {
        let [dxmi, dxmj] = i.slide().increments(&i.dx1, &i.dxn, i.dxmk);
        Increments { dxmi, dxmj }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptIncrement<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &KeptIncrement<D>) -> (Increments<D>, Jacobian<Self, D>) {
        let slide = i.slide();
        let [dxmi, dxmj] = slide.increments(&i.dx1, &i.dxn, i.dxmk);
        let rows = slide.gradients(&i.dx1, &i.dxn, i.dxmk);
        let row = |axis: usize| {
            let row = rows.row(axis);
            KeptIncrement { x1: row.x1, xn: row.xn, xm: row.xm, dx1: row.dx1, dxn: row.dxn, dxmk: row.dxmk }
        };
        (Increments { dxmi, dxmj }, Increments { dxmi: row(0), dxmj: row(1) })
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptIncrement<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
