//! Conversions of [`Octuple`] from and to `f64`, integers and decimal literals, each rounded at most once.

use super::bits::{exponent, leading_bits, nearest_f64};
use std::num::ParseFloatError;
use std::str::FromStr;

use f256::f256;
use num_traits::FromPrimitive;

use super::Octuple;

impl Octuple {
    /// The nearest `f64`, ties to even, rounded once even if the result is subnormal. Values half an ulp or more above
    /// the largest `f64` become infinite; signed zeros and NaN are kept.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        let magnitude = match self.0 {
            x if x.is_nan() => f64::NAN,
            x if x.is_infinite() => f64::INFINITY,
            x => nearest_f64(leading_bits(x), exponent(x)),
        };
        if self.0.is_sign_negative() { -magnitude } else { magnitude }
    }
}

impl From<f64> for Octuple {
    /// Exact.
    fn from(value: f64) -> Self {
        if value.is_nan() { Self::NAN } else { Self(f256::from(value)) }
    }
}

/// Exact: no integer type holds more than 128 bits.
impl FromPrimitive for Octuple {
    fn from_i64(n: i64) -> Option<Self> {
        Some(Self(f256::from(n)))
    }
    fn from_u64(n: u64) -> Option<Self> {
        Some(Self(f256::from(n)))
    }
    fn from_i128(n: i128) -> Option<Self> {
        Some(Self(f256::from(n)))
    }
    fn from_u128(n: u128) -> Option<Self> {
        Some(Self(f256::from(n)))
    }
    fn from_f64(value: f64) -> Option<Self> {
        Some(Self::from(value))
    }
}

impl FromStr for Octuple {
    type Err = ParseFloatError;

    /// The number nearest to a decimal literal of any length, ties to even.
    ///
    /// # Errors
    /// If `text` is not what `f64` accepts.
    fn from_str(text: &str) -> Result<Self, ParseFloatError> {
        // f256 also accepts "." and "1e+"; the grammar is that of f64.
        text.parse::<f64>()?;
        let value: f256 = text.parse()?;
        // f256 returns zero for numbers below 1e-78980 that are written with more than 70 digits.
        let shortened = if value.eq_zero() { shortened_literal(text) } else { None };
        shortened.map_or(Ok(value), |text| text.parse()).map(Self)
    }
}

