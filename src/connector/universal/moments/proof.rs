//! Evidence for the formulas of the parent module: cases, laws.

use super::{ConstraintMoment, Driven, KineticMoment, Twisted};
use crate::element::cardan::turns;
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use crate::number::scalar::norm;
use nalgebra::Vector3;

impl Proved for ConstraintMoment {
    fn cases() -> Vec<Case<Twisted<f64>>> {
        let axes = Twisted { e2a: Vector3::y(), e3a: Vector3::z(), e3b: Vector3::z(), m2: 2.0 };
        let mut cases = vec![
            Case::hand("aligned", "α = 0: about e2a", axes),
            Case::hand("quarter-turn", "α = 90°: about e3a", Twisted { e3b: -Vector3::y(), ..axes }),
            Case::hand("half-turn", "α = -180°: about -e2a", Twisted { e3b: -Vector3::z(), ..axes }),
            Case::hand(
                "3-4-5",
                "cos α = 0.8, sin α = 0.6, and the size of e3b does not count",
                Twisted { e3b: Vector3::new(0.0, -3.0, 4.0), ..axes },
            ),
            Case::running("5 (0, 0.8, 0.6)", Twisted { e3b: turns::PYTHAGOREAN[2], m2: 5.0, ..axes }),
        ];
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [[_, e2a, e3a], [.., e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Twisted { e2a, e3a, e3b, m2: -1.5 })
        }));
        let [_, e2a, e3a] = hard::triad();
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2] = load.value;
            Case::hard(
                format!("moment-{}", load.id),
                "a moment of extreme size",
                Twisted { e2a, e3a, e3b: Vector3::new(0.6, 0.0, 0.8), m2 },
            )
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Twisted<f64>>> {
        let locked = Twisted { e2a: Vector3::y(), e3a: Vector3::z(), e3b: Vector3::x(), m2: 2.0 };
        vec![Case::invalid("gimbal-lock", "b's shaft in line with a's: no line of nodes", locked)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("on perpendicular shafts it is -m2 e1a × e3b", |i| {
                let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                let across = i.e3b - e1a * e1a.dot(&i.e3b);
                let e3b = across / law::length(across);
                law::equal_vectors(Self::eval(&Twisted { e2a, e3a, e3b, ..*i }).m, -e1a.cross(&e3b) * i.m2)
            }),
            Law::<Self>::new("it does no work on turns about either shaft, on orthonormal triads", |i| {
                let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                let m = Self::eval(&Twisted { e2a, e3a, ..*i }).m;
                [law::no_work(m, e1a), law::no_work(m, i.e3b)].concat()
            }),
            Law::<Self>::new(
                "in any position Jacobianᵀ · m2, with the constraint of UNIVERSAL and the spin of b, is cos β times it",
                |i| {
                    let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
                    let e3b = i.e3b / law::length(i.e3b);
                    let jac = crate::connector::universal::Constraint::jacobian(&crate::connector::universal::Shafts {
                        e1a,
                        e3b,
                        c0: i.m2,
                    });
                    let on_b = e3b.cross(&jac.g.e3b) * i.m2;
                    let cos_beta = norm([e2a.dot(&e3b), e3a.dot(&e3b)]);
                    law::equal_vectors(on_b, Self::eval(&Twisted { e2a, e3a, e3b, ..*i }).m * cos_beta)
                },
            ),
        ]
    }
}

impl Proved for KineticMoment {
    fn cases() -> Vec<Case<Driven<f64>>> {
        let axes = Driven { e1a: Vector3::x(), e3b: Vector3::z(), m1: 2.0, m3: -3.0 };
        let [e1a, _, e3b] = hard::triad();
        let mut cases = vec![
            Case::hand("axes", "m = (2, 0, -3)", axes),
            Case::running(
                "(1, 0, 0) + 2.5 (0.6, -0.48, 0.64)",
                Driven { e3b: crate::element::cardan::turns::PYTHAGOREAN[2], m1: 1.0, m3: 2.5, ..axes },
            ),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m1, m3] = load.value;
            Case::hard(load.id, "moments of extreme size", Driven { e1a, e3b, m1, m3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "it works with m1 on turns about e1a and with m3 on turns about e3b, on perpendicular shafts",
            |i| {
                let [e1a, e3b, _] = law::orthonormal([i.e1a, i.e3b, i.e1a.cross(&i.e3b)]);
                let m = Self::eval(&Driven { e1a, e3b, ..*i }).m;
                law::equal_all_with([(m.dot(&e1a), i.m1), (m.dot(&e3b), i.m3)], law::length(m))
            },
        )]
    }
}
