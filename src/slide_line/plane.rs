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
pub(crate) fn length<D: Scalar>(v: Vector2<D>) -> D {
    norm([v.x, v.y])
}

/// Checks that the named points are all at different places.
#[inline]
pub(crate) fn check_distinct<D: Scalar, const N: usize>(points: [(&'static str, Vector2<D>); N]) -> Result<(), Error> {
    for (k, &a) in points.iter().enumerate() {
        for &b in &points[k + 1..] {
            Error::check_apart(a, b)?;
        }
    }
    Ok(())
}

/// Checks that the named points are not left of the axis of revolution.
#[inline]
pub(crate) fn check_radii<D: Scalar, const N: usize>(points: [(&'static str, Vector2<D>); N]) -> Result<(), Error> {
    let left = points.iter().find(|(_, x)| x.x < 0.0);
    left.map_or(Ok(()), |&(name, x)| Error::check(name, Some(0), x.x.re(), Domain::NonNegative))
}
