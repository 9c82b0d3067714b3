//! [`Ordinary`]: one of several doubles that are computed together.

use crate::number::angle::usual_angles;
use crate::number::asin::asin;
use crate::number::double::SQUARES;
use crate::number::exp::exp_m1;
use crate::number::newtype::{newtype_dual_num, newtype_number, newtype_text};
use crate::number::scalar::Scalar;
use num_traits::FromPrimitive;

/// An `f64` that becomes NaN where a formula would branch for extreme numbers.
///
/// A loop over rows of a formula then has no branch that the compiler could not turn into a selection, and it
/// vectorises. Results that are not NaN have the same bits as in `f64`.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
#[repr(transparent)]
pub(crate) struct Ordinary(f64);

impl Ordinary {
    #[inline]
    pub(crate) fn to_f64(self) -> f64 {
        self.0
    }
}

newtype_number!(Ordinary(f64), zero: 0.0, one: 1.0, rem: ::std::ops::Rem::rem);
newtype_dual_num!(Ordinary, f64);
newtype_text!(Ordinary: Display, Debug, LowerExp);

impl Scalar for Ordinary {
    type Leaf = f64;
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);
    const MINUS_ONE: Self = Self(-1.0);
    #[inline]
    fn leaf_of(x: Self) -> f64 {
        x.0
    }
    #[inline]
    fn constant_of(x: f64) -> Self {
        Self(x)
    }
    #[inline]
    fn norm_of<const N: usize>(x: [Self; N]) -> Self {
        SQUARES.norm(x)
    }
    #[inline]
    fn angle_of(y: Self, x: Self) -> Self {
        let [angle] = Self::angles_of([y], [x]);
        angle
    }
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
    fn angles_of<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        usual_angles(y.map(Self::to_f64), x.map(Self::to_f64)).map(Self)
    }
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
    fn asin_of(x: Self) -> Self {
        Self(asin(x.0))
    }
    #[inline]
    fn exp_m1_of(x: Self) -> Self {
        Self(exp_m1(x.0))
    }
    #[inline]
    fn has_extremes() -> bool {
        false
    }
    #[inline]
    fn abs_of(x: Self) -> Self {
        Self(x.0.abs())
    }
}

impl From<f64> for Ordinary {
    #[inline]
    fn from(x: f64) -> Self {
        Self(x)
    }
}

impl FromPrimitive for Ordinary {
    fn from_i64(n: i64) -> Option<Self> {
        f64::from_i64(n).map(Self)
    }
    fn from_u64(n: u64) -> Option<Self> {
        f64::from_u64(n).map(Self)
    }
}

#[cfg(test)]
mod tests {
    use super::Ordinary;
    use num_traits::FromPrimitive;

    #[test]
    fn a_whole_number_is_that_double() {
        let found = [Ordinary::from_i64(-3), Ordinary::from_u64(5), Ordinary::from_u64(u64::MAX)];
        assert_eq!(found.map(|x| x.map(Ordinary::to_f64)), [Some(-3.0), Some(5.0), Some(18_446_744_073_709_551_616.0)]);
    }
}
