//! The JOIN connector as a program uses it: validated once, then evaluated by the formulas.

use super::{Constraint, Displaced, JoinElement, JoinStart, Joined};
use crate::connector::slot::{ConstraintForce, CrossFrame, Force, KineticForce, Pose, SlotForce};
use crate::element::frame::Triad;
use crate::element::{Contribution, Nothing, Parameters};
use crate::formula::error::Error;
use crate::formula::{ValueAndJacobian, value, value_and_jacobian};
use nalgebra::Vector3;

/// A JOIN connector.
///
/// ```
/// use jointproof::connector::{join::Join, slot::Pose};
/// use jointproof::element::frame::Triad;
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
    /// Keeps b at its initial position in the triad of a.
    ///
    /// # Errors
    /// A position that is not finite, or so large that the relative position overflows.
    pub fn new(initial: &Pose) -> Result<Self, Error> {
        let none = Self { d0: Vector3::zeros() };
        Ok(Self { d0: none.constraint(initial)?.g })
    }

    /// The initial position of b, as components in the triad of a.
    pub const fn initial_position(&self) -> Vector3<f64> {
        self.d0
    }

    /// The displacement of b from its initial position ([`Constraint`]).
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

    /// The constraint force on b, in the global frame: f1 e1a + f2 e2a + f3 e3a.
    ///
    /// # Errors
    /// A force that is not finite, or one so large that the sum overflows.
    pub fn constraint_force(&self, triad_a: &Triad, [f1, f2, f3]: [f64; 3]) -> Result<Force<f64>, Error> {
        let along = value::<KineticForce>(&SlotForce { e1a: triad_a.e1(), f1 })?.f;
        let across = value::<ConstraintForce>(&CrossFrame { e2a: triad_a.e2(), e3a: triad_a.e3(), f2, f3 })?.f;
        let f = along + across;
        if f.iter().all(|f| f.is_finite()) { Ok(Force { f }) } else { Err(Error::Overflow { name: "f" }) }
    }

    /// The element that a solver calls: its start.
    pub const fn element(&self) -> Parameters<JoinElement, f64, 3> {
        Parameters { start: JoinStart { d0: self.d0 }, contact: None }
    }

    /// The contribution to a step of Newton's method.
    ///
    /// # Errors
    /// As [`Parameters::newton`].
    pub fn newton(&self, pose: &Pose, multipliers: &Vector3<f64>) -> Result<Contribution<f64, 3>, Error> {
        self.element().newton(&pose.nodes(), multipliers, &Nothing::new()).map(|(found, _)| found)
    }

    fn inputs(&self, pose: &Pose) -> Joined<f64> {
        let Pose { triad, xa, xb } = *pose;
        Joined { e1a: triad.e1(), e2a: triad.e2(), e3a: triad.e3(), xa, xb, d0: self.d0 }
    }
}
