//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{Angles, Constraint, RelativeMotion, Shafts, TurnsSince};
use crate::Octuple;
use crate::element::cardan::Triads;
use crate::element::cardan::turns;
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use nalgebra::Vector3;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Shafts<f64>>> {
        let right = Shafts { e1a: Vector3::x(), e3b: Vector3::z(), c0: 0.0 };
        let mut cases = vec![
            Case::hand("right-angle", "the cross as it is meant to be: no residual", right),
            Case::hand(
                "oblique",
                "0.6 against an initial cosine of 0.5",
                Shafts { e3b: Vector3::new(0.6, 0.0, 0.8), c0: 0.5, ..right },
            ),
            Case::hand("in-line", "the shafts in one line", Shafts { e3b: Vector3::x(), ..right }),
            Case::running("e1a·e3b = 0.6 against 0.55", Shafts { e3b: turns::PYTHAGOREAN[2], c0: 0.55, ..right }),
        ];
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [[e1a, ..], [.., e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Shafts { e1a, e3b, c0: e1a.dot(&e3b) })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "turning b about e3b, or a about e1a, does not change it: the rotation of each shaft about its arm is free",
            |i| {
                let jac = Self::jacobian(i);
                let about_b = i.e3b.cross(&jac.g.e3b).dot(&i.e3b);
                let about_a = i.e1a.cross(&jac.g.e1a).dot(&i.e1a);
                law::equal_all_with(
                    [(about_b, 0.0.into()), (about_a, 0.0.into())],
                    law::length(i.e1a) * law::length(i.e3b),
                )
            },
        )]
    }
}

impl Proved for Angles {
    fn cases() -> Vec<Case<Triads<f64>>> {
        let [a, b] = turns::axes([1, 2, 3]);
        let [x, y, z] = a;
        let mut cases = vec![
            Case::hand("aligned", "both 0 where both triads are the same", Triads::new(a, b)),
            Case::hand("quarter-turn-of-a-shaft", "b turned by 90° about e1a", Triads::new(a, [x, z, -y])),
            Case::hand("quarter-turn-of-b-shaft", "b turned by 90° about e3b", Triads::new(a, [y, -x, z])),
            Case::running("both have the sine 0.6", Triads::new(a, turns::PYTHAGOREAN)),
        ];
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [a, b] = pair.value;
            Case::hard(pair.id, pair.comment, Triads::new(a, b))
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Triads<f64>>> {
        let locked = turns::gimbal_locked().into_iter();
        locked.map(|pair| Case::invalid(pair.id, pair.comment, Triads::new(pair.value[0], pair.value[1]))).collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        turns::cuts().into()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("spinning b about e1a or e3b changes α or γ alone, at rate 1", |i| {
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
        })]
    }
}

impl Proved for RelativeMotion {
    fn cases() -> Vec<Case<TurnsSince<f64>>> {
        let hand =
            TurnsSince { alpha: 0.75, gamma: -0.5, alpha0: 0.25, gamma0: 0.25, theta1_ref: 0.5, theta3_ref: -1.0 };
        let start = TurnsSince { alpha: 0.25, gamma: 0.25, ..hand };
        let ulp = TurnsSince { alpha: 1.0_f64.next_up(), gamma: 1.0_f64.next_down(), alpha0: 1.0, gamma0: 1.0, ..hand };
        let turn = TurnsSince { alpha: 3.125, gamma: -3.125, alpha0: -3.125, gamma0: 3.125, ..hand };
        vec![
            Case::hand("turned", "0.5 and -0.75 from the start, 0.25 and 0.5 from the reference", hand),
            Case::hand("start", "no rotation at the start", start),
            Case::hard("ulp", "one ulp from the start", ulp),
            Case::hard("across-180", "the plain difference is nearly a full turn", turn),
            Case::hard(
                "tiny",
                "angles of 1e-200",
                TurnsSince { alpha: 3e-200, gamma: -1e-200, alpha0: 1e-200, gamma0: 0.0, ..hand },
            ),
            Case::running(
                "0.6435 - 0.6, 0.6435 - 0.5; 0.6435 - 0.25, 0.6435 + 1",
                TurnsSince {
                    alpha: 0.6435,
                    gamma: 0.6435,
                    alpha0: 0.6,
                    gamma0: 0.5,
                    theta1_ref: 0.25,
                    theta3_ref: -1.0,
                },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("both displacements differ by a constant, so they change by the same amount", |i| {
            let here = Self::eval(i);
            let pairs = [
                (here.ur1 - here.ur1_mat, i.theta1_ref - i.alpha0),
                (here.ur3 - here.ur3_mat, i.theta3_ref - i.gamma0),
            ];
            law::equal_all_with(pairs, law::length([i.alpha, i.gamma, 1.0.into()].into()))
        })]
    }
}
