//! The UJOINT connector as a program uses it: a [`Join`] and a [`Universal`], with stops and friction of its own.

use super::{
    AngleGaps, ContactMomentPair, ContactMoments, Friction, FrictionLoads, JoinForces, JointResiduals, Reaction,
    ReactionForce, Stop, StopAngles, UJointContact, UJointElement, UJointStart, UJointState, YieldPair,
};
use crate::connector::join::{Displaced, Join, Joined};
use crate::connector::slot::Force;
use crate::connector::translator::{Gradient, Pose};
use crate::connector::universal::{FreeMoment, Moment, Rotations, Shafts, Skew, Turns, Universal};
use crate::element::cardan::Triads;
use crate::element::frame::Triad;
use crate::element::{Contribution, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Fields, Jacobian, value, value_and_jacobian};
use nalgebra::{Vector3, Vector4};

/// Forces and moments. Those of the constraint act on node b, their opposites on node a; the kinetic moments m1 and m3 act
/// on a, their opposites on b.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loads {
    /// Constraint force along the first axis of a.
    pub f1: f64,
    /// Constraint force along the second axis of a.
    pub f2: f64,
    /// Constraint force along the third axis of a.
    pub f3: f64,
    /// Kinetic moment about the first axis of a, which is free to rotate: conjugate to ur1.
    pub m1: f64,
    /// Constraint moment about the direction normal to the cross, cos α e2a + sin α e3a.
    pub m2: f64,
    /// Kinetic moment about the third axis of b, which is free to rotate: conjugate to ur3.
    pub m3: f64,
}

/// The least and the greatest value of both free angles; infinite where there is no stop.
///
/// ```
/// use jointproof::connector::ujoint::Stops;
/// let upper = Stops { theta1_max: 2.0, ..Stops::NONE };
/// assert_eq!((upper.theta1_min, upper.theta3_max), (f64::NEG_INFINITY, f64::INFINITY));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stops {
    /// Lower stop of α.
    pub theta1_min: f64,
    /// Upper stop of α.
    pub theta1_max: f64,
    /// Lower stop of γ.
    pub theta3_min: f64,
    /// Upper stop of γ.
    pub theta3_max: f64,
}

impl Stops {
    /// No stop at all.
    pub const NONE: Self = Self {
        theta1_min: f64::NEG_INFINITY,
        theta1_max: f64::INFINITY,
        theta3_min: f64::NEG_INFINITY,
        theta3_max: f64::INFINITY,
    };

    /// The remaining angles to the stops, infinite for a missing stop.
    fn gaps(&self, Turns { alpha, gamma }: Turns<f64>) -> Result<AngleGaps<f64>, Error> {
        let [theta1_min, theta1_max] = both(self.theta1_min, self.theta1_max);
        let [theta3_min, theta3_max] = both(self.theta3_min, self.theta3_max);
        let gaps = value::<Stop>(&StopAngles { alpha, gamma, theta1_min, theta1_max, theta3_min, theta3_max })?;
        let before = |stop: f64, missing: f64, gap: f64| if stop == missing { f64::INFINITY } else { gap };
        Ok(AngleGaps {
            gap1_min: before(self.theta1_min, f64::NEG_INFINITY, gaps.gap1_min),
            gap1_max: before(self.theta1_max, f64::INFINITY, gaps.gap1_max),
            gap3_min: before(self.theta3_min, f64::NEG_INFINITY, gaps.gap3_min),
            gap3_max: before(self.theta3_max, f64::INFINITY, gaps.gap3_max),
        })
    }
}

/// Both stops of an angle, where a missing stop is replaced by the other.
fn both(min: f64, max: f64) -> [f64; 2] {
    match (min == f64::NEG_INFINITY, max == f64::INFINITY) {
        (true, true) => [0.0; 2],
        (true, false) => [max; 2],
        (false, true) => [min; 2],
        (false, false) => [min, max],
    }
}

/// The dimensions of the cross, and the friction of its hinges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cross {
    /// Radius of the pins, > 0.
    pub rp: f64,
    /// Length of an arm from the centre to the pin, > 0.
    pub la: f64,
    /// Lever arm of the friction due to the axial force of a pin; 0 ignores that force.
    pub ra: f64,
    /// Length over which pin and sleeve overlap; 0 ignores the bending moments.
    pub ls: f64,
    /// Friction coefficient, ≥ 0.
    pub mu: f64,
    /// Internal contact moment about the first axis of a, for example of a press fit.
    pub mc1_int: f64,
    /// Internal contact moment about the third axis of b.
    pub mc3_int: f64,
}

