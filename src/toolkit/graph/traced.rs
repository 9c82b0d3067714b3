//! A number that records the operations on it.

use super::node::{self, Binary, Node, Op, Relation, Unary};
use super::recorder::{Escape, Extremes, ask, constant, decide, enter, escape, extremes, sides};
use crate::number::newtype::{newtype_dual_num, newtype_number};
use crate::number::scalar::{Leaf, Scalar, Search, choice, direction_of_length, divide, e_minus_one, itself, norm, pi};
use num_traits::FromPrimitive;
use std::cmp::Ordering;
use std::fmt;
use std::num::ParseFloatError;
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};
use std::str::FromStr;

/// A number of which only the index in the graph is known; it is valid while [`record`](super::record) runs.
///
/// Its comparisons take every possible outcome, one after the other.
#[derive(Clone, Copy)]
pub struct Traced(Place);

impl Traced {
    pub(super) fn input(k: usize) -> Self {
        Self(Place::entered(Op::Input(k)))
    }

    pub(super) fn at(node: Node) -> Self {
        Self(Place::Node(node))
    }

    pub(super) fn node(self) -> Node {
        self.0.node()
    }

    /// The value of a constant; nothing else has a value, and a run that requests one cannot be recorded.
    pub(crate) fn to_f64(self) -> f64 {
        constant(self.node()).unwrap_or_else(ask)
    }
}

/// The index or constant, with the operations that the inner numbers of other scalars have.
#[derive(Clone, Copy)]
enum Place {
    Node(Node),
    /// A constant, which is added to the graph when it is used: some exist before recording starts.
    Number(f64),
}

impl Place {
    fn entered(op: Op) -> Self {
        Self::Node(enter(op))
    }
    fn node(self) -> Node {
        match self {
            Self::Node(node) => node,
            Self::Number(x) => enter(Op::Number(x.to_bits())),
        }
    }
    fn unary(self, function: Unary) -> Self {
        Self::entered(Op::Unary(function, self.node()))
    }
    fn binary(self, operation: Binary, other: Self) -> Self {
        Self::entered(Op::Binary(operation, self.node(), other.node()))
    }
    fn abs(self) -> Self {
        self.unary(Unary::Absolute)
    }
}

/// Methods that formulas never call but the macros of scalars name.
#[expect(clippy::unused_self, reason = "the macros of scalars name them as methods")]
impl Place {
    fn signum(self) -> Self {
        escape(Escape::Function("signum"))
    }
    fn is_sign_positive(self) -> bool {
        escape(Escape::Function("is_sign_positive"))
    }
    fn is_sign_negative(self) -> bool {
        escape(Escape::Function("is_sign_negative"))
    }
    fn remainder(self, _: Self) -> Self {
        escape(Escape::Function("%"))
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $operation:ident),*) => {
        $(impl $trait for Place {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.binary(Binary::$operation, other)
            }
        })*
    };
}
operators!(Add add Add, Sub sub Subtract, Mul mul Multiply, Div div Divide);

impl Neg for Place {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Unary::Negative)
    }
}

impl Rem for Place {
    type Output = Self;
    fn rem(self, other: Self) -> Self {
        self.remainder(other)
    }
}

impl PartialEq for Place {
    fn eq(&self, other: &Self) -> bool {
        decide(Relation::Equal, self.node(), other.node())
    }
}

impl PartialEq for Traced {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl PartialOrd for Traced {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(if self < other {
            Ordering::Less
        } else if self == other {
            Ordering::Equal
        } else {
            Ordering::Greater
        })
    }
    fn lt(&self, other: &Self) -> bool {
        decide(Relation::Less, self.node(), other.node())
    }
    fn le(&self, other: &Self) -> bool {
        decide(Relation::LessOrEqual, self.node(), other.node())
    }
    fn gt(&self, other: &Self) -> bool {
        other < self
    }
    fn ge(&self, other: &Self) -> bool {
        other <= self
    }
}

/// The functions of a number, under their names in the standard library.
mod function {
    use super::{Binary, Escape, Op, Place, Unary, escape};

    macro_rules! known {
        ($($name:ident $function:ident),*) => {
            $(pub(super) fn $name(x: Place) -> Place {
                x.unary(Unary::$function)
            })*
        };
    }
    known!(sqrt Root, sin Sine, cos Cosine, asin ArcSine, exp Exponential, exp_m1 ExponentialMinusOne);

    macro_rules! unknown {
        ($($name:ident)*) => {
            $(pub(super) fn $name(_: Place) -> Place {
                escape(Escape::Function(stringify!($name)))
            })*
        };
    }
    unknown!(cbrt exp2 ln log2 log10 ln_1p tan acos atan sinh cosh tanh asinh acosh atanh);

