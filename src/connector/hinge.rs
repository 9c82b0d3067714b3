//! HINGE: node b stays in its place relative to node a, and rotates about the first axis of a alone.
//!
//! | | |
//! |---|---|
//! | frames | the triads of both nodes; the pin is along e1a, which stays e1b |
//! | matrix | as of [`revolute`](crate::connector::revolute) |
//! | zero position | both triads equal: α = 0; held are the position of b in a's triad and e1a·e2b, e1a·e3b of the start |
//! | signs | as of [`join`](crate::connector::join) and [`revolute`](crate::connector::revolute): α about e1a by the right-hand rule; f1, f2, f3 along a's triad and m2, m3 about it act on b and their opposites on a; m1 e1a, conjugate to ur1, acts on a and its opposite on b |
//!
//! A pin in a sleeve carries the constraint forces and moments; they press it, and so produce friction about e1a. [`Hinge`] is what a
//! program calls.

mod element;
mod friction;
mod kinematics;
#[cfg(feature = "verify")]
mod proof;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use element::{HingeContact, HingeElement, HingeStart, HingeState};
pub use friction::{
    Contact, ContactMoment, Friction, HingeFriction, HingeLoads, LS, MC, MC_INT, MN, P_MOMENT, PHI_MOMENT, PinLoads,
    RA, RP,
};
pub use kinematics::{AngleGap, Constraint, DOCUMENT, HingeResiduals, Hinged, Stop, StopAngle};

use crate::connector::join::Join;
use crate::connector::revolute::{Across, Angle, RelativeMotion, Rotation, Turn, TurnSince};
use crate::connector::translator::Pose;
use crate::element::cardan::nearest;
use crate::element::frame::Triad;
use crate::element::{Contribution, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Jacobian, value, value_and_jacobian};
use nalgebra::{SVector, Vector3};

/// The pin, and its friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// Effective radius of the cross-section, > 0.
    pub rp: f64,
    /// Friction arm of the force along the pin; 0 omits that force.
    pub ra: f64,
    /// Length over which pin and sleeve overlap; 0 omits the bending moments.
    pub ls: f64,
    /// Internal contact moment, as of a press fit.
    pub mc_int: f64,
    /// Friction coefficient, ≥ 0.
    pub mu: f64,
}

/// A HINGE connector.
///
/// ```
/// use jointproof::connector::hinge::{Hinge, HingeState, Pin};
/// use jointproof::connector::translator::Pose;
/// use jointproof::element::frame::Triad;
/// use nalgebra::{SVector, Vector3};
///
/// let a = Triad::global();
/// let mut pose = Pose { triad_a: a, triad_b: a, xa: Vector3::zeros(), xb: Vector3::zeros() };
/// let pin = Pin { rp: 0.5, ra: 0.25, ls: 2.0, mc_int: 1.0, mu: 0.125 };
/// let hinge = Hinge::new(&pose)?.with_stops(-1.0, 2.0)?.with_friction(&pin)?.with_stick_stiffness(100.0)?;
///
/// pose.triad_b = Triad::new(Vector3::x(), Vector3::z(), -Vector3::y())?; // b rotates by 90° about e1a, which is free
/// let held = hinge.constraint(&pose)?;
/// assert_eq!((held.g2, held.g3), (0.0, 0.0));
/// assert_eq!(hinge.relative_motion_from(0.0, &pose)?.ur1, std::f64::consts::FRAC_PI_2);
///
/// // Along the pin 4, across it 5, and 6 of bending: M_C = 1 + 2.5 + 3, and M_N = 6.5 + 1.
/// assert_eq!(hinge.friction(0.0, [4.0, 3.0, -4.0], [6.0, 0.0])?.unwrap().mn, 7.5);
/// let (step, after) = hinge.newton(&pose, &SVector::from([4.0, 3.0, -4.0, 6.0, 0.0]), &HingeState { ur1: 0.0, m1: 0.0 })?;
/// assert_eq!(after.m1, 0.125 * 7.5); // it slips
/// assert_eq!(step.forces[3], after.m1); // the friction moment on a
///
/// let error = hinge.with_friction(&Pin { rp: 0.0, ..pin }).unwrap_err();
/// assert_eq!(error.to_string(), "rp is 0.0; allowed is a finite number > 0");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hinge {
    join: Join,
    c2: f64,
    c3: f64,
    alpha0: f64,
    theta1_ref: f64,
    stops: Option<[f64; 2]>,
    pin: Option<Pin>,
    /// 0 where it is not given.
    k_stick: f64,
}

impl Hinge {
    /// Keeps b in its place, and the first axes of both nodes at their initial angle, as a rule together.
    ///
    /// # Errors
    /// As [`Join::new`]; [`Error::GimbalLock`]: e3b is along e1a, so that there is no angle about the pin.
    pub fn new(initial: &Pose) -> Result<Self, Error> {
        let (a, b) = (initial.triad_a, initial.triad_b);
        let Turn { alpha } = value::<Angle>(&across(&a, &b))?;
        let join = Join::new(&initial.slot())?;
        let (c2, c3) = (a.e1().dot(&b.e2()), a.e1().dot(&b.e3()));
        Ok(Self { join, c2, c3, alpha0: alpha, theta1_ref: alpha, stops: None, pin: None, k_stick: 0.0 })
    }

    /// Sets the constitutive reference angle; the initial one otherwise.
    ///
    /// # Errors
    /// An angle that is not finite.
    pub fn with_reference_angle(self, theta1_ref: f64) -> Result<Self, Error> {
        Error::check("theta1_ref", None, theta1_ref, Domain::Angle)?;
        Ok(Self { theta1_ref, ..self })
    }

