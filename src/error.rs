//! What can be wrong with an input, and what is allowed instead.

use crate::quantity::Domain;
use nalgebra::SVector;
use std::fmt;

/// An input was rejected. The message names the input, its value and what is allowed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An input is NaN or infinite.
    #[error("{name} is {value}; allowed is {allowed}")]
    NonFinite {
        /// The input.
        name: Name,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// An input is outside its domain.
    #[error("{name} is {value}; allowed is {allowed}")]
    OutOfRange {
        /// The input.
        name: Name,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// A lower bound is above its upper bound.
    #[error("{lower} = {lower_value} is above {upper} = {upper_value}; allowed is {lower} ≤ {upper}")]
    OutOfOrder {
        /// The lower bound.
        lower: &'static str,
        /// Its value.
        lower_value: f64,
        /// The upper bound.
        upper: &'static str,
        /// Its value.
        upper_value: f64,
    },
    /// A vector of a triad is not of length 1.
    #[error("{name} has length {length}; allowed is 1 within {tolerance}")]
    NotUnit {
        /// The vector.
        name: &'static str,
        /// Its length.
        length: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// Two vectors of a triad are not perpendicular.
    #[error("{first}·{second} is {product}; allowed is 0 within {tolerance}")]
    NotPerpendicular {
        /// One vector.
        first: &'static str,
        /// The other.
        second: &'static str,
        /// Their scalar product.
        product: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// A triad is left-handed.
    #[error("{third} points against {first} × {second}; allowed is a right-handed triad (reverse one vector)")]
    LeftHanded {
        /// The first vector.
        first: &'static str,
        /// The second vector.
        second: &'static str,
        /// The third vector.
        third: &'static str,
    },
    /// A vector that gives a direction is zero.
    #[error("{name} is the zero vector, which has no direction; allowed is any other vector")]
    ZeroVector {
        /// The vector.
        name: &'static str,
    },
    /// Two points that must differ are at one place.
    #[error("{first} and {second} are at one place; allowed are different places")]
    Coincident {
        /// One point.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// A curve stands still where its tangent is asked for.
    #[error(
        "the curve has no tangent at {coordinate} = {value}: a midside node is at the quarter point, or the curve folds back"
    )]
    NoTangent {
        /// The coordinate along the curve.
        coordinate: &'static str,
        /// Its value.
        value: f64,
    },
    /// A list of components has the wrong length.
    #[error("{found} components were given; allowed are exactly {expected}")]
    Components {
        /// How many were given.
        found: usize,
        /// How many there must be.
        expected: usize,
    },
    /// The inputs are allowed, but a result is too large for a double.
    #[error("{name} is too large for a double; use units in which the inputs are closer to 1")]
    Overflow {
        /// The output.
        name: &'static str,
    },
}

/// An input, or one component of it, counted from 0: `f2`, `e1a[2]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name {
    /// The field.
    pub field: &'static str,
    /// The component of a vector.
    pub component: Option<usize>,
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.component {
            None => f.write_str(self.field),
            Some(component) => write!(f, "{}[{component}]", self.field),
        }
    }
}

impl Error {
    /// Checks one number against its domain.
    ///
    /// # Errors
    /// [`Error::NonFinite`] or [`Error::OutOfRange`].
    pub fn check(field: &'static str, component: Option<usize>, value: f64, domain: Domain) -> Result<(), Self> {
        let name = Name { field, component };
        let allowed = || domain.allowed();
        if !value.is_finite() {
            Err(Self::NonFinite { name, value, allowed: allowed() })
        } else if !domain.allows(value) {
            Err(Self::OutOfRange { name, value, allowed: allowed() })
        } else {
            Ok(())
        }
    }

    /// Checks that every component of a vector is finite.
    ///
    /// # Errors
    /// [`Error::NonFinite`], naming the component.
    pub fn check_vector<const N: usize>(field: &'static str, v: SVector<f64, N>) -> Result<(), Self> {
        v.iter().enumerate().try_for_each(|(k, &x)| Self::check(field, Some(k), x, Domain::Real))
    }

    /// Checks that a lower bound, given with its name, is not above its upper bound.
    ///
    /// # Errors
    /// [`Error::OutOfOrder`].
    pub fn check_order(lower: (&'static str, f64), upper: (&'static str, f64)) -> Result<(), Self> {
        if lower.1 <= upper.1 {
            return Ok(());
        }
        Err(Self::OutOfOrder { lower: lower.0, lower_value: lower.1, upper: upper.0, upper_value: upper.1 })
    }

    /// The variant's name, as golden files give it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NonFinite { .. } => "NonFinite",
            Self::OutOfRange { .. } => "OutOfRange",
            Self::OutOfOrder { .. } => "OutOfOrder",
            Self::NotUnit { .. } => "NotUnit",
            Self::NotPerpendicular { .. } => "NotPerpendicular",
            Self::LeftHanded { .. } => "LeftHanded",
            Self::ZeroVector { .. } => "ZeroVector",
            Self::Coincident { .. } => "Coincident",
            Self::NoTangent { .. } => "NoTangent",
            Self::Components { .. } => "Components",
            Self::Overflow { .. } => "Overflow",
        }
    }
}
