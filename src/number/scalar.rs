//! The numbers that formulas compute with.
//!
//! A formula is written once, generic over [`Scalar`], and runs in `f64`, in other numbers without derivatives (the
//! exact reference of 237 bits, single precision), and in every dual number of `num-dual` over these.
//!
//! Three functions are here because the standard ones lose their derivative or their value at ordinary positions of a
//! joint. [`norm`] neither overflows nor underflows and has derivative 0 at the zero vector; [`atan2`] has the right
//! derivative at ±90° and ±180°; [`abs`] has derivative 0 at 0. All three hold for second derivatives too. [`asin`]
//! has the same bits on every machine, and no branch.
//!
//! Comparisons between dual numbers use the real part only, which is what a branch of a formula means; to compare
//! derivatives, compare the parts.

use crate::number::power::{power_of_two, power_of_two_below};
use num_dual::DualNum;

/// A number that formulas compute with: real, or carrying derivatives.
///
/// `Primitive = f64` lets formulas use plain literals for every scalar, with `2.0 * x` written as `x * 2.0`. The
/// methods are the guarded elementary functions; call them by the free functions [`norm`], [`atan2`], [`asin`] and
/// [`abs`].
pub trait Scalar: DualNum<Primitive = f64> + Copy + Send + Sync + nalgebra::Scalar {
    /// The number without its derivatives.
    type Leaf: Leaf;
    /// 0, as a compile-time constant: derivatives that are the same everywhere are copied rather than written one by one.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// −1.
    const MINUS_ONE: Self;
    /// See [`leaf`].
    fn leaf_of(x: Self) -> Self::Leaf;
    /// See [`constant`].
    fn constant_of(x: Self::Leaf) -> Self;
    /// See [`norm`].
    fn norm_of<const N: usize>(x: [Self; N]) -> Self;
    /// See [`norm_and_direction`].
    #[inline]
    fn norm_and_direction_of<const N: usize>(x: [Self; N]) -> (Self, [Self; N]) {
        let length = norm(x);
        if !Self::has_extremes() {
            return (length, x.map(|x| x / length));
        }
        (length, direction_of_length(x, length))
    }
    /// See [`atan2`].
    fn angle_of(y: Self, x: Self) -> Self;
    /// See [`angles`].
    #[inline]
    fn angles_of<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        std::array::from_fn(|k| Self::angle_of(y[k], x[k]))
    }
    /// See [`asin`].
    #[inline]
    fn asin_of(x: Self) -> Self {
        DualNum::asin(&x)
    }
    /// See [`exp_m1`].
    #[inline]
    fn exp_m1_of(x: Self) -> Self {
        DualNum::exp_m1(&x)
    }
    /// See [`choice`].
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is chosen by is at hand where it is compiled in place")]
    fn choice_of<const N: usize>(choose: impl Fn() -> [Self; N]) -> [Self; N] {
        choose()
    }
    /// Whether extreme numbers, which would over- or underflow, are computed by a separate branch. Where several rows
    /// of a batch are computed together they are not, since all rows would wait: they become NaN, as do their results,
    /// and the row is computed again on its own.
    #[inline]
    fn has_extremes() -> bool {
        true
    }
    /// Whether nothing is done about extreme numbers: neither a branch nor NaN. A recorded graph has neither where frameworks for
    /// arrays differentiate it.
    #[inline]
    fn ignores_extremes() -> bool {
        false
    }
    /// Whether to test for shortcuts, which save time and change no result. Recording a graph omits them: it contains
    /// the full computation anyway, and each test would double the number of paths.
    #[inline]
    fn takes_shortcuts() -> bool {
        true
    }
    /// See [`abs`].
    #[inline]
    fn abs_of(x: Self) -> Self {
        let sign = sign(x);
        // +0 for either zero, NaN for NaN, and no derivative.
        if sign == 0.0 { x * 0.0 + 0.0 } else { x * sign }
    }
}

