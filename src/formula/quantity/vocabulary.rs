//! The properties of a quantity: unit, shape, allowed values.

use std::fmt;

/// Powers of length, force, time and temperature; radians and plain numbers have none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Unit {
    /// Power of the unit of length.
    pub length: i32,
    /// Power of the unit of force.
    pub force: i32,
    /// Power of the unit of time.
    pub time: i32,
    /// Power of the unit of temperature.
    pub temperature: i32,
}

impl Unit {
    /// Radians, direction cosines, ratios.
    pub const ONE: Self = Self::new(0, 0, 0);
    /// Length.
    pub const L: Self = Self::new(1, 0, 0);
    /// Force.
    pub const F: Self = Self::new(0, 1, 0);
    /// Moment.
    pub const FL: Self = Self::new(1, 1, 0);

    /// Time.
    pub const T: Self = Self::new(0, 0, 1);
    /// Temperature.
    pub const TEMPERATURE: Self = Self { temperature: 1, ..Self::ONE };

    /// The unit LᵃFᵇTᶜ.
    pub const fn new(length: i32, force: i32, time: i32) -> Self {
        Self { length, force, time, temperature: 0 }
    }

    /// The unit of a product.
    ///
    /// ```
    /// use jointproof::formula::quantity::Unit;
    /// let power = Unit::FL.per(Unit::T);
    /// let conductance = power.per(Unit::L.times(Unit::L).times(Unit::TEMPERATURE));
    /// assert_eq!(conductance.to_string(), "F/LTΘ");
    /// ```
    pub const fn times(self, other: Self) -> Self {
        Self {
            length: self.length + other.length,
            force: self.force + other.force,
            time: self.time + other.time,
            temperature: self.temperature + other.temperature,
        }
    }

    /// The unit of a quotient, as of a Jacobian entry.
    pub const fn per(self, other: Self) -> Self {
        Self {
            length: self.length - other.length,
            force: self.force - other.force,
            time: self.time - other.time,
            temperature: self.temperature - other.temperature,
        }
    }
}

/// `1`, `L`, `F`, `FL`, `F/L^2`, `FT/L^3` …
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let powers = [("F", self.force), ("L", self.length), ("T", self.time), ("Θ", self.temperature)];
        let factor = |sign: i32| {
            let of_sign = powers.iter().filter(move |(_, power)| power * sign > 0);
            of_sign
                .map(|(symbol, power)| match power.abs() {
                    1 => (*symbol).to_string(),
                    power => format!("{symbol}^{power}"),
                })
                .collect::<String>()
        };
        match (factor(1), factor(-1)) {
            (above, below) if below.is_empty() => f.write_str(if above.is_empty() { "1" } else { &above }),
            (above, below) => write!(f, "{}/{below}", if above.is_empty() { "1" } else { &above }),
        }
    }
}

/// How many components a quantity has: a scalar, a column of two or three, or a square matrix of two or three rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// A column of two: (x, y) or (r, z).
    Vec2,
    /// A column of three.
    Vec3,
    /// A 2×2 matrix, row by row.
    Mat2,
    /// A 3×3 matrix, row by row.
    Mat3,
}

impl Shape {
    /// The number of components.
    #[expect(clippy::len_without_is_empty, reason = "a shape is never empty")]
    pub const fn len(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vec2 => 2,
            Self::Vec3 => 3,
            Self::Mat2 => 4,
            Self::Mat3 => 9,
        }
    }

    /// As golden files print it: `[]`, `[2]`, `[3]`, `[2, 2]`, `[3, 3]`.
    pub fn dimensions(self) -> Vec<usize> {
        match self {
            Self::Scalar => Vec::new(),
            Self::Vec2 | Self::Vec3 => vec![self.len()],
            Self::Mat2 => vec![2, 2],
            Self::Mat3 => vec![3, 3],
        }
    }
}

/// A node, identified by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node(pub &'static str);

impl Node {
    /// The first node of a connector, whose triad the connector follows.
    pub const A: Self = Self("a");
    /// The second node of a connector, at which the constraint acts.
    pub const B: Self = Self("b");
}

