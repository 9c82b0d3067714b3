//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{LinearPressures, ParabolicPressures, TorqueLinear, TorqueParabolic};
use crate::contact::slide_line::points::proof::parabolas;
use crate::contact::slide_line::running::{ELEMENT, PRESSURE};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use nalgebra::Vector2;

impl Proved for TorqueLinear {
    fn cases() -> Vec<Case<LinearPressures<f64>>> {
        let on = |x1: [f64; 2], x2: [f64; 2], p1, p2| LinearPressures { x1: x1.into(), x2: x2.into(), p1, p2 };
        let mut cases = vec![
            Case::hand("cylinder", "2π r² ℓ p = 2π × 4 × 3 × 0.5", on([2.0, 0.0], [2.0, 3.0], 0.5, 0.5)),
            Case::hand("disc", "2π p r³/3 from the axis to r = 3: 18π p", on([0.0, 1.0], [3.0, 1.0], 1.0, 1.0)),
            Case::hand("ramp", "p = r/3 on the disc: 2π/3 × 3⁴/4", on([0.0, 1.0], [3.0, 1.0], 0.0, 1.0)),
            Case::hand("axis", "r → 0: nothing on the axis", on([0.0, 1.0], [0.0, 2.0], 5.0, 7.0)),
            Case::hand("open", "no pressure, no torque", on([1.0, 1.0], [2.0, 3.0], 0.0, 0.0)),
            Case::hard("near-axis", "r = 1e-200", on([1e-200, 1.0], [1e-200, 2.0], 5.0, 7.0)),
            Case::hard("coincident", "ℓ = 0: derivative 0 by convention", on([1.5, 1.0], [1.5, 1.0], 2.0, 3.0)),
            Case::hard("tiny", "lengths of 1e-100", on([3e-100, 1e-100], [7e-100, 4e-100], 1e-5, 3e-5)),
            Case::hard("huge", "lengths of 1e100", on([3e100, 1e100], [7e100, 4e100], 1e-5, 3e-5)),
            {
                let ([x1, x2, _], [p1, p2, _]) = (ELEMENT, PRESSURE);
                Case::running("r² p, integrated from 3.2 to 6.2", LinearPressures { x1, x2, p1, p2 })
            },
        ];
        cases.extend(hard::places().into_iter().filter(|place| place.id != "coincident").map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, LinearPressures { x1, x2, p1: 0.75, p2: 2.5 })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearPressures<f64>>> {
        let (x1, x2) = (Vector2::new(1.0, 0.0), Vector2::new(-1.0, 0.0));
        vec![Case::invalid("negative-radius", "left of the axis", LinearPressures { x1, x2, p1: 1.0, p2: 1.0 })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::subgradient(
            r"\mathbf{x}_1 = \mathbf{x}_2",
            |i| i.x1 == i.x2,
            LinearPressures { x1: Vector2::new(1.5, 1.0), x2: Vector2::new(1.5, 1.0), p1: 2.0, p2: 3.0 },
            LinearPressures { x1: Vector2::zeros(), x2: Vector2::new(0.6, 0.8), p1: 0.0, p2: 0.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("cutting the element in two adds up to the same torque", |i| {
                let third = |a, b| a + (b - a) / 3.0;
                let cut = Vector2::new(third(i.x1.x, i.x2.x), third(i.x1.y, i.x2.y));
                let p = third(i.p1, i.p2);
                let first = Self::eval(&LinearPressures { x2: cut, p2: p, ..*i }).t;
                let second = Self::eval(&LinearPressures { x1: cut, p1: p, ..*i }).t;
                law::equal(Self::eval(i).t, first + second)
            }),
            Law::<Self>::new("it does not depend on the sequence of the nodes", |i| {
                let back = LinearPressures { x1: i.x2, x2: i.x1, p1: i.p2, p2: i.p1 };
                law::equal(Self::eval(i).t, Self::eval(&back).t)
            }),
        ]
    }
}

impl Proved for TorqueParabolic {
    fn cases() -> Vec<Case<ParabolicPressures<f64>>> {
        let on = |[x1, x2, x3]: [[f64; 2]; 3], [p1, p2, p3]: [f64; 3]| ParabolicPressures {
            x1: x1.into(),
            x2: x2.into(),
            x3: x3.into(),
            p1,
            p2,
            p3,
        };
        let bowl = [[1.0, 0.0], [2.0, 0.5], [3.0, 2.0]];
        let mut cases = vec![
            Case::hand("cylinder", "2π r² ℓ p = 2π × 4 × 6 × 0.5", on([[2.0, 0.0], [2.0, 3.0], [2.0, 6.0]], [0.5; 3])),
            Case::hand(
                "disc",
                "p = r/6 from the axis to r = 6: 2π/6 × 6⁴/4",
                on([[0.0, 1.0], [3.0, 1.0], [6.0, 1.0]], [0.0, 0.5, 1.0]),
            ),
            Case::hand(
                "parabolic-pressure",
                "p = (r/6)² on that disc: 2π/36 × 6⁵/5",
                on([[0.0, 1.0], [3.0, 1.0], [6.0, 1.0]], [0.0, 0.25, 1.0]),
            ),
            Case::hand("axis", "r → 0: nothing on the axis", on([[0.0, 1.0], [0.0, 2.0], [0.0, 2.5]], [5.0, 6.0, 7.0])),
            Case::hand("open", "no pressure, no torque", on(bowl, [0.0; 3])),
            Case::hand("bowl", "a curved element", on(bowl, [0.5, 0.25, 0.75])),
            Case::hard("near-axis", "r = 1e-200", on([[1e-200, 1.0], [1e-200, 2.0], [1e-200, 3.5]], [5.0, 6.0, 7.0])),
            Case::hard("closed", "x1 = x3, X'(0) = 0", on([[1.0, 1.0], [2.0, 1.5], [1.0, 1.0]], [1.0, 2.0, 3.0])),
            Case::hard("coincident", "all nodes coincide", on([[1.5, 1.0]; 3], [1.0, 2.0, 3.0])),
            {
                let ([x1, x2, x3], [p1, p2, p3]) = (ELEMENT, PRESSURE);
                Case::running("r² p, integrated from 3.2 to 9.2", ParabolicPressures { x1, x2, x3, p1, p2, p3 })
            },
        ];
        cases.extend(parabolas().into_iter().map(|p| {
            // Shifted to the right of the axis, and scaled to sizes whose third power does not over- or underflow.
            let factor = match p.id {
                "tiny" => 1e100,
                "huge" => 1e-100,
                _ => 1.0,
            };
            let [x1, x2, x3] = p.value.map(|x| x * factor);
            let right = Vector2::new((-x1.x).max(0.0), 0.0);
            let (x1, x2, x3) = (x1 + right, x2 + right, x3 + right);
            Case::hard(p.id, p.comment, ParabolicPressures { x1, x2, x3, p1: 0.75, p2: 2.5, p3: 1.25 })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicPressures<f64>>> {
        let on = |r| Vector2::new(r, r);
        let i = ParabolicPressures { x1: on(1.0), x2: on(-0.5), x3: on(2.0), p1: 1.0, p2: 1.0, p3: 1.0 };
        vec![Case::invalid("negative-radius", "left of the axis", i)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::subgradient(
            r"\mathbf{x}_1 = \mathbf{x}_3",
            |i| i.x1 == i.x3,
            {
                let (x1, x2) = (Vector2::new(1.0, 1.0), Vector2::new(2.0, 1.5));
                ParabolicPressures { x1, x2, x3: x1, p1: 1.0, p2: 2.0, p3: 3.0 }
            },
            {
                let still = Vector2::zeros();
                ParabolicPressures { x1: still, x2: still, x3: Vector2::new(0.5, 1.0), p1: 0.0, p2: 0.0, p3: 0.0 }
            },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("with midside node and pressure in the middle it is that of ISL21A", |i| {
                let half = crate::Octuple::from(0.5);
                let straight = ParabolicPressures { x2: (i.x1 + i.x3) * half, p2: (i.p1 + i.p3) * half, ..*i };
                let linear = LinearPressures { x1: i.x1, x2: i.x3, p1: i.p1, p2: i.p3 };
                law::equal(Self::eval(&straight).t, TorqueLinear::eval(&linear).t)
            }),
            Law::<Self>::new("it does not depend on the sequence of the nodes", |i| {
                let back = ParabolicPressures { x1: i.x3, x3: i.x1, p1: i.p3, p3: i.p1, ..*i };
                law::equal(Self::eval(i).t, Self::eval(&back).t)
            }),
        ]
    }
}
