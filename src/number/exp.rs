//! eˣ − 1 in doubles, with the same bits on every machine.
//!
//! x is k ln 2 + r with |r| ≤ ½ ln 2, and eˣ − 1 is 2ᵏ (eʳ − 1) + (2ᵏ − 1), where eʳ − 1 = r + r² P(r).

use crate::number::angle::beyond;
use crate::number::scalar::is_between;
use std::f64::consts::LOG2_E;

/// ln 2 in two parts: the first has trailing zeros, so that a thousand times it is still a double.
const LN_2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// P, close to the best polynomial of its degree: the error of r² P(r) is at most 2⁻⁵⁹ r.
const EXPONENTIAL: [f64; 12] = [
    0.5,
    0.166_666_666_666_666_66,
    0.041_666_666_666_666_67,
    0.008_333_333_333_333_333,
    0.001_388_888_888_888_374_8,
    0.000_198_412_698_412_664_15,
    2.480_158_732_554_774_3e-5,
    2.755_731_923_995_709_7e-6,
    2.755_727_364_311_03e-7,
    2.505_207_800_232_945_6e-8,
    2.091_468_696_808_687_6e-9,
    1.608_432_788_395_260_3e-10,
];
/// Adding this, 1.5 × 2⁵², rounds a number to an integer, which is then in the lowest bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// Between these sizes 2ᵏ is a double, and r does not underflow.
const SMALL: f64 = 1e-300;
const LARGE: f64 = 700.0;

/// eˣ − 1, within one unit in the last place; special values as in [`f64::exp_m1`].
#[inline]
pub(crate) fn exp_m1(x: f64) -> f64 {
    if is_between(x.abs(), SMALL, LARGE) { usual(x) } else { extreme(x) }
}

#[inline]
fn usual(x: f64) -> f64 {
    let shifted = x * LOG2_E + WHOLE;
    let k = shifted - WHOLE;
    let (above, below) = (x - k * LN_2_HIGH, k * LN_2_LOW);
    let r = above - below;
    // The shift discards all bits above those of the integer; 1023 is the exponent of 1.
    let power = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
    let (more, most) = (power * r, power - 1.0);
    let sum = most + more;
    // The rounding errors of r and of the sum.
    let lost = power * ((above - r) - below) + ((most - sum) + more);
    sum + (more * beyond(&EXPONENTIAL, r) + lost)
}

/// For x that is NaN, near zero, or so large that 2ᵏ is no double.
#[cold]
fn extreme(x: f64) -> f64 {
    x.exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;
    use num_dual::DualNum;
    use proptest::prelude::*;

    /// The error in units in the last place of the exact value.
    fn error(x: f64) -> f64 {
        let exact = DualNum::exp_m1(&Octuple::from(x));
        let nearest = exact.to_f64().abs();
        ((Octuple::from(exp_m1(x)) - exact) / (nearest.next_up() - nearest)).to_f64().abs()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5000))]
        #[test]
        fn it_is_right_to_one_unit(near in -2.0..2.0_f64, far in -709.0..709.0_f64, power in -1000..-1) {
            for x in [near, far, near * 2.0_f64.powi(power), near * 2.0_f64.powi(power / 50)] {
                prop_assert!(error(x) < 1.0, "{x:e}: {}", error(x));
            }
        }
    }

    #[test]
    fn the_bits_are_these_on_every_machine() {
        for (x, expected) in
            [(1.0, 1.718_281_828_459_045_3), (-0.5, -0.393_469_340_287_366_6), (2.5, 11.182_493_960_703_473)]
        {
            assert_eq!(exp_m1(x), expected);
        }
    }

    #[test]
    fn special_values_are_those_of_the_library() {
        for x in [0.0, 5e-324, f64::MIN_POSITIVE, 709.7, 710.0, 750.0, f64::MAX, f64::INFINITY, f64::NAN] {
            for x in [x, -x] {
                let (found, expected) = (exp_m1(x), x.exp_m1());
                assert!(
                    found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan(),
                    "{x:e}: {found} {expected}"
                );
            }
        }
    }
}
