//! Evidence for the formulas next door: cases, kinks, laws.

use super::{Constraint2d, Increment2d, KeptIncrement2d, Nodes2d};
use crate::formula::{Fields, Formula};
use crate::proof::{Case, Kink, Law, Proved, law};
use crate::scalar::{abs, sign};
use crate::slider::hard::{plane_lines, scenes};
use crate::slider::{Constraint, Increment, KeptIncrement, Nodes};
use crate::slider::{Pivots, Pivots2d};
use nalgebra::{Vector2, Vector3};

impl Proved for Constraint2d {
    fn cases() -> Vec<Case<Nodes2d<f64>>> {
        let hand = Nodes2d { x1: Vector2::new(1.0, 1.0), xn: Vector2::new(4.0, 5.0), xm: Vector2::new(2.0, 4.0) };
        let mut cases = vec![
            Case::hand("left", "t = (-0.8, 0.6): g = -0.8 + 1.8", hand),
            Case::hand("right", "the same on the other side", Nodes2d { xm: Vector2::new(2.0, 0.0), ..hand }),
            Case::hand("at-node-n", "on the line", Nodes2d { xm: hand.xn, ..hand }),
        ];
        cases.extend(
            scenes(plane_lines())
                .into_iter()
                .map(|(id, line, xm)| Case::hard(id, line.comment, Nodes2d { x1: line.x1, xn: line.xn, xm })),
        );
        cases
    }

    fn invalid_cases() -> Vec<Case<Nodes2d<f64>>> {
        let x1 = Vector2::new(1.0, 2.0);
        vec![Case::invalid("coincident", "nodes 1 and n at one place", Nodes2d { x1, xn: x1, xm: Vector2::zeros() })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("in the plane z = 0 of space (g1, g2) is (0, g sign n2); along i it is (−g, 0)", |i| {
            let zero = num_traits::Zero::zero();
            let space = |v: Vector2<_>| Vector3::new(v.x, v.y, zero);
            let nodes = Nodes { x1: space(i.x1), xn: space(i.xn), xm: space(i.xm) };
            let (flat, full) = (Self::eval(i).g, Constraint::eval(&nodes));
            let sign = sign(i.xn.y - i.x1.y);
            if sign == 0.0 {
                law::equal_all([(full.g1, -flat), (full.g2, zero)])
            } else {
                law::equal_all([(full.g1, zero), (full.g2, flat * sign)])
            }
        })]
    }
}

impl Proved for Increment2d {
    fn cases() -> Vec<Case<KeptIncrement2d<f64>>> {
        let hand = KeptIncrement2d {
            x1: Vector2::zeros(),
            xn: Vector2::new(4.0, 2.0),
            xm: Vector2::new(2.0, 1.0),
            dx1: Vector2::zeros(),
            dxn: Vector2::new(0.0, 1.0),
            dxmk: 0.0,
        };
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n", hand),
            Case::hand(
                "sliding",
                "m moves along the resting line: dxm2 = 2/4 × 3",
                KeptIncrement2d { dxn: Vector2::zeros(), dxmk: 3.0, ..hand },
            ),
        ];
        cases.extend(scenes(plane_lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxmk = dx1.x + dxn.y;
            Case::hard(id, line.comment, KeptIncrement2d { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxmk })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<KeptIncrement2d<f64>>> {
        let (x1, zero) = (Vector2::new(1.0, 2.0), Vector2::zeros());
        let inputs = KeptIncrement2d { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxmk: 0.0 };
        vec![Case::invalid("coincident", "nodes 1 and n at one place", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"\lvert d_1\rvert = \lvert d_2\rvert",
            |i| abs(i.xn.x - i.x1.x) == abs(i.xn.y - i.x1.y),
            KeptIncrement2d {
                x1: Vector2::zeros(),
                xn: Vector2::new(2.0, -2.0),
                xm: Vector2::new(0.5, 1.0),
                dx1: Vector2::new(0.25, -0.5),
                dxn: Vector2::new(-0.5, 0.125),
                dxmk: 0.375,
            },
            KeptIncrement2d { xn: Vector2::new(1.0, 0.0), ..KeptIncrement2d::filled(0.0) },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "in the plane z = 0 of space it is the eliminated increment that is not along z, where no tie lets \
                        both keep different axes",
            |i| {
                let zero = num_traits::Zero::zero();
                let space = |v: Vector2<_>| Vector3::new(v.x, v.y, zero);
                let [x1, xn, xm, dx1, dxn] = [i.x1, i.xn, i.xm, i.dx1, i.dxn].map(space);
                let full = Increment::eval(&KeptIncrement { x1, xn, xm, dx1, dxn, dxmk: i.dxmk });
                let (axes, flat) = (Pivots::new(&x1, &xn), Self::eval(i).dxmi);
                match axes {
                    axes if axes.k != Pivots2d::new(&i.x1, &i.xn).k => Vec::new(),
                    Pivots { i: 2, .. } => law::equal_all([(full.dxmi, zero), (full.dxmj, flat)]),
                    _ => law::equal_all([(full.dxmi, flat), (full.dxmj, zero)]),
                }
            },
        )]
    }
}
