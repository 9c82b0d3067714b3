//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{ClosestParabolic, ParabolicSlave};
use crate::Octuple;
use crate::contact::slide_line::closest::{Foot, evidence};
use crate::contact::slide_line::points::proof::{arch, parabolas, quarter_point};
use crate::contact::slide_line::running::{AT_PARABOLA, PARABOLA};
use crate::contact::slide_line::{ClosestLinear, LinearSlave, ParabolicPlace, ParabolicPoint, left, length};
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{norm, sign};
use nalgebra::Vector2;

impl Proved for ClosestParabolic {
    fn cases() -> Vec<Case<ParabolicSlave<f64>>> {
        let mut cases = vec![
            Case::hand(
                "below-centre",
                "on the axis of z = (r-2)², below the centre of curvature (2, 0.5)",
                in_bowl(2.0, 0.25),
            ),
            Case::hand("on-the-curve", "separation 0", in_bowl(2.5, 0.25)),
            Case::hand("outside", "penetration of 3 at the vertex", in_bowl(2.0, -3.0)),
            Case::hand("tied", "(2, 1) is as near to g = -√½ as to g = √½: the smaller is taken", in_bowl(2.0, 1.0)),
            Case::hand("beyond-first", "the foot stays at the first node", in_bowl(-2.0, 1.0)),
            Case::hand("beyond-last", "the foot stays at the last node", in_bowl(5.0, 1.0)),
            Case::hand("at-first", "foot exactly at the first node", in_bowl(-1.0, 0.0)),
            Case::hand("at-last", "foot exactly at the last node", in_bowl(5.0, 0.0)),
            Case::hard("centre", "on the centre of curvature: three feet merge", in_bowl(2.0, 0.5)),
            Case::hard("near-centre-1e-4", "1e-4 beside the centre of curvature", in_bowl(2.0 + 1e-4, 0.5)),
            Case::hard("near-centre-1e-8", "1e-8 beside the centre of curvature", in_bowl(2.0 + 1e-8, 0.5)),
            Case::hard("near-centre-1e-10", "1e-10 beside the centre of curvature", in_bowl(2.0 + 1e-10, 0.5)),
            Case::hard(
                "two-feet",
                "above the centre of curvature: two roots nearly equal",
                in_bowl(2.0 + 1e-9, 0.5 + 1e-5),
            ),
            Case::hard("near-medial", "1e-12 beside the medial axis", in_bowl(2.0 + 1e-12, 1.0)),
            Case::hard("far-slave", "the slave point 1e10 away", in_bowl(2.5, -1e10)),
            Case::hard("near-slave", "the slave point 1e-12 away", in_bowl(2.5, 0.25 + 1e-12)),
            Case::hard("inside-last", "1e-8 before the last node", in_bowl(5.0 - 1e-8, 0.0)),
            {
                let ([x1, x2, x3], (xs, _)) = (PARABOLA, AT_PARABOLA);
                Case::running("(4.375, 1.875) is nearest", ParabolicSlave { xs, x1, x2, x3 })
            },
        ];
        let slave = |[x1, x2, x3]: [Vector2<f64>; 3], along: f64, across: f64| {
            let chord = x3 - x1;
            ParabolicSlave { xs: x1 + chord * along + left(chord) * across, x1, x2, x3 }
        };
        cases.extend(parabolas().into_iter().map(|p| Case::hard(p.id, p.comment, slave(p.value, 0.5625, 0.3125))));
        cases.push(Case::hard(
            "quarter-point-tip",
            "close to the end next to a quarter-point node, where X' nearly vanishes",
            slave(quarter_point(), 1e-6, 1e-3),
        ));
        cases.push(Case::hard(
            "needle",
            "the curve nearly folds back, and the slave point is before the tip",
            slave([Vector2::new(1.0, 0.0), Vector2::new(4.0, 1e-3), Vector2::new(5.0, 0.0)], 1.25, 0.0),
        ));
        cases.push(Case::hard(
            "end-at-origin",
            "far nodes must not blur the foot",
            ParabolicSlave {
                xs: Vector2::new(-1e-9, 3e-9),
                x1: Vector2::new(-4.0, -6.0),
                x2: Vector2::new(-2.0, -2.5),
                x3: Vector2::zeros(),
            },
        ));
        cases
    }

