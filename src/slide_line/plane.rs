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
#[inline]
pub(super) fn check_distinct<const N: usize>(points: [(&'static str, Vector2<f64>); N]) -> Result<(), Error> {
    for (k, &a) in points.iter().enumerate() {
        for &b in &points[k + 1..] {
            Error::check_apart(a, b)?;
        }
    }
    Ok(())
}

/// Checks that the named points are not left of the axis of revolution.
#[inline]
pub(super) fn check_radii<const N: usize>(points: [(&'static str, Vector2<f64>); N]) -> Result<(), Error> {
    points.iter().try_for_each(|&(name, x)| Error::check(name, Some(0), x.x, Domain::NonNegative))
}
