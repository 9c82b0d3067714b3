//! The forces and moments on the four hinges of the cross, from the loads at its centre.

mod axial;
mod bending;
mod transverse;
mod twist;

pub use axial::{AxialForces, AxialLoads, HingeAxial};
pub use bending::{Bending, BendingLoads, HingeBending};
pub use transverse::{CentreLoads, HingeTransverse, TransverseForces};
pub use twist::{HingeTwist, Twist, TwistLoads};

pub(super) use axial::{Shared, share_of};
pub(super) use bending::{bending, in_sleeve};
pub(super) use transverse::transverse;
