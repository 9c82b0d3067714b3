//! The position of b in the triad of a, relative to its initial position.

#![expect(clippy::inline_always, reason = "compiled in place, zeros that lie side by side are stored together")]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::slot::RelativePosition;
use crate::element::line::Positions;
use crate::fields;
use crate::formula::quantity::{D0, E1A, E2A, E3A, G_JOIN, XA, XB};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The positions of both nodes, the triad of a, and the initial position of b.
    pub struct Joined<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB, d0: Vector3<T> = D0,
    }
}
fields! {
    /// The displacement of b from its initial position.
    pub struct Displaced<T> { g: Vector3<T> = G_JOIN }
}

impl<T: Component> Joined<T> {
    /// The inputs without the initial position.
    #[inline]
    const fn positions(&self) -> Positions<T> {
        let Self { e1a, e2a, e3a, xa, xb, .. } = *self;
        Positions { e1a, e2a, e3a, xa, xb }
    }

    #[inline]
    const fn of(positions: Positions<T>, d0: Vector3<T>) -> Self {
        let Positions { e1a, e2a, e3a, xa, xb } = positions;
        Self { e1a, e2a, e3a, xa, xb, d0 }
    }
}

/// The three conditions that keep b at its initial position: g_i = e_ia·(xb − xa) − d0_i.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "join.constraint",
        "Constraint",
        Document::UJOINT.ours("Description", "the page of JOIN was not given; b is held where it was at the start"),
    )
    .equation(r"g_i = \mathbf{e}_{ia}\cdot(\mathbf{x}_b-\mathbf{x}_a) - d_{0i},\quad i = 1, 2, 3")
    .eta(2.0, 1.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Joined<T>;
    type Outputs<T: Component> = Displaced<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Joined<D>) -> Displaced<D> {
        let here = RelativePosition::eval(&i.positions());
        Displaced { g: Vector3::new(here.x, here.y, here.z) - i.d0 }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Joined<D>) -> Jacobian<Self, D> {
        let here = RelativePosition::jacobian(&i.positions());
        let row = |k: usize, gradient| Joined::of(gradient, along(k, -D::one()));
        Displaced { g: Vector3::new(row(0, here.x), row(1, here.y), row(2, here.z)) }
    }
}