/// A number without derivatives, the innermost type of nested dual numbers: `f64` or another one of any precision.
///
/// Its arithmetic is binary and rounds to nearest.
///
/// Iterations, such as a root search, run on leaves; the result becomes a [`constant`] again, and one step of Newton's
/// method on the full scalar supplies the derivatives (the implicit function theorem).
pub trait Leaf: Scalar<Leaf = Self> {
    /// The distance from 1 to the next larger number.
    const EPSILON: f64;
    /// See [`pi`].
    fn pi() -> Self;
    /// See [`e_minus_one`].
    fn e_minus_one() -> Self;
    /// Constants, given by the nearest doubles and by a definition for numbers with more digits.
    ///
    /// `f64` takes the doubles as they are, so that no formula pays for digits it does not need.
    fn constants<const N: usize>(nearest: [f64; N], definition: impl FnOnce() -> [Self; N]) -> [Self; N];
    /// The larger of two numbers; `self` where the other is NaN.
    #[inline]
    fn or_larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    /// The largest power of two that is not above a positive number, within 2⁻¹⁰²² … 2¹⁰²², and its reciprocal.
    #[inline]
    fn power_of_two_below(self) -> [Self; 2] {
        power_of_two_below(self.re()).map(Self::from)
    }
    /// See [`nearest_integer`].
    fn nearest_integer_of(x: Self) -> Self;
    /// A sum of at most 18 products of four numbers each, of the right sign: only the final sum is rounded.
    fn exact_sum(products: impl IntoIterator<Item = [Self; 4]>) -> Self;
    /// The result of a search from these numbers.
    #[inline]
    fn find<S: Search<N>, const N: usize>(from: [Self; N]) -> Self {
        S::find(from)
    }
}

/// An iteration with as many steps as its numbers need; in a recorded graph it is a single operation.
pub trait Search<const N: usize> {
    /// Its name in other languages.
    const NAME: &'static str;
    /// The result of the search from these numbers.
    fn find<L: Leaf>(from: [L; N]) -> L;
}

/// The number without its derivatives.
///
/// ```
/// use num_dual::Dual64;
/// assert_eq!(jointproof::number::scalar::leaf(Dual64::from_re(2.0).derivative()), 2.0);
/// ```
#[inline]
pub fn leaf<D: Scalar>(x: D) -> D::Leaf {
    D::leaf_of(x)
}

/// A number as a constant, whose derivatives are 0; unlike `D::from(f64)` it keeps every digit of the leaf.
#[inline]
pub fn constant<D: Scalar>(x: D::Leaf) -> D {
    D::constant_of(x)
}

/// A number with another value and the same derivatives.
#[inline]
pub(crate) fn with_leaf<D: Scalar>(x: D, value: D::Leaf) -> D {
    x - constant::<D>(leaf(x)) + constant::<D>(value)
}

/// π, correctly rounded in every scalar.
///
/// ```
/// assert_eq!(jointproof::number::scalar::pi::<f64>(), std::f64::consts::PI);
/// ```
#[inline]
pub fn pi<D: Scalar>() -> D {
    constant(D::Leaf::pi())
}

/// e − 1, within an ulp in every scalar.
///
/// ```
/// assert_eq!(jointproof::number::scalar::e_minus_one::<f64>(), 1.0_f64.exp_m1());
/// ```
#[inline]
pub fn e_minus_one<D: Scalar>() -> D {
    constant(D::Leaf::e_minus_one())
}

/// The nearest integer, which has no derivative; of two that are equally near, the one farther from 0. In 237 bits it is that of the
/// nearest double, so that every number type jumps at the same numbers.
///
/// ```
/// use jointproof::number::scalar::nearest_integer;
/// assert_eq!([0.49999999999999994, 0.5, 2.5, -2.5].map(nearest_integer::<f64>), [0.0, 1.0, 3.0, -3.0]);
/// ```
#[inline]
pub fn nearest_integer<D: Scalar>(x: D) -> D {
    constant(D::Leaf::nearest_integer_of(leaf(x)))
}

/// √(Σ xᵢ²), within about an ulp for every representable input, also if subnormal or near the overflow threshold.
///
/// At the zero vector the derivative is 0, the minimum-norm subgradient.
///
/// ```
/// use jointproof::number::scalar::norm;
/// assert_eq!(norm([3.0, 4.0]), 5.0);
/// assert!((norm([3e-200, 4e-200]) / 5e-200 - 1.0).abs() < 1e-15); // the squares would underflow
/// assert!((norm([3e200, 4e200]) / 5e200 - 1.0).abs() < 1e-15); // the squares would overflow
/// ```
#[inline]
pub fn norm<D: Scalar, const N: usize>(x: [D; N]) -> D {
    D::norm_of(x)
}

