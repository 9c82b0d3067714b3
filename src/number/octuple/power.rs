//! Powers with integer and with real exponents.
//!
//! f256 (0.11.3) fails here in several ways: xⁿ with x < 1 counts as an underflow from |n| · ⌈−log₂ x⌉ > 262380 on
//! although 0.9^300000 is not that small; `i32::MIN` panics; (−0)^n loses its sign; real exponents panic when they are
//! tiny, infinite, or integers beyond 2³¹. So f256 only computes x^b with |b| < 1, and the rest is done here: integer
//! powers in pairs of numbers with separate exponents.

use f256::f256;

use super::bits::{power_of_two, scale_by_power_of_two};
use super::elementary::{exp, mul_add, significand};

/// (high + low) · 2^exponent, with 1 ≤ |high| < 2 on creation and |low| at most an ulp of high: at least 470 bits.
#[derive(Clone, Copy)]
struct Pair {
    high: f256,
    low: f256,
    exponent: i64,
}

impl Pair {
    /// A finite number other than zero.
    fn new(x: f256) -> Self {
        let (high, exponent) = significand(x);
        Self { high, low: f256::ZERO, exponent: i64::from(exponent) }
    }

    fn times(self, other: Self) -> Self {
        let (product, error) = exact_product(self.high, other.high);
        let rest = error + (self.high * other.low + self.low * other.high);
        let (high, low) = exact_sum(product, rest);
        let exponent = self.exponent + other.exponent;
        if high < f256::TWO {
            return Self { high, low, exponent };
        }
        Self { high: high.div2(), low: low.div2(), exponent: exponent + 1 }
    }

    /// By repeated squaring, from the leading bit of n ≥ 1 downwards: every factor is the exact x or an intermediate result.
    fn power(self, n: u32) -> Self {
        let below_leading = (0..n.ilog2()).rev();
        below_leading.fold(self, |power, bit| {
            let square = power.times(power);
            if n >> bit & 1 == 1 { square.times(self) } else { square }
        })
    }

    /// 1/(h+l) = q + q(1 − qh − ql) with q the rounded 1/h.
    fn recip(self) -> Self {
        let quotient = self.high.recip();
        let remainder = -quotient.mul_add(self.high, f256::NEG_ONE) - quotient * self.low;
        let (high, low) = (quotient.mul2(), (quotient * remainder).mul2());
        Self { high, low, exponent: -self.exponent - 1 }
    }

    fn round(self) -> f256 {
        let limit = 1_000_000;
        let exponent = self.exponent.clamp(-limit, limit);
        scale_by_power_of_two(self.high + self.low, i32::try_from(exponent).expect("a million fits"))
    }
}

/// a·b rounded, and its rounding error; for factors of moderate size.
fn exact_product(a: f256, b: f256) -> (f256, f256) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

/// a+b rounded, and its rounding error, for |a| ≥ |b| (Dekker 1971).
fn exact_sum(a: f256, b: f256) -> (f256, f256) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// xⁿ; 1 for n = 0, whatever x.
pub(super) fn powi(x: f256, n: i32) -> f256 {
    match n {
        0 => f256::ONE,
        1 => x,
        2 => x * x,
        _ if x.is_special() => power_of_special(x, n < 0, n % 2 != 0),
        _ => whole_power(x, n).round(),
    }
}

/// xⁿ for finite x ≠ 0 and n ≠ 0.
fn whole_power(x: f256, n: i32) -> Pair {
    let power = Pair::new(x.abs()).power(n.unsigned_abs());
    let power = if n < 0 { power.recip() } else { power };
    if n % 2 != 0 && x.is_sign_negative() { Pair { high: -power.high, low: -power.low, ..power } } else { power }
}

/// Powers of 0, ∞ and NaN.
fn power_of_special(x: f256, negative: bool, odd: bool) -> f256 {
    if x.is_nan() {
        return f256::NAN;
    }
    let magnitude = if x.eq_zero() == negative { f256::INFINITY } else { f256::ZERO };
    if odd { magnitude.copysign(x) } else { magnitude }
}

/// x^y, special values as in C99 (F.9.4.4).
pub(super) fn powf(x: f256, y: f256) -> f256 {
    if y.eq_zero() || x == f256::ONE {
        return f256::ONE;
    }
    if x.is_nan() || y.is_nan() {
        return f256::NAN;
    }
    let a = x.abs();
    if y.is_infinite() {
        return if a == f256::ONE {
            f256::ONE
        } else if (a > f256::ONE) == y.is_sign_positive() {
            f256::INFINITY
        } else {
            f256::ZERO
        };
    }
    let whole = y == y.trunc();
    let odd = whole && y.div2() != y.div2().trunc();
    if x.is_special() {
        return power_of_special(x, y.is_sign_negative(), odd);
    }
    if x.is_sign_negative() && !whole {
        return f256::NAN;
    }
    let magnitude = power_of_positive(a, y);
    if odd { magnitude.copysign(x) } else { magnitude }
}

