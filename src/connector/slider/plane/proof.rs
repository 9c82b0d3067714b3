//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{
    Constraint2d, Eliminate2d, Increment2d, IncrementalConstraint2d, KeptCoordinate2d, KeptIncrement2d, MovingNodes2d,
    Nodes2d,
};
use crate::Octuple;
use crate::connector::slider::hard::{change_of_pivot, plane_lines, scenes};
use crate::connector::slider::running::{
    PLANE_BESIDE as BESIDE, PLANE_DX1 as DX1, PLANE_DXM as DXM, PLANE_DXN as DXN, PLANE_X1 as X1, PLANE_XM as XM,
    PLANE_XN as XN,
};
use crate::connector::slider::{Constraint, Increment, IncrementalConstraint, KeptIncrement, MovingNodes, Nodes};
use crate::connector::slider::{Pivots, Pivots2d};
use crate::formula::proof::{Case, Equation, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{abs, norm, sign};
use nalgebra::{Vector2, Vector3};

impl Proved for Constraint2d {
    fn cases() -> Vec<Case<Nodes2d<f64>>> {
        let hand = Nodes2d { x1: Vector2::new(1.0, 1.0), xn: Vector2::new(4.0, 5.0), xm: Vector2::new(2.0, 4.0) };
        let mut cases = vec![
            Case::hand("left", "t = (-0.8, 0.6): g = -0.8 + 1.8", hand),
            Case::hand("right", "the same on the other side", Nodes2d { xm: Vector2::new(2.0, 0.0), ..hand }),
            Case::hand("at-node-n", "on the line", Nodes2d { xm: hand.xn, ..hand }),
            Case::running("t = (-0.8, 0.6): g = -0.8 + 1.8", Nodes2d { x1: X1, xn: XN, xm: BESIDE }),
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
        vec![Case::invalid("coincident", "nodes 1 and n coincide", Nodes2d { x1, xn: x1, xm: Vector2::zeros() })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("in the plane z = 0 of space (g1, g2) is (0, g sign n2); along i it is (−g, 0)", |i| {
            let zero = num_traits::Zero::zero();
            let space = |v: Vector2<_>| Vector3::new(v.x, v.y, zero);
            let nodes = Nodes { x1: space(i.x1), xn: space(i.xn), xm: space(i.xm) };
            let (flat, full) = (Self::eval(i).g, Constraint::eval(&nodes));
            in_space(i.xn.y - i.x1.y, flat, [full.g1, full.g2])
        })]
    }
}

impl Proved for IncrementalConstraint2d {
    fn cases() -> Vec<Case<MovingNodes2d<f64>>> {
        let hand = MovingNodes2d {
            x1: Vector2::zeros(),
            xn: Vector2::new(4.0, 3.0),
            xm: Vector2::new(2.0, 1.5),
            dx1: Vector2::zeros(),
            dxn: Vector2::new(0.0, 1.0),
            dxm: Vector2::new(0.0, 0.5),
        };
        let same = Vector2::new(1.0, -2.0);
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n", hand),
            Case::hand("lagging", "t = (-0.6, 0.8): r = -0.8 × 0.5", MovingNodes2d { dxm: Vector2::zeros(), ..hand }),
            Case::hand("translation", "all alike", MovingNodes2d { dx1: same, dxn: same, dxm: same, ..hand }),
            Case::hand(
                "sliding",
                "m moves along the resting line",
                MovingNodes2d { dxn: Vector2::zeros(), dxm: Vector2::new(4.0, 3.0), ..hand },
            ),
            Case::running(
                "w = (2.5, 1): t·(0.5, 0.8) = -0.4 + 0.48",
                MovingNodes2d { x1: X1, xn: XN, xm: XM, dx1: DX1, dxn: DXN, dxm: DXM },
            ),
        ];
        cases.extend(scenes(plane_lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxm = (dx1 + dxn) * 0.5;
            Case::hard(id, line.comment, MovingNodes2d { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxm })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<MovingNodes2d<f64>>> {
        let (x1, zero) = (Vector2::new(1.0, 2.0), Vector2::zeros());
        let inputs = MovingNodes2d { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxm: zero };
        vec![Case::invalid("coincident", "nodes 1 and n coincide", inputs)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("on the line it is the variation of the constraint: that of t cancels", |i| {
                let xm = i.x1 + (i.xn - i.x1) * i.xm.x; // any fraction of the line
                let at = MovingNodes2d { xm, ..*i };
                let by = Constraint2d::jacobian(&Nodes2d { x1: at.x1, xn: at.xn, xm }).g;
                let size = (length(at.dx1) + length(at.dxn)) * (abs(i.xm.x) + 1.0) + length(at.dxm);
                law::equal_with(Self::eval(&at).r, by.x1.dot(&at.dx1) + by.xn.dot(&at.dxn) + by.xm.dot(&at.dxm), size)
            }),
            Law::<Self>::new("the increments that the elimination gives satisfy it, on the line and off it", |i| {
                let MovingNodes2d { x1, xn, xm, dx1, dxn, mut dxm } = *i;
                let Pivots2d { i: axis, k } = Pivots2d::new(&x1, &xn);
                dxm[axis] = Increment2d::eval(&KeptIncrement2d { x1, xn, xm, dx1, dxn, dxmk: dxm[k] }).dxmi;
                law::vanish([Self::eval(&MovingNodes2d { dxm, ..*i }).r], length(dxm) + length(dx1) + length(dxn))
            }),
            Law::<Self>::new("in the plane z = 0 of space (r1, r2) is (0, r sign n2); along i it is (−r, 0)", |i| {
                let zero = num_traits::Zero::zero();
                let space = |v: Vector2<_>| Vector3::new(v.x, v.y, zero);
                let [x1, xn, xm, dx1, dxn, dxm] = [i.x1, i.xn, i.xm, i.dx1, i.dxn, i.dxm].map(space);
                let full = IncrementalConstraint::eval(&MovingNodes { x1, xn, xm, dx1, dxn, dxm });
                let flat = Self::eval(i).r;
                in_space(i.xn.y - i.x1.y, flat, [full.r1, full.r2])
            }),
        ]
    }
}

/// The two conditions in space, along the tangents of a line in the plane z = 0, equal those in the plane.
fn in_space(n2: Octuple, flat: Octuple, [first, second]: [Octuple; 2]) -> Vec<Equation> {
    let zero = flat * 0.0;
    if n2 == 0.0 {
        law::equal_all([(first, -flat), (second, zero)])
    } else {
        law::equal_all([(first, zero), (second, flat * sign(n2))])
    }
}

/// The length of a vector in the plane.
fn length(v: Vector2<Octuple>) -> Octuple {
    norm(v.into())
}

impl Proved for Eliminate2d {
    fn cases() -> Vec<Case<KeptCoordinate2d<f64>>> {
        let hand = KeptCoordinate2d { x1: Vector2::zeros(), xn: Vector2::new(4.0, 2.0), xmk: 8.0 };
        let mut cases = vec![
            Case::hand("twice", "k = 1, i = 2: m is twice as far as n, xm2 = 4", hand),
            Case::hand("at-node-1", "m at node 1", KeptCoordinate2d { xmk: 0.0, ..hand }),
            Case::hand("at-node-n", "m at node n", KeptCoordinate2d { xmk: 4.0, ..hand }),
            Case::running("k = 2, i = 1: 1 + 0.75 × 3", KeptCoordinate2d { x1: X1, xn: XN, xmk: XM.y }),
        ];
        cases.extend(scenes(plane_lines()).into_iter().map(|(id, line, xm)| {
            let xmk = xm[Pivots2d::new(&line.x1, &line.xn).k];
            Case::hard(id, line.comment, KeptCoordinate2d { x1: line.x1, xn: line.xn, xmk })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<KeptCoordinate2d<f64>>> {
        let x1 = Vector2::new(1.0, 2.0);
        vec![Case::invalid("coincident", "nodes 1 and n coincide", KeptCoordinate2d { x1, xn: x1, xmk: 1.0 })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        change_of_pivot::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptCoordinate2d { x1: Vector2::zeros(), xn, xmk: 0.375 },
            |dxn| KeptCoordinate2d { xn: dxn, ..KeptCoordinate2d::filled(0.0) },
        )
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("m is on the line: the condition in the plane holds", |i| {
                let KeptCoordinate2d { x1, xn, xmk } = *i;
                let Pivots2d { i: axis, k } = Pivots2d::new(&x1, &xn);
                let mut xm = Vector2::from_element(xmk);
                xm[axis] = Self::eval(i).xmi;
                law::vanish([Constraint2d::eval(&Nodes2d { x1, xn, xm }).g], length(x1) + length(xm) + abs(xm[k]))
            }),
            Law::<Self>::new("at the coordinate of node n it is node n", |i| {
                let Pivots2d { i: axis, k } = Pivots2d::new(&i.x1, &i.xn);
                law::equal(Self::eval(&KeptCoordinate2d { xmk: i.xn[k], ..*i }).xmi, i.xn[axis])
            }),
        ]
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
            Case::running(
                "2.5 + 0.75 × 0.8",
                KeptIncrement2d { x1: X1, xn: XN, xm: XM, dx1: DX1, dxn: DXN, dxmk: DXM.y },
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
        vec![Case::invalid("coincident", "nodes 1 and n coincide", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        change_of_pivot::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptIncrement2d {
                x1: Vector2::zeros(),
                xn,
                xm: Vector2::new(0.5, 1.0),
                dx1: Vector2::new(0.25, -0.5),
                dxn: Vector2::new(-0.5, 0.125),
                dxmk: 0.375,
            },
            |dxn| KeptIncrement2d { xn: dxn, ..KeptIncrement2d::filled(0.0) },
        )
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
