//! Evidence for the formulas of the parent module: cases, laws.

use super::{Direction, DirectionChange, DirectionVariation, Ends, Line, MovingEnds};
use crate::connector::slider::hard::lines;
use crate::connector::slider::running::{DX1, DXN, X1, XN};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, law};
use nalgebra::Vector3;

impl Proved for Line {
    fn cases() -> Vec<Case<Ends<f64>>> {
        let hand = Ends { x1: Vector3::new(1.0, 1.0, 1.0), xn: Vector3::new(3.0, 4.0, 7.0) };
        let mut cases = vec![
            Case::hand("pythagoras", "d = (2, 3, 6): l = 7", hand),
            Case::hand("reversed", "n changes sign, l does not", Ends { x1: hand.xn, xn: hand.x1 }),
            Case::running("d = (15, 12, 16): l = 25", Ends { x1: X1, xn: XN }),
        ];
        cases.extend(
            lines().into_iter().map(|line| Case::hard(line.id, line.comment, Ends { x1: line.x1, xn: line.xn })),
        );
        cases
    }

    fn invalid_cases() -> Vec<Case<Ends<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        vec![Case::invalid("coincident", "both nodes coincide", Ends { x1, xn: x1 })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("l n leads from node 1 to node n", |i| {
                let Direction { n, l } = Self::eval(i);
                law::equal_vectors(n * l, i.xn - i.x1)
            }),
            Law::<Self>::new("n has length 1", |i| {
                let n = Self::eval(i).n;
                law::equal(n.dot(&n), 1.0.into())
            }),
        ]
    }
}

impl Proved for DirectionVariation {
    fn cases() -> Vec<Case<MovingEnds<f64>>> {
        let hand = MovingEnds {
            x1: Vector3::zeros(),
            xn: Vector3::new(2.0, 0.0, 0.0),
            dx1: Vector3::zeros(),
            dxn: Vector3::new(0.5, 1.0, -3.0),
        };
        let same = Vector3::new(1.0, -2.0, 3.0);
        let mut cases = vec![
            Case::hand("along-x", "dl = 0.5, dn = (0, 0.5, -1.5)", hand),
            Case::hand(
                "translation",
                "moving both nodes alike changes nothing",
                MovingEnds { dx1: same, dxn: same, ..hand },
            ),
            Case::hard(
                "stretch",
                "moving n along the line only stretches it: dn is what is left of a cancellation",
                MovingEnds { xn: Vector3::new(0.1, 0.2, 0.3), dxn: Vector3::new(1e-3, 2e-3, 3e-3), ..hand },
            ),
            Case::running("(1, 5.3, 2.9) = 5 n + 25 dn", MovingEnds { x1: X1, xn: XN, dx1: DX1, dxn: DXN }),
        ];
        cases.extend(lines().into_iter().map(|line| {
            let [dx1, dxn] = line.motion();
            Case::hard(line.id, line.comment, MovingEnds { x1: line.x1, xn: line.xn, dx1, dxn })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<MovingEnds<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        let inputs = MovingEnds { x1, xn: x1, dx1: Vector3::x(), dxn: Vector3::y() };
        vec![Case::invalid("coincident", "both nodes coincide", inputs)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the line along (dx1, dxn)", |i| {
                let ends = Ends { x1: i.x1, xn: i.xn };
                let jac = Line::jacobian(&ends);
                let along = |row: Ends<_>| row.x1.dot(&i.dx1) + row.xn.dot(&i.dxn);
                let DirectionChange { dn, dl } = Self::eval(i);
                let size = law::length(i.dx1) + law::length(i.dxn);
                let mut sides = law::equal_with(dl, along(jac.l), size);
                let turning = dn.iter().zip(&jac.n).map(|(&dn, &row)| (dn, along(row)));
                sides.extend(law::equal_all_with(turning, size / Line::eval(&ends).l));
                sides
            }),
            Law::<Self>::new("the direction stays a unit vector: n·dn = 0", |i| {
                let n = Line::eval(&Ends { x1: i.x1, xn: i.xn }).n;
                law::no_work(n, Self::eval(i).dn)
            }),
        ]
    }
}
