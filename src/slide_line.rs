//! Slide lines, and the axisymmetric elements that slide on them.
//!
//! A slide line is a chain of segments in the plane (r, z), straight or parabolic, whose corners may be smoothed. Its
//! tangent t follows the sequence of its nodes and its normal n = s × t = (−t₂, t₁), with s = (0, 0, 1), points to the
//! side of the slave. A slave point has a nearest place on the line, at the coordinate g ∈ [−1, 1] of a segment or
//! t ∈ [0, 1] of a smoothed corner, and from it the separation E11 = (xs − X)·n, positive when open.
//!
//! One room per topic: the local basis, points of the curves, the closest point, slip, contact area and torque; and the
//! line as a model states it, [`SlideLine`], with the closest point of the whole of it. The elements on it are in
//! [`isl`](crate::isl).

mod area;
mod basis;
mod closest;
mod corners;
mod line;
mod plane;
mod points;
mod shape;
mod slip;
mod torque;

pub use area::{ContactAreaLinear, ContactAreaParabolic, LinearNodes, ParabolicNodes, ThreeAreas, TwoAreas};
pub use basis::{Basis, Direction, LocalBasis};
pub use closest::{
    ClosestLinear, ClosestParabolic, ClosestSmoothedLinear, ClosestSmoothedParabolic, CornerFoot, LinearCornerSlave,
    LinearSlave, ParabolicCornerSlave, ParabolicSlave, SegmentFoot,
};
pub use corners::{LinearCornerPlace, ParabolicCornerPlace, SmoothedLinearPoint, SmoothedParabolicPoint};
pub(crate) use line::check_position;
pub use line::{ClosestPoint, Interpolation, Nodes, OverclosureVariation, Place, PlacedLine, SlideLine};
pub use points::{CurvePoint, LinearPlace, LinearPoint, ParabolicPlace, ParabolicPoint};
pub use slip::{LinearMotion, ParabolicMotion, Slip, SlipIncrementLinear, SlipIncrementParabolic};
pub use torque::{LinearPressures, ParabolicPressures, Torque, TorqueLinear, TorqueParabolic};

use plane::{check_distinct, check_radii, left, length};
