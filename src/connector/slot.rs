//! SLOT: node b stays on a line through its initial position along the first axis of node a.
//!
//! | | |
//! |---|---|
//! | frames | the triad e1a, e2a, e3a of node a, orthonormal and right-handed, which rotates with a; node b has none |
//! | position | d = xb − xa in that triad: x = e1a·d, y = e2a·d, z = e3a·d, that is (x, y, z) = Rᵀ d |
//! | matrix | R has the columns e1a, e2a, e3a: `R[i][j]` is the i-th global component of e_(j+1)a |
//! | zero position | the initial position: x = x0, y = y0, z = z0 and u1 = 0, for any rotation of a |
//! | signs | u1 = x − x0 is positive where b has moved along e1a; f2 e2a + f3 e3a acts on b and its opposite on a; f1 is conjugate to u1, so that f1 e1a acts on a and its opposite on b; rotations are positive by the right-hand rule |
//!
//! In the plane there is no third axis, no z and no f3.
//!
//! [`Slot`] and [`Slot2d`] are what a program calls. Their formulas are in two modules: positions, constraint and forces in one,
//! contact force and friction in the other.

mod connector;
pub(crate) mod element;
mod element_plane;
mod friction;
mod kinematics;
pub mod plane;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use crate::element::line::Positions;
pub use connector::{Pose, Pose2d, Slot, Slot2d};
pub use element::{SlotContact, SlotElement, SlotStart, SlotState};
pub use element_plane::{SlotElement2d, SlotStart2d};
pub use friction::{
    Contact, ContactForce, ContactForces, CrossForces, Friction, FrictionOutputs, Normal, NormalForce, SlotLoads,
};
pub use kinematics::{
    AlongForce, Constraint, Constraint2d, ConstraintForce, CrossFrame, Displacements, Force, Gaps, KineticForce,
    Relative, RelativeMotion, RelativePosition, Residual2d, Residuals, SlotForce, SlotLengths, SlotPositions,
    SlotPositions2d, Stop, StopLengths,
};
