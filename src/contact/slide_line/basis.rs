//! The local basis of a slide line.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::left;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{CURVE_RATE, NORMAL, TANGENT};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, norm_and_direction};
use nalgebra::Vector2;

fields! {
    /// A vector along the slide line.
    pub struct Direction<T> { dx: Vector2<T> = CURVE_RATE }
}
fields! {
    /// Unit tangent and unit normal.
    pub struct Basis<T> { t: Vector2<T> = TANGENT, n: Vector2<T> = NORMAL }
}

/// The local basis: t = dx/|dx|, n = s × t = (−t₂, t₁).
#[derive(Clone, Copy, Debug)]
pub struct LocalBasis;

impl Formula for LocalBasis {
    const SPEC: Spec = Spec::new(
        "slide_line.basis",
        "Local basis",
        Document::SLIDE_LINE.reconstructed(
            "Defining the local basis system",
            "the symbol of the tangent was lost; its words: along the sequence of the nodes",
        ),
    )
        .equation(r"\mathbf{t} = \frac{\mathbf{X}'}{\lvert\mathbf{X}'\rvert},\quad \mathbf{n} = \mathbf{s}\times\mathbf{t} = (-t_2, t_1)")
        // The squares, their sum and the root have two rounding errors, and the quotient has one more.
        // The largest η that `audit --attack` found is 2.44 for the value, and 3 is possible to first order; for the Jacobian 3.91 and 12.
        .eta(3.0, 8.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Direction<T>;
    type Outputs<T: Component> = Basis<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Direction<D>) -> Basis<D> {
        let (_, t) = length_and_tangent(i.dx);
        Basis { t, n: left(t) }
    }

    /// δt = n (n·δdx)/|dx| and δn = −t (n·δdx)/|dx|: a change of dx along t has no effect.
    #[inline]
    fn jacobian<D: Scalar>(i: &Direction<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Direction<D>) -> ValueAndJacobian<Self, D> {
        let (length, t) = length_and_tangent(i.dx);
        let n = left(t);
        let turn = n / length;
        let by = Basis {
            t: n.map(|component| Direction { dx: turn * component }),
            n: t.map(|component| Direction { dx: turn * -component }),
        };
        (Basis { t, n }, by)
    }

    #[inline]
    fn validate<D: Scalar>(i: &Direction<D>) -> Result<(), Error> {
        Error::check_direction("dx", i.dx)
    }
}

/// |v| and v/|v|.
#[inline]
pub(crate) fn length_and_tangent<D: Scalar>(v: Vector2<D>) -> (D, Vector2<D>) {
    let (length, [x, y]) = norm_and_direction([v.x, v.y]);
    (length, Vector2::new(x, y))
}
