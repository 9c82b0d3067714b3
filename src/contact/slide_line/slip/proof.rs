//! Evidence for the formulas of the parent module: cases, laws.

use super::{LinearMotion, ParabolicMotion, SlipIncrementLinear, SlipIncrementParabolic};
use crate::Octuple;
use crate::contact::slide_line::points::proof::{arch, parabolas, quarter_point};
use crate::contact::slide_line::running::{AT_PARABOLA, LINE, MOTION, PARABOLA, SLAVE};
use crate::contact::slide_line::{left, shape};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use crate::number::scalar::norm;
use nalgebra::Vector2;

impl Proved for SlipIncrementLinear {
    fn cases() -> Vec<Case<LinearMotion<f64>>> {
        let still = Vector2::zeros();
        let hand = LinearMotion {
            x1: Vector2::new(1.0, 1.0),
            x2: Vector2::new(4.0, 5.0),
            g: 0.5,
            dxs: Vector2::new(5.0, 0.0),
            dx1: still,
            dx2: still,
        };
        let mut cases = vec![
            Case::hand("slave-moves", "t = (0.6, 0.8): 5 along r is a slip of 3", hand),
            Case::hand(
                "master-moves",
                "the material under the slave moves by a quarter and three quarters of the nodes' increments: 3 - 1.2",
                LinearMotion { dx1: Vector2::new(2.0, 0.0), dx2: Vector2::new(2.0, 0.0), ..hand },
            ),
            Case::hand(
                "together",
                "no slip when slave and segment move alike",
                LinearMotion { dx1: hand.dxs, dx2: hand.dxs, ..hand },
            ),
            Case::hand("normal", "no slip along the normal", LinearMotion { x2: Vector2::new(1.0, 5.0), ..hand }),
            Case::hand("still", "nothing moves", LinearMotion { dxs: still, ..hand }),
            {
                let ([x1, x2, _], [dxs, dx1, dx2, _]) = (LINE, MOTION);
                Case::running("t·((0.3, 0.1) - (0.16, 0.08))", LinearMotion { x1, x2, g: SLAVE.1, dxs, dx1, dx2 })
            },
        ];
        let [dxs, dx1, dx2] = steps();
        let places = hard::places().into_iter().filter(|place| place.id != "coincident");
        cases.extend(places.map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, LinearMotion { x1, x2, g: -0.3125, dxs, dx1, dx2 })
        }));
        cases.push(Case::hard(
            "nearly-together",
            "increments of 1e8 that differ by 1",
            LinearMotion { dxs: carried(dxs), dx1: carried(dx1), dx2: carried(dx2), ..hand },
        ));
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearMotion<f64>>> {
        let x = Vector2::new(1.0, 2.0);
        let [dxs, dx1, dx2] = steps();
        vec![Case::invalid("coincident", "no tangent", LinearMotion { x1: x, x2: x, g: 0.0, dxs, dx1, dx2 })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("a common displacement is no slip", |i| {
                let (a, b) = (i.dxs, i.dxs + i.dxs);
                let alike = LinearMotion { dxs: i.dxs + a, dx1: i.dx1 + a, dx2: i.dx2 + a, ..*i };
                let twice = LinearMotion { dxs: i.dxs + b, dx1: i.dx1 + b, dx2: i.dx2 + b, ..*i };
                law::equal_with(Self::eval(&alike).dslip, Self::eval(&twice).dslip, norm([b.x, b.y]))
            }),
            Law::<Self>::new(
                "a small rotation of slave point and segment together is no slip of a point on the segment",
                |i| {
                    let [n1, n2] = shape::linear(i.g);
                    let turn = |x: Vector2<_>| left(x);
                    let xs = i.x1 * n1 + i.x2 * n2;
                    let spun = LinearMotion { dxs: turn(xs), dx1: turn(i.x1), dx2: turn(i.x2), ..*i };
                    law::equal_with(Self::eval(&spun).dslip, 0.0.into(), norm([i.x1.x, i.x1.y, i.x2.x, i.x2.y]))
                },
            ),
        ]
    }
}

