//! Evidence for the formulas next door: cases, kinks, laws.

use super::{
    Across, Angle, Axes, Constraint, ConstraintMoment, Driven, KineticMoment, RelativeMotion, Tilt, Tilted, Turn,
    TurnSince,
};
use crate::Octuple;
use crate::element::cardan::{CardanAngles, Triads, turns};
use crate::formula::Formula;
use crate::formula::proof::{Case, Convention, Kink, Law, Proved, hard, law};
use nalgebra::Vector3;
use num_dual::DualNum;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Axes<f64>>> {
        let agree = Axes { e1a: Vector3::x(), e2b: Vector3::y(), e3b: Vector3::z(), c2: 0.0, c3: 0.0 };
        let tilted = Axes { e2b: Vector3::new(-0.6, 0.8, 0.0), ..agree };
        let mut cases = vec![
            Case::hand("aligned", "the first axes agree: no residual", agree),
            Case::hand("tilted", "b turned about its third axis: e1a·e2b is -0.6", tilted),
            Case::hand("as-at-the-start", "and it was so at the start: no residual", Axes { c2: -0.6, ..tilted }),
            {
                let [_, e2b, e3b] = turns::PYTHAGOREAN;
                Case::running("-0.48 + 0.5, 0.6 - 0.55", Axes { e2b, e3b, c2: -0.5, c3: 0.55, ..agree })
            },
        ];
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [[e1a, ..], [_, e2b, e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Axes { e1a, e2b, e3b, c2: 0.125, c3: e1a.dot(&e3b) })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("a rotation of b about the axis does no work where the first axes agree", |i| {
                let [e2b, e3b, e1a] = law::orthonormal([i.e2b, i.e3b, i.e1a]);
                let by = Self::jacobian(&Axes { e1a, e2b, e3b, ..*i });
                let on_b = |row: &Axes<Octuple>| e2b.cross(&row.e2b) + e3b.cross(&row.e3b);
                [law::no_work(on_b(&by.g2), e1a), law::no_work(on_b(&by.g3), e1a)].concat()
            }),
            Law::<Self>::new("they are −cos β sin γ and sin β of the Cardan angles", |i| {
                let [e2b, e3b, e1b] = law::orthonormal([i.e2b, i.e3b, i.e1a]);
                let a = law::orthonormal([i.e1a, i.e3b, i.e2b]);
                let Tilt { g2, g3 } = Self::eval(&Axes { e1a: a[0], e2b, e3b, c2: 0.0.into(), c3: 0.0.into() });
                let angles = CardanAngles::eval(&Triads::new(a, [e1b, e2b, e3b]));
                let expected = [-angles.beta.cos() * angles.gamma.sin(), angles.beta.sin()];
                law::equal_all_with([(g2, expected[0]), (g3, expected[1])], 1.0.into())
            }),
        ]
    }
}

