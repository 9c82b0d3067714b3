//! UJOINT: a universal joint. Node b is held at its place relative to a, and e1a stays across e3b.
//!
//! A cross joins the two nodes: its first axis e1a turns in the yoke of a, its second axis e3b in the yoke of b, so that
//! two rotations are free and four hinges, one at each end of the cross, can rub. The documents' chain from the loads to
//! friction is kept link by link, each its own formula:
//!
//! | room | formulas |
//! |---|---|
//! | kinematics | the constraint, which is JOIN's and UNIVERSAL's, and the stops |
//! | loads | reaction force, direction across the cross, decomposition of the force |
//! | [`arm`] | how slender a cross arm is, and what share of a load that makes a hinge carry |
//! | hinge | forces and moments on the hinges |
//! | contact | contact moments, with their derivative by all 20 inputs |
//! | friction | normal moments and yield functions |
//!
//! [`UJoint`] is what a program calls.

pub mod arm;
mod connector;
mod contact;
mod friction;
mod hinge;
mod kinematics;
mod loads;

pub use crate::translator::{Gradient, Pose};
pub use arm::{Arm, AxialFactors, AxialShares, TwistFactors, TwistShares};
pub use connector::{Cross, Loads, Stops, UJoint};
pub use contact::*;
pub use friction::*;
pub use hinge::*;
pub use kinematics::*;
pub use loads::*;
