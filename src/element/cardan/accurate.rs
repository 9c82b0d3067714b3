//! The three angles as programs should compute them, with β in the two-argument form; and their condition number.

use super::{Angles, Beta, BetaAxes, BetaTwoArgument, Triads, check_turns};
use crate::element::frame::Triad;
use crate::formula::error::Error;
use crate::formula::{Fields, Formula};
use crate::number::scalar::Scalar;

/// The Cardan angles of b relative to a.
///
/// ```
/// use jointproof::element::cardan::between;
/// use jointproof::element::frame::Triad;
/// use nalgebra::Vector3;
///
/// let b = Triad::new(Vector3::x(), Vector3::z(), -Vector3::y())?; // a quarter turn about the first axis
/// assert_eq!(between(&Triad::global(), &b)?.alpha, std::f64::consts::FRAC_PI_2);
///
/// let b = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x())?; // a quarter turn about the second axis
/// assert_eq!(
///     between(&Triad::global(), &b).unwrap_err().to_string(),
///     "alpha is undefined, since e2a·e3b = 0 and e3a·e3b = 0 (gimbal lock, beta = ±90°); allowed is at least one that is not 0",
/// );
/// # Ok::<(), jointproof::Error>(())
/// ```
///
/// # Errors
/// [`Error::GimbalLock`] if α or γ is undefined.
pub fn between(a: &Triad, b: &Triad) -> Result<Angles<f64>, Error> {
    let triads = Triads::from((a, b));
    check_turns(&triads)?;
    Ok(accurate(&triads))
}

/// The largest condition number of the angles with which a joint may start.
pub const MOST_CONDITION: f64 = 1e3;

/// The condition number of the derivative of (α, β, γ) with respect to a spin of b: √((1 + |sin β|)/(1 − |sin β|)), which is
/// (1 + |sin β|)/cos β.
///
/// The spin is `dα e1a + dβ n + dγ e3b` with n normal to e1a and e3b, so that only the angle between e1a and e3b matters.
///
/// ```
/// use jointproof::element::cardan::condition;
/// for (degrees, expected) in [(0.0_f64, 1.0), (60.0, 3.7), (85.0, 23.0), (89.9, 1100.0)] {
///     assert!((condition(degrees.to_radians()) / expected - 1.0).abs() < 0.05);
/// }
/// ```
pub fn condition(beta: f64) -> f64 {
    (1.0 + beta.sin().abs()) / beta.cos().abs()
}

/// Whether a joint may start at this second angle.
///
/// # Errors
/// [`Error::IllConditioned`]: the condition number is above [`MOST_CONDITION`], from 89.885° on.
#[inline]
pub fn check_start<D: Scalar>(beta: D) -> Result<(), Error> {
    let beta = beta.re();
    let condition = condition(beta);
    if condition <= MOST_CONDITION {
        return Ok(());
    }
    Err(Error::IllConditioned { angle: "beta", value: beta, condition, most: MOST_CONDITION })
}

impl From<(&Triad, &Triad)> for Triads<f64> {
    fn from((a, b): (&Triad, &Triad)) -> Self {
        Self { e1a: a.e1(), e2a: a.e2(), e3a: a.e3(), e1b: b.e1(), e2b: b.e2(), e3b: b.e3() }
    }
}

/// As [`CardanAngles`](super::CardanAngles), with β from [`BetaTwoArgument`].
#[inline]
pub fn accurate<D: Scalar>(i: &Triads<D>) -> Angles<D> {
    let [alpha, gamma] = i.alpha_and_gamma();
    Angles { alpha, beta: BetaTwoArgument::eval(&BetaAxes::from(i)).beta, gamma }
}

/// The derivatives of [`accurate`].
pub fn accurate_jacobian<D: Scalar>(i: &Triads<D>) -> Angles<Triads<D>> {
    let zero = Triads::filled(D::zero());
    let Beta { beta: BetaAxes { e1a, e1b, e2b, e3b } } = BetaTwoArgument::jacobian(&BetaAxes::from(i));
    let beta = Triads { e1a, e1b, e2b, e3b, ..zero };
    let [alpha, gamma] = i.alpha_and_gamma_gradients();
    Angles { alpha, beta, gamma }
}
