//! Vectors in the plane (r, z), and checks of points there.

use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::number::scalar::{Scalar, norm};
use nalgebra::Vector2;

/// The vector rotated by 90° to the left: the normal of a tangent.
#[inline]
pub(crate) fn left<D: Scalar>(v: Vector2<D>) -> Vector2<D> {
    Vector2::new(-v.y, v.x)
}

/// The length of a vector.
#[inline]
pub(crate) fn length<D: Scalar>(v: Vector2<D>) -> D {
    norm([v.x, v.y])
}

/// Checks that the named points are all distinct.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_point_left_of_the_axis_is_named_and_one_on_it_is_none() {
        let check = |radii: [f64; 2]| {
            let [x1, x2] = radii.map(|r| Vector2::new(r, -2.0));
            check_radii([("x1", x1), ("x2", x2)]).map_err(|error| error.to_string())
        };
        assert_eq!(check([0.0, 0.5]), Ok(()));
        for (radii, named) in [([0.0, -0.5], "x2[0] is -0.5"), ([-0.25, -0.5], "x1[0] is -0.25")] {
            let said = check(radii).unwrap_err();
            assert!(said.starts_with(named), "{said}");
        }
    }

    #[test]
    fn any_two_points_at_one_place_are_noticed() {
        let check = |places: [f64; 3]| {
            let [x1, x2, x3] = places.map(|x| Vector2::new(x, 1.0));
            check_distinct([("x1", x1), ("x2", x2), ("x3", x3)]).is_ok()
        };
        assert!(check([1.0, 2.0, 3.0]));
        assert!(!check([1.0, 1.0, 3.0]) && !check([1.0, 2.0, 1.0]) && !check([1.0, 2.0, 2.0]));
        assert_eq!((left(Vector2::new(1.0, 2.0)), length(Vector2::new(3.0, -4.0))), (Vector2::new(-2.0, 1.0), 5.0));
    }
}