impl Proved for SlipIncrementParabolic {
    fn cases() -> Vec<Case<ParabolicMotion<f64>>> {
        let [dxs, dx1, dx2] = steps();
        let dx3 = Vector2::new(-0.125, 0.25);
        let still = Vector2::zeros();
        let place = |[x1, x2, x3]: [Vector2<f64>; 3], g| ParabolicMotion { x1, x2, x3, g, dxs, dx1, dx2, dx3 };
        let hand = ParabolicMotion {
            dxs: Vector2::new(5.0, 0.0),
            dx1: still,
            dx2: still,
            dx3: still,
            ..place(arch(2.0), 0.375)
        };
        let mut cases = vec![
            Case::hand("arch", "z = 2 - 2(r - 2)² at g = 3/8 has X' = (1, -1.5)", hand),
            Case::hand(
                "crown",
                "at the crown t = (1, 0): 5 along r is a slip of 5",
                ParabolicMotion { g: 0.0, ..hand },
            ),
            Case::hand(
                "together",
                "no slip when slave and segment move alike",
                ParabolicMotion { dx1: hand.dxs, dx2: hand.dxs, dx3: hand.dxs, ..hand },
            ),
            Case::hand("still", "nothing moves", ParabolicMotion { dxs: still, ..hand }),
            {
                let ([x1, x2, x3], [dxs, dx1, dx2, dx3]) = (PARABOLA, MOTION);
                Case::running(
                    "t·((0.3, 0.1) - (0.1, 0.2))",
                    ParabolicMotion { x1, x2, x3, g: AT_PARABOLA.1, dxs, dx1, dx2, dx3 },
                )
            },
        ];
        cases.extend(parabolas().into_iter().map(|p| {
            let width = p.value[2].x - p.value[0].x;
            let [dxs, dx1, dx2, dx3] = [dxs, dx1, dx2, dx3].map(|step| step * width);
            Case::hard(p.id, p.comment, ParabolicMotion { dxs, dx1, dx2, dx3, ..place(p.value, -0.6875) })
        }));
        cases.push(Case::hard(
            "nearly-together",
            "increments of 1e8 that differ by 1",
            ParabolicMotion { dxs: carried(dxs), dx1: carried(dx1), dx2: carried(dx2), dx3: carried(dx3), ..hand },
        ));
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicMotion<f64>>> {
        let [dxs, dx1, dx2] = steps();
        let at = |[x1, x2, x3]: [Vector2<f64>; 3], g| ParabolicMotion { x1, x2, x3, g, dxs, dx1, dx2, dx3: dx1 };
        let [x1, x2, _] = arch(1.0);
        vec![
            Case::invalid("coincident", "two nodes coincide", at([x1, x2, x2], 0.5)),
            Case::invalid("no-tangent", "X' = 0 beside a quarter-point node", at(quarter_point(), -1.0)),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "with the midside node in the middle, of the motion too, it is that of the straight segment",
            |i| {
                let half = Octuple::from(0.5);
                let straight = ParabolicMotion { x2: (i.x1 + i.x3) * half, dx2: (i.dx1 + i.dx3) * half, ..*i };
                let linear = LinearMotion { x1: i.x1, x2: i.x3, g: i.g, dxs: i.dxs, dx1: i.dx1, dx2: i.dx3 };
                let size = norm([i.dxs.x, i.dxs.y, i.dx1.x, i.dx1.y, i.dx3.x, i.dx3.y]);
                law::equal_with(Self::eval(&straight).dslip, SlipIncrementLinear::eval(&linear).dslip, size)
            },
        )]
    }
}

/// Displacement increments without any pattern.
fn steps() -> [Vector2<f64>; 3] {
    [Vector2::new(0.75, -0.25), Vector2::new(0.125, 0.375), Vector2::new(-0.5, 0.0625)]
}

/// A step on top of a large common displacement.
fn carried(step: Vector2<f64>) -> Vector2<f64> {
    step + Vector2::new(1e8, -1e8)
}
