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
mod nodes;
mod place;
mod placed;
mod points;
mod shape;
mod slip;
mod torque;
mod tree;

pub use area::*;
pub use basis::*;
pub use closest::*;
pub use corners::*;
pub use line::{Kind, SlideLine};
pub use nodes::Nodes;
pub use place::{ClosestPoint, OverclosureVariation, Place};
pub use placed::PlacedLine;
pub use points::*;
pub use slip::*;
pub use torque::*;

use crate::Scalar;
use crate::error::Error;
use nalgebra::Vector2;

/// The vector turned left by 90°: the normal of a tangent.
#[inline]
pub(crate) fn left<D: Scalar>(v: Vector2<D>) -> Vector2<D> {
    Vector2::new(-v.y, v.x)
}

/// The length of a vector.
#[inline]
fn length<D: Scalar>(v: Vector2<D>) -> D {
    crate::scalar::norm([v.x, v.y])
}

/// Checks that the named points are all at different places.
fn check_distinct(points: &[(&'static str, Vector2<f64>)]) -> Result<(), Error> {
    let mut pairs = points.iter().enumerate().flat_map(|(k, &a)| points.iter().skip(k + 1).map(move |&b| (a, b)));
    pairs.try_for_each(|(a, b)| Error::check_apart(a, b))
}

/// Checks that the named points are not left of the axis of revolution.
fn check_radii(points: &[(&'static str, Vector2<f64>)]) -> Result<(), Error> {
    points.iter().try_for_each(|&(name, x)| Error::check(name, Some(0), x.x, crate::quantity::Domain::NonNegative))
}
