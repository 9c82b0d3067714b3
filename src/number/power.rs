//! Powers of two: scaling by one of them does not round.

/// The exponent bits.
const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
/// The exponent of 2¹⁰²², whose reciprocal is still a normal number.
const LARGEST: u64 = 0x7fd0_0000_0000_0000;

/// The largest power of two that is not above a number, within 2⁻¹⁰²² … 2¹⁰²², and its reciprocal.
#[inline]
pub(crate) fn power_of_two_below(x: f64) -> [f64; 2] {
    let exponent = (x.to_bits() & EXPONENT).min(LARGEST);
    [exponent, EXPONENT - (1 << 52) - exponent].map(f64::from_bits)
}

/// 2^exponent, a normal number.
pub(crate) const fn power_of_two(exponent: i64) -> f64 {
    #[expect(clippy::cast_sign_loss, reason = "the biased exponent of a normal double is positive")]
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// The exponent of a positive normal number, which is that of the largest power of two not above it.
#[cfg(feature = "verify")]
pub(crate) const fn exponent(x: f64) -> i64 {
    (x.to_bits() >> 52).cast_signed() - 1023
}
