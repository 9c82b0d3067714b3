//! The TRANSLATOR connector as a program uses it: a [`Slot`] and an [`Align`], with friction of its own.

use super::{AllResiduals, Friction, FrictionLoads, TranslatorContact, TranslatorElement, TranslatorStart};
use crate::connector::align::{Align, Misalignment, Moment};
use crate::connector::slot::{
    self, AlongForce, Displacements, Force, FrictionOutputs, Gaps, Relative, Residuals, Slot, SlotStart, SlotState,
};
use crate::element::cardan::{Angles, Triads};
use crate::element::frame::Triad;
use crate::element::{Contribution, Nodes, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Fields, Jacobian, value, value_and_jacobian};
use nalgebra::{SVector, Vector3};

/// A state of the two nodes: their triads and positions, in the global frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// The triad of node a.
    pub triad_a: Triad,
    /// The triad of node b; that of a if b has none.
    pub triad_b: Triad,
    /// The position of node a.
    pub xa: Vector3<f64>,
    /// The position of node b.
    pub xb: Vector3<f64>,
}

impl Pose {
    /// The part of the state that [`Slot`] uses.
    pub fn slot(&self) -> slot::Pose {
        slot::Pose { triad: self.triad_a, xa: self.xa, xb: self.xb }
    }

    /// The nodes of an element.
    pub fn nodes(&self) -> Nodes<f64> {
        Nodes::new([self.triad_a.into(), self.triad_b.into()], [self.xa, self.xb])
    }
}

/// Forces and moments along and about the axes of a. Those of the constraint act on node b, their opposites on node a; the
/// kinetic force f1 acts on a, its opposite on b.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loads {
    /// Kinetic force along the slot, conjugate to u1.
    pub f1: f64,
    /// Constraint force along the second axis.
    pub f2: f64,
    /// Constraint force along the third axis.
    pub f3: f64,
    /// Constraint moment about the slot.
    pub m1: f64,
    /// Constraint moment about the second axis.
    pub m2: f64,
    /// Constraint moment about the third axis.
    pub m3: f64,
}

/// Derivatives of a residual with respect to the triads and positions of both nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient {
    /// With respect to the vectors of both triads.
    pub triads: Triads<f64>,
    /// With respect to the position of a.
    pub xa: Vector3<f64>,
    /// With respect to the position of b.
    pub xb: Vector3<f64>,
}

/// A TRANSLATOR connector.
///
/// ```
/// use jointproof::connector::translator::{Loads, Pose, Translator};
/// use jointproof::element::frame::Triad;
/// use nalgebra::Vector3;
///
/// let global = Triad::global();
/// let mut pose = Pose { triad_a: global, triad_b: global, xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) };
/// let translator = Translator::new(&pose)?.with_stops(0.0, 4.0)?.with_levers(0.5, 2.0)?.with_friction(0.25, 2.0)?;
///
/// pose.xb.x = 3.5; // b slides along the slot
/// assert_eq!(translator.relative_motion(&pose)?.u1, 2.5);
/// assert_eq!(translator.constraint(&pose)?.ur1, 0.0);
///
/// // |-6|/0.5 + 5 + 2 × 13/2 = 30, and 2 of press fit: 8 can be transmitted
/// let loads = Loads { f1: 8.0, f2: 3.0, f3: 4.0, m1: -6.0, m2: 5.0, m3: -12.0 };
/// assert_eq!(translator.friction(&loads)?.phi, 0.0);
///
/// let error = translator.with_levers(-0.5, 2.0).unwrap_err();
/// assert_eq!(error.to_string(), "rr is -0.5; allowed is a finite number ≥ 0");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Translator {
    slot: Slot,
    align: Align,
    rr: f64,
    l: f64,
    /// 0 if not given.
    k_stick: f64,
    mu: f64,
    fc_int: f64,
}

impl Translator {
    /// A slot along the first axis of a, through the initial position of b, that keeps the initial orientation of b.
    ///
    /// # Errors
    /// As [`Slot::new`] and [`Align::new`].
    pub fn new(initial: &Pose) -> Result<Self, Error> {
        let slot = Slot::new(&initial.slot())?;
        let align = Align::new(&initial.triad_a, &initial.triad_b)?;
        Ok(Self { slot, align, rr: 0.0, l: 0.0, k_stick: 0.0, mu: 0.0, fc_int: 0.0 })
    }