/// Whether the length of a vector is a normal number, so that it has a direction. The sum of the magnitudes decides without a
/// root, except for lengths near the limit (the length of up to 16 components is at least a quarter of that sum). When rows are
/// computed together, a row near the limit counts as having no length, and is computed again on its own.
#[inline]
pub(crate) fn has_length<D: Scalar, const N: usize>(x: [D; N]) -> bool {
    const { assert!(N <= 16) };
    let sum = x.into_iter().map(abs).fold(D::zero(), |sum, x| sum + x);
    let is_long = || sum > 4.0 * f64::MIN_POSITIVE || D::has_extremes() && norm(x) >= f64::MIN_POSITIVE;
    let [length] = choice(|| [if is_long() { D::one() } else { D::zero() }]);
    length > 0.0
}

/// x/|x|, the derivative of [`norm`]; the zero vector at the zero vector.
///
/// ```
/// assert_eq!(jointproof::number::scalar::direction([3.0, 4.0]), [0.6, 0.8]);
/// assert_eq!(jointproof::number::scalar::direction([0.0, 0.0]), [0.0, 0.0]);
/// ```
#[inline]
pub fn direction<D: Scalar, const N: usize>(x: [D; N]) -> [D; N] {
    norm_and_direction(x).1
}

/// Both [`norm`] and [`direction`], with a single square root.
#[inline]
pub fn norm_and_direction<D: Scalar, const N: usize>(x: [D; N]) -> (D, [D; N]) {
    D::norm_and_direction_of(x)
}

/// The direction of a vector of this length.
#[inline(always)]
#[expect(clippy::inline_always, reason = "a call would need the components in memory, on the way that is usual too")]
pub(crate) fn direction_of_length<D: Scalar, const N: usize>(x: [D; N], length: D) -> [D; N] {
    if length >= f64::MIN_POSITIVE { divide(x, length) } else { direction_of_subnormal(x) }
}

/// Tells the compiler that the branch in which this is called is seldom taken, as `std::hint::cold_path` does in newer Rust.
#[cold]
#[inline]
pub(crate) fn cold_path() {}

/// The direction of a vector of subnormal length. Such a length has lost digits that the direction needs; scaling by a
/// power of two recovers them.
#[inline(always)]
#[expect(clippy::inline_always, reason = "a call would need the components in memory, on the way that is usual too")]
fn direction_of_subnormal<D: Scalar, const N: usize>(x: [D; N]) -> [D; N] {
    cold_path();
    let x = x.map(|x| x * power_of_two(60));
    divide(x, norm(x))
}

/// The angle of the point (x, y), in (−π, π], with the derivative (x dy − y dx)/(x² + y²) everywhere but at the origin.
///
/// In `f64` it is within two units in the last place; where no coordinate exceeds 1e300 it has the same bits on every machine.
///
/// At the origin the angle has no derivative; this function then returns derivative 0, and a formula that can get there should
/// reject the input (`Formula::validate`).
///
/// ```
/// use jointproof::number::scalar::atan2;
/// use num_dual::Dual64;
/// let upright = atan2(Dual64::from_re(2.0), Dual64::from_re(0.0).derivative());
/// assert_eq!(upright.re, std::f64::consts::FRAC_PI_2);
/// assert_eq!(upright.eps, -0.5); // num-dual's own atan2 gives NaN here
/// ```
#[inline]
pub fn atan2<D: Scalar>(y: D, x: D) -> D {
    D::angle_of(y, x)
}

/// [`atan2`] of several points, which in doubles takes hardly longer than for one.
///
/// ```
/// use jointproof::number::scalar::{angles, atan2};
/// assert_eq!(angles([2.0, 1.0], [0.0, -1.0]), [atan2(2.0, 0.0), atan2(1.0, -1.0)]);
/// ```
#[inline(always)]
#[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
pub fn angles<D: Scalar, const N: usize>(y: [D; N], x: [D; N]) -> [D; N] {
    D::angles_of(y, x)
}

