//! The SLOT connector as a program uses it: validated once, then evaluated by the formulas.

use super::plane::PlanePlaces;
use super::{
    AlongForce, Constraint, Constraint2d, ConstraintForce, CrossFrame, Displacements, Force, Friction, FrictionOutputs,
    Gaps, KineticForce, Positions, Relative, RelativeMotion, RelativePosition, Residual2d, Residuals, SlotContact,
    SlotElement, SlotElement2d, SlotForce, SlotLengths, SlotLoads, SlotPositions, SlotPositions2d, SlotStart,
    SlotStart2d, SlotState, Stop, StopLengths,
};
use crate::element::frame::{PlaneTriad, Triad};
use crate::element::{Contribution, Nodes, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Jacobian, value, value_and_jacobian};
use nalgebra::{Vector1, Vector2, Vector3};

/// A state of the two nodes: the triad of a, and the positions of both, in the global frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// The triad of node a.
    pub triad: Triad,
    /// The position of node a.
    pub xa: Vector3<f64>,
    /// The position of node b.
    pub xb: Vector3<f64>,
}

/// A state of the two nodes in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose2d {
    /// The axes of node a.
    pub triad: PlaneTriad,
    /// The position of node a.
    pub xa: Vector2<f64>,
    /// The position of node b.
    pub xb: Vector2<f64>,
}

/// The options along the slot, which do not depend on the number of dimensions: lengths, stops, friction.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Line {
    x0: f64,
    l1_ref: f64,
    /// The lower stop and the upper one.
    stops: [Option<f64>; 2],
    /// 0 if not given.
    k_stick: f64,
    mu: f64,
    fc_int: f64,
}

impl Line {
    fn new(x0: f64) -> Self {
        Self { x0, l1_ref: x0, stops: [None; 2], k_stick: 0.0, mu: 0.0, fc_int: 0.0 }
    }

    fn reference_length(&mut self, l1_ref: f64) -> Result<(), Error> {
        Error::check("l1_ref", None, l1_ref, Domain::Real)?;
        self.l1_ref = l1_ref;
        Ok(())
    }

    fn stops(&mut self, stops: [Option<f64>; 2]) -> Result<(), Error> {
        gaps(0.0, stops)?;
        self.stops = stops;
        Ok(())
    }

    fn friction(&mut self, mu: f64, fc_int: f64) -> Result<(), Error> {
        Error::check("mu", None, mu, Domain::NonNegative)?;
        Error::check("fc_int", None, fc_int, Domain::Real)?;
        (self.mu, self.fc_int) = (mu, fc_int);
        Ok(())
    }

    fn stick_stiffness(&mut self, k_stick: f64) -> Result<(), Error> {
        Error::check("k_stick", None, k_stick, Domain::Positive)?;
        self.k_stick = k_stick;
        Ok(())
    }

    fn contact(&self) -> Option<SlotContact<f64>> {
        let Self { k_stick, fc_int, mu, .. } = *self;
        (mu > 0.0).then_some(SlotContact { k_stick, fc_int, mu })
    }

    fn motion(&self, x: f64) -> Result<Displacements<f64>, Error> {
        value::<RelativeMotion>(&SlotLengths { x, x0: self.x0, l1_ref: self.l1_ref })
    }

    fn gaps(&self, x: f64) -> Result<Option<Gaps<f64>>, Error> {
        gaps(x, self.stops)
    }

    fn loads(&self, f1: f64, f2: f64, f3: f64) -> SlotLoads<f64> {
        SlotLoads { f1, f2, f3, fc_int: self.fc_int, mu: self.mu }
    }
}

/// The distances to the stops; infinity for a missing stop.
fn gaps(x: f64, stops: [Option<f64>; 2]) -> Result<Option<Gaps<f64>>, Error> {
    let both = |l1_min, l1_max| value::<Stop>(&StopLengths { x, l1_min, l1_max });
    Ok(Some(match stops {
        [None, None] => return Ok(None),
        [Some(l1_min), Some(l1_max)] => both(l1_min, l1_max)?,
        [Some(l1_min), None] => Gaps { gap_max: f64::INFINITY, ..both(l1_min, l1_min)? },
        [None, Some(l1_max)] => Gaps { gap_min: f64::INFINITY, ..both(l1_max, l1_max)? },
    }))
}

