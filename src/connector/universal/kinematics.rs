//! The constraint on the angle between the shafts, and the free rotations.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use crate::element::cardan::{Triads, check_turns};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA, ALPHA0, C0, E1A, E3B, G_UNIVERSAL, GAMMA, GAMMA0, THETA1_REF, THETA3_REF, U_R1, U_R1_MAT, U_R3, U_R3_MAT,
};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The two shafts, and the initial cosine between them.
    pub struct Shafts<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B, c0: T = C0 }
}
fields! {
    /// The deviation of the cosine between the shafts from its initial value.
    pub struct Skew<T> { g: T = G_UNIVERSAL }
}

/// The condition that keeps the shafts at their angle: g = e1a·e3b − c0.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "universal.constraint",
        "Constraint",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; the arms of the cross keep their initial angle"),
    )
    .equation(r"g = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b} - c_0")
    .eta(2.0, 0.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Shafts<T>;
    type Outputs<T: Component> = Skew<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Shafts<D>) -> Skew<D> {
        Skew { g: i.e1a.dot(&i.e3b) - i.c0 }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Shafts<D>) -> Jacobian<Self, D> {
        // By components: whole vectors would be copied through memory, twice.
        Skew { g: Shafts { e1a: i.e3b.xyz(), e3b: i.e1a.xyz(), c0: -D::one() } }
    }
}

fields! {
    /// The two free angles.
    pub struct Turns<T> { alpha: T = ALPHA, gamma: T = GAMMA }
}

/// The free angles: α about e1a and γ about e3b, as in [`CardanAngles`](crate::element::cardan::CardanAngles).
#[derive(Clone, Copy, Debug)]
pub struct Angles;

impl Formula for Angles {
    const SPEC: Spec = Spec::new(
        "universal.angles",
        "Angles",
        Document::UJOINT.ours(
            "Summary",
            "the page of UNIVERSAL was not given; these are the first and the third Cardan angle",
        ),
    )
        .equation(r"\alpha = -\operatorname{atan2}(\mathbf{e}_{2a}\cdot\mathbf{e}_{3b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}),\quad \gamma = -\operatorname{atan2}(\mathbf{e}_{1a}\cdot\mathbf{e}_{2b},\ \mathbf{e}_{1a}\cdot\mathbf{e}_{1b})")
        // The largest η that `audit --attack` found is 0.84 for the value, and 2 is possible to first order; for the Jacobian 2.52 and 4.
        .eta(3.0, 8.0)
        .normwise(3.0, 4.5)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Triads<T>;
    type Outputs<T: Component> = Turns<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Triads<D>) -> Turns<D> {
        let [alpha, gamma] = i.alpha_and_gamma();
        Turns { alpha, gamma }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Triads<D>) -> Jacobian<Self, D> {
        let [alpha, gamma] = i.alpha_and_gamma_gradients();
        Turns { alpha, gamma }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
        check_turns(i)
    }
}

fields! {
    /// The free angles, their initial values, and the reference angles.
    pub struct TurnsSince<T> {
        alpha: T = ALPHA, gamma: T = GAMMA, alpha0: T = ALPHA0, gamma0: T = GAMMA0,
        theta1_ref: T = THETA1_REF, theta3_ref: T = THETA3_REF,
    }
}
fields! {
    /// Rotations from the start and from the reference angles.
    pub struct Rotations<T> { ur1: T = U_R1, ur3: T = U_R3, ur1_mat: T = U_R1_MAT, ur3_mat: T = U_R3_MAT }
}

/// The rotations about both shafts, from the start and from the reference angles.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion;

impl Formula for RelativeMotion {
    const SPEC: Spec = Spec::new(
        "universal.relative_motion",
        "Relative motion",
        Document::UJOINT.ours(
            "Summary",
            "the page names the components and the reference angles, and prints no equation",
        ),
    )
        .equation(r"u_{r1} = \alpha-\alpha_0,\quad u_{r3} = \gamma-\gamma_0,\quad u_{r1}^{\mathrm{mat}} = \alpha-\theta_1^{\mathrm{ref}},\quad u_{r3}^{\mathrm{mat}} = \gamma-\theta_3^{\mathrm{ref}}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = TurnsSince<T>;
    type Outputs<T: Component> = Rotations<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TurnsSince<D>) -> Rotations<D> {
        Rotations {
            ur1: i.alpha - i.alpha0,
            ur3: i.gamma - i.gamma0,
            ur1_mat: i.alpha - i.theta1_ref,
            ur3_mat: i.gamma - i.theta3_ref,
        }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &TurnsSince<D>) -> Jacobian<Self, D> {
        const {
            let (zero, one, minus_one) = (D::ZERO, D::ONE, D::MINUS_ONE);
            let none =
                TurnsSince { alpha: zero, gamma: zero, alpha0: zero, gamma0: zero, theta1_ref: zero, theta3_ref: zero };
            Rotations {
                ur1: TurnsSince { alpha: one, alpha0: minus_one, ..none },
                ur3: TurnsSince { gamma: one, gamma0: minus_one, ..none },
                ur1_mat: TurnsSince { alpha: one, theta1_ref: minus_one, ..none },
                ur3_mat: TurnsSince { gamma: one, theta3_ref: minus_one, ..none },
            }
        }
    }
}
