//! Spherical Bessel functions of the first kind, j₀, j₁ and j₂, for any scalar.
//!
//! jₙ(x) = xⁿ/(2n+1)!! · Σₖ (−1)ᵏ x²ᵏ / (2ᵏ k! (2n+3)(2n+5)…(2n+2k+1))  (Abramowitz & Stegun 10.1.2),
//! and in closed form (10.1.11)  j₀ = sin x / x,  j₁ = sin x / x² − cos x / x,
//! j₂ = (3/x³ − 1/x) sin x − 3 cos x / x².
//! The closed forms of j₁ and j₂ lose the digits of 3/x² and 15/x⁴ to cancellation, so the series is used up to
//! [`SERIES_UP_TO`]; there its first term dominates and Horner's scheme keeps the error within two ulps.

use num_dual::DualNum;

/// The series is used for |x| up to here. At 2 both methods lose less than a factor of three to cancellation.
const SERIES_UP_TO: f64 = 2.0;
/// At |x| = 2 the first omitted term, number 36, is below 2^-260 of the first.
const TERMS: u32 = 35;

/// j₀(x) = sin x / x, which has no cancellation; 1 at 0 and 0 at ±∞.
pub(crate) fn j0<D: DualNum<Primitive = f64> + Copy>(x: D) -> D {
    if x.is_zero() {
        return D::one();
    }
    vanishing_at_infinity(x, |x| x.sin() / x)
}

/// j₁(x); 0 at 0 and at ±∞, odd.
pub(crate) fn j1<D: DualNum<Primitive = f64> + Copy>(x: D) -> D {
    if x.abs() <= SERIES_UP_TO {
        return x * series(x, 1) / 3.0;
    }
    vanishing_at_infinity(x, |x| {
        let (sin, cos) = x.sin_cos();
        (sin / x - cos) / x
    })
}

/// j₂(x); 0 at 0 and at ±∞, even.
pub(crate) fn j2<D: DualNum<Primitive = f64> + Copy>(x: D) -> D {
    if x.abs() <= SERIES_UP_TO {
        return x * x * series(x, 2) / 15.0;
    }
    vanishing_at_infinity(x, |x| {
        let (sin, cos) = x.sin_cos();
        ((sin / x - cos) / x * 3.0 - sin) / x
    })
}

/// Σₖ of the module's equation for order n, by Horner's scheme: 1 − x²/(2(2n+3)) · (1 − x²/(4(2n+5)) · (…)).
fn series<D: DualNum<Primitive = f64> + Copy>(x: D, n: u32) -> D {
    let square = x * x;
    (1..=TERMS).rev().fold(D::one(), |sum, k| D::one() - square * sum / f64::from(2 * k * (2 * n + 2 * k + 1)))
}

/// `f(x)`, but the limit 0 where x is infinite and sin x has no value.
fn vanishing_at_infinity<D: DualNum<Primitive = f64> + Copy>(x: D, f: impl Fn(D) -> D) -> D {
    if x.abs() == f64::INFINITY {
        return D::zero();
    }
    f(x)
}
