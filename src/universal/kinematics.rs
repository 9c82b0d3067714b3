//! What is held, and what turns.

use crate::Octuple;
use crate::cardan::{self, Triads, alpha, alpha_gradient, check_turns, gamma, gamma_gradient};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    ALPHA, ALPHA0, C0, E1A, E3B, G_UNIVERSAL, GAMMA, GAMMA0, THETA1_REF, THETA3_REF, U_R1, U_R1_MAT, U_R3, U_R3_MAT,
};
use crate::scalar::Scalar;
use crate::verify::{hard, law};
use nalgebra::Vector3;

fields! {
    /// The two shafts, and the initial cosine between them.
    pub struct Shafts<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B, c0: T = C0 }
}
fields! {
    /// By how much the angle between the shafts is off.
    pub struct Skew<T> { g: T = G_UNIVERSAL }
}

/// The condition that keeps the shafts at their angle: g = e1a·e3b − c0.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "universal.constraint",
        title: "Constraint",
        latex: r"g = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b} - c_0",
        source: Source::UJOINT.section("Description"),
        eta: 2.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = Shafts<T>;
    type Outputs<T: Element> = Skew<T>;

    fn eval<D: Scalar>(i: &Shafts<D>) -> Skew<D> {
        Skew { g: i.e1a.dot(&i.e3b) - i.c0 }
    }

    fn jacobian<D: Scalar>(i: &Shafts<D>) -> Jacobian<Self, D> {
        Skew { g: Shafts { e1a: i.e3b, e3b: i.e1a, c0: -D::one() } }
    }

    fn cases() -> Vec<Case<Shafts<f64>>> {
        let right = Shafts { e1a: Vector3::x(), e3b: Vector3::z(), c0: 0.0 };
        let mut cases = vec![
            Case::limit("right-angle", "the cross as it is meant to be: no residual", right),
            Case::hand(
                "oblique",
                "0.6 against an initial cosine of 0.5",
                Shafts { e3b: Vector3::new(0.6, 0.0, 0.8), c0: 0.5, ..right },
            ),
            Case::hand("in-line", "the shafts in one line", Shafts { e3b: Vector3::x(), ..right }),
        ];
        cases.extend(hard::triads().into_iter().map(|pair| {
            let [[e1a, ..], [.., e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Shafts { e1a, e3b, c0: e1a.dot(&e3b) })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "turning b about e3b, or a about e1a, leaves it: neither shaft's own turn is held",
            sides: |i| {
                let jac = Self::jacobian(i);
                let about_b = i.e3b.cross(&jac.g.e3b).dot(&i.e3b);
                let about_a = i.e1a.cross(&jac.g.e1a).dot(&i.e1a);
                law::equal_all_with(
                    [(about_b, 0.0.into()), (about_a, 0.0.into())],
                    law::length(i.e1a) * law::length(i.e3b),
                )
            },
        }]
    }
}

fields! {
    /// The two free angles.
    pub struct Turns<T> { alpha: T = ALPHA, gamma: T = GAMMA }
}

/// The free angles: α about e1a and γ about e3b, as in [`CardanAngles`](cardan::CardanAngles).
#[derive(Clone, Copy, Debug)]
pub struct Angles;

impl Formula for Angles {
    const SPEC: Spec = Spec {
        id: "universal.angles",
        title: "Angles",
        latex: r"\alpha = -\operatorname{atan2}(\mathbf{e}_{2a}\cdot\mathbf{e}_{3b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}),\quad \gamma = -\operatorname{atan2}(\mathbf{e}_{1a}\cdot\mathbf{e}_{2b},\ \mathbf{e}_{1a}\cdot\mathbf{e}_{1b})",
        source: Source::UJOINT.section("Summary"),
        eta: 2.0,
        eta_jacobian: 8.0,
        objective: true,
    };
    type Inputs<T: Element> = Triads<T>;
    type Outputs<T: Element> = Turns<T>;

    fn eval<D: Scalar>(i: &Triads<D>) -> Turns<D> {
        Turns { alpha: alpha(&i.e2a, &i.e3a, &i.e3b), gamma: gamma(&i.e1a, &i.e1b, &i.e2b) }
    }

    fn jacobian<D: Scalar>(i: &Triads<D>) -> Jacobian<Self, D> {
        let zero = Triads::filled(D::zero());
        let [e2a, e3a, e3b] = alpha_gradient(&i.e2a, &i.e3a, &i.e3b);
        let by_alpha = Triads { e2a, e3a, e3b, ..zero };
        let [e1a, e1b, e2b] = gamma_gradient(&i.e1a, &i.e1b, &i.e2b);
        Turns { alpha: by_alpha, gamma: Triads { e1a, e1b, e2b, ..zero } }
    }

    fn validate(i: &Triads<f64>) -> Result<(), Error> {
        check_turns(i)
    }

    fn cases() -> Vec<Case<Triads<f64>>> {
        let [a, b] = hard::axes([1, 2, 3]);
        let [x, y, z] = a;
        let mut cases = vec![
            Case::limit("aligned", "both 0 where both triads are the same", Triads::new(a, b)),
            Case::hand("quarter-turn-of-a-shaft", "b turned by 90° about e1a", Triads::new(a, [x, z, -y])),
            Case::hand("quarter-turn-of-b-shaft", "b turned by 90° about e3b", Triads::new(a, [y, -x, z])),
        ];
        cases.extend(hard::triads().into_iter().map(|pair| {
            let [a, b] = pair.value;
            Case::hard(pair.id, pair.comment, Triads::new(a, b))
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Triads<f64>>> {
        let locked = hard::gimbal_locked().into_iter();
        locked.map(|pair| Case::invalid(pair.id, pair.comment, Triads::new(pair.value[0], pair.value[1]))).collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        cardan::cuts()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "spinning b about e1a or e3b changes α or γ alone, at rate 1",
            sides: |i| {
                let (a, b) = i.orthonormal();
                let triads = Triads::new(a, b);
                let jac = Self::jacobian(&triads);
                let rate = |gradient: &Triads<Octuple>, spin| triads.moments(gradient)[1].dot(&spin);
                let pairs = [
                    (rate(&jac.alpha, a[0]), 1.0.into()),
                    (rate(&jac.alpha, b[2]), 0.0.into()),
                    (rate(&jac.gamma, a[0]), 0.0.into()),
                    (rate(&jac.gamma, b[2]), 1.0.into()),
                ];
                law::equal_all_with(pairs, 1.0.into())
            },
        }]
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
    const SPEC: Spec = Spec {
        id: "universal.relative_motion",
        title: "Relative motion",
        latex: r"u_{r1} = \alpha-\alpha_0,\quad u_{r3} = \gamma-\gamma_0,\quad u_{r1}^{\mathrm{mat}} = \alpha-\theta_1^{\mathrm{ref}},\quad u_{r3}^{\mathrm{mat}} = \gamma-\theta_3^{\mathrm{ref}}",
        source: Source::UJOINT.section("Summary"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = TurnsSince<T>;
    type Outputs<T: Element> = Rotations<T>;

    fn eval<D: Scalar>(i: &TurnsSince<D>) -> Rotations<D> {
        Rotations {
            ur1: i.alpha - i.alpha0,
            ur3: i.gamma - i.gamma0,
            ur1_mat: i.alpha - i.theta1_ref,
            ur3_mat: i.gamma - i.theta3_ref,
        }
    }

    fn jacobian<D: Scalar>(_: &TurnsSince<D>) -> Jacobian<Self, D> {
        let (one, zero) = (D::one(), TurnsSince::filled(D::zero()));
        Rotations {
            ur1: TurnsSince { alpha: one, alpha0: -one, ..zero },
            ur3: TurnsSince { gamma: one, gamma0: -one, ..zero },
            ur1_mat: TurnsSince { alpha: one, theta1_ref: -one, ..zero },
            ur3_mat: TurnsSince { gamma: one, theta3_ref: -one, ..zero },
        }
    }

    fn cases() -> Vec<Case<TurnsSince<f64>>> {
        let hand =
            TurnsSince { alpha: 0.75, gamma: -0.5, alpha0: 0.25, gamma0: 0.25, theta1_ref: 0.5, theta3_ref: -1.0 };
        let start = TurnsSince { alpha: 0.25, gamma: 0.25, ..hand };
        let ulp = TurnsSince { alpha: 1.0_f64.next_up(), gamma: 1.0_f64.next_down(), alpha0: 1.0, gamma0: 1.0, ..hand };
        let turn = TurnsSince { alpha: 3.125, gamma: -3.125, alpha0: -3.125, gamma0: 3.125, ..hand };
        vec![
            Case::hand("turned", "0.5 and -0.75 from the start, 0.25 and 0.5 from the reference", hand),
            Case::limit("start", "no rotation at the start", start),
            Case::hard("ulp", "one ulp from the start", ulp),
            Case::hard("across-180", "the plain difference is nearly a full turn", turn),
            Case::hard(
                "tiny",
                "angles of 1e-200",
                TurnsSince { alpha: 3e-200, gamma: -1e-200, alpha0: 1e-200, gamma0: 0.0, ..hand },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "both counts differ by a constant: what changes one changes the other by as much",
            sides: |i| {
                let here = Self::eval(i);
                let pairs = [
                    (here.ur1 - here.ur1_mat, i.theta1_ref - i.alpha0),
                    (here.ur3 - here.ur3_mat, i.theta3_ref - i.gamma0),
                ];
                law::equal_all_with(pairs, law::length([i.alpha, i.gamma, 1.0.into()].into()))
            },
        }]
    }
}
