//! `f64` as a number that formulas compute with.

use crate::number::angle::{angle, angles};
use crate::number::asin::asin;
use crate::number::eft::exact_sum;
use crate::number::exp::exp_m1;
use crate::number::scalar::{Leaf, Scalar, itself};
use crate::number::squares::Squares;

/// 2⁻⁹⁰⁰ … 2¹⁰⁰⁰, factor 2⁶⁰⁰.
pub(crate) const SQUARES: Squares = Squares::new(-900, 1000, 600);

impl Leaf for f64 {
    const EPSILON: f64 = Self::EPSILON;
    #[inline]
    fn pi() -> Self {
        std::f64::consts::PI
    }
    #[inline]
    fn e_minus_one() -> Self {
        1.718_281_828_459_045
    }
    #[inline]
    fn constants<const N: usize>(nearest: [f64; N], _: impl FnOnce() -> [Self; N]) -> [Self; N] {
        nearest
    }
    #[inline]
    fn or_larger(self, other: Self) -> Self {
        self.max(other)
    }
    #[inline]
    fn nearest_integer_of(x: Self) -> Self {
        x.round()
    }
    #[inline]
    fn exact_sum(products: impl IntoIterator<Item = [Self; 4]>) -> Self {
        exact_sum(products)
    }
}

impl Scalar for f64 {
    itself!();
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const MINUS_ONE: Self = -1.0;
    #[inline]
    fn norm_of<const N: usize>(x: [Self; N]) -> Self {
        SQUARES.norm(x)
    }
    #[inline]
    fn norm_and_direction_of<const N: usize>(x: [Self; N]) -> (Self, [Self; N]) {
        SQUARES.norm_and_direction(x)
    }
    #[inline]
    fn angle_of(y: Self, x: Self) -> Self {
        angle(y, x)
    }
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
    fn angles_of<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        angles(y, x)
    }
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
    fn asin_of(x: Self) -> Self {
        asin(x)
    }
    #[inline]
    fn exp_m1_of(x: Self) -> Self {
        exp_m1(x)
    }
    #[inline]
    fn abs_of(x: Self) -> Self {
        x.abs()
    }
}
