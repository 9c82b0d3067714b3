//! Evidence for the formula of the parent module: cases, laws.

use super::{Basis, Direction, LocalBasis};
use crate::contact::slide_line::running::RATE;
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use nalgebra::Vector2;

impl Proved for LocalBasis {
    fn cases() -> Vec<Case<Direction<f64>>> {
        let along = |x, y| Direction { dx: Vector2::new(x, y) };
        let mut cases = vec![
            Case::hand("along-r", "t = (1, 0), n = (0, 1)", along(2.0, 0.0)),
            Case::hand("along-z", "t = (0, 1), n = (-1, 0)", along(0.0, 0.5)),
            Case::hand("backwards", "t = (-1, 0), n = (0, -1)", along(-3.0, 0.0)),
            Case::hand("pythagoras", "t = (0.6, 0.8), n = (-0.8, 0.6)", along(3.0, 4.0)),
            Case::running("t = (0.6, 0.8), n = (-0.8, 0.6)", Direction { dx: RATE }),
        ];
        // The derivative of a direction is 1/|dx|, which overflows for a subnormal dx.
        let has_derivative = |id: &str| id != "zero" && id != "subnormal";
        let norms = hard::norms().into_iter().filter(|norm| has_derivative(norm.id));
        cases.extend(norms.map(|norm| Case::hard(norm.id, norm.comment, Direction { dx: norm.value.into() })));
        cases
    }

    fn invalid_cases() -> Vec<Case<Direction<f64>>> {
        vec![Case::invalid("zero", "no direction", Direction { dx: Vector2::zeros() })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("t and n are orthonormal and right-handed: t·t = n·n = 1, t·n = 0, t × n = 1", |i| {
                let Basis { t, n } = Self::eval(i);
                let one = 1.0.into();
                let mut sides = law::equal_all([(t.dot(&t), one), (n.dot(&n), one), (t.perp(&n), one)]);
                sides.extend(law::equal_with(t.dot(&n), 0.0.into(), one));
                sides
            }),
            Law::<Self>::new("reversing the sequence of the nodes reverses both vectors", |i| {
                let (here, back) = (Self::eval(i), Self::eval(&Direction { dx: -i.dx }));
                law::equal_all([(here.t.x, -back.t.x), (here.t.y, -back.t.y), (here.n.x, -back.n.x)])
            }),
        ]
    }
}
