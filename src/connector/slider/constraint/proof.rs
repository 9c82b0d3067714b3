//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{Constraint, Distances, IncrementalConstraint, IncrementalResiduals, MovingNodes, Nodes};
use crate::connector::slider::hard::{lines, scenes};
use crate::connector::slider::running::{BESIDE, DX1, DXM, DXN, X1, XM, XN};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::number::scalar::abs;
use nalgebra::Vector3;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Nodes<f64>>> {
        let hand =
            Nodes { x1: Vector3::new(1.0, 1.0, 1.0), xn: Vector3::new(1.0, 4.0, 5.0), xm: Vector3::new(3.0, 5.0, 4.0) };
        let mut cases = vec![
            Case::hand("off-the-line", "t1 = (0, 0.8, -0.6), t2 = (-1, 0, 0): g1 = 3.2 - 1.8, g2 = -2", hand),
            Case::hand("at-node-1", "both residuals vanish", Nodes { xm: hand.x1, ..hand }),
            Case::hand("at-node-n", "both residuals vanish", Nodes { xm: hand.xn, ..hand }),
            Case::running(
                "t1·(8, 7, 8) = 5.6 - 4.8, t2·(8, 7, 8) = -6.4 + 2.52 + 3.84",
                Nodes { x1: X1, xn: XN, xm: BESIDE },
            ),
        ];
        cases.extend(
            scenes(lines())
                .into_iter()
                .map(|(id, line, xm)| Case::hard(id, line.comment, Nodes { x1: line.x1, xn: line.xn, xm })),
        );
        cases
    }

    fn invalid_cases() -> Vec<Case<Nodes<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        vec![Case::invalid("coincident", "nodes 1 and n coincide", Nodes { x1, xn: x1, xm: Vector3::zeros() })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"\mathbf{n}\times\mathbf{i} = \mathbf{0}",
            |i| i.xn.y == i.x1.y && i.xn.z == i.x1.z,
            Nodes { x1: Vector3::zeros(), xn: Vector3::new(2.0, 0.0, 0.0), xm: Vector3::new(1.0, 0.5, -0.25) },
            Nodes { x1: Vector3::zeros(), xn: Vector3::new(0.0, 3.0, 4.0), xm: Vector3::zeros() },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("g1² + g2² is the squared distance of m from the line, for any t1 and t2", |i| {
                let Distances { g1, g2 } = Self::eval(i);
                let d = i.xn - i.x1;
                let offset = i.xm - i.x1;
                let moment = offset.cross(&d);
                let size = d.dot(&d) * offset.dot(&offset);
                law::equal_with((g1 * g1 + g2 * g2) * d.dot(&d), moment.dot(&moment), size)
            }),
            Law::<Self>::new("it vanishes on the line", |i| {
                let xm = i.x1 + (i.xn - i.x1) * i.xm.x; // any fraction of the line
                let Distances { g1, g2 } = Self::eval(&Nodes { xm, ..*i });
                law::vanish([g1, g2], law::length(i.x1) + law::length(xm))
            }),
        ]
    }
}

impl Proved for IncrementalConstraint {
    fn cases() -> Vec<Case<MovingNodes<f64>>> {
        let hand = MovingNodes {
            x1: Vector3::zeros(),
            xn: Vector3::new(0.0, 3.0, 4.0),
            xm: Vector3::new(0.0, 1.5, 2.0),
            dx1: Vector3::zeros(),
            dxn: Vector3::new(0.5, 1.0, 0.0),
            dxm: Vector3::new(0.25, 0.5, 0.0),
        };
        let same = Vector3::new(1.0, -2.0, 3.0);
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n", hand),
            Case::hand(
                "lagging",
                "t1 = (0, 0.8, -0.6), t2 = (-1, 0, 0): r1 = -0.4, r2 = 0.25",
                MovingNodes { dxm: Vector3::zeros(), ..hand },
            ),
            Case::hand("translation", "all nodes move alike", MovingNodes { dx1: same, dxn: same, dxm: same, ..hand }),
            Case::hand(
                "sliding",
                "m moves along the line",
                MovingNodes { dxn: Vector3::zeros(), dxm: Vector3::new(0.0, 3.0, 4.0), ..hand },
            ),
            Case::running(
                "w = (1, 2, 3): t1·(1, 1, 0.8) = 0.32, t2·(1, 1, 0.8) = -0.056",
                MovingNodes { x1: X1, xn: XN, xm: XM, dx1: DX1, dxn: DXN, dxm: DXM },
            ),
        ];
        cases.extend(scenes(lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxm = (dx1 + dxn) * 0.5;
            Case::hard(id, line.comment, MovingNodes { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxm })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<MovingNodes<f64>>> {
        let (x1, zero) = (Vector3::new(1.0, 2.0, 3.0), Vector3::zeros());
        let inputs = MovingNodes { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxm: zero };
        vec![Case::invalid("coincident", "nodes 1 and n coincide", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"\mathbf{n}\times\mathbf{i} = \mathbf{0}",
            |i| i.xn.y == i.x1.y && i.xn.z == i.x1.z,
            MovingNodes {
                x1: Vector3::zeros(),
                xn: Vector3::new(2.0, 0.0, 0.0),
                xm: Vector3::new(1.0, 0.0, 0.0),
                dx1: Vector3::new(0.25, -0.5, 0.75),
                dxn: Vector3::new(-0.5, 0.125, 0.25),
                dxm: Vector3::new(0.5, 0.5, -0.25),
            },
            {
                let zero = Vector3::zeros();
                MovingNodes { x1: zero, xn: Vector3::new(0.0, 3.0, 4.0), xm: zero, dx1: zero, dxn: zero, dxm: zero }
            },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "on the line it is the variation of the constraint: t1, t2 and their variations cancel",
                |i| {
                    let xm = i.x1 + (i.xn - i.x1) * i.xm.x; // any fraction of the line
                    let at = MovingNodes { xm, ..*i };
                    let jac = Constraint::jacobian(&Nodes { x1: at.x1, xn: at.xn, xm });
                    let along = |row: Nodes<_>| row.x1.dot(&at.dx1) + row.xn.dot(&at.dxn) + row.xm.dot(&at.dxm);
                    let IncrementalResiduals { r1, r2 } = Self::eval(&at);
                    let motion = law::length(at.dx1) + law::length(at.dxn);
                    let size = motion * (abs(i.xm.x) + 1.0) + law::length(at.dxm);
                    law::equal_all_with([(r1, along(jac.g1)), (r2, along(jac.g2))], size)
                },
            ),
            Law::<Self>::new("a translation of all three nodes is free", |i| {
                let IncrementalResiduals { r1, r2 } = Self::eval(&MovingNodes { dx1: i.dxm, dxn: i.dxm, ..*i });
                law::vanish([r1, r2], law::length(i.dxm))
            }),
        ]
    }
}
