//! Lengths of vectors whose squared components may over- or underflow.

use crate::number::power::power_of_two;
use crate::number::scalar::{Scalar, abs, cold_path, direction_of_length, is_between, number_if, sum_of_squares};

/// The range in which sums of squares need no scaling, and the power of two that scales everything else into it.
pub(crate) struct Squares {
    smallest: f64,
    largest: f64,
    rescale: f64,
}

impl Squares {
    /// From the exponents of the two limits of the sum and of the factor.
    pub(crate) const fn new(smallest: i64, largest: i64, rescale: i64) -> Self {
        Self { smallest: power_of_two(smallest), largest: power_of_two(largest), rescale: power_of_two(rescale) }
    }

    #[inline]
    pub(crate) fn norm<D: Scalar, const N: usize>(&self, x: [D; N]) -> D {
        let sum = sum_of_squares(x);
        let is_usual = is_between(sum, self.smallest, self.largest);
        if is_usual || !D::has_extremes() { number_if(is_usual, sum.sqrt()) } else { self.rescaled(x) }
    }

    /// The norm and the direction, also of extreme numbers. Vectors of usual size skip the test for a subnormal length.
    #[inline]
    pub(crate) fn norm_and_direction<D: Scalar, const N: usize>(&self, x: [D; N]) -> (D, [D; N]) {
        let sum = sum_of_squares(x);
        if is_between(sum, self.smallest, self.largest) {
            let length = sum.sqrt();
            return (length, x.map(|x| x / length));
        }
        let length = self.rescaled(x);
        (length, direction_of_length(x, length))
    }

    #[inline(always)]
    #[expect(
        clippy::inline_always,
        reason = "a call would need the components in memory, on the way that is usual too"
    )]
    fn rescaled<D: Scalar, const N: usize>(&self, x: [D; N]) -> D {
        cold_path();
        let large = x.iter().any(|&x| abs(x) > 1.0);
        let factor = if large { self.rescale.recip() } else { self.rescale };
        sum_of_squares(x.map(|x| x * factor)).sqrt() / factor
    }
}
