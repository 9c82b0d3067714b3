//! The roundings of every operation.

use super::field::Rational;
use super::way::Way;
use crate::toolkit::graph::{Binary, Node, Op, Unary};
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, CheckedSub, Signed, Zero};

/// A literal with more significant bits may be the double next to a number that has no end, as π is.
const SHORT: u32 = 20;
/// Fractions of exact constants are as small as this, so that products of some of them are exact, too.
const SMALL: i128 = 1 << 20;

impl Way<'_> {
    /// The value of a constant, or of a number made of constants, where it is exact.
    pub(super) fn exact(&self, node: Node) -> Option<Rational> {
        let value = |node: &Node| self.exact(self.resolved(*node).ok()?);
        match self.graph.op(node) {
            Op::Number(bits) => rational(f64::from_bits(*bits)),
            Op::Unary(Unary::Negative, x) => value(x).map(|x| -x),
            Op::Unary(Unary::Absolute, x) => value(x).map(|x| x.abs()),
            Op::Binary(operation, x, y) => {
                let (x, y) = (value(x)?, value(y)?);
                let result = match operation {
                    Binary::Add => x.checked_add(&y),
                    Binary::Subtract => x.checked_sub(&y),
                    Binary::Multiply => x.checked_mul(&y),
                    Binary::Divide => x.checked_div(&y),
                    Binary::Angle | Binary::Maximum => None,
                };
                result.filter(is_short)
            }
            _ => None,
        }
    }

    pub(super) fn is_zero(&self, node: Node) -> bool {
        self.exact(node).is_some_and(|value| value.is_zero())
    }

    /// Whether a number is ± a power of two whatever the inputs are, so that scaling by it does not round.
    fn is_power_of_two(&self, node: Node) -> bool {
        let is = |node: &Node| self.resolved(*node).is_ok_and(|node| self.is_power_of_two(node));
        match self.graph.op(node) {
            Op::Number(bits) => f64::from_bits(*bits).is_normal() && bits.trailing_zeros() >= f64::MANTISSA_DIGITS - 1,
            Op::Unary(Unary::PowerOfTwo, _) => true,
            Op::Unary(Unary::Negative | Unary::Absolute, x) => is(x),
            Op::Binary(Binary::Multiply | Binary::Divide, x, y) => is(x) && is(y),
            _ => false,
        }
    }

    /// The relative error of an operation whose operands are exact, at most, in units of u = 2⁻⁵³.
    pub(super) fn roundings(&self, node: Node) -> Rational {
        let zero = Rational::zero();
        let op = self.graph.op(node);
        let operands = self.operands(node).unwrap_or_default();
        if self.exact(node).is_some() {
            return zero;
        }
        let halves = |halves: usize| Rational::new(i128::try_from(halves).unwrap_or(i128::MAX), 2);
        match op {
            Op::Input(_) | Op::Compare(..) | Op::Select(..) | Op::Search(..) => zero,
            // A power of two has been written as one; of others, the nearest double.
            Op::Number(_) if self.is_power_of_two(node) => zero,
            Op::Unary(function, _) => match function {
                Unary::Negative | Unary::Absolute | Unary::PowerOfTwo | Unary::NearestInteger => zero,
                Unary::Root => halves(2),
                // Within a unit in the last place, which is at most 2u.
                Unary::Sine | Unary::Cosine | Unary::Exponential | Unary::ExponentialMinusOne => halves(4),
                // Within 1.3 units in the last place, as its test says.
                Unary::ArcSine => Rational::new(13, 5),
            },
            Op::Binary(operation, ..) => match operation {
                // Adding 0 does not round, nor does 0 times something.
                Binary::Add | Binary::Subtract | Binary::Multiply if operands.iter().any(|&x| self.is_zero(x)) => zero,
                Binary::Divide if self.is_zero(operands[0]) => zero,
                Binary::Multiply if operands.iter().any(|&x| self.is_power_of_two(x)) => zero,
                Binary::Divide if self.is_power_of_two(operands[1]) => zero,
                Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide => halves(2),
                // Within two units in the last place, as its test says.
                Binary::Angle => halves(8),
                Binary::Maximum => zero,
            },
            Op::Number(_) | Op::MultiplyAdd(..) => halves(2),
            // n squares and n − 1 sums are halved by the root, which itself is rounded.
            Op::Norm(parts) => halves(parts.len() + 2),
            // Its exact sum of parts is added up with an error of at most a unit in the last place.
            Op::ExactSum(_) => halves(4),
        }
    }
}

/// A double with few digits as the fraction that it is.
pub(super) fn rational(x: f64) -> Option<Rational> {
    if x == 0.0 {
        return Some(Rational::zero());
    }
    let scaled = x * f64::from(1 << SHORT);
    #[expect(clippy::cast_possible_truncation, reason = "it is small and whole")]
    let whole = (scaled.abs() < 1e18 && scaled.fract() == 0.0).then_some(scaled as i128)?;
    let short = whole.unsigned_abs() >> whole.trailing_zeros();
    let fraction = Rational::new(whole, 1 << SHORT);
    (short < 1 << SHORT && is_short(&fraction)).then_some(fraction)
}

/// Whether a fraction is a double with few digits.
fn is_short(x: &Rational) -> bool {
    x.numer().abs() < SMALL && *x.denom() <= SMALL && x.denom().count_ones() == 1
}
