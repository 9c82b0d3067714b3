//! What can be wrong with an input, and what is allowed instead.

mod message;

use crate::formula::quantity::Domain;
use crate::number::scalar::{Scalar, has_length, norm};
use nalgebra::SVector;
use std::fmt;

/// An input was rejected. The message names the input, its value and what is allowed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// An input is NaN or infinite.
    NonFinite {
        /// The input.
        name: Name,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// An input is outside its domain.
    OutOfRange {
        /// The input.
        name: Name,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// A lower bound is above its upper bound.
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
    NotUnit {
        /// The vector.
        name: &'static str,
        /// Its length.
        length: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// Two vectors of a triad are not perpendicular.
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
    LeftHanded {
        /// The first vector.
        first: &'static str,
        /// The second vector.
        second: &'static str,
        /// The third vector.
        third: &'static str,
    },
    /// An input given by name cannot be read.
    Unreadable {
        /// The input.
        name: String,
        /// What was found.
        found: String,
        /// What is allowed.
        allowed: String,
    },
    /// At gimbal lock, β = ±90°, the Cardan angles α and γ rotate about one axis and neither is defined.
    GimbalLock {
        /// The angle.
        angle: &'static str,
        /// The expression proportional to its sine.
        sine: &'static str,
        /// The expression proportional to its cosine.
        cosine: &'static str,
    },
    /// A joint starts with its second Cardan angle so near ±90° that its angular residuals are useless.
    IllConditioned {
        /// The angle.
        angle: &'static str,
        /// Its value.
        value: f64,
        /// The condition number of the derivative of the three angles with respect to a spin of b.
        condition: f64,
        /// The largest allowed condition number.
        most: f64,
    },
    /// An angle is undefined, since a vector is perpendicular to all the axes between which it is measured.
    UndefinedAngle {
        /// The angle.
        angle: &'static str,
        /// The vector.
        vector: &'static str,
        /// The axes.
        axes: &'static str,
    },
    /// A scalar product that must have an arc sine exceeds 1 in magnitude, as rounding alone can cause.
    NoArcSine {
        /// The scalar product.
        product: &'static str,
        /// By how much its magnitude exceeds 1.
        excess: f64,
    },
    /// Two points that must differ coincide, or are so close that the reciprocal of their distance overflows.
    TooClose {
        /// One point.
        first: &'static str,
        /// The other.
        second: &'static str,
        /// Their distance.
        distance: f64,
        /// The least distance allowed.
        least: f64,
    },
    /// A vector that must have a direction is zero, or so short that the reciprocal of its length overflows.
    TooShort {
        /// The vector.
        name: &'static str,
        /// Its length.
        length: f64,
        /// The least length allowed.
        least: f64,
    },
    /// The derivative of a curve vanishes where its tangent is required.
    NoTangent {
        /// The coordinate along the curve.
        coordinate: &'static str,
        /// Its value.
        value: f64,
    },
    /// A node is referred to that has no coordinates.
    UnknownNode {
        /// Its number.
        node: u32,
    },
    /// Something is wrong with a node.
    Node {
        /// Its number.
        node: u32,
        /// What is wrong.
        fault: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Two nodes of a segment or an element coincide.
    CoincidentNodes {
        /// One node.
        first: u32,
        /// The other.
        second: u32,
    },
    /// A slide line has too few nodes, or a parabolic one an even number.
    NodeCount {
        /// The number of nodes.
        count: usize,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Nodes cannot be generated with this increment.
    Increment {
        /// The first node.
        first: u32,
        /// The last node.
        last: u32,
        /// The increment.
        increment: i64,
    },
    /// A slide line turns straight back at a node, so that neither side is the slave's.
    FoldsBack {
        /// The node.
        node: u32,
    },
    /// Something is wrong with an element.
    Element {
        /// Its number.
        element: u32,
        /// What is wrong.
        fault: &'static str,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A set of elements is empty.
    EmptySet {
        /// The name of the set.
        name: String,
    },
    /// A list of components has the wrong length.
    Components {
        /// The number of components given.
        found: usize,
        /// The number of components required.
        expected: usize,
    },
    /// The directions of a triad in the plane are ordered clockwise.
    Clockwise,
    /// The inputs are allowed, but a result is too large for a double.
    Overflow {
        /// The output.
        name: &'static str,
    },
    /// The inputs and the result are allowed, but a derivative is too large for a double.
    DerivativeOverflow {
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
    #[inline]
    pub fn check(field: &'static str, component: Option<usize>, value: f64, domain: Domain) -> Result<(), Self> {
        if value.is_finite() && domain.allows(value) {
            return Ok(());
        }
        Err(Self::not_allowed(Name { field, component }, value, domain))
    }

    #[cold]
    fn not_allowed(name: Name, value: f64, domain: Domain) -> Self {
        let allowed = domain.allowed();
        if value.is_finite() {
            Self::OutOfRange { name, value, allowed }
        } else {
            Self::NonFinite { name, value, allowed }
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
    #[inline]
    pub fn check_order<D: Scalar>(lower: (&'static str, D), upper: (&'static str, D)) -> Result<(), Self> {
        if lower.1 <= upper.1 {
            return Ok(());
        }
        let (lower_value, upper_value) = (lower.1.re(), upper.1.re());
        Err(Self::OutOfOrder { lower: lower.0, lower_value, upper: upper.0, upper_value })
    }

    /// Checks that two points do not coincide.
    ///
    /// # Errors
    /// [`Error::TooClose`].
    #[inline]
    pub fn check_apart<D: Scalar, const N: usize>(
        (first, a): (&'static str, SVector<D, N>),
        (second, b): (&'static str, SVector<D, N>),
    ) -> Result<(), Self> {
        let between = <[D; N]>::from(b - a);
        if has_length(between) {
            return Ok(());
        }
        Err(Self::too_close(first, second, norm(between).re()))
    }

    #[cold]
    fn too_close(first: &'static str, second: &'static str, distance: f64) -> Self {
        Self::TooClose { first, second, distance, least: f64::MIN_POSITIVE }
    }

    /// Checks that a vector has a direction.
    ///
    /// # Errors
    /// [`Error::TooShort`].
    #[inline]
    pub fn check_direction<D: Scalar, const N: usize>(name: &'static str, v: SVector<D, N>) -> Result<(), Self> {
        let v = <[D; N]>::from(v);
        if has_length(v) {
            return Ok(());
        }
        Err(Self::too_short(name, norm(v).re()))
    }

    #[cold]
    fn too_short(name: &'static str, length: f64) -> Self {
        Self::TooShort { name, length, least: f64::MIN_POSITIVE }
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
            Self::Clockwise => "Clockwise",
            Self::Unreadable { .. } => "Unreadable",
            Self::GimbalLock { .. } => "GimbalLock",
            Self::IllConditioned { .. } => "IllConditioned",
            Self::UndefinedAngle { .. } => "UndefinedAngle",
            Self::NoArcSine { .. } => "NoArcSine",
            Self::TooClose { .. } => "TooClose",
            Self::TooShort { .. } => "TooShort",
            Self::NoTangent { .. } => "NoTangent",
            Self::UnknownNode { .. } => "UnknownNode",
            Self::Node { .. } => "Node",
            Self::CoincidentNodes { .. } => "CoincidentNodes",
            Self::NodeCount { .. } => "NodeCount",
            Self::Increment { .. } => "Increment",
            Self::FoldsBack { .. } => "FoldsBack",
            Self::Element { .. } => "Element",
            Self::EmptySet { .. } => "EmptySet",
            Self::Components { .. } => "Components",
            Self::Overflow { .. } => "Overflow",
            Self::DerivativeOverflow { .. } => "DerivativeOverflow",
        }
    }
}
