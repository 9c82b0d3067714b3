//! The line through nodes 1 and n, and how it varies when they move.

use super::hard::lines;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Formula, Jacobian, Law, Source, Spec};
use crate::quantity::{SLIDER_DL, SLIDER_DN, SLIDER_DX1, SLIDER_DXN, SLIDER_LENGTH, SLIDER_N, SLIDER_X1, SLIDER_XN};
use crate::scalar::{Scalar, norm_and_direction};
use crate::verify::law;
use nalgebra::{Matrix3, Vector3};

fields! {
    /// The two nodes that the line runs through.
    pub struct Ends<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN }
}
fields! {
    /// Direction and length of the line.
    pub struct Direction<T> { n: Vector3<T> = SLIDER_N, l: T = SLIDER_LENGTH }
}

/// The line: l = |xn − x1|, n = (xn − x1)/l.
#[derive(Clone, Copy, Debug)]
pub struct Line;

impl Formula for Line {
    const SPEC: Spec = Spec {
        id: "slider.line",
        title: "Line",
        latex: r"l = \lvert\mathbf{x}_n-\mathbf{x}_1\rvert,\quad \mathbf{n} = (\mathbf{x}_n-\mathbf{x}_1)/l",
        source: Source::SLIDER.section("Direction of the line"),
        eta: 3.0,
        eta_jacobian: 5.0,
        objective: true,
    };
    type Inputs<T: Element> = Ends<T>;
    type Outputs<T: Element> = Direction<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Ends<D>) -> Direction<D> {
        let (l, n) = norm_and_direction((i.xn - i.x1).into());
        Direction { n: n.into(), l }
    }

    fn jacobian<D: Scalar>(i: &Ends<D>) -> Jacobian<Self, D> {
        let Direction { n, l } = Self::eval(i);
        let turn = across(&n) / l;
        let row = |by_xn: Vector3<D>| Ends { x1: -by_xn, xn: by_xn };
        let along = |axis: usize| row(turn.column(axis).into_owned());
        Direction { n: Vector3::new(along(0), along(1), along(2)), l: row(n) }
    }

    fn validate(i: &Ends<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<Ends<f64>>> {
        let hand = Ends { x1: Vector3::new(1.0, 1.0, 1.0), xn: Vector3::new(3.0, 4.0, 7.0) };
        let mut cases = vec![
            Case::hand("pythagoras", "d = (2, 3, 6): l = 7", hand),
            Case::hand("reversed", "n changes sign, l does not", Ends { x1: hand.xn, xn: hand.x1 }),
        ];
        cases.extend(
            lines().into_iter().map(|line| Case::hard(line.id, line.comment, Ends { x1: line.x1, xn: line.xn })),
        );
        cases
    }

    fn invalid_cases() -> Vec<Case<Ends<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        vec![Case::invalid("coincident", "both nodes at one place", Ends { x1, xn: x1 })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "l n leads from node 1 to node n",
                sides: |i| {
                    let Direction { n, l } = Self::eval(i);
                    law::equal_vectors(n * l, i.xn - i.x1)
                },
            },
            Law {
                statement: "n has length 1",
                sides: |i| {
                    let n = Self::eval(i).n;
                    law::equal(n.dot(&n), 1.0.into())
                },
            },
        ]
    }
}

/// I − n nᵀ for a unit vector n, its diagonal as a sum of squares, so that nothing cancels.
pub(super) fn across<D: Scalar>(n: &Vector3<D>) -> Matrix3<D> {
    let square = n.component_mul(n);
    let [xy, yz, zx] = [-n.x * n.y, -n.y * n.z, -n.z * n.x];
    Matrix3::new(square.y + square.z, xy, zx, xy, square.z + square.x, yz, zx, yz, square.x + square.y)
}

