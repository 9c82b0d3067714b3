//! The messages of errors: what was found, and what is allowed instead.

use super::Error;
use std::fmt;

/// The parts of a message.
struct Message {
    found: String,
    /// The text between the two.
    join: &'static str,
    allowed: String,
}

impl Message {
    fn is(found: String, allowed: impl Into<String>) -> Self {
        Self { found, join: "; allowed is ", allowed: allowed.into() }
    }

    fn are(found: String, allowed: impl Into<String>) -> Self {
        Self { found, join: "; allowed are ", allowed: allowed.into() }
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.found, self.join, self.allowed)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message(&by_number).fmt(f)
    }
}

impl std::error::Error for Error {}

fn by_number(node: u32) -> String {
    node.to_string()
}

impl Error {
    /// What was found: the first part of the message.
    ///
    /// ```
    /// let error = jointproof::contact::isl::Interaction::linear(-1.0).unwrap_err();
    /// assert_eq!(error.to_string(), "k is -1.0; allowed is a finite number > 0");
    /// assert_eq!((error.found(), error.allowed()), ("k is -1.0".into(), "a finite number > 0".into()));
    /// ```
    pub fn found(&self) -> String {
        self.message(&by_number).found
    }

    /// The allowed values: the last part of the message.
    pub fn allowed(&self) -> String {
        self.message(&by_number).allowed
    }

    /// The condition on inputs that avoids this error, independent of their values.
    ///
    /// ```
    /// # use jointproof::Error;
    /// let error = Error::check_order(("l1_min", 2.0), ("l1_max", 1.0)).unwrap_err();
    /// assert_eq!(error.required(), "l1_min ≤ l1_max");
    /// ```
    pub fn required(&self) -> String {
        match self {
            Self::NonFinite { name, allowed, .. } | Self::OutOfRange { name, allowed, .. } => {
                format!("{name}: {allowed}")
            }
            Self::TooClose { first, second, least, .. } => format!("{first} and {second} at least {least:e} apart"),
            Self::TooShort { name, least, .. } => format!("a length of {name} of at least {least:e}"),
            Self::GimbalLock { sine, cosine, .. } => format!("{sine} ≠ 0 or {cosine} ≠ 0"),
            Self::UndefinedAngle { vector, axes, .. } => format!("{vector} not perpendicular to all of {axes}"),
            Self::NoArcSine { product, .. } => format!("|{product}| ≤ 1"),
            Self::NoTangent { coordinate, .. } => format!("a curve that moves at {coordinate}"),
            _ => self.allowed(),
        }
    }

    /// Whether both state the same condition on the same inputs, whatever the numbers.
    pub fn is_alike(&self, other: &Self) -> bool {
        self.required() == other.required()
    }

    /// The message, with nodes called by these names instead of their numbers.
    pub fn with_names(&self, name: impl Fn(u32) -> String) -> String {
        self.message(&name).to_string()
    }

    fn message(&self, name_of: &dyn Fn(u32) -> String) -> Message {
        match self {
            Self::NonFinite { name, value, allowed } | Self::OutOfRange { name, value, allowed } => {
                Message::is(format!("{name} is {value:?}"), allowed)
            }
            Self::Unreadable { name, found, allowed } => Message::is(format!("{name} is {found}"), allowed),
            Self::OutOfOrder { lower, lower_value, upper, upper_value } => Message::is(
                format!("{lower} = {lower_value:?} is above {upper} = {upper_value:?}"),
                format!("{lower} ≤ {upper}"),
            ),
            Self::TooClose { first, second, distance, least } => {
                Message::is(format!("{first} and {second} are {distance:?} apart"), format!("a distance ≥ {least:?}"))
            }
            Self::TooShort { name, length, least } => {
                Message::is(format!("{name} has length {length:?}"), format!("a length ≥ {least:?}"))
            }
            Self::Components { found, expected } => {
                Message::are(format!("{found} components"), format!("exactly {expected}"))
            }
            Self::Overflow { name } => Message::are(
                format!("{name} is too large for a double"),
                "results below 1.8e308 (use units in which the inputs are closer to 1)",
            ),
            Self::DerivativeOverflow { name } => Message {
                found: format!("a derivative of {name} is too large for a double"),
                join: "; ",
                allowed: "use units in which the inputs are closer to 1".into(),
            },
            Self::NotUnit { name, length, tolerance } => {
                Message::is(format!("{name} has length {length:?}"), format!("1 within {tolerance:?}"))
            }
            Self::NotPerpendicular { first, second, product, tolerance } => {
                Message::is(format!("{first}·{second} is {product:?}"), format!("0 within {tolerance:?}"))
            }
            Self::LeftHanded { first, second, third } => Message::is(
                format!("{third} points against {first} × {second}"),
                "a right-handed triad (reverse one vector)",
            ),
            Self::Clockwise => {
                Message::is("e2 points to the right of e1".into(), "e1 turned left by 90° (reverse one vector)")
            }
            Self::GimbalLock { angle, sine, cosine } => Message::is(
                format!("{angle} is undefined, since {sine} = 0 and {cosine} = 0 (gimbal lock, beta = ±90°)"),
                "at least one that is not 0",
            ),
            Self::IllConditioned { angle, value, condition, most } => Message::is(
                format!(
                    "{angle} is {value} ({:.3}°), where the angles have the condition number {condition:.3e}",
                    value.to_degrees()
                ),
                format!("a condition number of at most {most}, farther from ±90° (or the residual from the start)"),
            ),
            Self::UndefinedAngle { angle, vector, axes } => Message::is(
                format!("{angle} is undefined, since {vector} is perpendicular to {axes}"),
                "a unit vector and a triad",
            ),
            Self::NoArcSine { product, excess } => Message::is(
                format!("|{product}| is above 1 by {excess:e}"),
                "at most 1 (or use the two-argument angle, which has no such limit)",
            ),
            Self::NoTangent { coordinate, value } => Message::is(
                format!("the curve has no tangent at {coordinate} = {value}"),
                "a midside node short of the quarter point, and no fold",
            ),
            Self::UnknownNode { node } => {
                Message::are(format!("node {} is unknown", name_of(*node)), "nodes with coordinates")
            }
            Self::Node { node, fault, allowed } => Message::are(format!("node {} {fault}", name_of(*node)), *allowed),
            Self::CoincidentNodes { first, second } => Message::are(
                format!("nodes {} and {} coincide", name_of(*first), name_of(*second)),
                "different positions",
            ),
            Self::NodeCount { count, allowed } => Message::is(format!("{count} nodes are given"), *allowed),
            Self::Increment { first, last, increment } => Message::is(
                format!("increment {increment} does not lead from node {first} to node {last}"),
                format!("a divisor of {last} - {first} with its sign"),
            ),
            Self::FoldsBack { node } => {
                Message::is(format!("the slide line turns straight back at node {}", name_of(*node)), "any other angle")
            }
            Self::Element { element, fault, allowed } => Message::are(format!("element {element} {fault}"), *allowed),
            Self::EmptySet { name } => Message::is(format!("the element set {name} is empty"), "at least one element"),
        }
    }
}
