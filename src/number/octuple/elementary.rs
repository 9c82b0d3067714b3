//! The elementary functions of [`Octuple`](super::Octuple) on the `f256` inside.
//!
//! `f256` 0.11.3 computes nearly all of them to half an ulp. Where it does not, the comment "f256:" names the defect,
//! and the function repairs it; repairs are only here and in [`super::power`]. For each defect a test in `upstream.rs`
//! fails once `f256` has fixed it, and then the repair can be removed.

use ::f256::consts::{FRAC_3_PI_2, FRAC_PI_2, FRAC_PI_4, PI};
use f256::f256;

use super::bits::{exponent, power_of_two, scale_by_power_of_two};
pub(super) use super::hyperbolic::{acosh, asinh, atanh, cosh, sinh, tanh};
pub(super) use super::power::{powf, powi};
pub(super) use super::root::sqrt;

/// Below this, x² is negligible compared with 1: sin x, tan x, sinh x and their inverses are x to within 0.1 ulp.
pub(super) const TINY: f256 = power_of_two(-120);
/// Below this, x is negligible compared with 1: exp x − 1 is x to within 0.1 ulp.
const MINUTE: f256 = power_of_two(-240);

/// π/2 minus [`FRAC_PI_2`], which is 0.45 ulp.
const FRAC_PI_2_TAIL: f256 = f256::from_bits((
    power_of_two(-238).to_bits().0 | 0xcd9_128a_5043_cc71_a026_ef7c_a8cd,
    0x9e69_d218_d981_5853_6f92_f8a1_ba7f_09ab,
));

/// f256: a remainder of zero is +0 even if x is negative.
pub(super) fn rem(x: f256, y: f256) -> f256 {
    let remainder = x % y;
    if remainder.eq_zero() { remainder.copysign(x) } else { remainder }
}

pub(super) fn recip(x: f256) -> f256 {
    f256::ONE / x
}

pub(super) fn cbrt(x: f256) -> f256 {
    x.cbrt()
}

/// f256: fails debug assertions and gives wrong digits where the product or the sum is near the ends of the exponent range.
///
/// There the factors are scaled to [1, 2) and the addend with them, as far as it matters; the result is scaled back, which rounds
/// a second time if it is subnormal.
pub(super) fn mul_add(x: f256, y: f256, addend: f256) -> f256 {
    const HARMLESS: i32 = 60_000;
    let operands = [x, y, addend];
    if operands.iter().all(|v| exponent(*v).abs() < HARMLESS) || operands.iter().any(|v| v.is_special()) {
        return x.mul_add(y, addend);
    }
    let [(x, ex), (y, ey), (a, ea)] = operands.map(significand);
    let product = ex + ey;
    match ea - product {
        // The product is less than a quarter ulp of the addend, in either direction.
        500.. => addend,
        // The addend at most breaks a tie.
        gap => scale_by_power_of_two(x.mul_add(y, scale_by_power_of_two(a, gap.max(-600))), product),
    }
}

/// x = m · 2^e with 1 ≤ |m| < 2, for a finite x other than zero.
pub(super) fn significand(x: f256) -> (f256, i32) {
    // A subnormal number is first scaled to a normal one.
    let lift = if x.is_subnormal() { 237 } else { 0 };
    let x = scale_by_power_of_two(x, lift);
    let e = exponent(x);
    (scale_by_power_of_two(x, -e), e - lift)
}

/// f256: results below 2^-262144 become zero though numbers down to 2^-262378 exist.
pub(super) fn exp(x: f256) -> f256 {
    if x < f256::from(-181_000) {
        return x.div2().exp().square();
    }
    x.exp()
}

/// f256: as with [`exp`]; whole exponents are right.
pub(super) fn exp2(x: f256) -> f256 {
    if x < f256::from(-262_000) && x != x.trunc() {
        return x.div2().exp2().square();
    }
    x.exp2()
}

/// f256: −0 and subnormal numbers become +0.
pub(super) fn exp_m1(x: f256) -> f256 {
    if x.abs() < MINUTE { x } else { x.exp_m1() }
}

pub(super) fn ln(x: f256) -> f256 {
    x.ln()
}

/// f256: the logarithm of 1 is +0 also for bases below 1, where ln 1 / ln base is −0.
pub(super) fn log(x: f256, base: f256) -> f256 {
    let quotient = x.log(&base);
    if x == f256::ONE && base < f256::ONE { -quotient.abs() } else { quotient }
}

pub(super) fn log2(x: f256) -> f256 {
    x.log2()
}

pub(super) fn log10(x: f256) -> f256 {
    x.log10()
}

/// f256: NaN for every x in (−1, 0).
///
/// There 1 + x is a rounded sum s and its exact error e, and ln(s + e) = ln s + e/s up to (e/s)²/2 < 2^-475.
pub(super) fn ln_1p(x: f256) -> f256 {
    if x < f256::ZERO && x > f256::NEG_ONE {
        let sum = f256::ONE + x;
        let error = x - (sum - f256::ONE);
        return sum.ln() + error / sum;
    }
    x.ln_1p()
}

/// f256: sin −0 is +0, and its 492 bits after the point do not suffice below 2^-256.
pub(super) fn sin(x: f256) -> f256 {
    if x.abs() < TINY { x } else { x.sin() }
}

pub(super) fn cos(x: f256) -> f256 {
    x.cos()
}

/// f256: as with [`sin`].
pub(super) fn tan(x: f256) -> f256 {
    if x.abs() < TINY { x } else { x.tan() }
}

/// f256: as with [`sin`].
pub(super) fn sin_cos(x: f256) -> (f256, f256) {
    if x.abs() < TINY { (x, f256::ONE) } else { x.sin_cos() }
}

/// f256: loses half the digits near ±1, where √(1 − x²) cancels.
pub(super) fn asin(x: f256) -> f256 {
    if x.abs() > f256::from(0.999) {
        return (FRAC_PI_2 - (acos_of_one_minus(f256::ONE - x.abs()) - FRAC_PI_2_TAIL)).copysign(x);
    }
    x.asin()
}

/// f256: as with [`asin`].
pub(super) fn acos(x: f256) -> f256 {
    if x > f256::from(0.5) {
        return acos_of_one_minus(f256::ONE - x);
    }
    if x < f256::from(-0.999) {
        return PI - acos_of_one_minus(f256::ONE + x);
    }
    x.acos()
}

/// arccos(1 − d) = 2 arcsin √(d/2), for the exact d; NaN if d < 0.
fn acos_of_one_minus(d: f256) -> f256 {
    d.div2().sqrt().asin().mul2()
}

pub(super) fn atan(x: f256) -> f256 {
    x.atan()
}

/// f256: returns π/2 instead of π/4 where |y| = |x|; drops signs of zeros; treats one infinity as two; has few or no
/// digits for quotients below 2^-256.
pub(super) fn atan2(y: f256, x: f256) -> f256 {
    let ahead = x.is_sign_positive();
    let (height, width) = (y.abs(), x.abs());
    let angle = if y.is_nan() || x.is_nan() {
        return f256::NAN;
    } else if height.eq_zero() || width.is_infinite() && height.is_finite() {
        if ahead { f256::ZERO } else { PI }
    } else if width.eq_zero() || height.is_infinite() && width.is_finite() {
        FRAC_PI_2
    } else if height == width {
        if ahead { FRAC_PI_4 } else { FRAC_3_PI_2.div2() }
    } else if ahead && height < width * TINY {
        height / width
    } else {
        height.atan2(&x)
    };
    angle.copysign(y)
}
