//! A power of two near the size of some numbers, as a unit for them.

use crate::number::scalar::{Leaf, Scalar, abs, constant, is_between, leaf};

/// Numbers between 1/2³² and 2³², and their reciprocals, are far from both limits of the exponent.
const USUAL: f64 = 4_294_967_296.0;

/// A power of two, and its reciprocal: in this unit, squares and products of some numbers neither over- nor underflow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Binade<D> {
    pub(crate) unit: D,
    pub(crate) per_unit: D,
}

impl<D: Scalar> Binade<D> {
    /// The largest power of two that is not above the largest of the numbers, within 2⁻¹⁰²² … 2¹⁰²²; or 1 where the
    /// largest number is of usual size, which changes no digit.
    #[inline]
    pub(crate) fn of(numbers: impl IntoIterator<Item = D>) -> Self {
        if D::ignores_extremes() {
            return Self { unit: D::one(), per_unit: D::one() };
        }
        let least = D::Leaf::from(f64::MIN_POSITIVE);
        let largest = numbers.into_iter().fold(least, |largest, x| largest.or_larger(abs(leaf(x))));
        // Everything that follows would wait for the unit, whereas the processor can predict this branch.
        if D::takes_shortcuts() && D::has_extremes() && is_between(largest, 1.0 / USUAL, USUAL) {
            return Self { unit: D::one(), per_unit: D::one() };
        }
        let [unit, per_unit] = largest.power_of_two_below().map(constant);
        Self { unit, per_unit }
    }
}

#[cfg(test)]
mod tests {
    use super::Binade;
    use crate::number::power::power_of_two;

    #[test]
    fn the_unit_is_next_below_the_largest_number_if_that_is_not_usual_and_both_powers_are_normal() {
        for (numbers, exponent) in [
            ([0.0, 0.0], -1022),
            ([0.0, f64::from_bits(1)], -1022),
            ([1e-10, 2e-10], -33),
            ([3e-10, -1e-300], 0),
            ([0.1, -3.9], 0),
            ([4e9, 1e-300], 0),
            ([4e9, -5e9], 32),
            ([f64::MAX, -1.0], 1022),
        ] {
            let Binade { unit, per_unit } = Binade::of(numbers);
            assert_eq!([unit, per_unit], [exponent, -exponent].map(power_of_two), "{numbers:?}");
        }
    }
}