    fn placed(drawn: ParabolicSlave<f64>) -> ParabolicSlave<f64> {
        let ParabolicSlave { xs, x1, x2, x3 } = drawn;
        let on = |g| {
            let point = ParabolicPoint::eval(&ParabolicPlace { x1, x2, x3, g });
            [point.x, point.dx]
        };
        ParabolicSlave { xs: evidence::slave_point(xs, on), ..drawn }
    }

    fn invalid_cases() -> Vec<Case<ParabolicSlave<f64>>> {
        let at = |xs: [f64; 2], [x1, x2, x3]: [Vector2<f64>; 3]| ParabolicSlave { xs: xs.into(), x1, x2, x3 };
        let [x1, x2, _] = arch(1.0);
        let folded = [[1.0, 1.0], [4.0, 4.0], [5.0, 5.0]].map(Vector2::from);
        vec![
            Case::invalid("coincident", "two nodes coincide", at([1.0, 3.0], [x1, x2, x2])),
            Case::invalid("quarter-point-end", "foot where X' = 0", at([0.0, 1.0], quarter_point())),
            Case::invalid(
                "folded",
                "the curve turns back on itself before it reaches the slave point",
                at([9.0, 9.0], folded),
            ),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switch(
                r"(\mathbf{x}_s-\mathbf{X})\cdot\mathbf{X}' = 0 \text{ at } g = \pm 1",
                |i| Foot::on(&i.view()).is_exactly_at_end(&i.view()),
                in_bowl(5.0, 0.0),
                along_r(),
            ),
            Kink::<Self>::switch(
                r"\text{two places equally near}",
                |i| i.view().is_tied(),
                in_bowl(2.0, 1.0),
                along_r(),
            ),
            Kink::<Self>::switch(
                r"\mathbf{x}_s \text{ on the centre of curvature}",
                |i| Foot::on(&i.view()).is_centre_of_curvature(),
                in_bowl(2.0, 0.5),
                along_r(),
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("xs − X is perpendicular to the curve, or the closest point is an end", |i| {
                let g = Self::eval(i).g;
                let point = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g });
                let (along, zero) = ((i.xs - point.x).dot(&point.dx), Octuple::from(0.0));
                let outside = g * g == 1.0 && sign(along) == sign(g);
                let size = norm([i.xs - i.x1, i.x2 - i.x1, i.x3 - i.x1].map(length));
                law::equal_with(if outside { zero } else { along }, zero, size * size)
            }),
            Law::<Self>::new(
                "half-way to the closest point, the closest point is the same and the separation is half",
                |i| {
                    let here = Self::eval(i);
                    let foot = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g: here.g }).x;
                    let nearer = Self::eval(&ParabolicSlave { xs: (i.xs + foot) * Octuple::from(0.5), ..*i });
                    let size = length(i.xs - foot) + length(i.x3 - i.x1);
                    [
                        law::equal_with(here.g, nearer.g, 1.0.into()),
                        law::equal_with(here.separation, nearer.separation * 2.0, size),
                    ]
                    .concat()
                },
            ),
            Law::<Self>::new(
                "with the midside node in the middle it is the closest point of the straight segment",
                |i| {
                    let middle = (i.x1 + i.x3) * Octuple::from(0.5);
                    let straight = Self::eval(&ParabolicSlave { x2: middle, ..*i });
                    let linear = ClosestLinear::eval(&LinearSlave { xs: i.xs, x1: i.x1, x2: i.x3 });
                    [
                        law::equal_with(straight.g, linear.g, 1.0.into()),
                        law::equal_with(straight.separation, linear.separation, length(i.xs - i.x1)),
                    ]
                    .concat()
                },
            ),
            Law::<Self>::new("reversing the nodes reverses g and the sign of the separation", |i| {
                let (here, back) = (Self::eval(i), Self::eval(&ParabolicSlave { x1: i.x3, x3: i.x1, ..*i }));
                [
                    law::equal_with(here.g, -back.g, 1.0.into()),
                    law::equal_with(here.separation, -back.separation, length(i.xs - i.x1)),
                ]
                .concat()
            }),
        ]
    }
}

/// A slave point close to the parabola z = (r − 2)² from (1, 1) to (3, 1), at r = g + 2.
fn in_bowl(r: f64, z: f64) -> ParabolicSlave<f64> {
    let [x1, x2, x3] = arch(-1.0).map(|x| x + Vector2::new(0.0, 1.0));
    ParabolicSlave { xs: Vector2::new(r, z), x1, x2, x3 }
}

fn along_r() -> ParabolicSlave<f64> {
    ParabolicSlave { xs: Vector2::new(1.0, 0.0), ..ParabolicSlave::filled(0.0) }
}
