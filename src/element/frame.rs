//! Validated triads of nodes: three unit vectors e1, e2, e3, perpendicular to one another and right-handed, e1 × e2 = e3.
//!
//! Their columns form the rotation R that maps the global axes to them; with the identity the triad coincides with the global
//! axes. In the plane e2 is e1 rotated by 90° to the left.

use crate::formula::error::Error;
use crate::number::scalar::norm;
use nalgebra::{SVector, Vector2, Vector3};

/// The tolerance of orthonormality: of lengths from 1 and of scalar products from 0.
pub const TOLERANCE: f64 = 1e-10;

/// A right-handed orthonormal triad in space.
///
/// ```
/// use jointproof::element::frame::Triad;
/// use nalgebra::Vector3;
/// let triad = Triad::new(Vector3::y(), -Vector3::x(), Vector3::z())?;
/// assert_eq!(triad.e1(), Vector3::y());
/// let error = Triad::new(Vector3::x(), Vector3::y(), -Vector3::z()).unwrap_err();
/// assert_eq!(error.to_string(), "e3 points against e1 × e2; allowed is a right-handed triad (reverse one vector)");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triad {
    e1: Vector3<f64>,
    e2: Vector3<f64>,
    e3: Vector3<f64>,
}

impl From<Triad> for [Vector3<f64>; 3] {
    fn from(triad: Triad) -> Self {
        [triad.e1(), triad.e2(), triad.e3()]
    }
}

impl Triad {
    /// The global axes.
    pub fn global() -> Self {
        Self { e1: Vector3::x(), e2: Vector3::y(), e3: Vector3::z() }
    }

    /// The triad of these vectors, given in the global frame.
    ///
    /// # Errors
    /// A component that is not finite, a vector that is not of length 1, two that are not perpendicular (within
    /// [`TOLERANCE`]), or a left-handed triad; the message names the vector.
    pub fn new(e1: Vector3<f64>, e2: Vector3<f64>, e3: Vector3<f64>) -> Result<Self, Error> {
        let named = [("e1", e1), ("e2", e2), ("e3", e3)];
        for (name, e) in named {
            check_unit(name, e)?;
        }
        for (first, second) in [(0, 1), (1, 2), (2, 0)] {
            check_perpendicular(named[first], named[second])?;
        }
        if e1.cross(&e2).dot(&e3) < 0.0 {
            return Err(Error::LeftHanded { first: "e1", second: "e2", third: "e3" });
        }
        Ok(Self { e1, e2, e3 })
    }

    /// The first vector.
    pub fn e1(&self) -> Vector3<f64> {
        self.e1
    }
    /// The second vector.
    pub fn e2(&self) -> Vector3<f64> {
        self.e2
    }
    /// The third vector.
    pub fn e3(&self) -> Vector3<f64> {
        self.e3
    }
}

/// A right-handed orthonormal pair of directions in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneTriad {
    e1: Vector2<f64>,
    e2: Vector2<f64>,
}

impl PlaneTriad {
    /// The global axes.
    pub fn global() -> Self {
        Self { e1: Vector2::x(), e2: Vector2::y() }
    }

    /// The directions, given in the global frame; e2 is e1 rotated by 90° to the left.
    ///
    /// # Errors
    /// As [`Triad::new`].
    pub fn new(e1: Vector2<f64>, e2: Vector2<f64>) -> Result<Self, Error> {
        check_unit("e1", e1)?;
        check_unit("e2", e2)?;
        check_perpendicular(("e1", e1), ("e2", e2))?;
        if e1.perp(&e2) < 0.0 {
            return Err(Error::Clockwise);
        }
        Ok(Self { e1, e2 })
    }

    /// The first direction.
    pub fn e1(&self) -> Vector2<f64> {
        self.e1
    }
    /// The second direction.
    pub fn e2(&self) -> Vector2<f64> {
        self.e2
    }

    /// The triad in space with the plane's normal as third vector.
    pub fn in_space(&self) -> Triad {
        let space = |e: Vector2<f64>| Vector3::new(e.x, e.y, 0.0);
        Triad { e1: space(self.e1), e2: space(self.e2), e3: Vector3::z() }
    }
}

fn check_unit<const N: usize>(name: &'static str, e: SVector<f64, N>) -> Result<(), Error> {
    Error::check_vector(name, e)?;
    let length = norm(<[f64; N]>::from(e));
    if (length - 1.0).abs() <= TOLERANCE {
        return Ok(());
    }
    Err(Error::NotUnit { name, length, tolerance: TOLERANCE })
}

fn check_perpendicular<const N: usize>(
    (first, a): (&'static str, SVector<f64, N>),
    (second, b): (&'static str, SVector<f64, N>),
) -> Result<(), Error> {
    let product = a.dot(&b);
    if product.abs() <= TOLERANCE {
        return Ok(());
    }
    Err(Error::NotPerpendicular { first, second, product, tolerance: TOLERANCE })
}
