//! The three angles as programs should take them, β in the two-argument form; and what the arc sine loses.

use super::{
    Angles, Beta, BetaAxes, BetaTwoArgument, Triads, alpha, alpha_gradient, check_turns, gamma, gamma_gradient,
};
use crate::error::Error;
use crate::formula::{Fields, Formula};
use crate::frame::Triad;
use crate::scalar::Scalar;

/// The Cardan angles of b relative to a.
///
/// ```
/// use jointproof::{cardan::between, frame::Triad};
/// use nalgebra::Vector3;
///
/// let b = Triad::new(Vector3::x(), Vector3::z(), -Vector3::y())?; // a quarter turn about the first axis
/// assert_eq!(between(&Triad::global(), &b)?.alpha, std::f64::consts::FRAC_PI_2);
///
/// let b = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x())?; // a quarter turn about the second axis
/// assert_eq!(
///     between(&Triad::global(), &b).unwrap_err().to_string(),
///     "alpha is undefined, since e2a·e3b = 0 and e3a·e3b = 0 (gimbal lock); allowed is at least one that is not 0",
/// );
/// # Ok::<(), jointproof::Error>(())
/// ```
///
/// # Errors
/// [`Error::GimbalLock`] where α or γ is undefined.
pub fn between(a: &Triad, b: &Triad) -> Result<Angles<f64>, Error> {
    let triads = Triads::from((a, b));
    check_turns(&triads)?;
    Ok(accurate(&triads))
}

impl From<(&Triad, &Triad)> for Triads<f64> {
    fn from((a, b): (&Triad, &Triad)) -> Self {
        Self { e1a: a.e1(), e2a: a.e2(), e3a: a.e3(), e1b: b.e1(), e2b: b.e2(), e3b: b.e3() }
    }
}

/// As [`CardanAngles`], with β from [`BetaTwoArgument`].
#[inline]
pub fn accurate<D: Scalar>(i: &Triads<D>) -> Angles<D> {
    Angles {
        alpha: alpha(&i.e2a, &i.e3a, &i.e3b),
        beta: BetaTwoArgument::eval(&BetaAxes::from(i)).beta,
        gamma: gamma(&i.e1a, &i.e1b, &i.e2b),
    }
}

/// The derivatives of [`accurate`].
pub fn accurate_jacobian<D: Scalar>(i: &Triads<D>) -> Angles<Triads<D>> {
    let zero = Triads::filled(D::zero());
    let [e2a, e3a, e3b] = alpha_gradient(&i.e2a, &i.e3a, &i.e3b);
    let alpha = Triads { e2a, e3a, e3b, ..zero };
    let Beta { beta: BetaAxes { e1a, e1b, e2b, e3b } } = BetaTwoArgument::jacobian(&BetaAxes::from(i));
    let beta = Triads { e1a, e1b, e2b, e3b, ..zero };
    let [e1a, e1b, e2b] = gamma_gradient(&i.e1a, &i.e1b, &i.e2b);
    let gamma = Triads { e1a, e1b, e2b, ..zero };
    Angles { alpha, beta, gamma }
}
