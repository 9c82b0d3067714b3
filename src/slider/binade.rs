//! Powers of two that bring a line to unit size, so that squares and products neither over- nor underflow.

use crate::scalar::Scalar;

/// A power of two and its reciprocal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Binade {
    pub(super) unit: f64,
    pub(super) per_unit: f64,
}

/// The bits of the exponent.
const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
/// The exponent of 2¹⁰²², whose reciprocal is still a normal number.
const LARGEST: u64 = 0x7fd0_0000_0000_0000;

impl Binade {
    /// The largest power of two that is not above the largest of the numbers, within 2⁻¹⁰²² … 2¹⁰²².
    #[inline]
    pub(super) fn of<D: Scalar>(numbers: &[D]) -> Self {
        let largest = numbers.iter().fold(f64::MIN_POSITIVE, |largest, x| largest.max(x.re().abs()));
        let exponent = (largest.to_bits() & EXPONENT).min(LARGEST);
        Self { unit: f64::from_bits(exponent), per_unit: f64::from_bits(EXPONENT - (1 << 52) - exponent) }
    }
}
