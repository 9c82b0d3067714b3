//! The three angles as programs should take them, β in the two-argument form; and what the arc sine loses.

use super::turns;
use super::{
    Angles, Beta, BetaAxes, BetaTwoArgument, CardanAngles, Triads, alpha, alpha_gradient, check_turns, gamma,
    gamma_gradient, rotation, turned,
};
use crate::Octuple;
use crate::error::Error;
use crate::formula::{Fields, Formula, value};
use crate::frame::Triad;
use crate::scalar::Scalar;
use num_traits::Signed;

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

/// What both forms of β make of triads that are rotations rounded to doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearRightAngle {
    /// 90° − β, in radians.
    pub distance: f64,
    /// The largest relative error of the arc sine, where it exists.
    pub arc_sine: f64,
    /// The share of the poses at which rounding made |e1a·e3b| > 1, so that there is no arc sine.
    pub rejected: f64,
    /// The largest relative error of the two-argument form.
    pub two_argument: f64,
}

/// Both forms of β at each of these distances from 90°, the worst of 64 poses: the figure of the book.
///
/// ```
/// let [near] = jointproof::cardan::errors_near_right_angle(&[1e-6])[..] else { panic!() };
/// assert!(near.arc_sine > 1e-12 && near.two_argument < 1e-15);
/// ```
pub fn errors_near_right_angle(distances: &[f64]) -> Vec<NearRightAngle> {
    distances.iter().map(|&distance| errors_at(distance)).collect()
}

fn errors_at(distance: f64) -> NearRightAngle {
    let beta = Octuple::PI / 2.0 - distance;
    let turns = (0..8).map(|k| Octuple::from(-2.75) + f64::from(k) * 0.75);
    let poses = turns.clone().flat_map(|alpha| turns.clone().map(move |gamma| [alpha, beta, gamma]));
    let error = |found: f64| ((Octuple::from(found) - beta) / beta).abs().to_f64();

    let mut worst = NearRightAngle { distance, arc_sine: 0.0, rejected: 0.0, two_argument: 0.0 };
    for pose in poses {
        let triads = rounded_triads(pose);
        worst.two_argument = worst.two_argument.max(error(accurate(&triads).beta));
        match value::<CardanAngles>(&triads) {
            Ok(angles) => worst.arc_sine = worst.arc_sine.max(error(angles.beta)),
            Err(_) => worst.rejected += 1.0 / 64.0,
        }
    }
    worst
}

/// Triads that stand at these angles to one another, neither along the global axes, every component rounded once.
fn rounded_triads([alpha, beta, gamma]: [Octuple; 3]) -> Triads<f64> {
    let [global, _] = turns::axes([1, 2, 3]);
    let a = turned(&global.map(|e| e.map(Octuple::from)), &rotation(alpha, gamma * 0.25, gamma - alpha));
    let b = turned(&a, &rotation(alpha, beta, gamma));
    let [a, b] = [a, b].map(|triad| triad.map(|e| e.map(Octuple::to_f64)));
    Triads::new(a, b)
}