    /// Sets the stops, as values of α.
    ///
    /// # Errors
    /// A stop that is not finite, or `theta1_min > theta1_max`.
    pub fn with_stops(self, theta1_min: f64, theta1_max: f64) -> Result<Self, Error> {
        value::<Stop>(&StopAngle { alpha: 0.0, theta1_min, theta1_max })?;
        Ok(Self { stops: Some([theta1_min, theta1_max]), ..self })
    }

    /// Sets the pin and its friction; no friction otherwise.
    ///
    /// # Errors
    /// `rp` not above 0; `ra`, `ls` or `mu` negative; any of them, or `mc_int`, not finite.
    pub fn with_friction(self, pin: &Pin) -> Result<Self, Error> {
        let found = Self { pin: Some(*pin), ..self };
        found.friction(0.0, [0.0; 3], [0.0; 2]).map(|_| found)
    }

    /// Sets the stiffness in stick, > 0 (moment per radian), which [`newton`](Self::newton) needs where there is friction.
    ///
    /// # Errors
    /// `k_stick` not positive and finite.
    pub fn with_stick_stiffness(self, k_stick: f64) -> Result<Self, Error> {
        Error::check("k_stick", None, k_stick, Domain::Positive)?;
        Ok(Self { k_stick, ..self })
    }

    /// The residuals of JOIN and of REVOLUTE.
    ///
    /// # Errors
    /// A position that is not finite, or so far that the relative position overflows.
    pub fn constraint(&self, pose: &Pose) -> Result<HingeResiduals<f64>, Error> {
        value::<Constraint>(&self.inputs(pose))
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`Hinge::constraint`].
    pub fn constraint_jacobian(&self, pose: &Pose) -> Result<(HingeResiduals<f64>, Jacobian<Constraint, f64>), Error> {
        value_and_jacobian::<Constraint>(&self.inputs(pose))
    }

    fn inputs(&self, pose: &Pose) -> Hinged<f64> {
        let (Pose { triad_a: a, triad_b: b, xa, xb }, Self { c2, c3, .. }) = (*pose, *self);
        let d0 = self.join.initial_position();
        Hinged { e1a: a.e1(), e2a: a.e2(), e3a: a.e3(), e2b: b.e2(), e3b: b.e3(), xa, xb, d0, c2, c3 }
    }

    /// α at the start.
    pub const fn initial_angle(&self) -> f64 {
        self.alpha0
    }

    /// α, with the full rotations that bring it nearest to the angle of the last state: followed so from state to state, b may
    /// rotate as far as it likes, by less than half a turn between two states.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn angle_from(&self, last: f64, pose: &Pose) -> Result<f64, Error> {
        Ok(nearest(value::<Angle>(&across(&pose.triad_a, &pose.triad_b))?.alpha, last))
    }

    /// The rotation about e1a, from the start and from the reference angle, followed from the angle of the last state.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn relative_motion_from(&self, last: f64, pose: &Pose) -> Result<Rotation<f64>, Error> {
        let (alpha, Self { alpha0, theta1_ref, .. }) = (self.angle_from(last, pose)?, *self);
        value::<RelativeMotion>(&TurnSince { alpha, alpha0, theta1_ref })
    }

    /// The angles left to the stops ([`Stop`]), followed from the angle of the last state; `None` without stops.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn gaps_from(&self, last: f64, pose: &Pose) -> Result<Option<AngleGap<f64>>, Error> {
        let Some([theta1_min, theta1_max]) = self.stops else { return Ok(None) };
        let alpha = self.angle_from(last, pose)?;
        value::<Stop>(&StopAngle { alpha, theta1_min, theta1_max }).map(Some)
    }

    /// Moment of the tangential tractions, normal moment and yield function ([`Friction`]) of the friction moment `m1`, the
    /// constraint forces f1, f2, f3 and the constraint moments m2, m3; `None` without friction.
    ///
    /// # Errors
    /// A load that is not finite.
    pub fn friction(&self, m1: f64, forces: [f64; 3], moments: [f64; 2]) -> Result<Option<HingeFriction<f64>>, Error> {
        let Some(Pin { rp, ra, ls, mc_int, mu }) = self.pin else { return Ok(None) };
        let ([f1, f2, f3], [m2, m3]) = (forces, moments);
        value::<Friction>(&HingeLoads { m1, f1, f2, f3, m2, m3, rp, ra, ls, mc_int, mu }).map(Some)
    }

    /// The element that a solver calls: its start, and its friction where μ is not 0.
    pub fn element(&self) -> Parameters<HingeElement, f64, 5> {
        let Self { join, c2, c3, alpha0, pin, k_stick, .. } = *self;
        let contact = pin.filter(|pin| pin.mu > 0.0).map(|Pin { rp, ra, ls, mc_int, mu }| HingeContact {
            k_stick,
            rp,
            ra,
            ls,
            mc_int,
            mu,
        });
        Parameters { start: HingeStart { d0: join.initial_position(), c2, c3, alpha0 }, contact }
    }

    /// What it adds to a step of Newton's method, and the state after it, from the multipliers and the state in the last converged
    /// increment.
    ///
    /// # Errors
    /// As [`Parameters::newton`]; where μ is not 0, a stiffness in stick that was not given.
    pub fn newton(
        &self,
        pose: &Pose,
        multipliers: &SVector<f64, 5>,
        before: &HingeState<f64>,
    ) -> Result<(Contribution<f64, 5>, HingeState<f64>), Error> {
        self.element().newton(&pose.nodes(), multipliers, before)
    }
}

/// The axes between which α is measured.
fn across(a: &Triad, b: &Triad) -> Across<f64> {
    let [e2a, e3a, e3b]: [Vector3<f64>; 3] = [a.e2(), a.e3(), b.e3()];
    Across { e2a, e3a, e3b }
}
