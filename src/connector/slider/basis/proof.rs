//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{Basis, BasisVariation, LineDirection, TangentChanges, Tangents, TurningDirection};
use crate::connector::slider::across::Across;
use crate::connector::slider::hard::lines;
use crate::connector::slider::running::{DN, N};
use crate::connector::slider::{Ends, Line};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use nalgebra::Vector3;

impl Proved for Basis {
    fn cases() -> Vec<Case<LineDirection<f64>>> {
        let hand = LineDirection { n: Vector3::new(0.0, 0.6, 0.8) };
        let mut cases = vec![
            Case::hand("across-i", "t1 = (0, 0.8, -0.6), t2 = (-1, 0, 0)", hand),
            Case::hand("j", "t1 = (0, 0, -1), t2 = (-1, 0, 0)", LineDirection { n: Vector3::y() }),
            Case::hand(
                "i",
                "n = i: n×k takes over, t1 = (0, -1, 0), t2 = (0, 0, -1)",
                LineDirection { n: Vector3::x() },
            ),
            Case::hand("minus-i", "n = -i: t1 = (0, 1, 0), t2 = (0, 0, -1)", LineDirection { n: -Vector3::x() }),
            Case::hard("tiny", "squares underflow", LineDirection { n: Vector3::new(3e-200, -4e-200, 12e-200) }),
            Case::hard("huge", "squares overflow", LineDirection { n: Vector3::new(3e200, -4e200, 12e200) }),
            Case::running("(0, 0.64, -0.48)/0.8, and n × t1", LineDirection { n: N }),
        ];
        cases.extend(directions().map(|(id, comment, n)| Case::hard(id, comment, LineDirection { n })));
        cases
    }

    fn invalid_cases() -> Vec<Case<LineDirection<f64>>> {
        vec![Case::invalid("zero", "the zero vector has no direction", LineDirection { n: Vector3::zeros() })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            "n_2 = n_3 = 0",
            |i| i.n.y == 0.0 && i.n.z == 0.0,
            LineDirection { n: Vector3::x() },
            LineDirection { n: Vector3::new(0.0, 3.0, 4.0) },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("t1 is a unit vector perpendicular to the line and to i", |i| {
                let t1 = Self::eval(i).t1;
                let mut sides = law::equal(t1.dot(&t1), 1.0.into());
                sides.extend(law::no_work(t1, i.n));
                sides.extend(law::no_work(t1, Vector3::x()));
                sides
            }),
            Law::<Self>::new("t1, t2 and n are right-handed: t1×t2 = n", |i| {
                let Tangents { t1, t2 } = Self::eval(i);
                law::equal_vectors(t1.cross(&t2), i.n)
            }),
        ]
    }
}

impl Proved for BasisVariation {
    fn cases() -> Vec<Case<TurningDirection<f64>>> {
        let hand = TurningDirection { n: Vector3::y(), dn: Vector3::new(0.5, 0.0, 2.0) };
        let mut cases = vec![
            Case::hand("across-j", "ω = 2: dt1 = (0, 2, 0), dt2 = (0, 0.5, 0)", hand),
            Case::hand("still", "no variation", TurningDirection { dn: Vector3::zeros(), ..hand }),
            Case::hand("i", "n = i exactly: the axes of n×k", TurningDirection { n: Vector3::x(), ..hand }),
            Case::hard(
                "tiny",
                "squares underflow",
                TurningDirection {
                    n: Vector3::new(3e-200, -4e-200, 12e-200),
                    dn: Vector3::new(1e-200, 2e-200, -3e-200),
                },
            ),
            Case::running("dt1 = -0.125 (0, 0.6, 0.8)", TurningDirection { n: N, dn: DN }),
        ];
        let dn = Vector3::new(0.25, 0.5, 0.625);
        cases.extend(directions().map(|(id, comment, n)| Case::hard(id, comment, TurningDirection { n, dn })));
        cases
    }

    fn invalid_cases() -> Vec<Case<TurningDirection<f64>>> {
        let inputs = TurningDirection { n: Vector3::zeros(), dn: Vector3::x() };
        vec![Case::invalid("zero", "the zero vector has no direction", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            "n_2 = n_3 = 0",
            |i| i.n.y == 0.0 && i.n.z == 0.0,
            TurningDirection { n: Vector3::x(), dn: Vector3::new(0.25, -0.75, 0.5) },
            TurningDirection { n: Vector3::new(0.0, 3.0, 4.0), dn: Vector3::zeros() },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the directions across along dn", |i| {
                let jac = Basis::jacobian(&LineDirection { n: i.n });
                let along = |row: LineDirection<_>| row.n.dot(&i.dn);
                let TangentChanges { dt1, dt2 } = Self::eval(i);
                let across = Across::new(&i.n);
                let spin = law::length(i.dn) / across.distance();
                let first = dt1.iter().zip(&jac.t1).map(|(&dt, &row)| (dt, along(row)));
                let second = dt2.iter().zip(&jac.t2).map(|(&dt, &row)| (dt, along(row)));
                law::equal_all_with(first.chain(second), spin * law::length(i.n))
            }),
            Law::<Self>::new("the directions remain normal to the line: n·dt_q + dn·t_q = 0", |i| {
                let Tangents { t1, t2 } = Basis::eval(&LineDirection { n: i.n });
                let TangentChanges { dt1, dt2 } = Self::eval(i);
                let pairs = [(i.n.dot(&dt1), -i.dn.dot(&t1)), (i.n.dot(&dt2), -i.dn.dot(&t2))];
                law::equal_all_with(pairs, law::length(i.dn) * (law::length(i.n) + 1.0))
            }),
        ]
    }
}

/// The directions of the hard lines, computed as in a program.
fn directions() -> impl Iterator<Item = (&'static str, &'static str, Vector3<f64>)> {
    lines().into_iter().map(|line| (line.id, line.comment, Line::eval(&Ends { x1: line.x1, xn: line.xn }).n))
}
