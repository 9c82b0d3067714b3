//! JOIN: node b stays at its initial position in the triad of node a.
//!
//! | | |
//! |---|---|
//! | frames | the triad e1a, e2a, e3a of node a; node b has none |
//! | position | d = xb − xa in that triad: (e1a·d, e2a·d, e3a·d) = Rᵀ d, with R of the columns e1a, e2a, e3a |
//! | zero position | where the analysis begins, d0, which is 0 where the nodes coincide |
//! | signs | f1 e1a + f2 e2a + f3 e3a acts on b and its opposite on a |
//!
//! [`Join`] is what a program calls.

#![expect(clippy::inline_always, reason = "compiled in place, zeros that lie side by side are stored together")]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::frame::Triad;
use crate::connector::slot::{
    ConstraintForce, CrossFrame, Force, KineticForce, Pose, Positions, RelativePosition, SlotForce,
};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{D0, E1A, E2A, E3A, G_JOIN, XA, XB};
use crate::formula::{
    Component, Document, Finite, Formula, Jacobian, Spec, ValueAndJacobian, along, value, value_and_jacobian,
};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// Where the nodes are, how node a is turned, and where b was at the start.
    pub struct Joined<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB, d0: Vector3<T> = D0,
    }
}
fields! {
    /// By how much b is out of its place.
    pub struct Displaced<T> { g: Vector3<T> = G_JOIN }
}

impl<T: Component> Joined<T> {
    /// Without the initial position.
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

/// The three conditions that keep b in its place: g_i = e_ia·(xb − xa) − d0_i.
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

/// A JOIN connector.
///
/// ```
/// use jointproof::connector::{frame::Triad, join::Join, slot::Pose};
/// use nalgebra::Vector3;
///
/// let mut pose = Pose { triad: Triad::global(), xa: Vector3::zeros(), xb: Vector3::new(1.0, 0.0, 0.0) };
/// let join = Join::new(&pose)?;
/// pose.xb.y = 0.5;
/// assert_eq!(join.constraint(&pose)?.g, Vector3::new(0.0, 0.5, 0.0));
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Join {
    d0: Vector3<f64>,
}

impl Join {
    /// Keeps b where it is in the triad of a.
    ///
    /// # Errors
    /// A position that is not finite, or so far that the relative position overflows.
    pub fn new(initial: &Pose) -> Result<Self, Error> {
        let none = Self { d0: Vector3::zeros() };
        Ok(Self { d0: none.constraint(initial)?.g })
    }

    /// The initial position of b, as components in the triad of a.
    pub const fn initial_position(&self) -> Vector3<f64> {
        self.d0
    }

    /// By how much b is out of its place ([`Constraint`]).
    ///
    /// # Errors
    /// As [`Join::new`].
    pub fn constraint(&self, pose: &Pose) -> Result<Displaced<f64>, Error> {
        value::<Constraint>(&self.inputs(pose))
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`Join::new`].
    pub fn constraint_jacobian(&self, pose: &Pose) -> Result<ValueAndJacobian<Constraint, f64>, Error> {
        value_and_jacobian::<Constraint>(&self.inputs(pose))
    }

    /// The force on b that holds it in its place, in the global frame: f1 e1a + f2 e2a + f3 e3a.
    ///
    /// # Errors
    /// A force that is not finite, or one so large that the sum overflows.
    pub fn constraint_force(&self, triad_a: &Triad, [f1, f2, f3]: [f64; 3]) -> Result<Force<f64>, Error> {
        let along = value::<KineticForce>(&SlotForce { e1a: triad_a.e1(), f1 })?.f;
        let across = value::<ConstraintForce>(&CrossFrame { e2a: triad_a.e2(), e3a: triad_a.e3(), f2, f3 })?.f;
        let f = along + across;
        if f.iter().all(|f| f.is_finite()) { Ok(Force { f }) } else { Err(Error::Overflow { name: "f" }) }
    }

    fn inputs(&self, pose: &Pose) -> Joined<f64> {
        let Pose { triad, xa, xb } = *pose;
        Joined { e1a: triad.e1(), e2a: triad.e2(), e3a: triad.e3(), xa, xb, d0: self.d0 }
    }
}
