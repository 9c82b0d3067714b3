//! TRANSLATOR: SLOT and ALIGN together. Node b slides along a line of node a and keeps its orientation to it.
//!
//! The residuals are the two of [`slot`](crate::slot) and the three of [`align`](crate::align); its forces and moments are
//! theirs. What is new is friction: beside the force across the slot, the torque about it and the bending moment
//! press the parts together, each through a lever of its own.
//!
//! [`Translator`] is what a program calls; the formulas behind it stand in the three rooms below.

mod connector;
mod contact;
mod friction;
mod kinematics;

pub use connector::{Gradient, Loads, Pose, Translator};
pub use contact::*;
pub use friction::*;
pub use kinematics::*;
