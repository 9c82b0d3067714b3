//! Stumpff functions of θ²: sin θ/θ, (1 − cos θ)/θ² and (θ − sin θ)/θ³, which are regular at θ = 0.
//!
//! c_n(s) = Σ (−s)ᵏ/(2k+n)! and c_n = 1/n! − s c_(n+2), so that the series of c4 and c5 give all lower ones without cancellation
//! while s is small; for larger s, sine and cosine do (K. Stumpff, Himmelsmechanik I, section 41).

use crate::number::scalar::{Leaf, Scalar, constant};
use num_dual::DualNum;

/// The first three functions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stumpff<D> {
    pub(super) c1: D,
    pub(super) c2: D,
    pub(super) c3: D,
}

/// The series are used below this value, where an alternating sum loses no digits.
const SERIES_BELOW: f64 = 4.0;
/// The number of terms of the series: the remainder is below 2⁻²⁴⁰ of the first term at [`SERIES_BELOW`], also for derivatives.
const TERMS: usize = 36;
/// The number of terms for numbers with no more digits than doubles: the remainder is below 2⁻⁶⁰.
const TERMS_OF_DOUBLES: usize = 13;

impl<D: Scalar> Stumpff<D> {
    /// The functions at θ², and the derivatives of c2 and c3 with respect to θ, divided by θ.
    #[inline]
    pub(super) fn new(square: D) -> (Self, [D; 2]) {
        if square < SERIES_BELOW { Self::small(square) } else { Self::large(square) }
    }

    #[inline]
    fn small(s: D) -> (Self, [D; 2]) {
        let (c4, c5) = (series::<D, 4>(s) / 24.0, series::<D, 5>(s) / 120.0);
        let (c2, c3) = (-s * c4 + 0.5, -s * c5 + constant::<D>(sixth()));
        (Self { c1: -s * c3 + 1.0, c2, c3 }, [c4 * 2.0 - c3, c5 * 3.0 - c4])
    }

    #[inline]
    fn large(s: D) -> (Self, [D; 2]) {
        let half = s.sqrt() * 0.5;
        let (sin, cos) = half.sin_cos();
        let chord = sin / half;
        let (c1, c2) = (chord * cos, chord * chord * 0.5);
        let c3 = (-c1 + 1.0) / s;
        (Self { c1, c2, c3 }, [(c1 - c2 * 2.0) / s, (c2 - c3 * 3.0) / s])
    }
}

fn sixth<L: Leaf>() -> L {
    let [sixth] = L::constants([1.0 / 6.0], || [L::from(6.0).recip()]);
    sixth
}

/// n! c_n(s), by Horner's scheme: 1 − s/((n+1)(n+2)) · (1 − s/((n+3)(n+4)) · (…)).
#[inline]
fn series<D: Scalar, const N: usize>(s: D) -> D {
    let terms = if D::Leaf::EPSILON < f64::EPSILON { TERMS } else { TERMS_OF_DOUBLES };
    let factors =
        D::Leaf::constants(const { factors(N) }, || products(N).map(|product| D::Leaf::from(product).recip()));
    factors[..terms].iter().rev().fold(D::one(), |sum, &factor| -s * constant::<D>(factor) * sum + 1.0)
}

/// (n+1)(n+2), (n+3)(n+4), …
const fn products(n: usize) -> [f64; TERMS] {
    let mut all = [0.0; TERMS];
    let mut k = 0;
    while k < TERMS {
        #[expect(clippy::cast_precision_loss, reason = "small whole numbers")]
        let product = ((n + 2 * k + 1) * (n + 2 * k + 2)) as f64;
        all[k] = product;
        k += 1;
    }
    all
}

/// One over each of [`products`].
const fn factors(n: usize) -> [f64; TERMS] {
    let mut all = products(n);
    let mut k = 0;
    while k < TERMS {
        all[k] = 1.0 / all[k];
        k += 1;
    }
    all
}