/// The arc sine, with the derivative 1/√(1 − x²), which is infinite at ±1; NaN for |x| > 1.
///
/// In `f64` it is within two units in the last place, and has the same bits on every machine.
///
/// ```
/// use jointproof::number::scalar::asin;
/// let tilted = asin(num_dual::Dual64::from_re(0.6).derivative());
/// assert_eq!((asin(1.0), tilted.eps), (std::f64::consts::FRAC_PI_2, 1.25));
/// ```
#[inline(always)]
#[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
pub fn asin<D: Scalar>(x: D) -> D {
    D::asin_of(x)
}

/// eˣ − 1, with the derivative eˣ.
///
/// In `f64` it is within one unit in the last place; where 1e-300 < |x| < 700 it has the same bits on every machine.
///
/// ```
/// use jointproof::number::scalar::exp_m1;
/// let grown = exp_m1(num_dual::Dual64::from_re(1e-20).derivative());
/// assert_eq!((exp_m1(1.0), grown.re, grown.eps), (1.718_281_828_459_045_3, 1e-20, 1.0));
/// ```
#[inline]
pub fn exp_m1<D: Scalar>(x: D) -> D {
    D::exp_m1_of(x)
}

/// |x|, with derivative 0 at 0.
///
/// ```
/// use num_dual::Dual64;
/// assert_eq!(jointproof::number::scalar::abs(Dual64::from_re(-2.0).derivative()).eps, -1.0);
/// assert_eq!(jointproof::number::scalar::abs(Dual64::from_re(-0.0).derivative()).eps, 0.0);
/// ```
#[inline]
pub fn abs<D: Scalar>(x: D) -> D {
    D::abs_of(x)
}

/// Numbers selected by comparisons on which nothing else depends: a recorder of operations can join the branches here.
///
/// ```
/// use jointproof::number::scalar::choice;
/// let [larger] = choice(|| [if 2.0 > 3.0 { 2.0 } else { 3.0 }]);
/// assert_eq!(larger, 3.0);
/// ```
#[inline(always)]
#[expect(clippy::inline_always, reason = "as of `Scalar::choice_of`")]
pub fn choice<D: Scalar, const N: usize>(choose: impl Fn() -> [D; N]) -> [D; N] {
    D::choice_of(choose)
}

/// Whether a number lies strictly between these bounds, without a branch that would prevent vectorisation.
#[inline]
#[expect(clippy::needless_bitwise_bool, reason = "the branch is what is avoided")]
pub(crate) fn is_between<D: Scalar>(x: D, least: f64, most: f64) -> bool {
    (x > least) & (x < most)
}

/// The number, or NaN where it is [extreme](Scalar::has_extremes). Use it where a formula branches for extreme numbers:
///
/// ```text
/// if is_usual || !D::has_extremes() { number_if(is_usual, x) } else { … }
/// ```
#[inline]
pub(crate) fn number_if<D: Scalar>(is_usual: bool, x: D) -> D {
    if D::ignores_extremes() || is_usual { x } else { D::from(f64::NAN) }
}

/// −1, 0 or 1: the derivative of [`abs`].
#[inline]
pub fn sign<D: Scalar>(x: D) -> D {
    // A difference of two selections compiles to masks; a branch would be mispredicted for every other load.
    let one_if = |condition| if condition { 1.0 } else { 0.0 };
    let [sign] = choice(|| [D::from(one_if(x > 0.0) - one_if(x < 0.0))]);
    sign
}

/// x/length, or zeros where the length is 0.
#[inline]
pub(crate) fn divide<D: Scalar, const N: usize>(x: [D; N], length: D) -> [D; N] {
    if length == 0.0 { [D::zero(); N] } else { x.map(|x| x / length) }
}

#[inline]
pub(crate) fn sum_of_squares<D: Scalar, const N: usize>(x: [D; N]) -> D {
    x.iter().fold(D::zero(), |sum, &x| sum + x * x)
}

/// A leaf is its own leaf.
macro_rules! itself {
    () => {
        type Leaf = Self;
        #[inline]
        fn leaf_of(x: Self) -> Self {
            x
        }
        #[inline]
        fn constant_of(x: Self) -> Self {
            x
        }
    };
}
pub(crate) use itself;