impl Cross {
    fn check(&self) -> Result<(), Error> {
        let Self { rp, la, ra, ls, mu, mc1_int, mc3_int } = *self;
        let (positive, not_negative) = (Domain::Positive, Domain::NonNegative);
        Error::check("rp", None, rp, positive)?;
        Error::check("la", None, la, positive)?;
        Error::check("ra", None, ra, not_negative)?;
        Error::check("ls", None, ls, not_negative)?;
        Error::check("mu", None, mu, not_negative)?;
        Error::check("mc1_int", None, mc1_int, Domain::Real)?;
        Error::check("mc3_int", None, mc3_int, Domain::Real)
    }

    fn inputs(&self, a: &Triad, b: &Triad, loads: &Loads) -> FrictionLoads<f64> {
        let Self { rp, la, ra, ls, mu, mc1_int, mc3_int } = *self;
        let Loads { f1, f2, f3, m1, m2, m3 } = *loads;
        let (e1a, e2a, e3a, e3b) = (a.e1(), a.e2(), a.e3(), b.e3());
        FrictionLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, m1, m3, mc1_int, mc3_int, mu }
    }
}

impl UJointContact<f64> {
    /// The friction parameters of the hinges of this cross, with their stiffnesses in stick, in moment per radian.
    pub const fn new(cross: Cross, [k_stick1, k_stick3]: [f64; 2]) -> Self {
        let Cross { rp, la, ra, ls, mu, mc1_int, mc3_int } = cross;
        Self { k_stick1, k_stick3, rp, la, ra, ls, mc1_int, mc3_int, mu }
    }
}

/// A UJOINT connector.
///
/// ```
/// use jointproof::connector::ujoint::{Cross, Loads, Pose, Stops, UJoint};
/// use jointproof::element::frame::Triad;
/// use nalgebra::Vector3;
/// use std::f64::consts::FRAC_PI_2;
///
/// let a = Triad::global();
/// let mut pose = Pose { triad_a: a, triad_b: a, xa: Vector3::zeros(), xb: Vector3::zeros() };
/// let stops = Stops { theta1_min: -2.0, theta1_max: 2.0, theta3_min: -1.0, theta3_max: 1.0 };
/// let cross = Cross { rp: 1.0, la: 2.0, ra: 0.5, ls: 4.0, mu: 0.25, mc1_int: 4.0, mc3_int: 0.0 };
/// let joint = UJoint::new(&pose)?.with_stops(&stops)?.with_friction(&cross)?;
///
/// pose.triad_b = Triad::new(Vector3::x(), Vector3::z(), -Vector3::y())?; // b turns by 90° about e1a, which is free
/// assert_eq!(joint.constraint(&pose)?.g_rot, 0.0);
/// assert_eq!(joint.relative_motion(&pose)?.ur1, FRAC_PI_2);
/// assert_eq!(joint.gaps(&pose)?.unwrap().gap1_max, 2.0 - FRAC_PI_2);
///
/// // Across the cross 16: a quarter on each hinge and 2 × 4/4 from bending make M_C = 6, and M_N = 2 × 6 + 4.
/// let loads = Loads { f3: 16.0, m1: 4.0, ..Loads::default() };
/// assert_eq!(joint.contact_moments(&pose, &loads)?.unwrap().mc1, 6.0);
/// assert_eq!(joint.friction(&pose, &loads)?.unwrap().phi1, 0.0); // |m1| = μ M_N: it slips
///
/// let error = joint.with_friction(&Cross { la: 0.0, ..cross }).unwrap_err();
/// assert_eq!(error.to_string(), "la is 0.0; allowed is a finite number > 0");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UJoint {
    join: Join,
    universal: Universal,
    stops: Option<Stops>,
    cross: Option<Cross>,
    /// 0 if not given.
    k_stick: [f64; 2],
}

impl UJoint {
    /// Keeps b at its initial position and both axes of the cross at their initial angle, normally a right angle.
    ///
    /// # Errors
    /// As [`Join::new`] and [`Universal::new`].
    pub fn new(initial: &Pose) -> Result<Self, Error> {
        let join = Join::new(&initial.slot())?;
        let universal = Universal::new(&initial.triad_a, &initial.triad_b)?;
        Ok(Self { join, universal, stops: None, cross: None, k_stick: [0.0; 2] })
    }

    /// Sets the constitutive reference angles; by default they are the initial ones.
    ///
    /// # Errors
    /// As [`Universal::with_reference_angles`].
    pub fn with_reference_angles(self, theta1_ref: f64, theta3_ref: f64) -> Result<Self, Error> {
        Ok(Self { universal: self.universal.with_reference_angles(theta1_ref, theta3_ref)?, ..self })
    }

