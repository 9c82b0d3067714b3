//! The arc sine of a scalar product, with value and derivative as accurate close to ±1 as the components allow.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use crate::formula::error::Error;
use crate::number::scalar::{Leaf, Scalar, abs, asin, choice, constant, pi, sign};
use nalgebra::Vector3;

/// Above this |sin β| the difference 1 − |sin β| is formed without rounding errors.
const STEEP: f64 = 0.99;
/// π/2 minus the double below it.
const FRAC_PI_2_LOW: f64 = 6.123_233_995_736_766e-17;

/// asin(a·b), ±90° beyond ±1.
#[inline(always)]
pub(super) fn arc_sine<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    let sine = a.dot(b);
    if D::ignores_extremes() {
        return asin(sine);
    }
    let is_gentle = abs(sine) < STEEP;
    if !D::has_extremes() {
        return gentle_or_steep(is_gentle, sine, shortfall(a, b));
    }
    if is_gentle { asin(sine) } else { steep_arc_sine([*a, *b]) }
}

/// Passed by value, as in [`steep_slope`]: references would keep the vectors in memory on all paths.
#[cold]
fn steep_arc_sine<D: Scalar>([a, b]: [Vector3<D>; 2]) -> D {
    let (sine, shortfall) = (a.dot(&b), shortfall(&a, &b));
    if shortfall > 0.0 { gentle_or_steep(false, sine, shortfall) } else { asin(sign(sine)) }
}

/// The arc sine; where it is steep, from the difference of the sine from ±1: the angle differs from 90° by twice the arc sine of
/// √(shortfall/2).
#[inline(always)]
fn gentle_or_steep<D: Scalar>(is_gentle: bool, sine: D, shortfall: D) -> D {
    let angle = asin(if is_gentle { sine } else { (shortfall * 0.5).sqrt() });
    let [low] = D::Leaf::constants([FRAC_PI_2_LOW], || [D::Leaf::from(0.0)]).map(constant::<D>);
    if is_gentle { angle } else { sign(sine) * (pi::<D>() * 0.5 - (angle * 2.0 - low)) }
}

/// The derivative of [`arc_sine`] with respect to a·b, 1/√(1 − (a·b)²), and its square, of which it is computed as the root, so
/// that its powers have few rounding errors. Both are 0 beyond ±1.
#[inline]
pub(crate) fn arc_sine_slope<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> [D; 2] {
    let sine = a.dot(b);
    let is_gentle = abs(sine) < STEEP;
    let gentle = (-sine + 1.0) * (sine + 1.0);
    if D::ignores_extremes() {
        return per_square(gentle);
    }
    if !D::has_extremes() {
        return per_square(if is_gentle { gentle } else { steep_square(shortfall(a, b)) });
    }
    if is_gentle { per_square(gentle) } else { steep_slope([*a, *b]) }
}

#[cold]
fn steep_slope<D: Scalar>([a, b]: [Vector3<D>; 2]) -> [D; 2] {
    let shortfall = shortfall(&a, &b);
    if shortfall > 0.0 { per_square(steep_square(shortfall)) } else { [D::zero(); 2] }
}

/// 1/x and 1/x² from the square x² of a number.
#[inline(always)]
fn per_square<D: Scalar>(square: D) -> [D; 2] {
    let per_square = square.recip();
    [per_square.sqrt(), per_square]
}

/// 1 − (a·b)².
#[inline(always)]
fn steep_square<D: Scalar>(shortfall: D) -> D {
    shortfall * (-shortfall + 2.0)
}

/// 1 − |a·b| as if computed with twice the digits, so that its sign and its leading digits are correct even if a·b rounds to ±1:
/// products and sums are taken together with their rounding errors.
#[inline(always)]
fn shortfall<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    let [side] = choice(|| [D::from(if a.dot(b) < 0.0 { 1.0 } else { -1.0 })]);
    let (mut sum, mut errors) = (D::one(), D::zero());
    for (&a, &b) in a.iter().zip(b) {
        let b = b * side;
        let product = a * b;
        let before = sum;
        sum = before + product;
        let kept = sum - product;
        errors = errors + a.mul_add(b, -product) + ((before - kept) + (product - (sum - kept)));
    }
    sum + errors
}

/// Rejects |e1a·e3b| > 1, which has no arc sine. If several rows are computed at once, the results are not finite there instead.
///
/// # Errors
/// [`Error::NoArcSine`].
#[inline]
pub(super) fn check_arc_sine<D: Scalar>(e1a: &Vector3<D>, e3b: &Vector3<D>) -> Result<(), Error> {
    if !D::has_extremes() || abs(e1a.dot(e3b)) < STEEP {
        return Ok(());
    }
    check_steep(e1a, e3b)
}

#[cold]
fn check_steep<D: Scalar>(e1a: &Vector3<D>, e3b: &Vector3<D>) -> Result<(), Error> {
    let excess = -shortfall(e1a, e3b);
    if excess > 0.0 { Err(Error::NoArcSine { product: "e1a·e3b", excess: excess.re() }) } else { Ok(()) }
}
