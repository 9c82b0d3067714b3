//! JOIN in scenes.

#![expect(clippy::inline_always, reason = "a call would write the inputs to memory, and wait for them there")]

mod proof;

use super::Constraint;
use crate::connector::align::{ConstraintMoment, Moments};
use crate::element::table::{Dimension, FORCES, Given, Kind, NODES, Origin, Outputs, Use, always, renamed};
use crate::fields;
use crate::formula::quantity::{E1A, E2A, E3A, F2, F3, FORCE, JOIN_F1};
use crate::formula::{Component, Document, Formula, Jacobian, Spec};
use crate::number::scalar::Scalar;
use Origin::{Initial, Zero};
use nalgebra::Vector3;

/// The initial position of b is the residual with nothing subtracted.
pub(crate) const JOINED: &[Given] = &[("no_vector", Zero), ("d0", Initial("d"))];
pub(crate) const JOINING: &[Use] =
    &[always(&Constraint), renamed(&Constraint, &[("d0", "no_vector"), ("g", "d")]), renamed(&Joining, &[("f", "rf")])];
pub(crate) const APART: Outputs = &[("G", "g")];
pub(crate) const REACTION: Outputs = &[("RF", "rf")];

pub(crate) const JOIN: Kind = Kind {
    name: "join",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, JOINED, FORCES],
    ordered: &[],
    formulas: &[JOINING],
    meanings: &[],
    outputs: &[APART, REACTION],
};

fields! {
    /// The triad of a, and the forces along its axes.
    pub struct JoinLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, f1: T = JOIN_F1, f2: T = F2, f3: T = F3,
    }
}
fields! {
    /// The force on b.
    pub struct JoinForce<T> { f: Vector3<T> = FORCE }
}

impl<D: Scalar> JoinLoads<D> {
    /// The sum along a's axes is the same as that of ALIGN's moments.
    #[inline(always)]
    fn moments(&self) -> Moments<D> {
        let Self { e1a, e2a, e3a, f1, f2, f3 } = *self;
        Moments { e1a, e2a, e3a, m1: f1, m2: f2, m3: f3 }
    }
}

/// The force on b that JOIN transmits: f = f1 e1a + f2 e2a + f3 e3a.
#[derive(Clone, Copy, Debug)]
pub struct Joining;

impl Formula for Joining {
    const SPEC: Spec = Spec::new("scene.join_force", "Constraint force of JOIN", Document::UJOINT.printed("Friction"))
        .equation(r"\mathbf{f} = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a}")
        .eta(1.5, 0.0);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinForce<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinForce<D> {
        JoinForce { f: ConstraintMoment::eval(&i.moments()).m }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        let row = |Moments { e1a, e2a, e3a, m1, m2, m3 }| JoinLoads { e1a, e2a, e3a, f1: m1, f2: m2, f3: m3 };
        JoinForce { f: ConstraintMoment::jacobian(&i.moments()).m.map(row) }
    }
}