/// a^y for finite a > 0 and y ≠ 0.
fn power_of_positive(a: f256, y: f256) -> f256 {
    let log2 = a.log2();
    let size = y * log2;
    if size > f256::from(262_145) {
        return f256::INFINITY;
    }
    if size < f256::from(-262_380) {
        return f256::ZERO;
    }
    // a^y = a^n · a^b with integer n and |b| < 1, both of the sign of y.
    let Ok(n) = i32::try_from(&y.trunc()) else {
        return power_near_one(a, y);
    };
    let b = y.fract();
    let factor = if (b * log2).abs() < power_of_two(-240) { f256::ONE } else { a.powf(&b) };
    match n {
        0 => factor,
        _ if factor.is_special() => factor,
        _ => whole_power(a, n).times(Pair::new(factor)).round(),
    }
}

/// a^y where |y| ≥ 2³¹ and the result is neither 0 nor ∞, so that d = a − 1 is below 2^-13 (and exact).
///
/// a^y = exp(y ln(1+d)), where an error of ln is magnified by up to 2^18 in the result; so ln and its product with y
/// are sums of two numbers: ln(1+d) = d − d²/2 + (d³/3 − d⁴/4 + …), where the bracket is at most 2^-26 of the whole.
fn power_near_one(a: f256, y: f256) -> f256 {
    const TERMS: u8 = 22;
    let d = a - f256::ONE;
    let (square, square_error) = exact_product(d, d);
    // 1/3 − d/4 + d²/5 − … by Horner's scheme.
    let bracket = (3..=TERMS).rev().fold(f256::ZERO, |sum, k| f256::from(k).recip() - d * sum);
    let (high, low) = exact_sum(d, -square.div2());
    let (high, low) = exact_sum(high, low + (d * square * bracket - square_error.div2()));
    let (product, error) = exact_product(y, high);
    let power = exp(product);
    if power.is_special() { power } else { mul_add(power, error + y * low, power) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::octuple::Octuple;
    use num_dual::DualNum;
    use num_traits::Signed;

    fn octuple(text: &str) -> Octuple {
        text.parse().unwrap()
    }

    /// Integer powers against plain repeated multiplication where that is exact.
    #[test]
    fn small_integers_are_exact() {
        for base in -7..=7_i32 {
            for n in 0..=30_u8 {
                let exact = i128::from(base).pow(u32::from(n));
                assert_eq!(
                    format!("{}", Octuple::from(f64::from(base)).powi(n.into())),
                    exact.to_string(),
                    "{base}^{n}"
                );
                assert_eq!(
                    format!("{}", Octuple::from(f64::from(base)).powf(n.into())),
                    exact.to_string(),
                    "{base}^{n}.0"
                );
            }
        }
    }

    #[test]
    fn ends_of_the_exponent_range() {
        assert_eq!(Octuple::from(1.0).powi(i32::MIN), 1.0);
        assert_eq!(Octuple::from(-1.0).powi(i32::MIN), 1.0);
        assert_eq!(Octuple::from(-1.0).powi(i32::MAX), -1.0);
        assert_eq!(Octuple::from(0.5).powi(i32::MAX), 0.0);
        assert_eq!(Octuple::from(0.5).powi(i32::MIN), f64::INFINITY);
        assert_eq!(Octuple::from(2.0).powi(-262_378), Octuple(f256::MIN_GT_ZERO));
        assert_eq!(Octuple::from(2.0).powi(-262_379), 0.0);
        assert_eq!(Octuple::from(2.0).powi(262_144), f64::INFINITY);
    }

    #[test]
    fn underflow_is_not_declared_early() {
        // 0.9^300000 = 10^(300000 · log10 0.9)
        let log10 = Octuple::from(0.9).powi(300_000).log10();
        let expected = Octuple::from(0.9).log10() * 300_000.0;
        assert!(((log10 - expected) / expected).to_f64().abs() < 1e-69, "{log10} against {expected}");
    }

    #[test]
    fn results_at_the_ends_of_the_range() {
        let near_one = Octuple::from(1.0) + Octuple(power_of_two(-40));
        for base in [near_one, Octuple::from(0.9), Octuple::PI] {
            for log2 in [262_143.99, 262_100.5, -262_141.99, -262_100.5] {
                let power = base.powd(Octuple::from(log2) / base.log2());
                assert!((power.log2() - log2).abs() < 1e-60, "{base}: 2^{log2} came out as {power:e}");
            }
            for (log2, limit) in [(262_144.01, f64::INFINITY), (262_200.0, f64::INFINITY), (-262_379.5, 0.0)] {
                assert_eq!(base.powd(Octuple::from(log2) / base.log2()), limit, "{base}: 2^{log2}");
            }
        }
    }

    #[test]
    fn huge_exponents_near_one() {
        // (1 + 2^-40)^(2^40 + 1), an integer exponent beyond i32, against the power as 40 squarings and one factor.
        let base = octuple("1") + Octuple(power_of_two(-40));
        let mut squared = Pair::new(base.0);
        for _ in 0..40 {
            squared = squared.times(squared);
        }
        let expected = Octuple(squared.times(Pair::new(base.0)).round());
        let power = base.powf(2.0_f64.powi(40) + 1.0);
        assert!((power - expected).0.abs() <= expected.ulp().0, "{power} against {expected}");
    }
}
