//! The line through nodes 1 and n, and its variation when they move.

#![expect(clippy::inline_always, reason = "value and derivatives share the line where they are compiled as one piece")]

#[cfg(feature = "verify")]
mod proof;

use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    SLIDER_DL, SLIDER_DN, SLIDER_DX1, SLIDER_DXN, SLIDER_LENGTH, SLIDER_N, SLIDER_X1, SLIDER_XN,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, norm_and_direction};
use nalgebra::{Matrix3, Vector3};

fields! {
    /// The two nodes that define the line.
    pub struct Ends<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN }
}
fields! {
    /// Direction and length of the line.
    pub struct Direction<T> { n: Vector3<T> = SLIDER_N, l: T = SLIDER_LENGTH }
}

/// The line: l = |xn − x1|, n = (xn − x1)/l.
#[derive(Clone, Copy, Debug)]
pub struct Line;

impl Formula for Line {
    const SPEC: Spec = Spec::new(
        "slider.line",
        "Line",
        Document::SLIDER
            .reconstructed("", "every symbol was lost; the words: the direction of the line, and its length"),
    )
    .equation(r"l = \lvert\mathbf{x}_n-\mathbf{x}_1\rvert,\quad \mathbf{n} = (\mathbf{x}_n-\mathbf{x}_1)/l")
    // The largest η that `audit --attack` found is 2.6 for the value, and 3.5 is possible to first order; for the Jacobian 4.63 and 13.7.
    .eta(3.5, 10.0)
    .scale(1e250)
    .finite(Finite::Between);
    type Inputs<T: Component> = Ends<T>;
    type Outputs<T: Component> = Direction<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Ends<D>) -> Direction<D> {
        let (l, n) = norm_and_direction((i.xn - i.x1).into());
        Direction { n: n.into(), l }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Ends<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Ends<D>) -> ValueAndJacobian<Self, D> {
        let direction = Self::eval(i);
        let turn = across(&direction.n) * direction.l.recip();
        let row = |by_xn: Vector3<D>| Ends { x1: -by_xn, xn: by_xn };
        let along = |axis: usize| row(turn.column(axis).into_owned());
        (direction, Direction { n: Vector3::new(along(0), along(1), along(2)), l: row(direction.n) })
    }

    #[inline]
    fn validate<D: Scalar>(i: &Ends<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

/// I − n nᵀ for a unit vector n, with its diagonal as a sum of squares, so that nothing cancels.
#[inline]
pub(super) fn across<D: Scalar>(n: &Vector3<D>) -> Matrix3<D> {
    let square = n.component_mul(n);
    let [xy, yz, zx] = [-n.x * n.y, -n.y * n.z, -n.z * n.x];
    Matrix3::new(square.y + square.z, xy, zx, xy, square.z + square.x, yz, zx, yz, square.x + square.y)
}

fields! {
    /// The line, and increments of its nodes.
    pub struct MovingEnds<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN,
        dx1: Vector3<T> = SLIDER_DX1, dxn: Vector3<T> = SLIDER_DXN,
    }
}
fields! {
    /// Variation of direction and length of the line.
    pub struct DirectionChange<T> { dn: Vector3<T> = SLIDER_DN, dl: T = SLIDER_DL }
}

/// The variation of the line: dl = n·(dxn − dx1), dn = ((dxn − dx1) − dl n)/l.
///
/// Evaluated as dn = n×((dxn − dx1)×n)/l, which does not lose the small part of a relative motion that is almost along the line.
#[derive(Clone, Copy, Debug)]
pub struct DirectionVariation;

impl<D: Scalar> MovingEnds<D> {
    /// The line, and its variation.
    #[inline(always)]
    fn variation(&self) -> (Direction<D>, DirectionChange<D>) {
        let line @ Direction { n, l } = Line::eval(&Ends { x1: self.x1, xn: self.xn });
        let motion = self.dxn - self.dx1;
        (line, DirectionChange { dn: n.cross(&motion.cross(&n)) / l, dl: n.dot(&motion) })
    }
}

impl Formula for DirectionVariation {
    const SPEC: Spec = Spec::new(
        "slider.direction_variation",
        "Variation of the direction",
        Document::SLIDER.reconstructed(
            "",
            "every symbol was lost; the words: the change of the direction, from its definition",
        ),
    )
        .equation(r"\mathrm{d}l = \mathbf{n}\cdot(\mathrm{d}\mathbf{x}_n-\mathrm{d}\mathbf{x}_1),\quad \mathrm{d}\mathbf{n} = \bigl((\mathrm{d}\mathbf{x}_n-\mathrm{d}\mathbf{x}_1) - \mathrm{d}l\,\mathbf{n}\bigr)/l")
.given(&[Given::new(r"\mathbf{n},\ l", &Line::SPEC)])
        // The largest η that `audit --attack` found is 2.79 for the value, and 7.46 is possible to first order; for the Jacobian 4.43
        // and 17.5.
        .eta(7.0, 6.0)
        .normwise(7.5, 14.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = MovingEnds<T>;
    type Outputs<T: Component> = DirectionChange<T>;

    #[inline]
    fn eval<D: Scalar>(i: &MovingEnds<D>) -> DirectionChange<D> {
        i.variation().1
    }

    /// ∂dn/∂dxn = (I − n nᵀ)/l and ∂dn/∂xn = −(dn nᵀ + n dnᵀ + (dl/l)(I − n nᵀ))/l, both symmetric matrices.
    #[inline]
    fn jacobian<D: Scalar>(i: &MovingEnds<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &MovingEnds<D>) -> ValueAndJacobian<Self, D> {
        let (Direction { n, l }, change @ DirectionChange { dn, dl }) = i.variation();
        let per = l.recip();
        let (turn, outer) = (across(&n) * per, dn * n.transpose());
        let bend = (outer + outer.transpose() + turn * dl) * -per;
        let row = |xn: Vector3<D>, dxn: Vector3<D>| MovingEnds { x1: -xn, xn, dx1: -dxn, dxn };
        let along = |axis: usize| row(bend.column(axis).into_owned(), turn.column(axis).into_owned());
        (change, DirectionChange { dn: Vector3::new(along(0), along(1), along(2)), dl: row(dn, n) })
    }

    #[inline]
    fn validate<D: Scalar>(i: &MovingEnds<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
