//! Evidence for the formulas of the parent module: cases, laws.

use super::{Linear, LinearRows, Parabolic, ParabolicRows};
use crate::Octuple;
use crate::contact::slide_line::{
    ClosestLinear, ClosestParabolic, LinearMotion, LinearPlace, LinearPoint, LinearSlave, ParabolicMotion,
    ParabolicPlace, ParabolicPoint, ParabolicSlave, SlipIncrementLinear, SlipIncrementParabolic, check_tangent, left,
};
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Law, Proved, law};
use crate::number::scalar::norm;
use nalgebra::Vector2;
use num_traits::{One, Zero};

type Vector = Vector2<Octuple>;

/// The cases of points on straight segments.
pub(in crate::contact::slide_line::element) fn straight_places() -> Vec<Case<LinearPlace<f64>>> {
    let mut cases = LinearPoint::cases();
    cases.retain(|case| case.inputs.x1 != case.inputs.x2);
    cases
}

/// The cases of points on parabolas that have a tangent there.
pub(in crate::contact::slide_line::element) fn curved_places() -> Vec<Case<ParabolicPlace<f64>>> {
    let mut cases = ParabolicPoint::cases();
    cases.retain(|Case { inputs: i, .. }| check_tangent([i.x1, i.x2, i.x3], i.g).is_ok());
    let [x1, x2, x3] = [[-0.1, 0.002], [1.0, -28000.0], [4.75, 0.001]].map(Vector2::from);
    let far = ParabolicPlace { x1, x2, x3, g: -0.0055 };
    cases.push(Case::hard("far-midside", "far from a short chord: Nᵢ′ t and Nᵢ t′ are nearly opposite", far));
    cases
}

/// A point on a segment of zero length.
pub(in crate::contact::slide_line::element) fn no_segment() -> Case<LinearPlace<f64>> {
    let x = Vector2::new(1.0, 2.0);
    Case::invalid("coincident", "both nodes at one place", LinearPlace { x1: x, x2: x, g: 0.0 })
}

/// Points on parabolas without a tangent there.
pub(in crate::contact::slide_line::element) fn no_parabola() -> [Case<ParabolicPlace<f64>>; 2] {
    let [x1, x2, x3] = [[1.0, 2.0], [2.0, 4.0], [5.0, 10.0]].map(Vector2::from);
    [
        Case::invalid("coincident", "two nodes at one place", ParabolicPlace { x1, x2: x1, x3, g: 0.5 }),
        Case::invalid("quarter-point-end", "X' = 0", ParabolicPlace { x1, x2, x3, g: -1.0 }),
    ]
}

/// The vectors are equal, relative to the size of their terms.
pub(in crate::contact::slide_line::element) fn equal_vectors<const N: usize>(
    left: [Vector; N],
    right: [Vector; N],
    size: Octuple,
) -> Vec<Equation> {
    let pairs = left.into_iter().zip(right);
    pairs.flat_map(|(l, r)| law::equal_all_with(l.iter().copied().zip(r.iter().copied()), size)).collect()
}

/// The work of a row in a rotation of all its nodes about the origin.
fn turning<const N: usize>(rows: [Vector; N], places: [Vector; N]) -> Octuple {
    rows.iter().zip(places).fold(Octuple::zero(), |sum, (row, x)| sum + row.dot(&left(x)))
}

fn sum<const N: usize>(rows: [Vector; N]) -> Vector {
    rows.iter().fold(Vector::zeros(), |sum, row| sum + row)
}

fn size<const N: usize>(places: [Vector; N]) -> Octuple {
    places.iter().fold(Octuple::one(), |size, x| size + norm([x.x, x.y]))
}

/// The laws of the rows of the slave point and of the nodes on any segment.
fn rigid<const N: usize>(e11: [Vector; N], e12: [Vector; N], places: [Vector; N]) -> Vec<Equation> {
    let none = equal_vectors([sum(e11), sum(e12)], [Vector::zeros(); 2], Octuple::one());
    [none, law::vanish([turning(e11, places), turning(e12, places)], size(places))].concat()
}

const DERIVES: &str = "that of the separation is its derivative by places, that of the slip the derivative of its increment by displacements";
const RIGID: &str =
    "a rigid motion of a slave point on the segment together with it neither opens the contact nor slips";

