//! SLOT: node b stays on a line through its initial position along the first axis of node a.
//!
//! The triad of a is e1a, e2a, e3a; the slot runs along e1a at y = y0, z = z0. With d = xb − xa, the relative position
//! is x = e1a·d, y = e2a·d, z = e3a·d. Forces act on node b. In the plane there is no third axis, no z and no f3.
//!
//! [`Slot`] and [`Slot2d`] are what a program calls; the formulas behind them stand in the two rooms
//! below: positions, constraint and forces in one, contact force and friction in the other.

mod connector;
mod friction;
mod kinematics;

pub use connector::{Pose, Pose2d, Slot, Slot2d};
pub use friction::*;
pub use kinematics::*;