/// Cuts a literal of more than 71 digits to 71. This may round wrongly within 10^-70 above the midpoint of two
/// numbers, which have fewer than 20 bits here; the midpoint itself has tens of thousands of digits.
fn shortened_literal(text: &str) -> Option<String> {
    const DIGITS: usize = 71;
    let (number, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
    let sign = if whole.starts_with('-') { "-" } else { "" };
    let digits = whole.trim_start_matches(['+', '-']).to_owned() + fraction;
    let point = exponent.parse::<i64>().ok()?.checked_sub(i64::try_from(fraction.len()).ok()?)?;
    let (kept, rest) = digits.trim_start_matches('0').split_at_checked(DIGITS)?;
    let point = point.checked_add(i64::try_from(rest.len()).ok()?)?;
    Some(format!("{sign}{kept}e{point}"))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::octuple::bits::power_of_two;

    /// Compares `to_f64` with the hardware: numbers of 53 bits come back bit for bit.
    fn assert_round_trip(value: f64) {
        let back = Octuple::from(value).to_f64();
        assert!(
            back.to_bits() == value.to_bits() || back.is_nan() && value.is_nan(),
            "{value:e} = {:#018x} came back as {back:e} = {:#018x}",
            value.to_bits(),
            back.to_bits()
        );
    }

    /// Between `lower` and the next f64, the midpoint rounds to the even one and its neighbours to the nearer one.
    fn assert_rounds_at_midpoint_above(lower: f64) {
        let upper = lower.next_up();
        // Halving an exact sum of two f64 is exact, also for subnormals; 2^1024 replaces infinity.
        let upper_exact = if upper.is_finite() { Octuple::from(upper) } else { Octuple(power_of_two(1024)) };
        let middle = (Octuple::from(lower) + upper_exact) / 2.0;
        let even = if lower.to_bits().is_multiple_of(2) { lower } else { upper };
        let below = Octuple(middle.0.next_down());
        let above = Octuple(middle.0.next_up());
        for (wide, expected) in [(below, lower), (middle, even), (above, upper)] {
            assert_eq!(wide.to_f64().to_bits(), expected.to_bits(), "{wide:e} between {lower:e} and {upper:e}");
            assert_eq!((-wide).to_f64().to_bits(), (-expected).to_bits(), "-{wide:e}");
        }
    }

    #[test]
    fn f64_round_trip_at_the_edges() {
        for magnitude in
            [0.0, 5e-324, f64::MIN_POSITIVE.next_down(), f64::MIN_POSITIVE, 1.0, 0.1, f64::MAX, f64::INFINITY, f64::NAN]
        {
            assert_round_trip(magnitude);
            assert_round_trip(-magnitude);
        }
        // There is a single NaN, whatever the sign and bits of the source.
        for nan in [f64::NAN, -f64::NAN, f64::from_bits(0x7ff0_0000_0000_0001)] {
            assert_eq!(Octuple::from(nan).0.to_bits(), f256::NAN.to_bits());
        }
    }

    #[test]
    fn to_f64_rounds_midpoints_to_even() {
        let powers = (-1074..1024).step_by(13).map(|e| 2.0_f64.powi(e));
        let edges = [
            0.0,
            5e-324,
            1e-323,
            f64::MIN_POSITIVE.next_down(),
            f64::MIN_POSITIVE,
            1.0_f64.next_down(),
            1.0,
            0.1,
            1e300,
            f64::MAX.next_down(),
            f64::MAX,
        ];
        for lower in powers.chain(edges) {
            assert_rounds_at_midpoint_above(lower);
            assert_rounds_at_midpoint_above(lower.next_up().min(f64::MAX));
        }
    }

    #[test]
    fn to_f64_beyond_the_range() {
        assert_eq!(Octuple::MAX.to_f64().to_bits(), f64::INFINITY.to_bits());
        assert_eq!((-Octuple::MAX).to_f64().to_bits(), f64::NEG_INFINITY.to_bits());
        assert_eq!(Octuple::MIN_POSITIVE.to_f64().to_bits(), 0.0_f64.to_bits());
        assert_eq!((-Octuple::MIN_POSITIVE).to_f64().to_bits(), (-0.0_f64).to_bits());
        assert_eq!(Octuple(f256::MIN_GT_ZERO).to_f64().to_bits(), 0.0_f64.to_bits());
        // Every exponent, so that no shift is out of range.
        for e in -1200..1100 {
            let expected = if e > 1023 { f64::INFINITY } else { 2.0_f64.powi(e / 2) * 2.0_f64.powi(e - e / 2) };
            assert_eq!(Octuple(power_of_two(e)).to_f64().to_bits(), expected.to_bits(), "2^{e}");
        }
    }

    #[test]
    fn integers_are_exact() {
        for n in [0, 1, -1, i128::MAX, i128::MIN, i128::from(i64::MIN), 1 << 100 | 1] {
            let wide = Octuple::from_i128(n).unwrap();
            assert_eq!(format!("{wide}"), n.to_string());
        }
        assert_eq!(
            [-3, i64::MIN].map(|n| format!("{}", Octuple::from_i64(n).unwrap())),
            ["-3", "-9223372036854775808"]
        );
        assert_eq!(format!("{}", Octuple::from_u128(u128::MAX).unwrap()), u128::MAX.to_string());
        assert_eq!(Octuple::from_usize(usize::MAX).unwrap(), Octuple::from_u64(u64::MAX).unwrap());
        assert_eq!(Octuple::from_f64(0.1).unwrap(), 0.1);
        assert_eq!(Octuple::from_f32(0.1).unwrap(), f64::from(0.1_f32));
    }

    #[test]
    fn literals_are_those_of_f64() {
        for bad in ["", ".", "+", "e", "1e", "1e+", "0x1", "1_0", " 1", "1 ", "--1", "1e5.5", "∞", "in"] {
            assert!(bad.parse::<Octuple>().is_err(), "{bad:?}");
        }
        for good in ["1.", "-.5", "+2.5e3", "inf", "-INFINITY", "1e99999999999999999999", "-1e-99999999999999999999"] {
            let (wide, double): (Octuple, f64) = (good.parse().unwrap(), good.parse().unwrap());
            assert_eq!(wide.to_f64().to_bits(), double.to_bits(), "{good:?}");
        }
        assert!("-nan".parse::<Octuple>().unwrap().is_nan());
    }

    #[test]
    fn literals_of_the_smallest_numbers() {
        let smallest = Octuple(f256::MIN_GT_ZERO);
        for x in [smallest, -smallest * 5000.0] {
            for text in [format!("{x:.70e}"), format!("{x:.100e}")] {
                assert_eq!(text.parse::<Octuple>().unwrap(), x, "{}", &text[..40]);
            }
        }
        // Just below half of the smallest number, and just above it.
        let half = "1.124003543238518286485093073881325912986804591330501381471744872738546";
        assert_eq!(format!("{half}e-78984").parse::<Octuple>().unwrap(), 0.0);
        assert_eq!(format!("-{half}9999e-78984").parse::<Octuple>().unwrap(), -smallest);
        assert_eq!("1.2e-78984".parse::<Octuple>().unwrap(), smallest);
    }

    proptest! {
        #[test]
        fn f64_round_trip(bits: u64) {
            assert_round_trip(f64::from_bits(bits));
        }

        #[test]
        fn to_f64_rounds_midpoints_to_even_anywhere(bits in 0..f64::INFINITY.to_bits()) {
            assert_rounds_at_midpoint_above(f64::from_bits(bits));
        }
    }
}