    pub(super) fn recip(x: Place) -> Place {
        Place::Number(1.0) / x
    }
    pub(super) fn powi(_: Place, _: i32) -> Place {
        escape(Escape::Function("powi"))
    }
    pub(super) fn powf(_: Place, _: Place) -> Place {
        escape(Escape::Function("powf"))
    }
    pub(super) fn log(_: Place, _: Place) -> Place {
        escape(Escape::Function("log"))
    }
    pub(super) fn sin_cos(x: Place) -> (Place, Place) {
        (sin(x), cos(x))
    }
    pub(super) fn atan2(y: Place, x: Place) -> Place {
        y.binary(Binary::Angle, x)
    }
    pub(super) fn mul_add(x: Place, y: Place, z: Place) -> Place {
        Place::entered(Op::MultiplyAdd(x.node(), y.node(), z.node()))
    }
}

newtype_number!(Traced(Place), zero: Place::Number(0.0), one: Place::Number(1.0), rem: Rem::rem);
newtype_dual_num!(Traced, function);

impl Leaf for Traced {
    const EPSILON: f64 = f64::EPSILON;
    fn pi() -> Self {
        pi::<f64>().into()
    }
    fn e_minus_one() -> Self {
        e_minus_one::<f64>().into()
    }
    fn constants<const N: usize>(nearest: [f64; N], _: impl FnOnce() -> [Self; N]) -> [Self; N] {
        nearest.map(Self::from)
    }
    fn or_larger(self, other: Self) -> Self {
        Self(self.0.binary(Binary::Maximum, other.0))
    }
    fn power_of_two_below(self) -> [Self; 2] {
        let unit = Self(self.0.unary(Unary::PowerOfTwo));
        [unit, Self(function::recip(unit.0))]
    }
    fn nearest_integer_of(x: Self) -> Self {
        Self(x.0.unary(Unary::NearestInteger))
    }
    fn exact_sum(products: impl IntoIterator<Item = [Self; 4]>) -> Self {
        Self(Place::entered(Op::ExactSum(products.into_iter().map(|product| product.map(Self::node)).collect())))
    }
    fn find<S: Search<N>, const N: usize>(from: [Self; N]) -> Self {
        Self(Place::entered(Op::Search(node::Search::of::<S, N>(), from.map(Self::node).into())))
    }
}

impl Scalar for Traced {
    itself!();
    const ZERO: Self = Self(Place::Number(0.0));
    const ONE: Self = Self(Place::Number(1.0));
    const MINUS_ONE: Self = Self(Place::Number(-1.0));
    fn norm_of<const N: usize>(x: [Self; N]) -> Self {
        Self(Place::entered(Op::Norm(x.map(Self::node).into())))
    }
    fn norm_and_direction_of<const N: usize>(x: [Self; N]) -> (Self, [Self; N]) {
        let length = norm(x);
        let direction = || direction_of_length(x, length);
        match extremes() {
            Extremes::Computed => (length, direction()),
            Extremes::Joined => (length, choice(direction)),
            Extremes::Nan => (length, x.map(|x| x / length)),
            Extremes::Ignored => (length, choice(|| divide(x, length))),
        }
    }
    fn angle_of(y: Self, x: Self) -> Self {
        Self(function::atan2(y.0, x.0))
    }
    fn choice_of<const N: usize>(choose: impl Fn() -> [Self; N]) -> [Self; N] {
        let nodes = sides(&|| choose().map(Self::node).to_vec());
        let nodes = nodes.unwrap_or_else(|| panic!("no side of a choice can be reached"));
        std::array::from_fn(|k| Self(Place::Node(nodes[k])))
    }
    fn has_extremes() -> bool {
        !matches!(extremes(), Extremes::Nan | Extremes::Ignored)
    }
    fn ignores_extremes() -> bool {
        extremes() == Extremes::Ignored
    }
    // If extremes are NaN, so are uncertain results; without the test of the shortcut, all results would be uncertain.
    fn takes_shortcuts() -> bool {
        extremes() == Extremes::Nan
    }
    fn abs_of(x: Self) -> Self {
        Self(x.0.abs())
    }
}

impl From<f64> for Traced {
    fn from(x: f64) -> Self {
        Self(Place::Number(x))
    }
}

impl FromPrimitive for Traced {
    fn from_i64(n: i64) -> Option<Self> {
        f64::from_i64(n).map(Self::from)
    }
    fn from_u64(n: u64) -> Option<Self> {
        f64::from_u64(n).map(Self::from)
    }
    fn from_f64(x: f64) -> Option<Self> {
        Some(x.into())
    }
}

impl FromStr for Traced {
    type Err = ParseFloatError;
    fn from_str(text: &str) -> Result<Self, ParseFloatError> {
        text.parse::<f64>().map(Self::from)
    }
}

impl fmt::Display for Traced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

impl fmt::Debug for Traced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "node {}", self.node().index())
    }
}