/// Options common to [`Slot`] and [`Slot2d`], each checked when it is set.
macro_rules! line_options {
    () => {
        /// Sets the constitutive reference length; by default it is the initial length.
        ///
        /// # Errors
        /// `l1_ref` that is not finite.
        pub fn with_reference_length(mut self, l1_ref: f64) -> Result<Self, Error> {
            self.line.reference_length(l1_ref)?;
            Ok(self)
        }

        /// Sets the stops, as relative positions along the slot.
        ///
        /// # Errors
        /// A stop that is not finite, or `l1_min > l1_max`.
        pub fn with_stops(mut self, l1_min: f64, l1_max: f64) -> Result<Self, Error> {
            self.line.stops([Some(l1_min), Some(l1_max)])?;
            Ok(self)
        }

        /// Sets the lower stop; the upper one is unchanged.
        ///
        /// # Errors
        /// As [`Self::with_stops`].
        pub fn with_lower_stop(mut self, l1_min: f64) -> Result<Self, Error> {
            self.line.stops([Some(l1_min), self.line.stops[1]])?;
            Ok(self)
        }

        /// Sets the upper stop; the lower one is unchanged.
        ///
        /// # Errors
        /// As [`Self::with_stops`].
        pub fn with_upper_stop(mut self, l1_max: f64) -> Result<Self, Error> {
            self.line.stops([self.line.stops[0], Some(l1_max)])?;
            Ok(self)
        }

        /// Sets the friction coefficient μ ≥ 0 and the internal contact force; by default there is no friction.
        ///
        /// # Errors
        /// `mu` negative or not finite, `fc_int` not finite.
        pub fn with_friction(mut self, mu: f64, fc_int: f64) -> Result<Self, Error> {
            self.line.friction(mu, fc_int)?;
            Ok(self)
        }

        /// Sets the stiffness in stick, > 0 (F/L), which [`newton`](Self::newton) needs if there is friction.
        ///
        /// # Errors
        /// `k_stick` not positive and finite.
        pub fn with_stick_stiffness(mut self, k_stick: f64) -> Result<Self, Error> {
            self.line.stick_stiffness(k_stick)?;
            Ok(self)
        }
    };
}

/// A SLOT connector in space.
///
/// ```
/// use jointproof::connector::slot::{Pose, Slot, SlotState};
/// use jointproof::element::frame::Triad;
/// use nalgebra::{Vector2, Vector3};
///
/// let mut pose = Pose { triad: Triad::global(), xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) };
/// let slot = Slot::new(&pose)?.with_stops(0.0, 4.0)?.with_friction(0.25, 1.0)?;
///
/// pose.xb.x = 3.5; // b slides along the slot
/// assert_eq!(slot.constraint(&pose)?.gy, 0.0);
/// assert_eq!(slot.relative_motion(&pose)?.u1, 2.5);
/// assert_eq!(slot.gaps(&pose)?.unwrap().gap_max, 0.5);
/// assert_eq!(slot.friction(-2.0, 3.0, 4.0)?.phi, 0.5);
///
/// // What a solver adds: it has moved by 2.5 at once, and slips under (5 + 1)/4.
/// let slot = slot.with_stick_stiffness(100.0)?;
/// let (step, after) = slot.newton(&pose, &Vector2::new(3.0, 4.0), &SlotState { u1: 0.0, f1: 0.0 })?;
/// assert_eq!((step.forces[6], after.f1), (-1.5, 1.5));
///
/// let error = slot.with_stops(4.0, 0.0).unwrap_err();
/// assert_eq!(error.to_string(), "l1_min = 4.0 is above l1_max = 0.0; allowed is l1_min ≤ l1_max");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slot {
    y0: f64,
    z0: f64,
    line: Line,
}

impl Slot {
    /// A slot along the first axis of a, through the initial position of b.
    ///
    /// # Errors
    /// A position that is not finite, or so large that the relative position overflows.
    pub fn new(initial: &Pose) -> Result<Self, Error> {
        let Relative { x, y, z } = relative_position(initial)?;
        Ok(Self { y0: y, z0: z, line: Line::new(x) })
    }