    /// Sets the constitutive reference length; by default it is the initial length.
    ///
    /// # Errors
    /// As [`Slot::with_reference_length`].
    pub fn with_reference_length(self, l1_ref: f64) -> Result<Self, Error> {
        Ok(Self { slot: self.slot.with_reference_length(l1_ref)?, ..self })
    }

    /// Sets the stops, as relative positions along the slot.
    ///
    /// # Errors
    /// As [`Slot::with_stops`].
    pub fn with_stops(self, l1_min: f64, l1_max: f64) -> Result<Self, Error> {
        Ok(Self { slot: self.slot.with_stops(l1_min, l1_max)?, ..self })
    }

    /// Sets the lower stop; the upper one is unchanged.
    ///
    /// # Errors
    /// As [`Slot::with_stops`].
    pub fn with_lower_stop(self, l1_min: f64) -> Result<Self, Error> {
        Ok(Self { slot: self.slot.with_lower_stop(l1_min)?, ..self })
    }

    /// Sets the upper stop; the lower one is unchanged.
    ///
    /// # Errors
    /// As [`Slot::with_stops`].
    pub fn with_upper_stop(self, l1_max: f64) -> Result<Self, Error> {
        Ok(Self { slot: self.slot.with_upper_stop(l1_max)?, ..self })
    }

    /// Sets the friction coefficient μ ≥ 0 and the internal contact force; by default there is no friction.
    ///
    /// # Errors
    /// `mu` negative or not finite, `fc_int` not finite.
    pub fn with_friction(self, mu: f64, fc_int: f64) -> Result<Self, Error> {
        Error::check("mu", None, mu, Domain::NonNegative)?;
        Error::check("fc_int", None, fc_int, Domain::Real)?;
        Ok(Self { mu, fc_int, ..self })
    }

    /// Sets the stiffness in stick, > 0 (F/L), which [`newton`](Self::newton) needs if there is friction.
    ///
    /// # Errors
    /// `k_stick` not positive and finite.
    pub fn with_stick_stiffness(self, k_stick: f64) -> Result<Self, Error> {
        Error::check("k_stick", None, k_stick, Domain::Positive)?;
        Ok(Self { k_stick, ..self })
    }

    /// Sets the levers of the moments in friction: the effective radius for torque, the overlapping length for bending. A lever
    /// of 0, the default, ignores its moment.
    ///
    /// # Errors
    /// `rr` or `l` negative or not finite.
    pub fn with_levers(self, rr: f64, l: f64) -> Result<Self, Error> {
        Error::check("rr", None, rr, Domain::NonNegative)?;
        Error::check("l", None, l, Domain::NonNegative)?;
        Ok(Self { rr, l, ..self })
    }

    /// The SLOT that it contains.
    pub fn slot(&self) -> &Slot {
        &self.slot
    }

    /// The ALIGN that it contains.
    pub fn align(&self) -> &Align {
        &self.align
    }

    /// The deviations of b from the slot and from its initial orientation.
    ///
    /// # Errors
    /// As [`Slot::constraint`] and [`Align::constraint`].
    pub fn constraint(&self, pose: &Pose) -> Result<AllResiduals<f64>, Error> {
        let Residuals { gy, gz } = self.slot.constraint(&pose.slot())?;
        let Misalignment { ur1, ur2, ur3 } = self.align.constraint(&pose.triad_a, &pose.triad_b)?;
        Ok(AllResiduals { gy, gz, ur1, ur2, ur3 })
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`Translator::constraint`].
    pub fn constraint_jacobian(&self, pose: &Pose) -> Result<(AllResiduals<f64>, AllResiduals<Gradient>), Error> {
        let zero = Vector3::zeros();
        let (Residuals { gy, gz }, slot) = self.slot.constraint_jacobian(&pose.slot())?;
        let (Misalignment { ur1, ur2, ur3 }, align) = self.align.constraint_jacobian(&pose.triad_a, &pose.triad_b)?;
        let of_slot = |g: slot::SlotPositions<f64>| Gradient {
            triads: Triads { e2a: g.e2a, e3a: g.e3a, ..Triads::filled(0.0) },
            xa: g.xa,
            xb: g.xb,
        };
        let of_align = |triads| Gradient { triads, xa: zero, xb: zero };
        let gradients = AllResiduals {
            gy: of_slot(slot.gy),
            gz: of_slot(slot.gz),
            ur1: of_align(align.ur1),
            ur2: of_align(align.ur2),
            ur3: of_align(align.ur3),
        };
        Ok((AllResiduals { gy, gz, ur1, ur2, ur3 }, gradients))
    }

