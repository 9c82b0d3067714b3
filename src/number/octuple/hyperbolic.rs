//! Hyperbolic functions and their inverses, which `f256` does not have.
//!
//! Each is written so that there is no cancellation near 0 (through e^x − 1 and ln(1 + x)) and no premature overflow,
//! and is accurate to two ulps.

use ::f256::consts::LN_2;
use f256::f256;

use super::elementary::{TINY, exp, exp_m1, ln, ln_1p};

/// From here on e^-2x is negligible compared with 1.
const LARGE: u8 = 90;
/// From here on 1/x² is negligible compared with 1.
const HUGE: f256 = super::bits::power_of_two(120);

/// sinh x = (m + m/(m+1))/2 with m = e^x − 1.
pub(super) fn sinh(x: f256) -> f256 {
    let a = x.abs();
    let result = if a < TINY {
        a
    } else if a < f256::ONE {
        let m = exp_m1(a);
        (m + m / (m + f256::ONE)).div2()
    } else if a < f256::from(LARGE) {
        let e = exp(a);
        (e - e.recip()).div2()
    } else {
        half_exp(a)
    };
    result.copysign(x)
}

/// cosh x = (e^x + e^-x)/2.
pub(super) fn cosh(x: f256) -> f256 {
    let a = x.abs();
    if a < f256::from(LARGE) {
        let e = exp(a);
        return (e + e.recip()).div2();
    }
    half_exp(a)
}

/// e^x/2, which is finite for x up to ln 2 beyond the overflow of e^x.
fn half_exp(x: f256) -> f256 {
    const E_X_OVERFLOWS: u32 = 181_704;
    if x < f256::from(E_X_OVERFLOWS) {
        return exp(x).div2();
    }
    let root = exp(x.div2());
    root.div2() * root
}

/// tanh x = m/(m+2) with m = e^2x − 1.
pub(super) fn tanh(x: f256) -> f256 {
    let a = x.abs();
    let result = if a < TINY {
        a
    } else if a < f256::from(LARGE) {
        let m = exp_m1(a.mul2());
        m / (m + f256::TWO)
    } else if a.is_nan() {
        a
    } else {
        f256::ONE
    };
    result.copysign(x)
}

/// asinh x = ln(x + r) = ln(1 + (x + x²/(1+r))) with r = √(x²+1).
pub(super) fn asinh(x: f256) -> f256 {
    let a = x.abs();
    let root = || a.mul_add(a, f256::ONE).sqrt();
    let result = if a < TINY {
        a
    } else if a < f256::ONE {
        ln_1p(a + a.square() / (f256::ONE + root()))
    } else if a < HUGE {
        ln(a + root())
    } else {
        ln(a) + LN_2
    };
    result.copysign(x)
}

/// acosh x = ln(x + r) = ln(1 + (t + r)) with t = x − 1, r = √(x²−1) = √(t(t+2)); NaN for x < 1.
pub(super) fn acosh(x: f256) -> f256 {
    if x < f256::ONE {
        return f256::NAN;
    }
    if x < f256::TWO {
        let t = x - f256::ONE;
        return ln_1p(t + (t * (t + f256::TWO)).sqrt());
    }
    if x < HUGE {
        return ln(x + x.mul_add(x, f256::NEG_ONE).sqrt());
    }
    ln(x) + LN_2
}

/// atanh x = ln(1 + 2x/(1−x))/2; ±∞ at ±1, NaN beyond.
pub(super) fn atanh(x: f256) -> f256 {
    let a = x.abs();
    let result = if a < TINY {
        a
    } else if a > f256::ONE {
        f256::NAN
    } else {
        ln_1p(a.mul2() / (f256::ONE - a)).div2()
    };
    result.copysign(x)
}