    line_options!();

    /// The position of b in the triad of a ([`RelativePosition`]).
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn relative_position(&self, pose: &Pose) -> Result<Relative<f64>, Error> {
        relative_position(pose)
    }

    /// The deviation of b from the slot ([`Constraint`]).
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn constraint(&self, pose: &Pose) -> Result<Residuals<f64>, Error> {
        value::<Constraint>(&self.constraint_inputs(pose))
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn constraint_jacobian(&self, pose: &Pose) -> Result<(Residuals<f64>, Jacobian<Constraint, f64>), Error> {
        value_and_jacobian::<Constraint>(&self.constraint_inputs(pose))
    }

    fn constraint_inputs(&self, pose: &Pose) -> SlotPositions<f64> {
        let Pose { triad, xa, xb } = *pose;
        SlotPositions { e2a: triad.e2(), e3a: triad.e3(), xa, xb, y0: self.y0, z0: self.z0 }
    }

    /// Displacement along the slot from the start and from the reference length ([`RelativeMotion`]).
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn relative_motion(&self, pose: &Pose) -> Result<Displacements<f64>, Error> {
        self.line.motion(relative_position(pose)?.x)
    }

    /// The distances to the stops ([`Stop`]), infinite for a missing stop; `None` without stops.
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn gaps(&self, pose: &Pose) -> Result<Option<Gaps<f64>>, Error> {
        self.line.gaps(relative_position(pose)?.x)
    }

    /// The constraint force on b ([`ConstraintForce`]), in the global frame; its opposite acts on a.
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn constraint_force(&self, triad: &Triad, f2: f64, f3: f64) -> Result<Force<f64>, Error> {
        value::<ConstraintForce>(&CrossFrame { e2a: triad.e2(), e3a: triad.e3(), f2, f3 })
    }

    /// The force along the slot on a ([`KineticForce`]), in the global frame; its opposite acts on b.
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn kinetic_force(&self, triad: &Triad, f1: f64) -> Result<AlongForce<f64>, Error> {
        value::<KineticForce>(&SlotForce { e1a: triad.e1(), f1 })
    }

    /// Tangential traction, normal force and yield function ([`Friction`]); f1 is the friction force.
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn friction(&self, f1: f64, f2: f64, f3: f64) -> Result<FrictionOutputs<f64>, Error> {
        value::<Friction>(&self.line.loads(f1, f2, f3))
    }

    /// The friction with its derivatives.
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn friction_jacobian(
        &self,
        f1: f64,
        f2: f64,
        f3: f64,
    ) -> Result<(FrictionOutputs<f64>, Jacobian<Friction, f64>), Error> {
        value_and_jacobian::<Friction>(&self.line.loads(f1, f2, f3))
    }

    /// The element that a solver calls: its start, and its friction if μ is not 0.
    pub fn element(&self) -> Parameters<SlotElement, f64, 2> {
        let start = SlotStart { x0: self.line.x0, y0: self.y0, z0: self.z0 };
        Parameters { start, contact: self.line.contact() }
    }

    /// The contribution to a step of Newton's method, and the state after it, from the multipliers and the state in the last
    /// converged increment.
    ///
    /// # Errors
    /// As [`Parameters::newton`]; if μ is not 0, also a missing stiffness in stick.
    pub fn newton(
        &self,
        pose: &Pose,
        multipliers: &Vector2<f64>,
        before: &SlotState<f64>,
    ) -> Result<(Contribution<f64, 2>, SlotState<f64>), Error> {
        self.element().newton(&pose.nodes(), multipliers, before)
    }
}

fn relative_position(pose: &Pose) -> Result<Relative<f64>, Error> {
    let Pose { triad, xa, xb } = *pose;
    value::<RelativePosition>(&Positions { e1a: triad.e1(), e2a: triad.e2(), e3a: triad.e3(), xa, xb })
}

/// A SLOT connector in the plane: no third axis, no z and no f3.
///
/// ```
/// use jointproof::connector::slot::{Pose2d, Slot2d};
/// use jointproof::element::frame::PlaneTriad;
/// use nalgebra::Vector2;
///
/// let mut pose = Pose2d { triad: PlaneTriad::global(), xa: Vector2::zeros(), xb: Vector2::new(1.0, 2.0) };
/// let slot = Slot2d::new(&pose)?.with_friction(0.5, 0.0)?;
/// pose.xb = Vector2::new(4.0, 2.25);
/// assert_eq!(slot.constraint(&pose)?.gy, 0.25);
/// assert_eq!(slot.friction(1.0, -2.0)?.phi, 0.0);
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slot2d {
    y0: f64,
    line: Line,
}

impl Slot2d {
    /// A slot along the first axis of a, through the initial position of b.
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn new(initial: &Pose2d) -> Result<Self, Error> {
        let slot = Slot::new(&initial.in_space())?;
        Ok(Self { y0: slot.y0, line: slot.line })
    }

