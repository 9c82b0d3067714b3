//! [`Octuple`]: 237-bit arithmetic, the reference for all other computations.

mod bits;
mod convert;
mod decimal;
mod elementary;
mod hyperbolic;
mod power;
mod root;
#[cfg(test)]
mod upstream;

use f256::f256;
use num_dual::DualNum;

use crate::number::eft::exact_sum;
use crate::number::newtype::{newtype_dual_num, newtype_number};
use crate::number::power::power_of_two;
use crate::number::scalar::{Leaf, Scalar, itself, sum_of_squares};

/// A binary floating point number of 237 significant bits (71 decimal digits) and exponents up to ±262143: IEEE 754
/// binary256, by the crate `f256`, with that crate's gaps and defects repaired.
///
/// It is `Copy`, it implements [`DualNum`] over `f64`, so every formula of this crate and every dual number of
/// `num-dual` works with it unchanged. The same program gives the same bits on every machine, because all of it is
/// integer arithmetic.
///
/// # Accuracy
///
/// Errors are in units in the last place (ulps) of the result, where that is a normal number. Each bound is checked
/// against exact values by `tests/octuple.rs`, which holds the same table.
///
/// | operation | error at most |
/// |---|---|
/// | + − × ÷ √ %, `mul_add`, conversion from and to `f64` and decimal | ½: the nearest number, ties to even |
/// | `sin` `cos` `cbrt` `exp` `exp2` `ln` `log` `log2` `log10`, `powi` | 0.51 |
/// | `asin` `atan` `atan2` `exp_m1` | 1 |
/// | `tan` `acos` `ln_1p` `powf`, hyperbolic functions and their inverses, `sph_j0` | 2 |
/// | `sph_j1` `sph_j2` | 4, in ulps of the larger of the value and 1/\|x\| |
///
/// A result below 2^-261000 may be rounded twice. Special values are those of `f64` (C99, Annex F): zeros and
/// infinities with their signs, NaN. No operation panics, whatever its operands.
///
/// ```
/// # use jointproof::Octuple;
/// use num_dual::DualNum;
/// let third = Octuple::from(1.0) / 3.0;
/// assert_eq!(format!("{third:.40}"), "0.3333333333333333333333333333333333333333");
/// assert_eq!(Octuple::from(2.0).sqrt().to_f64(), 2.0_f64.sqrt());
/// ```
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct Octuple(f256);

newtype_number!(Octuple(f256), zero: f256::ZERO, one: f256::ONE, rem: elementary::rem);
newtype_dual_num!(Octuple, elementary);

impl Octuple {
    /// π, correctly rounded.
    pub const PI: Self = Self(::f256::consts::PI);
    /// Euler's number e, correctly rounded.
    pub const E: Self = Self(::f256::consts::E);
    /// The distance from 1 to the next larger number, 2^-236 ≈ 9.06e-72.
    pub const EPSILON: Self = Self(f256::EPSILON);
    /// The largest finite number, about 1.6e78913.
    pub const MAX: Self = Self(f256::MAX);
    /// The smallest positive normal number, 2^-262142 ≈ 2.5e-78913.
    pub const MIN_POSITIVE: Self = Self(f256::MIN_POSITIVE);
    /// +∞.
    pub const INFINITY: Self = Self(f256::INFINITY);
    /// Not a number.
    pub const NAN: Self = Self(f256::NAN);

    /// Whether this is neither infinite nor NaN.
    #[must_use]
    pub const fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    /// Whether this is NaN.
    #[must_use]
    pub const fn is_nan(self) -> bool {
        self.0.is_nan()
    }

    /// The distance to the next number further from zero: the unit in which errors are stated. NaN if not finite.
    #[must_use]
    pub fn ulp(self) -> Self {
        Self(self.0.ulp())
    }
}

impl Leaf for Octuple {
    const EPSILON: f64 = power_of_two(-236);
    fn pi() -> Self {
        Self::PI
    }
    fn e_minus_one() -> Self {
        Self::E - 1.0
    }
    fn constants<const N: usize>(_: [f64; N], definition: impl FnOnce() -> [Self; N]) -> [Self; N] {
        definition()
    }
    fn nearest_integer_of(x: Self) -> Self {
        Self::from(x.to_f64().round())
    }
    #[inline]
    fn exact_sum(products: impl IntoIterator<Item = [Self; 4]>) -> Self {
        exact_sum(products)
    }
}

/// The range of exponents is so wide that the square of a double never over- or underflows.
impl Scalar for Octuple {
    itself!();
    const ZERO: Self = Self(f256::ZERO);
    const ONE: Self = Self(f256::ONE);
    const MINUS_ONE: Self = Self(f256::NEG_ONE);
    fn norm_of<const N: usize>(x: [Self; N]) -> Self {
        DualNum::sqrt(&sum_of_squares(x))
    }
    fn angle_of(y: Self, x: Self) -> Self {
        DualNum::atan2(&y, x)
    }
}
