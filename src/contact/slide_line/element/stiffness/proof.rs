//! Evidence for the formulas of the parent module: cases, laws.

use super::super::Spot;
use super::{Linear, LinearTouch, Parabolic, ParabolicTouch};
use crate::Octuple;
use crate::contact::slide_line::element::forces;
use crate::contact::slide_line::element::rows::{
    self,
    proof::{curved_places, no_parabola, no_segment, straight_places},
};
use crate::contact::slide_line::{
    ClosestLinear, ClosestParabolic, LinearPlace, LinearPoint, LinearSlave, ParabolicPlace, ParabolicPoint,
    ParabolicSlave, Sides, left, length_and_tangent,
};
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Law, Proved, law};
use crate::number::scalar::{abs, norm};
use nalgebra::{SMatrix, SVector, Vector2};
use num_dual::Dual;
use num_traits::{One, Zero};

type Vector = Vector2<Octuple>;
type Moving = Dual<Octuple>;

fn straight(case: Case<LinearPlace<f64>>) -> Case<LinearTouch<f64>> {
    let LinearPlace { x1, x2, g } = case.inputs;
    Case::new(case.flag, case.id, case.comment, LinearTouch { x1, x2, g, separation: -0.125, lambda: 5.0 })
}

/// The same rotated away from the axes and five times as large, with a separation that the curvature allows.
fn curved(case: Case<ParabolicPlace<f64>>) -> Case<ParabolicTouch<f64>> {
    let ParabolicPlace { x1, x2, x3, g } = case.inputs;
    let [x1, x2, x3] = [x1, x2, x3].map(|x| x * 4.0 + left(x) * 3.0);
    let touch = ParabolicTouch { x1, x2, x3, g, separation: (x3 - x1).amax() * -0.03125, lambda: 5.0 };
    Case::new(case.flag, case.id, case.comment, touch)
}

/// The slave point and the nodes in order, with a unit motion of the k-th degree of freedom.
fn moved<const N: usize>(places: [Vector; N], k: usize) -> [Vector2<Moving>; N] {
    let change = |at: usize| if at == k { Octuple::one() } else { Octuple::zero() };
    std::array::from_fn(|node| Vector2::from_fn(|axis, _| Dual::new(places[node][axis], change(2 * node + axis))))
}

fn still(x: Octuple) -> Moving {
    Dual::from_re(x)
}

/// The size of the largest entry.
fn size<const M: usize>(matrix: &SMatrix<Octuple, M, M>) -> Octuple {
    matrix.iter().fold(Octuple::zero(), |size, &entry| if abs(entry) > size { abs(entry) } else { size })
}

fn equal<const M: usize>(
    left: &SMatrix<Octuple, M, M>,
    right: &SMatrix<Octuple, M, M>,
    term: Octuple,
) -> Vec<Equation> {
    law::equal_all_with(left.iter().copied().zip(right.iter().copied()), term)
}

/// The effect of a rigid motion: a translation changes nothing, a rotation rotates the forces.
fn follows<const M: usize, const N: usize>(
    k: &SMatrix<Octuple, M, M>,
    places: [Vector; N],
    forces: [Vector; N],
) -> Vec<Equation> {
    let motion = |of: &dyn Fn(usize) -> Vector| SVector::<Octuple, M>::from_fn(|row, _| of(row / 2)[row % 2]);
    let (term, reach) = (size(k), places.iter().fold(Octuple::one(), |sum, x| sum + norm([x.x, x.y])));
    let shifts = [Vector::x(), Vector::y()].map(|shift| k * motion(&|_| shift));
    let turned = k * motion(&|node| left(places[node]));
    let expected = motion(&|node| left(forces[node]));
    [
        law::vanish(shifts.iter().flat_map(|shift| shift.iter().copied()), term),
        law::equal_all_with(turned.iter().copied().zip(expected.iter().copied()), term * reach),
    ]
    .concat()
}