fields! {
    /// The line, and increments of its nodes.
    pub struct MovingEnds<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN,
        dx1: Vector3<T> = SLIDER_DX1, dxn: Vector3<T> = SLIDER_DXN,
    }
}
fields! {
    /// Variation of direction and length of the line.
    pub struct DirectionChange<T> { dn: Vector3<T> = SLIDER_DN, dl: T = SLIDER_DL }
}

/// How the line varies: dl = n·(dxn − dx1), dn = ((dxn − dx1) − dl n)/l.
///
/// Evaluated as dn = n×((dxn − dx1)×n)/l, which does not lose the small part of a relative motion that is almost along
/// the line.
#[derive(Clone, Copy, Debug)]
pub struct DirectionVariation;

impl Formula for DirectionVariation {
    const SPEC: Spec = Spec {
        id: "slider.direction_variation",
        title: "Variation of the direction",
        latex: r"\mathrm{d}l = \mathbf{n}\cdot(\mathrm{d}\mathbf{x}_n-\mathrm{d}\mathbf{x}_1),\quad \mathrm{d}\mathbf{n} = \bigl((\mathrm{d}\mathbf{x}_n-\mathrm{d}\mathbf{x}_1) - \mathrm{d}l\,\mathbf{n}\bigr)/l",
        source: Source::SLIDER.section("Variations"),
        eta: 5.0,
        eta_jacobian: 6.0,
        objective: true,
    };
    type Inputs<T: Element> = MovingEnds<T>;
    type Outputs<T: Element> = DirectionChange<T>;

    #[inline]
    fn eval<D: Scalar>(i: &MovingEnds<D>) -> DirectionChange<D> {
        let Direction { n, l } = Line::eval(&Ends { x1: i.x1, xn: i.xn });
        let motion = i.dxn - i.dx1;
        DirectionChange { dn: n.cross(&motion.cross(&n)) / l, dl: n.dot(&motion) }
    }

    /// ∂dn/∂dxn = (I − n nᵀ)/l and ∂dn/∂xn = −(dn nᵀ + n dnᵀ + (dl/l)(I − n nᵀ))/l, symmetric matrices both.
    fn jacobian<D: Scalar>(i: &MovingEnds<D>) -> Jacobian<Self, D> {
        let Direction { n, l } = Line::eval(&Ends { x1: i.x1, xn: i.xn });
        let DirectionChange { dn, dl } = Self::eval(i);
        let turn = across(&n) / l;
        let outer = dn * n.transpose();
        let bend = -(outer + outer.transpose() + turn * dl) / l;
        let row = |xn: Vector3<D>, dxn: Vector3<D>| MovingEnds { x1: -xn, xn, dx1: -dxn, dxn };
        let along = |axis: usize| row(bend.column(axis).into_owned(), turn.column(axis).into_owned());
        DirectionChange { dn: Vector3::new(along(0), along(1), along(2)), dl: row(dn, n) }
    }

    fn validate(i: &MovingEnds<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

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
        vec![Case::invalid("coincident", "both nodes at one place", inputs)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "it is the derivative of the line along (dx1, dxn)",
                sides: |i| {
                    let ends = Ends { x1: i.x1, xn: i.xn };
                    let jac = Line::jacobian(&ends);
                    let along = |row: Ends<_>| row.x1.dot(&i.dx1) + row.xn.dot(&i.dxn);
                    let DirectionChange { dn, dl } = Self::eval(i);
                    let size = law::length(i.dx1) + law::length(i.dxn);
                    let mut sides = law::equal_with(dl, along(jac.l), size);
                    let turning = dn.iter().zip(&jac.n).map(|(&dn, &row)| (dn, along(row)));
                    sides.extend(law::equal_all_with(turning, size / Line::eval(&ends).l));
                    sides
                },
            },
            Law {
                statement: "the direction stays a unit vector: n·dn = 0",
                sides: |i| {
                    let n = Line::eval(&Ends { x1: i.x1, xn: i.xn }).n;
                    law::no_work(n, Self::eval(i).dn)
                },
            },
        ]
    }
}