impl Proved for Linear {
    fn cases() -> Vec<Case<LinearPlace<f64>>> {
        straight_places()
    }

    fn invalid_cases() -> Vec<Case<LinearPlace<f64>>> {
        vec![no_segment()]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(DERIVES, |i| {
                let LinearPlace { x1, x2, g } = *i;
                let (rows, on, chord) = (Self::eval(i), LinearPoint::eval(i).x, x2 - x1);
                let xs = on + left(chord) * Octuple::from(0.375);
                let by = ClosestLinear::jacobian(&LinearSlave { xs, x1, x2 }).separation;
                let none = Vector::zeros();
                let slip = SlipIncrementLinear::jacobian(&LinearMotion { x1, x2, g, dxs: none, dx1: none, dx2: none });
                let left = [rows.e11_us, rows.e11_u1, rows.e11_u2, rows.e12_us, rows.e12_u1, rows.e12_u2];
                let right = [by.xs, by.x1, by.x2, slip.dslip.dxs, slip.dslip.dx1, slip.dslip.dx2];
                equal_vectors(left, right, size([x1, x2]) / norm([chord.x, chord.y]))
            }),
            Law::<Self>::new(RIGID, |i| {
                let LinearRows { e11_us, e11_u1, e11_u2, e12_us, e12_u1, e12_u2 } = Self::eval(i);
                rigid([e11_us, e11_u1, e11_u2], [e12_us, e12_u1, e12_u2], [LinearPoint::eval(i).x, i.x1, i.x2])
            }),
        ]
    }
}

impl Proved for Parabolic {
    fn cases() -> Vec<Case<ParabolicPlace<f64>>> {
        curved_places()
    }

    fn invalid_cases() -> Vec<Case<ParabolicPlace<f64>>> {
        no_parabola().into()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(DERIVES, |i| {
                let ParabolicPlace { x1, x2, x3, g } = *i;
                let (rows, point) = (Self::eval(i), ParabolicPoint::eval(i));
                let by = ClosestParabolic::jacobian(&ParabolicSlave { xs: point.x, x1, x2, x3 }).separation;
                let none = Vector::zeros();
                let motion = ParabolicMotion { x1, x2, x3, g, dxs: none, dx1: none, dx2: none, dx3: none };
                let slip = SlipIncrementParabolic::jacobian(&motion).dslip;
                let of_e11 = [rows.e11_us, rows.e11_u1, rows.e11_u2, rows.e11_u3];
                // Where the curve's derivative is small, the coordinate of a point on it is less accurate than the point itself.
                let blur = size([x1, x2, x3]) * size([x1, x2, x3]) / point.dx.dot(&point.dx);
                [
                    equal_vectors(of_e11, [by.xs, by.x1, by.x2, by.x3], blur),
                    equal_vectors(
                        [rows.e12_us, rows.e12_u1, rows.e12_u2, rows.e12_u3],
                        [slip.dxs, slip.dx1, slip.dx2, slip.dx3],
                        Octuple::one(),
                    ),
                ]
                .concat()
            }),
            Law::<Self>::new(RIGID, |i| {
                let ParabolicRows { e11_us, e11_u1, e11_u2, e11_u3, e12_us, e12_u1, e12_u2, e12_u3 } = Self::eval(i);
                let places = [ParabolicPoint::eval(i).x, i.x1, i.x2, i.x3];
                rigid([e11_us, e11_u1, e11_u2, e11_u3], [e12_us, e12_u1, e12_u2, e12_u3], places)
            }),
            Law::<Self>::new(
                "with the midside node in the middle, half of its part is that of each end of the straight segment",
                |i| {
                    let half = Octuple::from(0.5);
                    let curved = Self::eval(&ParabolicPlace { x2: (i.x1 + i.x3) * half, ..*i });
                    let straight = Linear::eval(&LinearPlace { x1: i.x1, x2: i.x3, g: i.g });
                    equal_vectors(
                        [
                            curved.e11_u1 + curved.e11_u2 * half,
                            curved.e11_u3 + curved.e11_u2 * half,
                            curved.e12_u1 + curved.e12_u2 * half,
                            curved.e12_u3 + curved.e12_u2 * half,
                        ],
                        [straight.e11_u1, straight.e11_u2, straight.e12_u1, straight.e12_u2],
                        Octuple::one(),
                    )
                },
            ),
        ]
    }
}
