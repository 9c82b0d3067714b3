//! The bits of a number of 237 bits: its exponent, powers of two, and the nearest double.

use ::f256::f256;

/// Fraction bits of `f256` in the upper half of its bits; the lower half holds the other 128.
pub(super) const HIGH_FRACTION_BITS: u32 = 108;

/// The bias of the stored exponent of `f256`.
pub(super) const BIAS: i32 = 262_143;

/// e of a finite |x| = 1.fraction · 2^e; −262143 if x is subnormal or zero.
pub(super) fn exponent(x: f256) -> i32 {
    let stored = x.to_bits().0 >> HIGH_FRACTION_BITS & 0x7_ffff;
    i32::try_from(stored).expect("19 bits fit") - BIAS
}

/// 2^e, for e from −262142 to 262143.
pub(super) const fn power_of_two(e: i32) -> f256 {
    f256::from_bits((((BIAS + e).unsigned_abs() as u128) << HIGH_FRACTION_BITS, 0))
}

/// x · 2^e, rounded only if the result is subnormal.
pub(super) fn scale_by_power_of_two(x: f256, e: i32) -> f256 {
    if e < 0 { x.div_pow2(e.unsigned_abs()) } else { x.mul_pow2(e.unsigned_abs()) }
}

/// The first 64 bits of the significand 1.fraction; the last of them is set if any lower bit is non-zero.
pub(super) fn leading_bits(x: f256) -> u64 {
    const CUT: u32 = HIGH_FRACTION_BITS - 63;
    let (high, low) = x.to_bits();
    let fraction = high & ((1 << HIGH_FRACTION_BITS) - 1);
    let rest = u64::from(fraction & ((1 << CUT) - 1) != 0 || low != 0);
    (1 << 63) | u64::try_from(fraction >> CUT).expect("63 bits fit") | rest
}

/// The `f64` nearest to `significand · 2^(exponent − 63)`, where the highest bit of `significand` is set.
pub(super) fn nearest_f64(significand: u64, exponent: i32) -> f64 {
    if exponent > f64::MAX_EXP - 1 {
        return f64::INFINITY;
    }
    // An f64 has 53 bits: 11 bits are dropped, and more below its smallest normal number.
    let missing = (f64::MIN_EXP - 1 - exponent).max(0).unsigned_abs();
    let drop = 11 + missing;
    if drop > 64 {
        return 0.0;
    }
    let kept = if drop < 64 { significand >> drop } else { 0 };
    let rest = u128::from(significand) - (u128::from(kept) << drop);
    let half = 1_u128 << (drop - 1);
    let up = rest > half || rest == half && kept & 1 == 1;
    // The leading bit of a normal number adds one to the stored exponent; a carry may do so again, up to infinity.
    let stored = if missing > 0 { 0 } else { exponent - f64::MIN_EXP + 1 };
    f64::from_bits((u64::from(stored.unsigned_abs()) << 52) + kept + u64::from(up))
}