    /// Sets the stops of both free angles; by default there are none.
    ///
    /// # Errors
    /// A stop that is not finite, or a lower stop above its upper one.
    pub fn with_stops(self, stops: &Stops) -> Result<Self, Error> {
        stops.gaps(Turns { alpha: 0.0, gamma: 0.0 })?;
        Ok(Self { stops: Some(*stops), ..self })
    }

    /// Sets the cross and its friction; by default there is no friction.
    ///
    /// # Errors
    /// `rp` or `la` not above 0; `ra`, `ls` or `mu` negative; any of them, `mc1_int` or `mc3_int` not finite.
    pub fn with_friction(self, cross: &Cross) -> Result<Self, Error> {
        cross.check()?;
        Ok(Self { cross: Some(*cross), ..self })
    }

    /// Sets the stiffnesses in stick about e1a and about e3b, > 0 (moment per radian), which [`newton`](Self::newton) needs if
    /// there is friction.
    ///
    /// # Errors
    /// A stiffness that is not positive and finite.
    pub fn with_stick_stiffness(self, [k_stick1, k_stick3]: [f64; 2]) -> Result<Self, Error> {
        Error::check("k_stick1", None, k_stick1, Domain::Positive)?;
        Error::check("k_stick3", None, k_stick3, Domain::Positive)?;
        Ok(Self { k_stick: [k_stick1, k_stick3], ..self })
    }

    /// The JOIN that it contains.
    pub const fn join(&self) -> &Join {
        &self.join
    }

    /// The UNIVERSAL that it contains.
    pub const fn universal(&self) -> &Universal {
        &self.universal
    }

    /// The displacement of b from its initial position, and the deviation of the cross from its initial angle.
    ///
    /// # Errors
    /// As [`Join::constraint`] and [`Universal::constraint`].
    pub fn constraint(&self, pose: &Pose) -> Result<JointResiduals<f64>, Error> {
        let Displaced { g } = self.join.constraint(&pose.slot())?;
        let Skew { g: g_rot } = self.universal.constraint(&pose.triad_a, &pose.triad_b)?;
        Ok(JointResiduals { g, g_rot })
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`UJoint::constraint`].
    pub fn constraint_jacobian(&self, pose: &Pose) -> Result<(JointResiduals<f64>, JointResiduals<Gradient>), Error> {
        let (Displaced { g }, by_join) = self.join.constraint_jacobian(&pose.slot())?;
        let (Skew { g: g_rot }, by_universal) = self.universal.constraint_jacobian(&pose.triad_a, &pose.triad_b)?;
        let none = Triads::filled(0.0);
        let of_join = |Joined { e1a, e2a, e3a, xa, xb, .. }: Joined<f64>| Gradient {
            triads: Triads { e1a, e2a, e3a, ..none },
            xa,
            xb,
        };
        let Shafts { e1a, e3b, .. } = by_universal.g;
        let of_universal = Gradient { triads: Triads { e1a, e3b, ..none }, xa: Vector3::zeros(), xb: Vector3::zeros() };
        Ok((JointResiduals { g, g_rot }, JointResiduals { g: by_join.g.map(of_join), g_rot: of_universal }))
    }

    /// The angles about both free axes, continued from those of the last state ([`Universal::turns_from`]).
    ///
    /// # Errors
    /// As [`Universal::turns_from`].
    pub fn turns_from(&self, last: &Turns<f64>, pose: &Pose) -> Result<Turns<f64>, Error> {
        self.universal.turns_from(last, &pose.triad_a, &pose.triad_b)
    }

    /// The rotations about both free axes, continued from the angles of the last state.
    ///
    /// # Errors
    /// As [`Universal::relative_motion_from`].
    pub fn relative_motion_from(&self, last: &Turns<f64>, pose: &Pose) -> Result<Rotations<f64>, Error> {
        self.universal.relative_motion_from(last, &pose.triad_a, &pose.triad_b)
    }

    /// The rotations about both free axes, from the start and from the reference angles, within half a turn of the start.
    ///
    /// # Errors
    /// As [`Universal::relative_motion`].
    pub fn relative_motion(&self, pose: &Pose) -> Result<Rotations<f64>, Error> {
        self.universal.relative_motion(&pose.triad_a, &pose.triad_b)
    }

