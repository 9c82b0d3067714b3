//! Octuple in decimal: with any number of digits, the exact value rounded once, half to even; or with the fewest
//! digits that read back as the same number.
//!
//! f256 panics beyond 75 digits, and its shortest output needs tables of megabytes. Every finite binary number has a
//! finite decimal expansion: m · 2^e is an integer for e ≥ 0, and for e < 0 it is m · 5^-e with the decimal point
//! moved −e digits to the left.

use std::cmp::Ordering;
use std::fmt;

use f256::f256;

use super::Octuple;
use super::bits::HIGH_FRACTION_BITS;

/// A natural number in groups of nine decimal digits, the least significant group first.
struct Groups(Vec<u64>);

impl Groups {
    const DIGITS: usize = 9;
    const BASE: u64 = 10_u64.pow(9);

    /// self · factor + addend.
    fn multiply_add(&mut self, factor: u32, addend: u8) {
        let mut carry = u64::from(addend);
        for group in &mut self.0 {
            let product = *group * u64::from(factor) + carry;
            *group = product % Self::BASE;
            carry = product / Self::BASE;
        }
        while carry > 0 {
            self.0.push(carry % Self::BASE);
            carry /= Self::BASE;
        }
    }

    fn multiply_by_power(&mut self, base: u32, mut exponent: u32) {
        let step = u32::MAX.ilog(base);
        while exponent > 0 {
            let taken = exponent.min(step);
            self.multiply_add(base.pow(taken), 0);
            exponent -= taken;
        }
    }

    fn digits(&self) -> Vec<u8> {
        let groups: Vec<_> =
            self.0.iter().rev().map(|group| format!("{group:0width$}", width = Self::DIGITS)).collect();
        groups.concat().trim_start_matches('0').into()
    }
}

/// A number significand · 2^exponent; the significand has 256 bits, upper half first.
struct Binary {
    significand: [u128; 2],
    exponent: i32,
}

impl Binary {
    /// |x|, for a finite x; its significand has 237 bits at most.
    fn of(x: f256) -> Self {
        const SMALLEST_EXPONENT: i32 = -262_378;
        let (high, low) = x.abs().to_bits();
        let stored = i32::try_from(high >> HIGH_FRACTION_BITS).expect("19 bits fit");
        let leading_one = u128::from(stored > 0) << HIGH_FRACTION_BITS;
        let fraction = high & ((1 << HIGH_FRACTION_BITS) - 1);
        Self { significand: [fraction | leading_one, low], exponent: SMALLEST_EXPONENT + (stored - 1).max(0) }
    }

    /// The midpoints to both neighbours: numbers between them are nearer to this one than to any other.
    fn halfway(&self) -> [Self; 2] {
        let [high, low] = self.significand;
        let exponent = self.exponent - 2;
        let fourfold = [high << 2 | low >> 126, low << 2];
        // Below a power of two numbers are twice as dense.
        let is_power = [high, low] == [1 << HIGH_FRACTION_BITS, 0];
        let (below, borrow) = fourfold[1].overflowing_sub(if is_power { 1 } else { 2 });
        [[fourfold[0] - u128::from(borrow), below], [fourfold[0], fourfold[1] + 2]]
            .map(|significand| Self { significand, exponent })
    }
}

/// 0.d₁d₂d₃… · 10^point with d₁ ≠ 0; zero has no digits.
#[derive(Clone)]
struct Decimal {
    digits: Vec<u8>,
    point: i64,
}

impl Decimal {
    /// |x| exactly, for a finite x.
    fn exact(x: f256) -> Self {
        Self::of(&Binary::of(x))
    }

    fn of(x: &Binary) -> Self {
        let &Binary { significand, exponent } = x;
        let mut number = Groups(Vec::new());
        for byte in significand.iter().flat_map(|part| part.to_be_bytes()) {
            number.multiply_add(1 << 8, byte);
        }
        number.multiply_by_power(if exponent < 0 { 5 } else { 2 }, exponent.unsigned_abs());
        let digits = number.digits();
        let point = i64::try_from(digits.len()).expect("what is in memory can be counted") + i64::from(exponent.min(0));
        Self { digits, point }.trimmed()
    }

    /// The fewest digits that read back as |x|, for a finite x; of these, the nearest number.
    fn shortest(x: f256) -> Self {
        let binary = Binary::of(x);
        let exact = Self::of(&binary);
        if exact.digits.is_empty() {
            return exact;
        }
        let [low, high] = binary.halfway().map(|x| Self::of(&x));
        // Ties go to the even one.
        let is_even = binary.significand[1].is_multiple_of(2);
        let reads_back = |decimal: &Self| match [low.order(decimal), decimal.order(&high)] {
            [Ordering::Less, Ordering::Less] => true,
            [Ordering::Greater, _] | [_, Ordering::Greater] => false,
            _ => is_even,
        };
        let found = (1..exact.digits.len()).find_map(|keep| exact.beside(keep).into_iter().find(reads_back));
        found.unwrap_or(exact)
    }

