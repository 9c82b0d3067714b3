//! The square root, correctly rounded in a quarter of the time that `f256` takes: it is a fifth of what an audit computes.

use super::bits::{exponent, leading_bits, nearest_f64};
use f256::f256;

/// Doubles have these exponents, with room for what is squared.
const EXPONENTS: std::ops::Range<i32> = -1000..1000;

/// √x: from the root in `f64` by Newton's method, held to what is left of x; where that is not sure of the last bit, by
/// `f256`.
pub(super) fn sqrt(x: f256) -> f256 {
    if x.is_sign_negative() || !EXPONENTS.contains(&exponent(x)) {
        return x.sqrt();
    }
    // 53, 106 and 212 digits.
    let mut reciprocal = f256::from(nearest_f64(leading_bits(x), exponent(x)).sqrt().recip());
    for _ in 0..2 {
        let error = f256::ONE - x * (reciprocal * reciprocal);
        reciprocal += (reciprocal * error).div2();
    }
    let near = x * reciprocal;
    let root = near + (left(x, near) * reciprocal).div2();
    if is_nearest(root, left(x, root)) { root } else { x.sqrt() }
}

/// x − s², rounded once.
fn left(x: f256, s: f256) -> f256 {
    (-s).mul_add(s, x)
}

/// Whether s is less than half an ulp from the root: |x − s²| < s ulp(s), for s ± ½ ulp(s) have the squares s² ± s ulp(s) + ¼ ulp(s)²,
/// and x − s² is a multiple of ulp(s)². Below a power of two the next number is at half the distance.
fn is_nearest(s: f256, left: f256) -> bool {
    let limit = s * s.ulp();
    if left.is_sign_negative() && is_power_of_two(s) { -left < limit.div2() } else { left.abs() < limit }
}

fn is_power_of_two(s: f256) -> bool {
    s == super::bits::power_of_two(exponent(s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::octuple::bits::power_of_two;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    /// As `f256` itself, which needs no start: at random, at squares, beside squares of the middle between two numbers, where
    /// rounding is hardest, and beside powers of two.
    #[test]
    fn every_bit_is_that_of_f256() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let mut fraction = || {
            let words = [(); 4].map(|()| u128::from(random.next_u64()));
            let bits = ((words[0] << 64 | words[1]) >> 20, words[2] << 64 | words[3]);
            f256::from_bits((power_of_two(0).to_bits().0 | bits.0, bits.1))
        };
        for k in 0..2000 {
            let s = fraction();
            let steps = f256::from(k % 9 - 4);
            let beside = |x: f256| x + x.ulp().div2() * steps;
            let hard = [s, s * s, s * s + s * s.ulp(), beside(s * s), beside(power_of_two(k % 7 - 3))];
            for x in hard.into_iter().flat_map(|x| [x, x * power_of_two(k - 1000)]) {
                assert_eq!(sqrt(x), x.sqrt(), "{x:?}");
            }
        }
    }

    #[test]
    fn what_has_no_root_in_doubles_is_left_to_f256() {
        for x in [f256::ZERO, f256::NEG_ZERO, f256::INFINITY, f256::NEG_ONE, f256::NAN, f256::MIN_GT_ZERO, f256::MAX] {
            assert_eq!(sqrt(x).to_bits(), x.sqrt().to_bits());
        }
    }
}
