//! Evidence for the formulas of the parent module: cases, kinks, laws, other methods.

use super::{Coordinates, Eliminate, Increment, Increments, KeptCoordinate, KeptIncrement};
use crate::Octuple;
use crate::connector::slider::hard::{changes_of_pivots, lines, scenes};
use crate::connector::slider::running::{DX1, DXM, DXN, X1, XM, XN};
use crate::connector::slider::{IncrementalConstraint, MovingNodes, Pivots, documented};
use crate::formula::proof::{Case, Kink, Law, Method, Proved, law};
use crate::formula::{Fields, Formula};
use nalgebra::Vector3;

impl Proved for Eliminate {
    fn cases() -> Vec<Case<KeptCoordinate<f64>>> {
        let hand = KeptCoordinate { x1: Vector3::zeros(), xn: Vector3::new(2.0, 1.0, 4.0), xmk: 8.0 };
        let mut cases = vec![
            Case::hand("twice", "k = 3, i = 2, j = 1: m is twice as far as n, xm2 = 2, xm1 = 4", hand),
            Case::hand("at-node-1", "m at node 1", KeptCoordinate { xmk: 0.0, ..hand }),
            Case::hand("at-node-n", "m at node n", KeptCoordinate { xmk: 4.0, ..hand }),
            Case::running(
                "k = 3, i = 2, j = 1: 1 + 0.75 × 8, 1 + 0.9375 × 8",
                KeptCoordinate { x1: X1, xn: XN, xmk: XM.z },
            ),
        ];
        cases.extend(scenes(lines()).into_iter().map(|(id, line, xm)| {
            let xmk = xm[Pivots::new(&line.x1, &line.xn).k];
            Case::hard(id, line.comment, KeptCoordinate { x1: line.x1, xn: line.xn, xmk })
        }));
        cases
    }

    fn methods() -> Vec<Method> {
        vec![Method::new::<Self>(
            "documented",
            "documented route: t1, t2 and a 2×2 system",
            documented::eliminate,
            documented::eliminate,
        )]
    }

    fn invalid_cases() -> Vec<Case<KeptCoordinate<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        vec![Case::invalid("coincident", "nodes 1 and n coincide", KeptCoordinate { x1, xn: x1, xmk: 1.0 })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        changes_of_pivots::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptCoordinate { x1: Vector3::zeros(), xn, xmk: 1.5 },
            |dxn| KeptCoordinate { xn: dxn, ..KeptCoordinate::filled(0.0) },
        )
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("the documented route, through t1, t2 and the 2×2 system, gives the same", |i| {
                let (here, there) = (Self::eval(i), documented::eliminate(i));
                law::equal_all([(here.xmi, there.xmi), (here.xmj, there.xmj)])
            }),
            Law::<Self>::new("m is on the line: (xm − x1) ∥ (xn − x1)", |i| {
                let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&i.x1, &i.xn);
                let Coordinates { xmi, xmj } = Self::eval(i);
                let mut xm = Vector3::from_element(i.xmk);
                (xm[axis_i], xm[axis_j], xm[k]) = (xmi, xmj, i.xmk);
                law::parallel(xm - i.x1, i.xn - i.x1)
            }),
            Law::<Self>::new("at the coordinate of node n it is node n", |i| {
                let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&i.x1, &i.xn);
                let Coordinates { xmi, xmj } = Self::eval(&KeptCoordinate { xmk: i.xn[k], ..*i });
                law::equal_all([(xmi, i.xn[axis_i]), (xmj, i.xn[axis_j])])
            }),
        ]
    }
}