    /// The nearest number with this many digits, and the next one above it.
    fn beside(&self, keep: usize) -> [Self; 2] {
        let mut nearest = self.clone();
        nearest.round(i64::try_from(keep).expect("what is in memory can be counted"));
        let mut above = nearest.clone();
        above.increment();
        [nearest, above].map(Self::trimmed)
    }

    /// Without zeros at the end.
    fn trimmed(mut self) -> Self {
        let zeros = self.digits.iter().rev().take_while(|digit| **digit == b'0').count();
        self.digits.truncate(self.digits.len() - zeros);
        self
    }

    /// Compares two numbers that are neither zero nor end in zeros.
    fn order(&self, other: &Self) -> Ordering {
        self.point.cmp(&other.point).then_with(|| self.digits.cmp(&other.digits))
    }

    /// The number of digits after the decimal point.
    fn decimals(&self) -> usize {
        if self.digits.is_empty() {
            return 0;
        }
        let digits = i64::try_from(self.digits.len()).expect("what is in memory can be counted");
        usize::try_from(digits - self.point).unwrap_or(0)
    }

    /// Rounds to `keep` digits, which may be zero or negative: then the result is 0 or the digit before the first.
    fn round(&mut self, keep: i64) {
        let Ok(keep) = usize::try_from(keep) else {
            self.digits.clear();
            return;
        };
        if keep >= self.digits.len() {
            self.digits.resize(keep, b'0');
            return;
        }
        let rest = self.digits.split_off(keep);
        let odd = self.digits.last().is_some_and(|digit| digit % 2 == 1);
        let half = rest[0] == b'5' && rest[1..].iter().all(|digit| *digit == b'0');
        if rest[0] > b'5' || rest[0] == b'5' && (!half || odd) {
            self.increment();
        }
    }

    /// Increments the last digit.
    fn increment(&mut self) {
        let nines = self.digits.iter().rev().take_while(|digit| **digit == b'9').count();
        let above = self.digits.len() - nines;
        self.digits[above..].fill(b'0');
        if let Some(digit) = self.digits[..above].last_mut() {
            *digit += 1;
        } else {
            self.digits.insert(0, b'1');
            self.point += 1;
        }
    }

    /// Fixed-point notation with `decimals` digits after the point.
    fn fixed(mut self, decimals: usize) -> String {
        // If the sum exceeds the integer type, it also exceeds the number of digits.
        let decimals_wanted = i64::try_from(decimals).unwrap_or(i64::MAX);
        self.round(self.point.saturating_add(decimals_wanted));
        let zeros = if self.digits.is_empty() {
            decimals + 1
        } else {
            usize::try_from((1 - self.point).max(0)).expect("as many zeros as digits were asked for")
        };
        let text = "0".repeat(zeros) + &String::from_utf8_lossy(&self.digits);
        let (whole, fraction) = text.split_at(text.len() - decimals);
        if fraction.is_empty() { whole.to_owned() } else { format!("{whole}.{fraction}") }
    }

    /// Scientific notation with one digit before the point and `decimals` digits after it.
    fn scientific(mut self, decimals: usize) -> String {
        if self.digits.is_empty() {
            return self.fixed(decimals) + "e0";
        }
        let keep = decimals.saturating_add(1);
        self.round(i64::try_from(keep).unwrap_or(i64::MAX));
        let exponent = self.point - 1;
        self.point = 1;
        format!("{}e{exponent}", self.fixed(decimals))
    }
}

impl Octuple {
    /// |x| in all its digits, still to be rounded; or in the fewest digits if no precision is given.
    fn decimal(self, precision: Option<usize>) -> Decimal {
        if precision.is_some() { Decimal::exact(self.0) } else { Decimal::shortest(self.0) }
    }

    /// Writes `text`, the digits of |x|, with the sign, width and fill that `f` asks for.
    fn pad(self, f: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
        f.pad_integral(self.0.is_sign_positive(), "", text)
    }

    /// Writes infinities and NaN as `f64` does.
    fn special(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.to_f64(), f)
    }
}

/// Without a precision: the fewest digits that read back as the same number.
impl fmt::Display for Octuple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.is_finite() {
            return self.special(f);
        }
        let decimal = self.decimal(f.precision());
        let decimals = f.precision().unwrap_or_else(|| decimal.decimals());
        self.pad(f, &decimal.fixed(decimals))
    }
}

/// Without a precision: the fewest digits that read back as the same number.
impl fmt::LowerExp for Octuple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.is_finite() {
            return self.special(f);
        }
        let decimal = self.decimal(f.precision());
        let decimals = f.precision().unwrap_or_else(|| decimal.digits.len().saturating_sub(1));
        self.pad(f, &decimal.scientific(decimals))
    }
}

