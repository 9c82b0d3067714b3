//! The residuals of the three angles, and the constraint moment.

#![expect(clippy::inline_always, reason = "a call would write the vectors to memory, and wait for them there")]

#[cfg(feature = "verify")]
mod proof;

use crate::element::cardan::{Angles, CardanAngles, Oriented, Triads};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA0, BETA0, E1A, E1B, E2A, E2B, E3A, E3B, GAMMA0, M1, M2, M3, MOMENT, UR1, UR2, UR3,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Given, Jacobian, Spec, along};
use crate::number::scalar::{Scalar, abs, pi, sign};
use nalgebra::Vector3;

fields! {
    /// The triads of both nodes, and the initial angles.
    pub struct Orientations<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        alpha0: T = ALPHA0, beta0: T = BETA0, gamma0: T = GAMMA0,
    }
}
fields! {
    /// The deviations of the angles from their initial values.
    pub struct Misalignment<T> { ur1: T = UR1, ur2: T = UR2, ur3: T = UR3 }
}

impl<T: Component> Orientations<T> {
    /// Combines both triads with the initial angles.
    #[inline]
    pub const fn new(triads: &Triads<T>, initial: &Angles<T>) -> Self {
        let Triads { e1a, e2a, e3a, e1b, e2b, e3b } = *triads;
        let Angles { alpha: alpha0, beta: beta0, gamma: gamma0 } = *initial;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 }
    }

    /// The initial angles.
    #[inline]
    pub const fn initial(&self) -> Angles<T> {
        Angles { alpha: self.alpha0, beta: self.beta0, gamma: self.gamma0 }
    }
}

impl<D: Scalar> Oriented<D> for Orientations<D> {
    #[inline(always)]
    fn triads(&self) -> Triads<D> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, .. } = self;
        Triads::by_components([e1a, e2a, e3a], [e1b, e2b, e3b])
    }
    #[inline(always)]
    fn of(triads: Triads<D>) -> Self {
        Self::new(&triads, &Angles::filled(D::zero()))
    }
}

/// The three conditions that keep b aligned: α − α0 = 0, β − β0 = 0, γ − γ0 = 0.
///
/// The differences are not reduced, as documented: the residual jumps by a full turn when α or γ passes ±180°.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "align.constraint",
        "Constraint",
        Document::TRANSLATOR
            .ours("Description", "the page of ALIGN was not given; the angles are held at their initial values"),
    )
    .equation(r"u_{r1} = \alpha - \alpha_0,\quad u_{r2} = \beta - \beta_0,\quad u_{r3} = \gamma - \gamma_0")
    .given(&[Given::new(r"\alpha,\ \beta,\ \gamma", &CardanAngles::SPEC)])
    // The largest η that `audit --attack` found is 1.3 for the value, and 3 is possible to first order; for the Jacobian 2.5 and 4.
    .eta(3.0, 4.0)
    .normwise(3.0, 4.5)
    .scale(1e250)
    .finite(Finite::Between);
    type Inputs<T: Component> = Orientations<T>;
    type Outputs<T: Component> = Misalignment<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Orientations<D>) -> Misalignment<D> {
        let Angles { alpha, beta, gamma } = CardanAngles::eval(&i.triads());
        Misalignment { ur1: alpha - i.alpha0, ur2: beta - i.beta0, ur3: gamma - i.gamma0 }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Orientations<D>) -> Jacobian<Self, D> {
        Misalignment::since_start(CardanAngles::jacobian(&i.triads()))
    }

    #[inline]
    fn validate<D: Scalar>(i: &Orientations<D>) -> Result<(), Error> {
        CardanAngles::validate(&i.triads())
    }
}

impl<D: Scalar> Misalignment<Orientations<D>> {
    /// The derivatives of the angles minus their initial values.
    #[inline(always)]
    pub(crate) fn since_start(angles: Angles<Triads<D>>) -> Self {
        let Angles { alpha, beta, gamma } = angles;
        Self {
            ur1: Orientations { alpha0: -D::one(), ..Orientations::of(alpha) },
            ur2: Orientations { beta0: -D::one(), ..Orientations::of(beta) },
            ur3: Orientations { gamma0: -D::one(), ..Orientations::of(gamma) },
        }
    }
}

/// The difference of two angles, brought back by a full turn if it exceeds half a turn, with π to the precision of `D`.
#[inline]
pub(crate) fn wrapped<D: Scalar>(difference: D) -> D {
    if abs(difference) <= pi::<D>() {
        return difference;
    }
    difference - pi::<D>() * sign(difference) * 2.0
}

fields! {
    /// The triad of a, and the moments about its axes.
    pub struct Moments<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, m1: T = M1, m2: T = M2, m3: T = M3,
    }
}
fields! {
    /// A constraint moment on node b; its opposite acts on node a.
    pub struct Moment<T> { m: Vector3<T> = MOMENT }
}

/// The moment that keeps b aligned: m = m1 e1a + m2 e2a + m3 e3a.
///
/// Where the triads are equal, it is conjugate to (α, β, γ): m1, m2, m3 do work on these angles. Elsewhere it is not; see the
/// laws of [`Constraint`].
#[derive(Clone, Copy, Debug)]
pub struct ConstraintMoment;

impl Formula for ConstraintMoment {
    const SPEC: Spec = Spec::new(
        "align.constraint_moment",
        "Constraint moment",
        Document::TRANSLATOR
            .ours("Summary", "the page names the components m1, m2, m3; that they are along the triad of a is ours"),
    )
    .equation(r"\mathbf{m} = m_1\,\mathbf{e}_{1a} + m_2\,\mathbf{e}_{2a} + m_3\,\mathbf{e}_{3a}")
    .eta(1.5, 0.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Moments<T>;
    type Outputs<T: Component> = Moment<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Moments<D>) -> Moment<D> {
        Moment { m: i.e1a * i.m1 + i.e2a * i.m2 + i.e3a * i.m3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Moments<D>) -> Jacobian<Self, D> {
        let row = |k| Moments {
            e1a: along(k, i.m1),
            e2a: along(k, i.m2),
            e3a: along(k, i.m3),
            m1: i.e1a[k],
            m2: i.e2a[k],
            m3: i.e3a[k],
        };
        Moment { m: Vector3::new(row(0), row(1), row(2)) }
    }
}