impl Proved for Angle {
    fn cases() -> Vec<Case<Across<f64>>> {
        let hand = Across { e2a: Vector3::y(), e3a: Vector3::z(), e3b: Vector3::z() };
        let mut cases = vec![
            Case::hand("aligned", "0 where both triads are the same", hand),
            Case::hand("quarter-turn", "b rotated by 90° about e1a", Across { e3b: -Vector3::y(), ..hand }),
            Case::running("sin α = 0.6", Across { e3b: turns::PYTHAGOREAN[2], ..hand }),
        ];
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [[_, e2a, e3a], [.., e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Across { e2a, e3a, e3b })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Across<f64>>> {
        let along = Across { e2a: Vector3::y(), e3a: Vector3::z(), e3b: Vector3::x() };
        vec![Case::invalid("gimbal-lock", "e3b along the axis of a: no angle", along)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let opposite = Across { e2a: Vector3::y(), e3a: Vector3::z(), e3b: -Vector3::z() };
        let none = Vector3::zeros();
        vec![Kink::<Self>::new(
            Convention::Cut,
            r"\alpha = -\pi",
            |i| i.e2a.dot(&i.e3b) == 0.0 && i.e3a.dot(&i.e3b) < 0.0,
            opposite,
            Across { e2a: none, e3a: none, e3b: Vector3::y() },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("it is the first Cardan angle, and a spin of b about e1a changes it at rate 1", |i| {
            let a @ [e1a, e2a, e3a] = law::orthonormal([i.e2a.cross(&i.e3a), i.e2a, i.e3a]);
            let b @ [e3b, ..] = law::orthonormal([i.e3b, i.e2a, i.e3a]);
            let here = Across { e2a, e3a, e3b };
            let (Turn { alpha }, by) = Self::linearized(&here);
            let cardan = CardanAngles::eval(&Triads::new(a, [b[1], b[2], b[0]])).alpha;
            law::equal_all_with([(alpha, cardan), (e3b.cross(&by.alpha.e3b).dot(&e1a), 1.0.into())], 1.0.into())
        })]
    }
}

impl Proved for RelativeMotion {
    fn cases() -> Vec<Case<TurnSince<f64>>> {
        let hand = TurnSince { alpha: 0.75, alpha0: 0.25, theta1_ref: 0.5 };
        vec![
            Case::hand("turned", "0.5 from the start, 0.25 from the reference", hand),
            Case::hand("start", "no rotation at the start", TurnSince { alpha: 0.25, ..hand }),
            Case::hard("many-turns", "a thousand radians on", TurnSince { alpha: 1000.0, ..hand }),
            Case::hard("ulp", "one ulp from the start", TurnSince { alpha: 0.25_f64.next_up(), ..hand }),
            Case::running("0.6435 - 0.6, 0.6435 - 0.25", TurnSince { alpha: 0.6435, alpha0: 0.6, theta1_ref: 0.25 }),
        ]
    }
    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("both rotations differ by a constant, so they change by the same amount", |i| {
            let here = Self::eval(i);
            law::equal_with(here.ur1 - here.ur1_mat, i.theta1_ref - i.alpha0, i.alpha)
        })]
    }
}

impl Proved for ConstraintMoment {
    fn cases() -> Vec<Case<Tilted<f64>>> {
        let hand = Tilted { e2a: Vector3::y(), e3a: Vector3::z(), m2: 3.0, m3: -4.0 };
        let [_, e2a, e3a] = hard::triad();
        let mut cases = vec![
            Case::hand("axes", "along the global axes", hand),
            Case::running("m = (0, 5, -12)", Tilted { m2: 5.0, m3: -12.0, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2, m3] = load.value;
            Case::hard(format!("moment-{}", load.id), "moments of extreme size", Tilted { e2a, e3a, m2, m3 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("it does no work on a rotation about the axis", |i| {
            let [e2a, e3a, e1a] = law::orthonormal([i.e2a, i.e3a, i.e2a.cross(&i.e3a)]);
            law::no_work(Self::eval(&Tilted { e2a, e3a, ..*i }).m, e1a)
        })]
    }
}

impl Proved for KineticMoment {
    fn cases() -> Vec<Case<Driven<f64>>> {
        let [e1a, ..] = hard::triad();
        let mut cases = vec![
            Case::hand("axis", "along the first axis", Driven { e1a: Vector3::x(), m1: 2.0 }),
            Case::running("m = (-1.5, 0, 0)", Driven { e1a: Vector3::x(), m1: -1.5 }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m1] = load.value;
            Case::hard(format!("moment-{}", load.id), "a moment of extreme size", Driven { e1a, m1 })
        }));
        cases
    }
    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "its work on a rotation about the axis is m1 times the angle, and on any other is 0",
            |i| {
                let [e1a, e2a, e3a] = law::orthonormal([i.e1a, i.e1a.yzx(), i.e1a.zxy()]);
                let m = Self::eval(&Driven { e1a, ..*i }).m;
                [law::equal(m.dot(&e1a), i.m1), law::no_work(m, e2a), law::no_work(m, e3a)].concat()
            },
        )]
    }
}
