//! [`Single`]: 24-bit arithmetic behind the interface of the other scalars.

use num_dual::DualNum;
use num_traits::FromPrimitive;

use crate::number::eft::exact_sum;
use crate::number::newtype::{newtype_dual_num, newtype_number, newtype_text};
use crate::number::scalar::{Leaf, Scalar, e_minus_one, itself, pi};
use crate::number::squares::Squares;

/// An `f32` with an interface of `f64`: every operation rounds to 24 bits, every `f64` operand is rounded to `f32` on
/// entry (in comparisons too, so that `Single::from(0.1) == 0.1`).
///
/// It shows what a formula would cost and lose in single precision. Its functions are those of `f32` in the standard
/// library, whose last bit may differ between platforms; the spherical Bessel functions are the project's own, within
/// four ulps of the larger of the value and 1/|x|.
///
/// ```
/// # use jointproof::Single;
/// use num_dual::DualNum;
/// assert_eq!((Single::from(2.0).sqrt() * 3.0).to_f64(), f64::from(2.0f32.sqrt() * 3.0));
/// ```
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct Single(f32);

impl Single {
    /// The value, exactly.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        f64::from(self.0)
    }
}

newtype_number!(Single(f32), zero: 0.0, one: 1.0, rem: ::std::ops::Rem::rem);
newtype_dual_num!(Single, f32);
newtype_text!(Single: Display, Debug, LowerExp);

impl Leaf for Single {
    const EPSILON: f64 = f32::EPSILON as f64;
    #[inline]
    fn pi() -> Self {
        Self::from(pi::<f64>())
    }
    #[inline]
    fn e_minus_one() -> Self {
        Self::from(e_minus_one::<f64>())
    }
    #[inline]
    fn constants<const N: usize>(nearest: [f64; N], _: impl FnOnce() -> [Self; N]) -> [Self; N] {
        nearest.map(Self::from)
    }
    #[inline]
    fn nearest_integer_of(x: Self) -> Self {
        Self(x.0.round())
    }
    #[inline]
    fn exact_sum(products: impl IntoIterator<Item = [Self; 4]>) -> Self {
        exact_sum(products)
    }
}

/// 2⁻⁷⁰ … 2¹²⁰, factor 2⁹⁰.
const SQUARES: Squares = Squares::new(-70, 120, 90);

impl Scalar for Single {
    itself!();
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const MINUS_ONE: Self = Self(-1.0);
    #[inline]
    fn norm_of<const N: usize>(x: [Self; N]) -> Self {
        SQUARES.norm(x)
    }
    #[inline]
    fn angle_of(y: Self, x: Self) -> Self {
        DualNum::atan2(&y, x)
    }
}

impl From<f64> for Single {
    /// The nearest `f32`, ties to even.
    #[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    fn from(value: f64) -> Self {
        Self(value as f32)
    }
}

/// Rounds once: integers are not converted through `f64`.
impl FromPrimitive for Single {
    fn from_i64(n: i64) -> Option<Self> {
        f32::from_i64(n).map(Self)
    }
    fn from_u64(n: u64) -> Option<Self> {
        f32::from_u64(n).map(Self)
    }
    fn from_i128(n: i128) -> Option<Self> {
        f32::from_i128(n).map(Self)
    }
    fn from_u128(n: u128) -> Option<Self> {
        f32::from_u128(n).map(Self)
    }
    fn from_f32(value: f32) -> Option<Self> {
        Some(Self(value))
    }
    fn from_f64(value: f64) -> Option<Self> {
        Some(Self::from(value))
    }
}
