//! A unit near the size of some numbers.

use crate::scalar::{Leaf, Scalar, abs, constant, leaf};

/// A power of two near the size of some numbers, and its reciprocal: in this unit, squares and products of the numbers
/// neither over- nor underflow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Binade<D> {
    pub(crate) unit: D,
    pub(crate) per_unit: D,
}

impl<D: Scalar> Binade<D> {
    /// The largest power of two that is not above the largest of the numbers, within 2⁻¹⁰²² … 2¹⁰²².
    #[inline]
    pub(crate) fn of(numbers: impl IntoIterator<Item = D>) -> Self {
        let least = D::Leaf::from(f64::MIN_POSITIVE);
        let largest = numbers.into_iter().fold(least, |largest, x| largest.or_larger(abs(leaf(x))));
        let [unit, per_unit] = largest.power_of_two_below().map(constant);
        Self { unit, per_unit }
    }
}

#[cfg(test)]
mod tests {
    use super::Binade;
    use crate::power::power_of_two;

    #[test]
    fn the_unit_is_next_below_the_largest_number_and_both_powers_are_normal() {
        for (numbers, exponent) in [
            ([0.0, 0.0], -1022),
            ([0.0, f64::from_bits(1)], -1022),
            ([1.0, -1.0], 0),
            ([0.1, -3.9], 1),
            ([4.0, 1e-300], 2),
            ([f64::MAX, -1.0], 1022),
        ] {
            let Binade { unit, per_unit } = Binade::of(numbers);
            assert_eq!([unit, per_unit], [exponent, -exponent].map(power_of_two), "{numbers:?}");
        }
    }
}
