//! UJOINT: a universal joint. Node b is held at its initial position relative to a, and e1a stays perpendicular to e3b.
//!
//! | | |
//! |---|---|
//! | frames | the triads of both nodes; the axes of the cross are e1a, in the yoke of a, and e3b, in the yoke of b; normal to both is e_cross = e1a × e3b |
//! | matrix | `R_ij = e_ia·e_jb` = R1(α) R2(β) R3(γ), written out in [`cardan`](crate::element::cardan); sin β = e1a·e3b stays 0 |
//! | zero position | both triads equal: α = γ = 0, the shafts in line; then e_cross = −e2a |
//! | signs | those of [`join`](crate::connector::join) and [`universal`](crate::connector::universal): α about e1a and γ about e3b by the right-hand rule; f1, f2, f3 along a's triad and m2 about the line of nodes act on b and their opposites on a; m1 e1a + m3 e3b acts on a and its opposite on b |
//!
//! Two rotations are free, and the four hinges, one at each end of the cross, can have friction. The documents' chain from the
//! loads to friction is kept link by link, each with its own formula:
//!
//! | module | formulas |
//! |---|---|
//! | kinematics | the constraint, from JOIN and UNIVERSAL, and the stops |
//! | loads | reaction force, direction normal to the cross |
//! | decomposition | the force along the axes of the cross and normal to them |
//! | [`arm`] | the slenderness of a cross arm, and the share of a load that a hinge carries because of it |
//! | hinge | forces and moments on the hinges |
//! | contact | contact moments, with their derivatives with respect to all 20 inputs |
//! | normal, friction | normal moments and yield functions |
//!
//! [`UJoint`] is what a program calls.

pub mod arm;
mod connector;
pub(crate) mod contact;
mod decomposition;
mod element;
mod friction;
mod hinge;
mod kinematics;
mod loads;
mod normal;
#[cfg(feature = "verify")]
mod running;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use crate::connector::translator::{Gradient, Pose};
pub use crate::element::cross::CrossAxes;
pub use arm::{Arm, AxialFactors, AxialShares, TwistFactors, TwistShares};
pub use connector::{Cross, Loads, Stops, UJoint};
pub use contact::{ContactMomentPair, ContactMoments, JointLoads};
pub use decomposition::{CrossForces, CrossLoads, Decomposition};
pub use element::{UJointContact, UJointElement, UJointStart, UJointState};
pub use friction::{Friction, FrictionLoads, YieldPair};
pub use hinge::{
    AxialForces, AxialLoads, Bending, BendingLoads, CentreLoads, HingeAxial, HingeBending, HingeTransverse, HingeTwist,
    TransverseForces, Twist, TwistLoads,
};
pub use kinematics::{AngleGaps, Constraint, JointResiduals, Jointed, Stop, StopAngles};
pub use loads::{CrossDirection, CrossNormal, JoinForces, Reaction, ReactionForce};
pub use normal::{AllContactMoments, NormalMomentPair, NormalMoments};
