//! The angle of a point in the plane, in doubles, without branches that mispredict when the points lie in arbitrary directions.
//!
//! The smaller of |x| and |y| over the larger is the tangent of at most an eighth of a turn. Measured from the nearest multiple
//! of a sixteenth of a turn, the angle has a tangent t of at most tan 22.5°, and its arc tangent is t + t³ P(t²). The octant
//! decides which multiple of π/4 is added and with which sign the remainder counts.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use crate::number::scalar::is_between;
use std::f64::consts::FRAC_PI_4;

/// π/4 minus the double below it.
const FRAC_PI_4_LOW: f64 = 3.061_616_997_868_383e-17;
/// tan 22.5°
const TAN_SIXTEENTH: f64 = 0.414_213_562_373_095_03;
/// P, close to the best polynomial of its degree: the error of t³ P(t²) is at most 2⁻⁵⁸ t.
const ARC_TANGENT: [f64; 12] = [
    -0.333_333_333_333_333_3,
    0.199_999_999_999_998_04,
    -0.142_857_142_856_597_8,
    0.111_111_111_051_505_88,
    -0.090_909_087_532_591_12,
    0.076_922_963_680_422_96,
    -0.066_664_247_602_005_2,
    0.058_789_275_544_738_07,
    -0.052_304_436_406_869_48,
    0.045_515_447_340_221_615,
    -0.034_569_315_063_326_09,
    0.016_284_375_050_043_393,
];
/// Above this, sums and quotients might overflow.
const LARGE: f64 = 1e300;

/// The angle of (x, y), within two units in the last place; special values as in [`f64::atan2`].
#[inline]
pub(crate) fn angle(y: f64, x: f64) -> f64 {
    let [angle] = angles([y], [x]);
    angle
}

/// The angles of several points, bit for bit those of [`angle`].
#[inline(always)]
pub(crate) fn angles<const N: usize>(y: [f64; N], x: [f64; N]) -> [f64; N] {
    if of_both(y, x, larger).into_iter().all(is_usual) { usual(y, x) } else { extreme(y, x) }
}

/// The angles of points, NaN for those that are extreme.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn usual_angles<const N: usize>(y: [f64; N], x: [f64; N]) -> [f64; N] {
    let (sizes, angles) = (of_both(y, x, larger), usual(y, x));
    of_both(sizes, angles, |size, angle| if is_usual(size) { angle } else { f64::NAN })
}

/// The larger of |x| and |y|.
#[inline(always)]
fn larger(y: f64, x: f64) -> f64 {
    let (across, along) = (y.abs(), x.abs());
    if across > along { across } else { along }
}

/// Whether the larger of |x| and |y| is non-zero and small enough to be added and divided; false for NaN.
#[inline(always)]
fn is_usual(large: f64) -> bool {
    is_between(large, 0.0, LARGE)
}

/// The angles of points that are not extreme, one step at a time for all of them, so that the loops vectorise.
#[inline(always)]
fn usual<const N: usize>(y: [f64; N], x: [f64; N]) -> [f64; N] {
    let (across, along) = (y.map(f64::abs), x.map(f64::abs));
    let large = of_both(y, x, larger);
    let small = of_both(across, along, |across, along| if along < across { along } else { across });
    let is_steep = of_both(across, along, |across, along| across > along);
    let is_back = x.map(|x| x < 0.0);
    let is_wide = of_both(small, large, |small, large| one_if(small > TAN_SIXTEENTH * large));
    let t: [f64; N] = std::array::from_fn(|k| (small[k] - large[k] * is_wide[k]) / (large[k] + small[k] * is_wide[k]));
    std::array::from_fn(|k| {
        let rest = t[k] * beyond(&ARC_TANGENT, t[k] * t[k]);
        let way = if is_steep[k] == is_back[k] { 1.0 } else { -1.0 };
        let quarters = 2.0 * one_if(is_steep[k]) + 4.0 * one_if(is_back[k] && !is_steep[k]);
        let eighths = quarters + way * is_wide[k];
        let turn = eighths * FRAC_PI_4 + way * (t[k] + (rest + way * eighths * FRAC_PI_4_LOW));
        turn.copysign(y[k])
    })
}

/// z P(z), in parts that do not depend on each other.
#[inline(always)]
pub(crate) fn beyond(p: &[f64; 12], z: f64) -> f64 {
    let z2 = z * z;
    let z4 = z2 * z2;
    let four = |k: usize| (p[k] + p[k + 1] * z) + (p[k + 2] + p[k + 3] * z) * z2;
    z * ((four(0) + four(4) * z4) + four(8) * (z4 * z4))
}

#[inline(always)]
fn of_both<T, const N: usize>(x: [f64; N], y: [f64; N], of: impl Fn(f64, f64) -> T) -> [T; N] {
    std::array::from_fn(|k| of(x[k], y[k]))
}

#[inline(always)]
fn one_if(condition: bool) -> f64 {
    if condition { 1.0 } else { 0.0 }
}

/// For points of which at least one is the origin, is extremely large, or has a coordinate that is infinite or NaN.
#[cold]
fn extreme<const N: usize>(y: [f64; N], x: [f64; N]) -> [f64; N] {
    of_both(y, x, |y, x| if is_usual(larger(y, x)) { angle(y, x) } else { y.atan2(x) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;
    use num_dual::DualNum;
    use proptest::prelude::*;

    /// The error in units in the last place of the exact angle.
    fn error(y: f64, x: f64) -> f64 {
        let exact = Octuple::from(y).atan2(Octuple::from(x));
        let nearest = exact.to_f64().abs();
        ((Octuple::from(angle(y, x)) - exact) / (nearest.next_up() - nearest)).to_f64().abs()
    }

    fn any_size() -> impl Strategy<Value = f64> {
        (-300..300_i32, 1.0..10.0_f64, any::<bool>()).prop_map(|(power, x, negative)| {
            let x = x * 10.0_f64.powi(power);
            if negative { -x } else { x }
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5000))]
        #[test]
        fn it_is_right_to_two_units(angle in -3.2..3.2_f64, size in any_size()) {
            let (y, x) = (size * angle.sin(), size * angle.cos());
            prop_assert!(error(y, x) < 2.0, "{y:e} {x:e}: {}", error(y, x));
        }

        #[test]
        fn it_is_right_whatever_the_sizes(y in any_size(), x in any_size()) {
            prop_assert!(error(y, x) < 2.0 || y.atan2(x).abs() < f64::MIN_POSITIVE, "{y:e} {x:e}: {}", error(y, x));
        }
    }

    #[test]
    fn special_values_are_those_of_the_library() {
        let sizes = [0.0, 5e-324, f64::MIN_POSITIVE, 1.0, 1e150, f64::MAX, f64::INFINITY, f64::NAN];
        for y in sizes.into_iter().flat_map(|x| [x, -x]) {
            for x in sizes.into_iter().flat_map(|x| [x, -x]) {
                let (found, expected) = (angle(y, x), y.atan2(x));
                assert!(
                    found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan(),
                    "{y:e} {x:e}: {found} {expected}"
                );
            }
        }
    }
}