const DERIVES: &str =
    "it is the derivative of the nodal forces of a contact force along the normal, by places, closest point and all";
const FOLLOWS: &str = "a translation of all changes no force, and a turn turns them";
const SYMMETRIC: &str = "it is symmetric";

impl LinearTouch<Octuple> {
    fn place(&self) -> LinearPlace<Octuple> {
        LinearPlace { x1: self.x1, x2: self.x2, g: self.g }
    }

    /// The positions of the slave point and the nodes.
    fn places(&self) -> [Vector; 3] {
        let n = rows::Linear::eval(&self.place()).e11_us;
        [LinearPoint::eval(&self.place()).x + n * self.separation, self.x1, self.x2]
    }
}

impl Proved for Linear {
    fn cases() -> Vec<Case<LinearTouch<f64>>> {
        let mut cases: Vec<_> = straight_places().into_iter().map(straight).collect();
        let here = cases[0].inputs;
        cases.extend([
            Case::hand("touching", "E11 = 0: SLIDER's stiffness", LinearTouch { separation: 0.0, ..here }),
            Case::hand("unloaded", "no force", LinearTouch { lambda: 0.0, ..here }),
            Case::hard("large", "a force of 1e200", LinearTouch { lambda: -3e200, ..here }),
            Case::hard("far", "a separation of 1e12", LinearTouch { separation: 1e12, ..here }),
        ]);
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearTouch<f64>>> {
        vec![straight(no_segment())]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(DERIVES, |i| {
                let i = LinearTouch { g: i.g * (15.0 / 16.0), ..*i };
                let (places, matrix) = (i.places(), Self::eval(&i).matrix());
                let columns: [_; 6] = std::array::from_fn(|k| {
                    let [xs, x1, x2] = moved(places, k);
                    let g = ClosestLinear::eval(&LinearSlave { xs, x1, x2 }).g;
                    let (area, s12) = (still(Octuple::one()), still(Octuple::zero()));
                    let loads = forces::LinearLoads { x1, x2, g, area, s11: still(i.lambda), s12 };
                    let found = forces::Linear::eval(&loads);
                    [found.fs, found.f1, found.f2]
                });
                let derivative = SMatrix::from_fn(|row, column| columns[column][row / 2][row % 2].eps);
                equal(&matrix, &derivative, size(&matrix))
            }),
            Law::<Self>::new(SYMMETRIC, |i| {
                let matrix = Self::eval(i).matrix();
                equal(&matrix, &matrix.transpose(), size(&matrix))
            }),
            Law::<Self>::new(FOLLOWS, |i| {
                let rows = rows::Linear::eval(&i.place());
                let forces = [rows.e11_us, rows.e11_u1, rows.e11_u2].map(|row| row * i.lambda);
                follows(&Self::eval(i).matrix(), i.places(), forces)
            }),
        ]
    }
}

impl ParabolicTouch<Octuple> {
    fn place(&self) -> ParabolicPlace<Octuple> {
        ParabolicPlace { x1: self.x1, x2: self.x2, x3: self.x3, g: self.g }
    }

    fn places(&self) -> [Vector; 4] {
        let n = rows::Parabolic::eval(&self.place()).e11_us;
        [ParabolicPoint::eval(&self.place()).x + n * self.separation, self.x1, self.x2, self.x3]
    }

    /// The same, close enough to the segment and far enough from its ends that the point is the closest one on every curve drawn
    /// here.
    fn near(&self) -> Self {
        let g = self.g * (15.0 / 16.0);
        let nodes = [self.x1, self.x2, self.x3];
        let (spot, speed) = (Spot::parabolic(nodes, g), length_and_tangent(Sides::new(nodes).rate(g)).0);
        let bent = norm([spot.curvature, Octuple::one() / speed]) * self.separation * Octuple::from(2.0_f64.powi(40));
        Self { g, separation: self.separation / norm([bent, Octuple::one()]), ..*self }
    }
}

