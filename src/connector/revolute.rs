//! REVOLUTE: node b rotates about the first axis of node a, which stays its own first axis.
//!
//! | | |
//! |---|---|
//! | frames | the triads e1a, e2a, e3a and e1b, e2b, e3b of both nodes, each orthonormal and right-handed |
//! | matrix | `R_ij = e_ia·e_jb` = R1(α) R2(β) R3(γ), written out in [`cardan`](crate::element::cardan); held are `R_12` = −cos β sin γ and `R_13` = sin β |
//! | zero position | both triads equal: α = 0; held are the c2 = e1a·e2b and c3 = e1a·e3b of the start, which are 0 where the first axes agree there |
//! | signs | α rotates b against a about e1a by the right-hand rule; m2 e2a + m3 e3a acts on b and its opposite on a; m1 is conjugate to ur1, so that m1 e1a acts on a and its opposite on b |

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;
#[cfg(feature = "scene")]
pub(crate) mod table;

use crate::element::cardan::{alpha, alpha_gradient, check_alpha};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA, ALPHA0, CROSS_M1, Domain, E1A, E2A, E2B, E3A, E3B, KINETIC_MOMENT, M2, M3, MOMENT, Quantity, Shape,
    THETA1_REF, U_R1, U_R1_MAT, Unit,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// The page of the connection type REVOLUTE.
pub const DOCUMENT: Document = Document::new("REVOLUTE");

const fn cosine(latex: &'static str, meaning: &'static str) -> Quantity {
    Quantity::new(latex, Shape::Scalar, Unit::ONE, Domain::Real, meaning)
}

/// Residual of e1a·e2b.
pub const G_R2: Quantity = cosine("g_{r2}", "residual of REVOLUTE, zero when e1a and e2b have their initial angle");
/// Residual of e1a·e3b.
pub const G_R3: Quantity = cosine("g_{r3}", "residual of REVOLUTE, zero when e1a and e3b have their initial angle");
/// Initial value of e1a·e2b.
pub const C2: Quantity = cosine("c_2", "initial value of e1a·e2b, zero where the first axes agree at the start");
/// Initial value of e1a·e3b.
pub const C3: Quantity = cosine("c_3", "initial value of e1a·e3b, zero where the first axes agree at the start");

fields! {
    /// The axis of a, the axes of b that are normal to it, and their initial cosines.
    pub struct Axes<T> { e1a: Vector3<T> = E1A, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B, c2: T = C2, c3: T = C3 }
}
fields! {
    /// The residuals.
    pub struct Tilt<T> { g2: T = G_R2, g3: T = G_R3 }
}

/// The two conditions that keep the first axes together: g2 = e1a·e2b − c2, g3 = e1a·e3b − c3.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "revolute.constraint",
        "Constraint",
        DOCUMENT.ours(
            "Description",
            "the page prints both products as 0, or holds β and γ where the axes do not agree at the start, which is the same",
        ),
    )
    .equation(r"g_{r2} = \mathbf{e}_{1a}\cdot\mathbf{e}_{2b} - c_2,\quad g_{r3} = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b} - c_3")
    .eta(2.0, 0.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Axes<T>;
    type Outputs<T: Component> = Tilt<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Axes<D>) -> Tilt<D> {
        Tilt { g2: i.e1a.dot(&i.e2b) - i.c2, g3: i.e1a.dot(&i.e3b) - i.c3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Axes<D>) -> Jacobian<Self, D> {
        let (none, held) = (Axes::filled(D::zero()), -D::one());
        Tilt {
            g2: Axes { e1a: i.e2b, e2b: i.e1a, c2: held, ..none },
            g3: Axes { e1a: i.e3b, e3b: i.e1a, c3: held, ..none },
        }
    }
}

fields! {
    /// The axes of a and of b whose angle it is.
    pub struct Across<T> { e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B }
}
fields! {
    /// The free angle.
    pub struct Turn<T> { alpha: T = ALPHA }
}

/// The free angle: α = −atan2(e2a·e3b, e3a·e3b), from −π to below π.
#[derive(Clone, Copy, Debug)]
pub struct Angle;

