//! The arc sine in doubles, without a branch between its two formulas, and with the same bits on every machine.
//!
//! Up to |x| = ½ it is s + s³ P(s²) with s = |x|. Above, it is π/2 minus twice the arc sine of s = √((1 − |x|)/2),
//! which is again at most ½.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use crate::number::angle::beyond;
use std::f64::consts::FRAC_PI_2;
use std::hint::select_unpredictable;

/// Half of the difference between π/2 and the double below it.
const HALF_FRAC_PI_2_LOW: f64 = 3.061_616_997_868_383e-17;
/// P, close to the best polynomial of its degree: the error of s³ P(s²) is at most 2⁻⁵⁵ s.
const ARC_SINE: [f64; 12] = [
    0.166_666_666_666_656_53,
    0.075_000_000_002_946_9,
    0.044_642_856_856_046_54,
    0.030_381_958_187_905_646,
    0.022_371_777_525_770_062,
    0.017_359_447_897_278_054,
    0.013_887_491_270_956_195,
    0.012_155_871_500_411_723,
    0.006_580_488_107_098_665,
    0.019_396_322_600_333_07,
    -0.016_032_766_254_421_116,
    0.031_790_119_883_824_87,
];

/// The arc sine, within two units in the last place; NaN for |x| > 1.
#[inline(always)]
pub(crate) fn asin(x: f64) -> f64 {
    let size = x.abs();
    let is_wide = size > 0.5;
    let missing = (1.0 - size) * 0.5;
    let z = select_unpredictable(is_wide, missing, size * size);
    let s = select_unpredictable(is_wide, missing.sqrt(), size);
    let turn = select_unpredictable(is_wide, FRAC_PI_2, 0.0);
    let low = select_unpredictable(is_wide, HALF_FRAC_PI_2_LOW, 0.0);
    let way = select_unpredictable(is_wide, -2.0, 1.0);
    let rest = s * beyond(&ARC_SINE, z) - low;
    let sum = turn + way * s;
    let lost = (turn - sum) + way * s;
    (sum + (lost + way * rest)).copysign(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;
    use num_dual::DualNum;
    use proptest::prelude::*;

    /// The error in units in the last place of the exact arc sine.
    fn error(x: f64) -> f64 {
        let exact = Octuple::from(x).asin();
        let nearest = exact.to_f64().abs();
        ((Octuple::from(asin(x)) - exact) / (nearest.next_up() - nearest)).to_f64().abs()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5000))]
        #[test]
        fn it_is_right_to_two_units(x in -1.0..1.0_f64, angle in -FRAC_PI_2..FRAC_PI_2, power in -1000..-1) {
            for x in [x, angle.sin(), x * 2.0_f64.powi(power), 0.5 + x * 1e-6, 1.0 - x.abs() * 2.0_f64.powi(power / 20)] {
                prop_assert!(error(x) < 1.3, "{x:e}: {}", error(x));
            }
        }
    }

    /// The formula with the root would give the double above the nearest.
    #[test]
    fn up_to_a_half_no_root_is_taken() {
        assert_eq!(asin(0.5), 0.523_598_775_598_298_8);
    }

    #[test]
    fn special_values_are_those_of_the_library() {
        for x in [0.0, 5e-324, f64::MIN_POSITIVE, 1.0, 1.0_f64.next_up(), 2.0, f64::MAX, f64::INFINITY, f64::NAN] {
            for x in [x, -x] {
                let (found, expected) = (asin(x), x.asin());
                assert!(
                    found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan(),
                    "{x:e}: {found} {expected}"
                );
            }
        }
    }
}
