//! Numbers modulo the prime 2⁶¹ − 1, at a few points at once.
//!
//! Two rational functions are the same if they agree at random points of a finite field: others of degree d agree at one point with
//! probability d/2⁶¹, so at all of them hardly ever. No rounding disturbs the comparison.

use num_rational::Ratio;

/// The number of points.
pub(super) const POINTS: usize = 8;
/// The prime; −1 has no root modulo it.
const PRIME: u64 = (1 << 61) - 1;
/// Numerators and denominators of factors are smaller.
const SMALL: u64 = 1 << 24;

/// A factor of a part, an amount, or a bound.
pub type Rational = Ratio<i128>;
/// A number at every point.
pub(super) type Values = [u64; POINTS];

pub(super) fn add(x: u64, y: u64) -> u64 {
    let sum = x + y;
    if sum >= PRIME { sum - PRIME } else { sum }
}

pub(super) fn negative(x: u64) -> u64 {
    if x == 0 { 0 } else { PRIME - x }
}

#[expect(clippy::cast_possible_truncation, reason = "61 bits each")]
pub(super) fn multiply(x: u64, y: u64) -> u64 {
    // 2⁶¹ is 1 more than the prime.
    let product = u128::from(x) * u128::from(y);
    add((product & u128::from(PRIME)) as u64, (product >> 61) as u64)
}

fn power(mut x: u64, mut exponent: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = multiply(result, x);
        }
        x = multiply(x, x);
        exponent >>= 1;
    }
    result
}

/// 1/x; `None` for 0.
pub(super) fn inverse(x: u64) -> Option<u64> {
    let (one, inverse) = divided(x, 2);
    (one == 1).then(|| of_integer(inverse.into()))
}

/// A number r below a limit and a number s with r = s x, by Euclid's algorithm.
fn divided(x: u64, limit: u64) -> (i64, i64) {
    let [prime, x, limit] = [PRIME, x, limit].map(u64::cast_signed);
    let (mut remainder, mut next, mut old, mut new) = (prime, x, 0, 1);
    while next >= limit {
        let quotient = remainder / next;
        (remainder, next) = (next, remainder - quotient * next);
        (old, new) = (new, old - quotient * new);
    }
    (next, new)
}

/// A root, if there is one.
pub(super) fn root(x: u64) -> Option<u64> {
    let root = power(x, (PRIME + 1) / 4);
    (multiply(root, root) == x).then_some(root)
}

fn of_integer(x: i128) -> u64 {
    u64::try_from(x.rem_euclid(i128::from(PRIME))).expect("a remainder is below the prime")
}

pub(super) fn of_rational(x: Rational) -> Option<u64> {
    inverse(of_integer(*x.denom())).map(|inverse| multiply(of_integer(*x.numer()), inverse))
}

/// The fraction of small numbers that this is, if it is one.
pub(super) fn to_rational(x: u64) -> Option<Rational> {
    let (numerator, denominator) = divided(x, SMALL);
    (denominator != 0 && denominator.unsigned_abs() < SMALL)
        .then(|| Rational::new(numerator.into(), denominator.into()))
}

/// The nearest double, or one next to it.
#[expect(clippy::cast_precision_loss, reason = "as it says")]
pub(super) fn to_f64(x: Rational) -> f64 {
    *x.numer() as f64 / *x.denom() as f64
}

/// A number that looks random, from what distinguishes it from others.
pub(super) fn random(seed: [u64; 3]) -> u64 {
    let mix = |state: u64, word: u64| {
        // SplitMix64.
        let mut z = (state ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    seed.into_iter().fold(0, mix) % PRIME
}

/// x y at every point.
pub(super) fn product(x: &Values, y: &Values) -> Values {
    std::array::from_fn(|k| multiply(x[k], y[k]))
}

/// x + y at every point.
pub(super) fn sum(x: &Values, y: &Values) -> Values {
    std::array::from_fn(|k| add(x[k], y[k]))
}

/// Subtracts the multiple of another row that makes this place 0, where the other has 1.
pub(super) fn subtract(row: &mut [u64], other: &[u64], place: usize) {
    let factor = negative(row[place]);
    if factor != 0 {
        row.iter_mut().zip(other).filter(|(_, y)| **y != 0).for_each(|(x, y)| *x = add(*x, multiply(factor, *y)));
    }
}

/// −x at every point.
pub(super) fn opposite(x: &Values) -> Values {
    x.map(negative)
}

/// 1/x at every point, or 0 where there is none, which makes no part.
pub(super) fn reciprocal(x: &Values) -> Values {
    x.map(|x| inverse(x).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_come_back_and_roots_are_roots() {
        for (numerator, denominator) in [(0, 1), (1, 1), (-1, 2), (5, 3), (-12_345, 678_910)] {
            let fraction = Rational::new(numerator, denominator);
            assert_eq!(of_rational(fraction).and_then(to_rational), Some(fraction));
        }
        assert_eq!((inverse(0), to_rational(random([1, 2, 3]))), (None, None));
        let x = random([4, 5, 6]);
        assert_eq!(inverse(x).map(|inverse| multiply(x, inverse)), Some(1));
        let square = multiply(x, x);
        assert!(root(square).is_some_and(|root| root == x || root == negative(x)));
        assert_eq!(root(negative(square)), None);
    }
}
