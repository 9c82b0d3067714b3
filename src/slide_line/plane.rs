//! Vectors in the plane (r, z), and what is asked of points there.

use crate::error::Error;
use crate::quantity::Domain;
use crate::scalar::{Scalar, norm};
use nalgebra::Vector2;

/// The vector turned left by 90°: the normal of a tangent.
#[inline]
pub(crate) fn left<D: Scalar>(v: Vector2<D>) -> Vector2<D> {
    Vector2::new(-v.y, v.x)
}

/// The length of a vector.
#[inline]
pub(super) fn length<D: Scalar>(v: Vector2<D>) -> D {
    norm([v.x, v.y])
}

/// Checks that the named points are all at different places.
pub(super) fn check_distinct(points: &[(&'static str, Vector2<f64>)]) -> Result<(), Error> {
    let mut pairs = points.iter().enumerate().flat_map(|(k, &a)| points.iter().skip(k + 1).map(move |&b| (a, b)));
    pairs.try_for_each(|(a, b)| Error::check_apart(a, b))
}

/// Checks that the named points are not left of the axis of revolution.
pub(super) fn check_radii(points: &[(&'static str, Vector2<f64>)]) -> Result<(), Error> {
    points.iter().try_for_each(|&(name, x)| Error::check(name, Some(0), x.x, Domain::NonNegative))
}