    /// The remaining angles to the stops ([`Stop`]), within half a turn of the start, infinite for a missing stop; `None` without
    /// stops.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn gaps(&self, pose: &Pose) -> Result<Option<AngleGaps<f64>>, Error> {
        self.gaps_from(&self.universal.initial(), pose)
    }

    /// The remaining angles to the stops, continued from the angles of the last state; `None` without stops.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn gaps_from(&self, last: &Turns<f64>, pose: &Pose) -> Result<Option<AngleGaps<f64>>, Error> {
        let Some(stops) = self.stops else { return Ok(None) };
        let turns = self.turns_from(last, pose)?;
        stops.gaps(turns).map(Some)
    }

    /// The constraint force on b, in the global frame.
    ///
    /// # Errors
    /// As [`Join::constraint_force`].
    pub fn constraint_force(&self, triad_a: &Triad, loads: &Loads) -> Result<Force<f64>, Error> {
        self.join.constraint_force(triad_a, [loads.f1, loads.f2, loads.f3])
    }

    /// The constraint moment on b that acts on the cross, in the global frame: m2 about cos α e2a + sin α e3a.
    ///
    /// It does the work m2 dβ on the second Cardan angle. The residual is a cosine and not an angle, g_rot = sin β − c0, so that
    /// the Jacobian's transpose times m2 is cos β times this moment: the two are equal if the axes of the cross are
    /// perpendicular, β = 0, as in a joint by design.
    ///
    /// # Errors
    /// As [`Universal::constraint_moment`].
    pub fn constraint_moment(&self, pose: &Pose, loads: &Loads) -> Result<Moment<f64>, Error> {
        self.universal.constraint_moment(&pose.triad_a, &pose.triad_b, loads.m2)
    }

    /// The moment about the free axes on a, in the global frame; its opposite acts on b.
    ///
    /// # Errors
    /// As [`Universal::kinetic_moment`].
    pub fn kinetic_moment(&self, pose: &Pose, loads: &Loads) -> Result<FreeMoment<f64>, Error> {
        self.universal.kinetic_moment(&pose.triad_a, &pose.triad_b, loads.m1, loads.m3)
    }

    /// The size of the force that the joint transmits ([`Reaction`]).
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn reaction(&self, loads: &Loads) -> Result<ReactionForce<f64>, Error> {
        let Loads { f1, f2, f3, .. } = *loads;
        value::<Reaction>(&JoinForces { f1, f2, f3 })
    }

    /// The contact moments of the hinges ([`ContactMoments`]); `None` without friction.
    ///
    /// # Errors
    /// A load that is not finite.
    pub fn contact_moments(&self, pose: &Pose, loads: &Loads) -> Result<Option<ContactMomentPair<f64>>, Error> {
        self.friction_inputs(pose, loads).map(|inputs| value::<ContactMoments>(&inputs.joint())).transpose()
    }

    /// The yield functions about both free axes ([`Friction`]); `None` without friction.
    ///
    /// # Errors
    /// A load that is not finite.
    pub fn friction(&self, pose: &Pose, loads: &Loads) -> Result<Option<YieldPair<f64>>, Error> {
        self.friction_inputs(pose, loads).map(|inputs| value::<Friction>(&inputs)).transpose()
    }

    /// The friction with its derivatives.
    ///
    /// # Errors
    /// A load that is not finite.
    #[expect(clippy::type_complexity, reason = "a value and its Jacobian, or none")]
    pub fn friction_jacobian(
        &self,
        pose: &Pose,
        loads: &Loads,
    ) -> Result<Option<(YieldPair<f64>, Jacobian<Friction, f64>)>, Error> {
        self.friction_inputs(pose, loads).map(|inputs| value_and_jacobian::<Friction>(&inputs)).transpose()
    }

    fn friction_inputs(&self, pose: &Pose, loads: &Loads) -> Option<FrictionLoads<f64>> {
        self.cross.map(|cross| cross.inputs(&pose.triad_a, &pose.triad_b, loads))
    }

    /// The element that a solver calls: its start, and its friction if μ is not 0.
    pub fn element(&self) -> Parameters<UJointElement, f64, 4> {
        let Turns { alpha: alpha0, gamma: gamma0 } = self.universal.initial();
        let (d0, c0) = (self.join.initial_position(), self.universal.initial_cosine());
        let rubs = self.cross.filter(|cross| cross.mu > 0.0);
        Parameters {
            start: UJointStart { d0, c0, alpha0, gamma0 },
            contact: rubs.map(|cross| UJointContact::new(cross, self.k_stick)),
        }
    }

    /// The contribution to a step of Newton's method, and the state after it, from the multipliers and the state in the last
    /// converged increment.
    ///
    /// # Errors
    /// As [`Parameters::newton`]; if μ is not 0, also a missing stiffness in stick.
    pub fn newton(
        &self,
        pose: &Pose,
        multipliers: &Vector4<f64>,
        before: &UJointState<f64>,
    ) -> Result<(Contribution<f64, 4>, UJointState<f64>), Error> {
        self.element().newton(&pose.nodes(), multipliers, before)
    }
}