impl Formula for Angle {
    const SPEC: Spec = Spec::new(
        "revolute.angle",
        "Angle",
        DOCUMENT.reconstructed("Description", "the quotient was lost; that both signs count, as atan2 has it, is ours"),
    )
    .equation(
        r"\alpha = -\operatorname{atan2}(\mathbf{e}_{2a}\cdot\mathbf{e}_{3b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{3b})",
    )
    // The largest η that `audit --attack` found is 0.78 for the value, and 2 is possible to first order; for the Jacobian 2.54 and 4.
    .eta(3.0, 8.0)
    .normwise(3.0, 4.5)
    .scale(1e250)
    .finite(Finite::Between);
    type Inputs<T: Component> = Across<T>;
    type Outputs<T: Component> = Turn<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Across<D>) -> Turn<D> {
        Turn { alpha: alpha(&i.e2a, &i.e3a, &i.e3b) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Across<D>) -> Jacobian<Self, D> {
        let [e2a, e3a, e3b] = alpha_gradient(&i.e2a, &i.e3a, &i.e3b);
        Turn { alpha: Across { e2a, e3a, e3b } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Across<D>) -> Result<(), Error> {
        check_alpha(&i.e2a, &i.e3a, &i.e3b)
    }
}

fields! {
    /// The free angle, its initial value, and the reference angle.
    pub struct TurnSince<T> { alpha: T = ALPHA, alpha0: T = ALPHA0, theta1_ref: T = THETA1_REF }
}
fields! {
    /// Rotations from the start and from the reference angle.
    pub struct Rotation<T> { ur1: T = U_R1, ur1_mat: T = U_R1_MAT }
}

/// The rotation about e1a, from the start and from the reference angle: ur1 = α − α0, `ur1_mat` = α − θ1_ref.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion;

impl Formula for RelativeMotion {
    const SPEC: Spec = Spec::new(
        "revolute.relative_motion",
        "Relative motion",
        DOCUMENT.ours(
            "Description",
            "the page adds nπ for full rotations; α is followed over full rotations here, by 2π each",
        ),
    )
    .equation(r"u_{r1} = \alpha-\alpha_0,\quad u_{r1}^{\mathrm{mat}} = \alpha-\theta_1^{\mathrm{ref}}")
    .eta(1.0, 0.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = TurnSince<T>;
    type Outputs<T: Component> = Rotation<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TurnSince<D>) -> Rotation<D> {
        Rotation { ur1: i.alpha - i.alpha0, ur1_mat: i.alpha - i.theta1_ref }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &TurnSince<D>) -> Jacobian<Self, D> {
        let (zero, one) = (D::zero(), D::one());
        Rotation {
            ur1: TurnSince { alpha: one, alpha0: -one, theta1_ref: zero },
            ur1_mat: TurnSince { alpha: one, alpha0: zero, theta1_ref: -one },
        }
    }
}

fields! {
    /// The axes normal to the axis of rotation, and the moments about them.
    pub struct Tilted<T> { e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, m2: T = M2, m3: T = M3 }
}
fields! {
    /// A constraint moment on node b; its opposite acts on node a.
    pub struct Moment<T> { m: Vector3<T> = MOMENT }
}

/// The moment that keeps the first axes together: m = m2 e2a + m3 e3a.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintMoment;

impl Formula for ConstraintMoment {
    const SPEC: Spec = Spec::new("revolute.constraint_moment", "Constraint moment", DOCUMENT.printed("Description"))
        .equation(r"\mathbf{m} = m_2\,\mathbf{e}_{2a} + m_3\,\mathbf{e}_{3a}")
        .eta(1.5, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Tilted<T>;
    type Outputs<T: Component> = Moment<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Tilted<D>) -> Moment<D> {
        Moment { m: i.e2a * i.m2 + i.e3a * i.m3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Tilted<D>) -> Jacobian<Self, D> {
        let row = |k: usize| Tilted { e2a: along(k, i.m2), e3a: along(k, i.m3), m2: i.e2a[k], m3: i.e3a[k] };
        Moment { m: Vector3::new(row(0), row(1), row(2)) }
    }
}

fields! {
    /// The axis of rotation, and the moment about it.
    pub struct Driven<T> { e1a: Vector3<T> = E1A, m1: T = CROSS_M1 }
}
fields! {
    /// A kinetic moment: on node a as it is, on node b its opposite.
    pub struct FreeMoment<T> { m: Vector3<T> = KINETIC_MOMENT }
}

/// The moment about the axis of rotation: m = m1 e1a. It is conjugate to ur1, so that it acts on a, and on b its opposite.
#[derive(Clone, Copy, Debug)]
pub struct KineticMoment;

impl Formula for KineticMoment {
    const SPEC: Spec = Spec::new("revolute.kinetic_moment", "Kinetic moment", DOCUMENT.printed("Description"))
        .equation(r"\mathbf{m} = m_1\,\mathbf{e}_{1a}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Driven<T>;
    type Outputs<T: Component> = FreeMoment<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Driven<D>) -> FreeMoment<D> {
        FreeMoment { m: i.e1a * i.m1 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Driven<D>) -> Jacobian<Self, D> {
        let row = |k: usize| Driven { e1a: along(k, i.m1), m1: i.e1a[k] };
        FreeMoment { m: Vector3::new(row(0), row(1), row(2)) }
    }
}