impl Proved for Increment {
    fn cases() -> Vec<Case<KeptIncrement<f64>>> {
        let hand = KeptIncrement {
            x1: Vector3::zeros(),
            xn: Vector3::new(2.0, 1.0, 4.0),
            xm: Vector3::new(1.0, 0.5, 2.0),
            dx1: Vector3::zeros(),
            dxn: Vector3::new(0.5, 1.0, 0.0),
            dxmk: 0.0,
        };
        let same = Vector3::new(1.0, -2.0, 3.0);
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n: dxm2 = 0.5, dxm1 = 0.25", hand),
            Case::hand(
                "sliding",
                "m moves along the resting line: dxm2 = 1/4 × 8, dxm1 = 2/4 × 8",
                KeptIncrement { dxn: Vector3::zeros(), dxmk: 8.0, ..hand },
            ),
            Case::hand(
                "translation",
                "all nodes move alike",
                KeptIncrement { dx1: same, dxn: same, dxmk: 3.0, ..hand },
            ),
            Case::running(
                "2 + 0.75 × 0.8, 1 + 0.9375 × 0.8",
                KeptIncrement { x1: X1, xn: XN, xm: XM, dx1: DX1, dxn: DXN, dxmk: DXM.z },
            ),
        ];
        cases.extend(scenes(lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxmk = dx1.x + dxn.z;
            Case::hard(id, line.comment, KeptIncrement { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxmk })
        }));
        cases
    }

    fn methods() -> Vec<Method> {
        vec![Method::new::<Self>(
            "documented",
            "documented route, m put on the line",
            documented::increment_on_line,
            documented::increment_on_line,
        )]
    }

    fn invalid_cases() -> Vec<Case<KeptIncrement<f64>>> {
        let (x1, zero) = (Vector3::new(1.0, 2.0, 3.0), Vector3::zeros());
        let inputs = KeptIncrement { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxmk: 0.0 };
        vec![Case::invalid("coincident", "nodes 1 and n coincide", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        changes_of_pivots::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptIncrement {
                x1: Vector3::zeros(),
                xn,
                xm: Vector3::new(0.5, 1.0, 0.75),
                dx1: Vector3::new(0.25, -0.5, 0.75),
                dxn: Vector3::new(-0.5, 0.125, 0.25),
                dxmk: 0.375,
            },
            |dxn| KeptIncrement { xn: dxn, ..KeptIncrement::filled(0.0) },
        )
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "on the line, the documented route, through t1, t2, dt1, dt2 and the 2×2 system, gives the same",
                |i| {
                    let xm = on_the_line(i);
                    let at = KeptIncrement { xm, ..*i };
                    let (here, there) = (Self::eval(&at), documented::increment(&at));
                    law::equal_all([(here.dxmi, there.dxmi), (here.dxmj, there.dxmj)])
                },
            ),
            Law::<Self>::new("the increments satisfy the incremental constraint, on the line and off it", |i| {
                let KeptIncrement { x1, xn, xm, dx1, dxn, dxmk } = *i;
                let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&x1, &xn);
                let Increments { dxmi, dxmj } = Self::eval(i);
                let mut dxm = Vector3::from_element(dxmk);
                (dxm[axis_i], dxm[axis_j], dxm[k]) = (dxmi, dxmj, dxmk);
                let r = IncrementalConstraint::eval(&MovingNodes { x1, xn, xm, dx1, dxn, dxm });
                let size = law::length(dxm) + law::length(dx1) + law::length(dxn);
                law::vanish([r.r1, r.r2], size)
            }),
            Law::<Self>::new("on the line it is the derivative of the elimination", |i| {
                let at = KeptIncrement { xm: on_the_line(i), ..*i };
                let k = Pivots::new(&at.x1, &at.xn).k;
                let jac = Eliminate::jacobian(&KeptCoordinate { x1: at.x1, xn: at.xn, xmk: at.xm[k] });
                let along = |row: KeptCoordinate<_>| row.x1.dot(&at.dx1) + row.xn.dot(&at.dxn) + row.xmk * at.dxmk;
                let Increments { dxmi, dxmj } = Self::eval(&at);
                law::equal_all([(dxmi, along(jac.xmi)), (dxmj, along(jac.xmj))])
            }),
        ]
    }
}

/// A point of the line with the k-th coordinate of xm.
fn on_the_line(i: &KeptIncrement<Octuple>) -> Vector3<Octuple> {
    let k = Pivots::new(&i.x1, &i.xn).k;
    i.x1 + (i.xn - i.x1) * ((i.xm[k] - i.x1[k]) / (i.xn[k] - i.x1[k]))
}