    /// The position of b in the triad of a.
    ///
    /// # Errors
    /// As [`Slot::relative_position`].
    pub fn relative_position(&self, pose: &Pose) -> Result<Relative<f64>, Error> {
        self.slot.relative_position(&pose.slot())
    }

    /// Displacement along the slot from the start and from the reference length.
    ///
    /// # Errors
    /// As [`Slot::relative_motion`].
    pub fn relative_motion(&self, pose: &Pose) -> Result<Displacements<f64>, Error> {
        self.slot.relative_motion(&pose.slot())
    }

    /// The distances to the stops, infinite for a missing stop; `None` without stops.
    ///
    /// # Errors
    /// As [`Slot::gaps`].
    pub fn gaps(&self, pose: &Pose) -> Result<Option<Gaps<f64>>, Error> {
        self.slot.gaps(&pose.slot())
    }

    /// The constraint force on b, in the global frame.
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn constraint_force(&self, triad_a: &Triad, loads: &Loads) -> Result<Force<f64>, Error> {
        self.slot.constraint_force(triad_a, loads.f2, loads.f3)
    }

    /// The moment on b that keeps it aligned, in the global frame.
    ///
    /// # Errors
    /// A moment that is not finite.
    pub fn constraint_moment(&self, triad_a: &Triad, loads: &Loads) -> Result<Moment<f64>, Error> {
        self.align.constraint_moment(triad_a, loads.m1, loads.m2, loads.m3)
    }

    /// The force along the slot on a, in the global frame; its opposite acts on b.
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn kinetic_force(&self, triad_a: &Triad, loads: &Loads) -> Result<AlongForce<f64>, Error> {
        self.slot.kinetic_force(triad_a, loads.f1)
    }

    /// Tangential traction, normal force and yield function ([`Friction`]).
    ///
    /// # Errors
    /// A load that is not finite.
    pub fn friction(&self, loads: &Loads) -> Result<FrictionOutputs<f64>, Error> {
        value::<Friction>(&self.friction_inputs(loads))
    }

    /// The friction with its derivatives.
    ///
    /// # Errors
    /// A load that is not finite.
    pub fn friction_jacobian(&self, loads: &Loads) -> Result<(FrictionOutputs<f64>, Jacobian<Friction, f64>), Error> {
        value_and_jacobian::<Friction>(&self.friction_inputs(loads))
    }

    fn friction_inputs(&self, loads: &Loads) -> FrictionLoads<f64> {
        let Loads { f1, f2, f3, m1, m2, m3 } = *loads;
        let Self { rr, l, fc_int, mu, .. } = *self;
        FrictionLoads { f1, f2, f3, m1, m2, m3, rr, l, fc_int, mu }
    }

    /// The element that a solver calls: its start, and its friction if μ is not 0.
    pub fn element(&self) -> Parameters<TranslatorElement, f64, 5> {
        let (SlotStart { x0, y0, z0 }, Self { rr, l, k_stick, fc_int, mu, .. }) = (self.slot.element().start, *self);
        let Angles { alpha: alpha0, beta: beta0, gamma: gamma0 } = self.align.initial();
        Parameters {
            start: TranslatorStart { x0, y0, z0, alpha0, beta0, gamma0 },
            contact: (mu > 0.0).then_some(TranslatorContact { k_stick, rr, l, fc_int, mu }),
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
        multipliers: &SVector<f64, 5>,
        before: &SlotState<f64>,
    ) -> Result<(Contribution<f64, 5>, SlotState<f64>), Error> {
        self.element().newton(&pose.nodes(), multipliers, before)
    }
}
