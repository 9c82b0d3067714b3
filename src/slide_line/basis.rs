//! The local basis of a slide line.

use super::left;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Formula, Jacobian, Law, Source, Spec};
use crate::quantity::{CURVE_RATE, NORMAL, TANGENT};
use crate::scalar::{Scalar, norm_and_direction};
use crate::verify::{hard, law};
use nalgebra::Vector2;

fields! {
    /// A vector along the slide line.
    pub struct Direction<T> { dx: Vector2<T> = CURVE_RATE }
}
fields! {
    /// Unit tangent and unit normal.
    pub struct Basis<T> { t: Vector2<T> = TANGENT, n: Vector2<T> = NORMAL }
}

/// The local basis: t = dx/|dx|, n = s × t = (−t₂, t₁).
#[derive(Clone, Copy, Debug)]
pub struct LocalBasis;

impl Formula for LocalBasis {
    const SPEC: Spec = Spec {
        id: "slide_line.basis",
        title: "Local basis",
        latex: r"\mathbf{t} = \frac{\mathbf{X}'}{\lvert\mathbf{X}'\rvert},\quad \mathbf{n} = \mathbf{s}\times\mathbf{t} = (-t_2, t_1)",
        source: Source::SLIDE_LINE.section("Defining the local basis system"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Direction<T>;
    type Outputs<T: Element> = Basis<T>;

    fn eval<D: Scalar>(i: &Direction<D>) -> Basis<D> {
        let (_, t) = length_and_tangent(i.dx);
        Basis { t, n: left(t) }
    }

    /// δt = n (n·δdx)/|dx| and δn = −t (n·δdx)/|dx|: a change of dx along t does nothing.
    fn jacobian<D: Scalar>(i: &Direction<D>) -> Jacobian<Self, D> {
        let (length, t) = length_and_tangent(i.dx);
        let n = left(t);
        let turn = n / length;
        Basis {
            t: n.map(|component| Direction { dx: turn * component }),
            n: t.map(|component| Direction { dx: turn * -component }),
        }
    }

    fn validate(i: &Direction<f64>) -> Result<(), Error> {
        Error::check_direction("dx", i.dx)
    }

    fn cases() -> Vec<Case<Direction<f64>>> {
        let along = |x, y| Direction { dx: Vector2::new(x, y) };
        let mut cases = vec![
            Case::hand("along-r", "t = (1, 0), n = (0, 1)", along(2.0, 0.0)),
            Case::hand("along-z", "t = (0, 1), n = (-1, 0)", along(0.0, 0.5)),
            Case::hand("backwards", "t = (-1, 0), n = (0, -1)", along(-3.0, 0.0)),
            Case::hand("pythagoras", "t = (0.6, 0.8), n = (-0.8, 0.6)", along(3.0, 4.0)),
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
            Law {
                statement: "t and n are orthonormal and right-handed: t·t = n·n = 1, t·n = 0, t × n = 1",
                sides: |i| {
                    let Basis { t, n } = Self::eval(i);
                    let one = 1.0.into();
                    let mut sides = law::equal_all([(t.dot(&t), one), (n.dot(&n), one), (t.perp(&n), one)]);
                    sides.extend(law::equal_with(t.dot(&n), 0.0.into(), one));
                    sides
                },
            },
            Law {
                statement: "reversing the sequence of the nodes reverses both vectors",
                sides: |i| {
                    let (here, back) = (Self::eval(i), Self::eval(&Direction { dx: -i.dx }));
                    law::equal_all([(here.t.x, -back.t.x), (here.t.y, -back.t.y), (here.n.x, -back.n.x)])
                },
            },
        ]
    }
}

/// |v| and v/|v|.
#[inline]
pub(super) fn length_and_tangent<D: Scalar>(v: Vector2<D>) -> (D, Vector2<D>) {
    let (length, [x, y]) = norm_and_direction([v.x, v.y]);
    (length, Vector2::new(x, y))
}
