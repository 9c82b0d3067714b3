//! The UNIVERSAL connector as a program uses it: validated once, then evaluated by the formulas.

use super::{
    Angles, Constraint, ConstraintMoment, Driven, FreeMoment, KineticMoment, Moment, RelativeMotion, Rotations, Shafts,
    Skew, Turns, TurnsSince, Twisted, UniversalElement, UniversalStart,
};
use crate::element::cardan::{Triads, nearest};
use crate::element::frame::Triad;
use crate::element::{Contribution, Nodes, Nothing, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{ValueAndJacobian, value, value_and_jacobian};
use nalgebra::{Vector1, Vector3};

/// A UNIVERSAL connector.
///
/// ```
/// use jointproof::connector::{universal::Universal};
/// use jointproof::element::frame::Triad;
/// use nalgebra::Vector3;
///
/// let a = Triad::global();
/// let joint = Universal::new(&a, &a)?;
/// let b = Triad::new(Vector3::x(), Vector3::z(), -Vector3::y())?; // b turned by 90° about e1a, which is free
/// assert_eq!(joint.constraint(&a, &b)?.g, 0.0);
/// assert_eq!(joint.relative_motion(&a, &b)?.ur1, std::f64::consts::FRAC_PI_2);
///
/// let in_line = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x())?; // the shafts in one line
/// assert!(joint.relative_motion(&a, &in_line).is_err()); // gimbal lock
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Universal {
    c0: f64,
    initial: Turns<f64>,
    theta1_ref: f64,
    theta3_ref: f64,
}

impl Universal {
    /// Keeps the shafts at their initial angle.
    ///
    /// # Errors
    /// [`Error::GimbalLock`]: the shafts are in one line, so that the angles about them are not defined.
    pub fn new(a: &Triad, b: &Triad) -> Result<Self, Error> {
        let initial = value::<Angles>(&Triads::from((a, b)))?;
        let c0 = value::<Constraint>(&Shafts { e1a: a.e1(), e3b: b.e3(), c0: 0.0 })?.g;
        Ok(Self { c0, initial, theta1_ref: initial.alpha, theta3_ref: initial.gamma })
    }

    /// Sets the constitutive reference angles; by default they are the initial ones.
    ///
    /// # Errors
    /// An angle that is not finite.
    pub fn with_reference_angles(mut self, theta1_ref: f64, theta3_ref: f64) -> Result<Self, Error> {
        Error::check("theta1_ref", None, theta1_ref, Domain::Angle)?;
        Error::check("theta3_ref", None, theta3_ref, Domain::Angle)?;
        (self.theta1_ref, self.theta3_ref) = (theta1_ref, theta3_ref);
        Ok(self)
    }

    /// The initial e1a·e3b.
    pub const fn initial_cosine(&self) -> f64 {
        self.c0
    }

    /// The deviation of the shafts from their initial angle ([`Constraint`]).
    ///
    /// # Errors
    /// None for validated triads; those of the formula are passed on.
    pub fn constraint(&self, a: &Triad, b: &Triad) -> Result<Skew<f64>, Error> {
        value::<Constraint>(&Shafts { e1a: a.e1(), e3b: b.e3(), c0: self.c0 })
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`Universal::constraint`].
    pub fn constraint_jacobian(&self, a: &Triad, b: &Triad) -> Result<ValueAndJacobian<Constraint, f64>, Error> {
        value_and_jacobian::<Constraint>(&Shafts { e1a: a.e1(), e3b: b.e3(), c0: self.c0 })
    }

    /// The angles at the start.
    pub const fn initial(&self) -> Turns<f64> {
        self.initial
    }

    /// The angles about both shafts that are nearest to those of the last state ([`Angles`], plus full turns): continued in this
    /// way from state to state, a joint may rotate without limit, by less than half a turn between two states.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn turns_from(&self, last: &Turns<f64>, a: &Triad, b: &Triad) -> Result<Turns<f64>, Error> {
        let Turns { alpha, gamma } = value::<Angles>(&Triads::from((a, b)))?;
        Ok(Turns { alpha: nearest(alpha, last.alpha), gamma: nearest(gamma, last.gamma) })
    }

    /// The rotations about both shafts, from the start and from the reference angles ([`RelativeMotion`]), within half a turn
    /// of the start.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn relative_motion(&self, a: &Triad, b: &Triad) -> Result<Rotations<f64>, Error> {
        self.relative_motion_from(&self.initial, a, b)
    }

    /// The rotations about both shafts, continued from the last state as by [`Universal::turns_from`].
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn relative_motion_from(&self, last: &Turns<f64>, a: &Triad, b: &Triad) -> Result<Rotations<f64>, Error> {
        let Turns { alpha, gamma } = self.turns_from(last, a, b)?;
        let Turns { alpha: alpha0, gamma: gamma0 } = self.initial;
        let (theta1_ref, theta3_ref) = (self.theta1_ref, self.theta3_ref);
        value::<RelativeMotion>(&TurnsSince { alpha, gamma, alpha0, gamma0, theta1_ref, theta3_ref })
    }

    /// The moment on b that keeps the shafts at their angle ([`ConstraintMoment`]), in the global frame.
    ///
    /// # Errors
    /// [`Error::GimbalLock`], or a moment that is not finite.
    pub fn constraint_moment(&self, a: &Triad, b: &Triad, m2: f64) -> Result<Moment<f64>, Error> {
        value::<ConstraintMoment>(&Twisted { e2a: a.e2(), e3a: a.e3(), e3b: b.e3(), m2 })
    }

    /// The moment about the shafts on a ([`KineticMoment`]), in the global frame; its opposite acts on b.
    ///
    /// # Errors
    /// A moment that is not finite.
    pub fn kinetic_moment(&self, a: &Triad, b: &Triad, m1: f64, m3: f64) -> Result<FreeMoment<f64>, Error> {
        value::<KineticMoment>(&Driven { e1a: a.e1(), e3b: b.e3(), m1, m3 })
    }

    /// The element that a solver calls.
    pub const fn element(&self) -> Parameters<UniversalElement, f64, 1> {
        Parameters { start: UniversalStart { c0: self.c0 }, contact: None }
    }

    /// The contribution to a step of Newton's method.
    ///
    /// # Errors
    /// As [`Parameters::newton`].
    pub fn newton(&self, a: &Triad, b: &Triad, multipliers: &Vector1<f64>) -> Result<Contribution<f64, 1>, Error> {
        let nodes = Nodes::new([(*a).into(), (*b).into()], [Vector3::zeros(); 2]);
        self.element().newton(&nodes, multipliers, &Nothing::new()).map(|(found, _)| found)
    }
}
