//! The ALIGN connector as a program uses it: validated once, then evaluated by the formulas.

use super::{AlignElement, AlignStart, ConstraintMoment, Misalignment, Moment, Moments, wrapped};
use crate::element::cardan::{Angles, Triads, accurate, accurate_jacobian, between, check_start, check_turns};
use crate::element::frame::Triad;
use crate::element::{Contribution, Nodes, Nothing, Parameters};
use crate::formula::error::Error;
use crate::formula::value;
use nalgebra::{Matrix3, Vector3};

/// An ALIGN connector.
///
/// ```
/// use jointproof::connector::{align::Align};
/// use jointproof::element::frame::Triad;
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
    /// Keeps b at its initial orientation relative to a. If b has no triad of its own, pass that of a for both.
    ///
    /// # Errors
    /// [`Error::GimbalLock`]: the second initial angle is ±90°; [`Error::IllConditioned`]: it is so close to ±90° that
    /// [`condition`](crate::element::cardan::condition) is above [`MOST_CONDITION`](crate::element::cardan::MOST_CONDITION).
    /// [`AlignFromStart`] is regular there.
    pub fn new(a: &Triad, b: &Triad) -> Result<Self, Error> {
        let initial = between(a, b)?;
        check_start(initial.beta)?;
        Ok(Self { initial })
    }

    /// The initial angles.
    pub fn initial(&self) -> Angles<f64> {
        self.initial
    }

    /// The deviation of b from its initial orientation.
    ///
    /// These are the residuals of [`Constraint`](super::Constraint) in a form suited to programs: β is computed by
    /// [`BetaTwoArgument`](crate::element::cardan::BetaTwoArgument), and the differences of α and γ are angles from −π to π, so
    /// that a joint that starts at half a turn has no jump at its start.
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

    /// The element that a solver calls.
    pub const fn element(&self) -> Parameters<AlignElement, f64, 3> {
        let Angles { alpha: alpha0, beta: beta0, gamma: gamma0 } = self.initial;
        Parameters { start: AlignStart { alpha0, beta0, gamma0 }, contact: None }
    }

    /// The contribution to a step of Newton's method.
    ///
    /// # Errors
    /// As [`Parameters::newton`].
    pub fn newton(&self, a: &Triad, b: &Triad, multipliers: &Vector3<f64>) -> Result<Contribution<f64, 3>, Error> {
        let nodes = Nodes::new([(*a).into(), (*b).into()], [Vector3::zeros(); 2]);
        self.element().newton(&nodes, multipliers, &Nothing::new()).map(|(found, _)| found)
    }
}

/// The conditions of ALIGN with angles measured from the start, regular for every initial orientation of b relative to a.
///
/// With the matrix R of entries `e_ia·e_jb` and its initial value R0, Q = R R0ᵀ is the rotation of b since the start, in the axes
/// of a. The Cardan angles of Q, 0 at the start, are held: the same motions satisfy these conditions as those of [`Align`], and
/// near the start their derivative with respect to a spin of b is the triad of a, of condition number 1, so that m1, m2, m3 are
/// conjugate to them there.
///
/// ```
/// use jointproof::connector::{align::{Align, AlignFromStart}};
/// use jointproof::element::frame::Triad;
/// use nalgebra::Vector3;
///
/// let a = Triad::global();
/// let b = Triad::new(-Vector3::z(), Vector3::y(), Vector3::x())?; // turned by 90° about the second axis
/// assert!(Align::new(&a, &b).is_err());
/// let align = AlignFromStart::new(&a, &b);
/// assert_eq!(align.constraint(&a, &b)?.ur2, 0.0);
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlignFromStart {
    /// R0.
    initial: Matrix3<f64>,
}

impl AlignFromStart {
    /// Keeps b at its initial orientation relative to a, whatever that is.
    pub fn new(a: &Triad, b: &Triad) -> Self {
        let columns = |t: &Triad| Matrix3::from_columns(&[t.e1(), t.e2(), t.e3()]);
        Self { initial: columns(a).transpose() * columns(b) }
    }

    /// The triad of a, and that of b with its initial rotation relative to a undone.
    fn triads(&self, a: &Triad, b: &Triad) -> Triads<f64> {
        let back = |j: usize| {
            [b.e1(), b.e2(), b.e3()].iter().enumerate().map(|(k, e)| e * self.initial[(j, k)]).sum::<Vector3<f64>>()
        };
        Triads { e1a: a.e1(), e2a: a.e2(), e3a: a.e3(), e1b: back(0), e2b: back(1), e3b: back(2) }
    }

    /// The rotation of b out of alignment, about the axes of a.
    ///
    /// # Errors
    /// [`Error::GimbalLock`]: b has rotated by 90° about the second axis since the start.
    pub fn constraint(&self, a: &Triad, b: &Triad) -> Result<Misalignment<f64>, Error> {
        let triads = self.triads(a, b);
        check_turns(&triads)?;
        let Angles { alpha: ur1, beta: ur2, gamma: ur3 } = accurate(&triads);
        Ok(Misalignment { ur1, ur2, ur3 })
    }

    /// The constraint with its derivatives with respect to the vectors of both triads.
    ///
    /// # Errors
    /// As [`AlignFromStart::constraint`].
    pub fn constraint_jacobian(
        &self,
        a: &Triad,
        b: &Triad,
    ) -> Result<(Misalignment<f64>, Misalignment<Triads<f64>>), Error> {
        let residuals = self.constraint(a, b)?;
        let Angles { alpha, beta, gamma } = accurate_jacobian(&self.triads(a, b));
        let row = |of: Triads<f64>| {
            let by = |k: usize| {
                of.e1b * self.initial[(0, k)] + of.e2b * self.initial[(1, k)] + of.e3b * self.initial[(2, k)]
            };
            Triads { e1b: by(0), e2b: by(1), e3b: by(2), ..of }
        };
        Ok((residuals, Misalignment { ur1: row(alpha), ur2: row(beta), ur3: row(gamma) }))
    }
}
