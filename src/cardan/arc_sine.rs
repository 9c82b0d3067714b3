//! The arc sine of a scalar product, with value and derivative as good close to ±1 as the components allow.

use crate::error::Error;
use crate::scalar::{Scalar, abs, atan2, number_if, sign};
use nalgebra::Vector3;

/// Above this |sin β| the difference 1 − |sin β| is formed without rounding.
const STEEP: f64 = 0.99;

/// asin(a·b), ±90° beyond ±1.
#[inline]
pub(super) fn arc_sine<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    let sine = a.dot(b);
    if abs(sine) < STEEP {
        return sine.asin();
    }
    let cosine = steep_cosine(a, b);
    if cosine == 0.0 { sign(sine).asin() } else { atan2(sine, cosine) }
}

/// The derivative of [`arc_sine`] with respect to a·b: 1/√(1 − (a·b)²); 0 beyond ±1.
#[inline]
pub(crate) fn arc_sine_slope<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    let sine = a.dot(b);
    let is_gentle = abs(sine) < STEEP;
    if is_gentle || !D::has_extremes() {
        return number_if(is_gentle, ((-sine + 1.0) * (sine + 1.0)).sqrt().recip());
    }
    let cosine = steep_cosine(a, b);
    if cosine == 0.0 { D::zero() } else { cosine.recip() }
}

/// √(1 − (a·b)²) where |a·b| is close to 1; 0 beyond.
#[cold]
fn steep_cosine<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    let shortfall = shortfall(a, b);
    if shortfall > 0.0 { (shortfall * (-shortfall + 2.0)).sqrt() } else { D::zero() }
}

/// 1 − |a·b| as if computed with twice the digits, so that its sign and its leading digits are right even where a·b
/// rounds to ±1: products and sums are taken together with their rounding errors.
fn shortfall<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> D {
    let side = -sign(a.dot(b));
    let (mut sum, mut errors) = (D::one(), D::zero());
    for (&a, &b) in a.iter().zip(b) {
        let b = b * side;
        let product = a * b;
        let before = sum;
        sum = before + product;
        let added = sum - before;
        errors = errors + a.mul_add(b, -product) + ((before - (sum - added)) + (product - added));
    }
    sum + errors
}

/// Rejects |e1a·e3b| > 1, which has no arc sine.
///
/// # Errors
/// [`Error::NoArcSine`].
#[inline]
pub(super) fn check_arc_sine<D: Scalar>(e1a: &Vector3<D>, e3b: &Vector3<D>) -> Result<(), Error> {
    if abs(e1a.dot(e3b)) < STEEP {
        return Ok(());
    }
    check_steep(e1a, e3b)
}

#[cold]
fn check_steep<D: Scalar>(e1a: &Vector3<D>, e3b: &Vector3<D>) -> Result<(), Error> {
    let excess = -shortfall(e1a, e3b);
    if excess > 0.0 { Err(Error::NoArcSine { product: "e1a·e3b", excess: excess.re() }) } else { Ok(()) }
}
