//! Slide lines: chains of segments in the plane (r, z), straight or parabolic, whose corners may be smoothed.
//!
//! | | |
//! |---|---|
//! | frames | the plane (r, z), with s = (0, 0, 1) out of it; the tangent t follows the sequence of the nodes, the normal is n = s × t = (−t₂, t₁) |
//! | matrix | the columns t, n rotate (1, 0), (0, 1) to the left by the angle of t: [[t₁, −t₂], [t₂, t₁]] |
//! | position | g ∈ [−1, 1] on a segment, from its first node to its last; t ∈ [0, 1] on a smoothed corner |
//! | zero position | the slave point on the line: E11 = 0; no slip since the start: E12 = 0 |
//! | signs | n points to the side of the slave, so E11 = (xs − X)·n is positive when open; slip is positive where the slave moves along t |
//!
//! One module per topic: the local basis, points of the curves, the closest point, slip, contact area and torque; and the line as
//! defined in a model, [`SlideLine`], with the closest point of the whole line. The elements on it are in
//! [`isl`](crate::contact::isl).

mod area;
mod basis;
mod closest;
mod corners;
pub mod element;
mod line;
mod plane;
mod points;
#[cfg(feature = "verify")]
mod running;
pub(crate) mod shape;
mod slip;
mod torque;

pub use area::{ContactAreaLinear, ContactAreaParabolic, LinearNodes, ParabolicNodes, ThreeAreas, TwoAreas};
pub(crate) use basis::length_and_tangent;
pub use basis::{Basis, Direction, LocalBasis};
pub use closest::{
    ClosestLinear, ClosestParabolic, ClosestSmoothedLinear, ClosestSmoothedParabolic, CornerFoot, LinearCornerSlave,
    LinearSlave, ParabolicCornerSlave, ParabolicSlave, SegmentFoot,
};
pub use corners::{LinearCornerPlace, ParabolicCornerPlace, SmoothedLinearPoint, SmoothedParabolicPoint};
pub use line::{ClosestPoint, Interpolation, Nodes, OverclosureVariation, Place, PlacedLine, SlideLine};
pub(crate) use line::{Foot, check_position, gauss};
pub(crate) use points::check_tangent;
pub use points::{CurvePoint, LinearPlace, LinearPoint, ParabolicPlace, ParabolicPoint};
pub(crate) use shape::Sides;
pub use slip::{LinearMotion, ParabolicMotion, Slip, SlipIncrementLinear, SlipIncrementParabolic};
pub use torque::{LinearPressures, ParabolicPressures, Torque, TorqueLinear, TorqueParabolic};

pub(crate) use plane::{check_distinct, check_radii, left, length};