/// What values a quantity may take, how the sampler draws it, and how it changes when the whole model is moved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Domain {
    /// Any finite number; drawn with either sign and a magnitude from 2⁻¹⁰ to 2¹⁰.
    Real,
    /// A finite number ≥ 0; drawn positive, since 0 is a hard case and not a random one.
    NonNegative,
    /// A finite number > 0.
    Positive,
    /// An angle; any finite number, drawn from (−π, π).
    Angle,
    /// A number strictly between the bounds.
    Between(f64, f64),
    /// A number between the bounds or on them.
    Within(f64, f64),
    /// A number between the bounds or on the lower one.
    HalfOpen(f64, f64),
    /// A point: translates and rotates with the model.
    Point,
    /// A point of an axisymmetric model, (r, z): it moves with the model along the axis.
    Meridian,
    /// A free vector (a displacement, a force), or a matrix that maps one to another: rotates with the model.
    Vector,
    /// A unit vector: rotates with the model.
    Direction,
    /// Unit vector of a triad, by node and axis 1, 2 or 3: rotates with the model. The vectors of one node are drawn
    /// as one rotation, never the identity.
    Triad(Node, usize),
}

impl Domain {
    /// Whether a finite number is in the domain.
    #[inline]
    pub fn allows<T: PartialOrd<f64> + Copy>(self, x: T) -> bool {
        match self {
            Self::NonNegative => x >= 0.0,
            Self::Positive => x > 0.0,
            Self::Between(low, high) => x > low && x < high,
            Self::Within(low, high) => x >= low && x <= high,
            Self::HalfOpen(low, high) => x >= low && x < high,
            _ => true,
        }
    }

    /// The conditions on a number besides being finite: comparisons, as `lower`, with numbers.
    pub fn comparisons(self) -> Vec<(&'static str, f64)> {
        match self {
            Self::NonNegative => vec![(">=", 0.0)],
            Self::Positive => vec![(">", 0.0)],
            Self::Between(low, high) => vec![(">", low), ("<", high)],
            Self::Within(low, high) => vec![(">=", low), ("<=", high)],
            Self::HalfOpen(low, high) => vec![(">=", low), ("<", high)],
            _ => Vec::new(),
        }
    }

    /// Whether a quantity with this domain rotates with the model.
    pub const fn turns(self) -> bool {
        matches!(self, Self::Point | Self::Vector | Self::Direction | Self::Triad(..))
    }

    /// The allowed values in words, for error messages and the book.
    pub fn allowed(self) -> String {
        match self {
            Self::NonNegative => "a finite number ≥ 0".into(),
            Self::Positive => "a finite number > 0".into(),
            Self::Between(low, high) => format!("a number > {low} and < {high}"),
            Self::Within(low, high) => format!("a number ≥ {low} and ≤ {high}"),
            Self::HalfOpen(low, high) => format!("a number ≥ {low} and < {high}"),
            _ => "a finite number".into(),
        }
    }
}

/// A quantity of the documents.
///
/// ```
/// use jointproof::formula::quantity::{Domain, Quantity, Shape, Unit};
/// const PLACE: Quantity =
///     Quantity::new(r"\mathbf{x}", Shape::Vec3, Unit::L, Domain::Point, "where the hub is");
/// const MASS: Quantity = Quantity::scalar("m", Unit::new(-1, 1, 2), Domain::Positive, "mass of the hub");
/// assert_eq!((PLACE.shape.len(), MASS.unit.to_string()), (3, "FT^2/L".into()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Quantity {
    /// Its symbol in LaTeX.
    pub latex: &'static str,
    /// The number of its components.
    pub shape: Shape,
    /// Its unit.
    pub unit: Unit,
    /// Its allowed values.
    pub domain: Domain,
    /// What it is, with frame and sign.
    pub meaning: &'static str,
}

impl Quantity {
    /// A quantity of any shape.
    pub const fn new(latex: &'static str, shape: Shape, unit: Unit, domain: Domain, meaning: &'static str) -> Self {
        Self { latex, shape, unit, domain, meaning }
    }

    /// A number.
    pub const fn scalar(latex: &'static str, unit: Unit, domain: Domain, meaning: &'static str) -> Self {
        Self::new(latex, Shape::Scalar, unit, domain, meaning)
    }
}

#[cfg(test)]
mod tests {
    use super::Domain;

    #[test]
    fn a_domain_is_what_a_component_is_compared_with() {
        assert_eq!(Domain::Real.comparisons(), []);
        assert_eq!([Domain::NonNegative, Domain::Positive].map(Domain::comparisons), [[(">=", 0.0)], [(">", 0.0)]]);
        assert_eq!(Domain::Between(1.0, 2.0).comparisons(), [(">", 1.0), ("<", 2.0)]);
        assert_eq!(Domain::Within(1.0, 2.0).comparisons(), [(">=", 1.0), ("<=", 2.0)]);
        assert_eq!(Domain::HalfOpen(1.0, 2.0).comparisons(), [(">=", 1.0), ("<", 2.0)]);
    }
}