impl Proved for Parabolic {
    fn cases() -> Vec<Case<ParabolicTouch<f64>>> {
        // Squares of these lengths do not over- or underflow; and on exactly straight segments some entries are 0, without a size
        // for comparison.
        let counts = |case: &Case<ParabolicPlace<f64>>| {
            (1e-100..1e100).contains(&case.inputs.x3.amax()) && case.id != "straight"
        };
        let mut cases: Vec<_> = curved_places().into_iter().filter(counts).map(curved).collect();
        let here = cases[0].inputs;
        cases.extend([
            Case::hand("touching", "E11 = 0", ParabolicTouch { separation: 0.0, ..here }),
            Case::hand("unloaded", "no force", ParabolicTouch { lambda: 0.0, ..here }),
            Case::hard("large", "a force of 1e150", ParabolicTouch { lambda: -3e150, ..here }),
            Case::hard("far", "a separation of 1e12", ParabolicTouch { separation: 1e12, ..here }),
        ]);
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicTouch<f64>>> {
        let mut cases: Vec<_> = no_parabola().into_iter().map(curved).collect();
        let [x1, x2, x3] = [[1.0, 1.0], [2.0, 0.0], [3.0, 1.0]].map(Vector2::from); // κ = 2 at g = 0
        let centre = ParabolicTouch { x1, x2, x3, g: 0.0, separation: 0.5, lambda: 1.0 };
        cases.push(Case::invalid("centre", "on the centre of curvature", centre));
        let beyond = ParabolicTouch { separation: 0.75, ..centre };
        cases.push(Case::invalid("beyond-centre", "the other side of the valley is closer", beyond));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(DERIVES, |i| {
                let i = i.near();
                let (places, matrix) = (i.places(), Self::eval(&i).matrix());
                let columns: [_; 8] = std::array::from_fn(|k| {
                    let [xs, x1, x2, x3] = moved(places, k);
                    let g = ClosestParabolic::eval(&ParabolicSlave { xs, x1, x2, x3 }).g;
                    let (area, s12) = (still(Octuple::one()), still(Octuple::zero()));
                    let loads = forces::ParabolicLoads { x1, x2, x3, g, area, s11: still(i.lambda), s12 };
                    let found = forces::Parabolic::eval(&loads);
                    [found.fs, found.f1, found.f2, found.f3]
                });
                let derivative = SMatrix::from_fn(|row, column| columns[column][row / 2][row % 2].eps);
                equal(&matrix, &derivative, size(&matrix))
            }),
            Law::<Self>::new(SYMMETRIC, |i| {
                let matrix = Self::eval(i).matrix();
                equal(&matrix, &matrix.transpose(), size(&matrix))
            }),
            Law::<Self>::new(FOLLOWS, |i| {
                let rows = rows::Parabolic::eval(&i.place());
                let forces = [rows.e11_us, rows.e11_u1, rows.e11_u2, rows.e11_u3].map(|row| row * i.lambda);
                follows(&Self::eval(i).matrix(), i.places(), forces)
            }),
            Law::<Self>::new(
                "with the midside node in the middle, half of its part is that of each end of the straight segment",
                |i| {
                    let half = Octuple::from(0.5);
                    let curved = Self::eval(&ParabolicTouch { x2: (i.x1 + i.x3) * half, ..*i }).matrix();
                    let straight =
                        LinearTouch { x1: i.x1, x2: i.x3, g: i.g, separation: i.separation, lambda: i.lambda };
                    let share = SMatrix::<Octuple, 8, 6>::from_fn(|row, column| {
                        let of = |parts: [f64; 4]| Octuple::from(parts[row / 2]);
                        let parts = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.5, 0.0], [0.0, 0.0, 0.5, 1.0]];
                        if row % 2 == column % 2 { of(parts[column / 2]) } else { Octuple::zero() }
                    });
                    let expected = Linear::eval(&straight).matrix();
                    equal(&(share.transpose() * curved * share), &expected, size(&curved))
                },
            ),
        ]
    }
}