/// As [`LowerExp`](fmt::LowerExp).
impl fmt::Debug for Octuple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::LowerExp::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::bits::{power_of_two, scale_by_power_of_two};
    use super::*;

    #[test]
    fn as_many_digits_as_asked() {
        let tenth = Octuple::from(0.1);
        assert_eq!(format!("{tenth:.60}"), format!("{:.60}", 0.1));
        assert_eq!(format!("{tenth:.100e}"), format!("{:.100e}", 0.1));
        assert_eq!(format!("{:.0}", Octuple::PI), "3");
    }

    #[test]
    fn a_carry_out_of_the_first_digit_makes_another() {
        for x in [9.96, 99.96, 0.996, 9.5, 999.75] {
            let wide = Octuple::from(x);
            assert_eq!(format!("{wide:.0} {wide:.1}|{wide:.0e} {wide:.1e}"), format!("{x:.0} {x:.1}|{x:.0e} {x:.1e}"));
        }
    }

    #[test]
    fn the_ends_of_the_range() {
        assert_eq!(format!("{:.3e}", Octuple::MAX), "1.611e78913");
        assert_eq!(format!("{:.3e}", Octuple(f256::MIN_GT_ZERO)), "2.248e-78984");
        assert_eq!(format!("{:.2}", Octuple(f256::MIN_GT_ZERO)), "0.00");
        assert_eq!(format!("{:.0}", Octuple::MAX).len(), 78_914);
    }

    /// The spacing of numbers doubles above a power of two. So of the numbers with 72 digits, one just above 2⁻¹²⁹
    /// reads back, while the nearer one just below it does not.
    #[test]
    fn the_fewest_digits_of_a_power_of_two_may_be_above_it() {
        let power = Octuple(scale_by_power_of_two(f256::ONE, -129));
        let text = "1.46936793852785938496092067152780709727333194596510940188593963284802158e-39";
        assert_eq!(format!("{power:e}"), text);
        assert!(text.parse::<Octuple>().unwrap() == power);
        assert!(text.replace("158e", "157e").parse::<Octuple>().unwrap() != power);
    }

    #[test]
    fn special_values() {
        for (x, text) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf"), (f64::NEG_INFINITY, "-inf")] {
            assert_eq!(format!("{:.100} {:.100e}", Octuple::from(x), Octuple::from(x)), format!("{text} {text}"));
        }
        assert_eq!(format!("{:.80}", Octuple::from(-0.0)), format!("{:.80}", -0.0));
        assert_eq!(format!("{:?}", Octuple::from(1.5)), "1.5e0");
    }

    proptest! {
        /// Prints like f64 for every flag; f64 also rounds exact values half to even.
        #[test]
        fn prints_like_f64(x in prop_oneof![-1e3..1e3_f64, any::<f64>(), (-64..64_i32).prop_map(|n| f64::from(n) / 16.0)], decimals in 0..40_usize) {
            prop_assume!(!x.is_nan());
            let wide = Octuple::from(x);
            assert_eq!(format!("{wide:.decimals$}"), format!("{x:.decimals$}"));
            assert_eq!(format!("{wide:.decimals$e}"), format!("{x:.decimals$e}"));
            assert_eq!(format!("{wide:+60.decimals$}|{wide:<60.2}|{wide:060.3e}"), format!("{x:+60.decimals$}|{x:<60.2}|{x:060.3e}"));
        }

        /// As few digits as f256 prints with its tables, which this crate does without. Integers and powers of two are
        /// excluded, since f256 prints others for them; of two equally near numbers it takes the larger.
        #[test]
        fn the_fewest_digits_are_as_few_as_those_of_f256(exponent in -2000..2000_i32, high: u128, low: u128, zeros in 0..236_u32) {
            let cut = |bits: u128, zeros: u32| if zeros < 128 { bits >> zeros << zeros } else { 0 };
            let (high, low) = (cut(high, zeros.saturating_sub(128)), cut(low, zeros));
            let high = high & ((1 << 108) - 1);
            let x = scale_by_power_of_two(f256::from_bits((high | power_of_two(0).to_bits().0, low)), exponent);
            let (ours, fixed) = (format!("{:e}", Octuple(x)), Octuple(x).to_string());
            for text in [&ours, &fixed] {
                assert_eq!(text.parse::<Octuple>().unwrap().0.to_bits(), x.to_bits());
            }
            if !x.fract().eq_zero() && (high, low) != (0, 0) {
                assert_eq!((ours.len(), fixed.len()), (format!("{x:e}").len(), x.to_string().len()));
            }
        }

        /// 72 decimals after the first digit identify a number of 237 bits; so do the shortest digits.
        #[test]
        fn reads_back(exponent in -2000..2000_i32, high: u128, low: u128) {
            let fraction = f256::from_bits((high & ((1 << 108) - 1) | power_of_two(0).to_bits().0, low));
            let x = Octuple(scale_by_power_of_two(fraction, exponent)) * if high >> 127 == 0 { 1.0 } else { -1.0 };
            for text in [format!("{x:.73e}"), format!("{x:e}"), format!("{x:?}")] {
                let back: Octuple = text.parse().unwrap();
                assert_eq!(back.0.to_bits(), x.0.to_bits(), "{text}");
            }
        }
    }
}
