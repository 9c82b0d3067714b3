//! The ALIGN connector as a program uses it: validated once, then evaluated by the formulas.

use super::{ConstraintMoment, Misalignment, Moment, Moments};
use crate::cardan::{Angles, Triads, accurate_jacobian, between};
use crate::error::Error;
use crate::formula::value;
use crate::frame::Triad;
use std::f64::consts::{PI, TAU};

/// An ALIGN connector.
///
/// ```
/// use jointproof::{align::Align, frame::Triad};
/// use nalgebra::Vector3;
///
/// let [a, b] = [Triad::global(), Triad::global()];
/// let align = Align::new(&a, &b)?;
///
/// let b = Triad::new(Vector3::new(0.8, 0.6, 0.0), Vector3::new(-0.6, 0.8, 0.0), Vector3::z())?;
/// assert_eq!(align.constraint(&a, &b)?.ur3, f64::atan2(0.6, 0.8)); // turned about the third axis
/// assert_eq!(align.constraint_moment(&a, 0.0, 0.0, -2.0)?.m, Vector3::new(0.0, 0.0, -2.0));
///
/// let upright = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x())?;
/// assert!(align.constraint(&a, &upright).is_err()); // gimbal lock: β = 90°
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Align {
    initial: Angles<f64>,
}

impl Align {
    /// Keeps b at its initial orientation to a. Where none is given at b, a's is to be taken for both.
    ///
    /// # Errors
    /// [`Error::GimbalLock`]: the second initial angle is ±90°.
    pub fn new(a: &Triad, b: &Triad) -> Result<Self, Error> {
        Ok(Self { initial: between(a, b)? })
    }

    /// The initial angles.
    pub fn initial(&self) -> Angles<f64> {
        self.initial
    }

    /// By how much b is out of alignment.
    ///
    /// These are the residuals of [`Constraint`](super::Constraint) made fit for programs: β by
    /// [`BetaTwoArgument`](crate::cardan::BetaTwoArgument), and differences of α and γ as angles from −π to π, so that a joint
    /// that starts at half a turn has no jump at its start.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn constraint(&self, a: &Triad, b: &Triad) -> Result<Misalignment<f64>, Error> {
        let Angles { alpha, beta, gamma } = between(a, b)?;
        let Angles { alpha: alpha0, beta: beta0, gamma: gamma0 } = self.initial;
        Ok(Misalignment { ur1: wrapped(alpha - alpha0), ur2: beta - beta0, ur3: wrapped(gamma - gamma0) })
    }

    /// The constraint with its derivatives with respect to the vectors of both triads.
    ///
    /// # Errors
    /// [`Error::GimbalLock`].
    pub fn constraint_jacobian(
        &self,
        a: &Triad,
        b: &Triad,
    ) -> Result<(Misalignment<f64>, Misalignment<Triads<f64>>), Error> {
        let residuals = self.constraint(a, b)?;
        let Angles { alpha: ur1, beta: ur2, gamma: ur3 } = accurate_jacobian(&Triads::from((a, b)));
        Ok((residuals, Misalignment { ur1, ur2, ur3 }))
    }

    /// The moment on b that keeps it aligned ([`ConstraintMoment`]), in the global frame.
    ///
    /// # Errors
    /// A moment that is not finite.
    pub fn constraint_moment(&self, a: &Triad, m1: f64, m2: f64, m3: f64) -> Result<Moment<f64>, Error> {
        value::<ConstraintMoment>(&Moments { e1a: a.e1(), e2a: a.e2(), e3a: a.e3(), m1, m2, m3 })
    }
}

/// The difference of two angles from [−π, π), as an angle from −π to π.
fn wrapped(difference: f64) -> f64 {
    match difference {
        d if d > PI => d - TAU,
        d if d < -PI => d + TAU,
        d => d,
    }
}