    line_options!();

    /// The deviation of b from the slot ([`Constraint2d`]).
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn constraint(&self, pose: &Pose2d) -> Result<Residual2d<f64>, Error> {
        value::<Constraint2d>(&self.constraint_inputs(pose))
    }

    /// The constraint with its derivatives.
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn constraint_jacobian(&self, pose: &Pose2d) -> Result<(Residual2d<f64>, Jacobian<Constraint2d, f64>), Error> {
        value_and_jacobian::<Constraint2d>(&self.constraint_inputs(pose))
    }

    fn constraint_inputs(&self, pose: &Pose2d) -> SlotPositions2d<f64> {
        let Pose2d { triad, xa, xb } = *pose;
        SlotPositions2d { e2a: triad.e2(), xa, xb, y0: self.y0 }
    }

    /// Displacement along the slot from the start and from the reference length ([`RelativeMotion`]).
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn relative_motion(&self, pose: &Pose2d) -> Result<Displacements<f64>, Error> {
        self.line.motion(relative_position(&pose.in_space())?.x)
    }

    /// The distances to the stops ([`Stop`]), infinite for a missing stop; `None` without stops.
    ///
    /// # Errors
    /// As [`Slot::new`].
    pub fn gaps(&self, pose: &Pose2d) -> Result<Option<Gaps<f64>>, Error> {
        self.line.gaps(relative_position(&pose.in_space())?.x)
    }

    /// Tangential traction, normal force and yield function ([`Friction`] with f3 = 0).
    ///
    /// # Errors
    /// A force that is not finite.
    pub fn friction(&self, f1: f64, f2: f64) -> Result<FrictionOutputs<f64>, Error> {
        value::<Friction>(&self.line.loads(f1, f2, 0.0))
    }

    /// The element that a solver calls: its start, and its friction if μ is not 0.
    pub fn element(&self) -> Parameters<SlotElement2d, f64, 1, 6> {
        let start = SlotStart2d { x0: self.line.x0, y0: self.y0 };
        Parameters { start, contact: self.line.contact() }
    }

    /// The contribution to a step of Newton's method, and the state after it, from the multipliers and the state in the last
    /// converged increment.
    ///
    /// # Errors
    /// As [`Parameters::newton`]; if μ is not 0, also a missing stiffness in stick.
    pub fn newton(
        &self,
        pose: &Pose2d,
        multipliers: &Vector1<f64>,
        before: &SlotState<f64>,
    ) -> Result<(Contribution<f64, 1, 6>, SlotState<f64>), Error> {
        self.element().newton(&pose.nodes(), multipliers, before)
    }
}

impl Pose {
    /// The nodes of an element; the triad of b is irrelevant.
    pub fn nodes(&self) -> Nodes<f64> {
        Nodes::new([self.triad.into(); 2], [self.xa, self.xb])
    }
}

impl Pose2d {
    /// The nodes of an element.
    pub fn nodes(&self) -> PlanePlaces<f64> {
        PlanePlaces { e2a: self.triad.e2(), xa: self.xa, xb: self.xb }
    }

    /// The same state in the plane z = 0 of space.
    fn in_space(&self) -> Pose {
        let space = |v: Vector2<f64>| Vector3::new(v.x, v.y, 0.0);
        Pose { triad: self.triad.in_space(), xa: space(self.xa), xb: space(self.xb) }
    }
}
