//! Evidence for the formulas of the parent module: cases, laws.

use super::{Linear, LinearForces, LinearLoads, Parabolic, ParabolicForces, ParabolicLoads};
use crate::Octuple;
use crate::contact::slide_line::{
    Basis, Direction, LinearPlace, LinearPoint, LocalBasis, ParabolicPlace, ParabolicPoint, check_tangent,
};
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Law, Proved, law};
use crate::number::scalar::abs;
use nalgebra::Vector2;
use num_traits::Zero;

type Vector = Vector2<Octuple>;

/// The cases of points on straight segments.
fn straight_places() -> Vec<Case<LinearPlace<f64>>> {
    let mut cases = LinearPoint::cases();
    cases.retain(|case| case.inputs.x1 != case.inputs.x2);
    cases
}

/// The cases of points on parabolas that have a tangent there.
fn curved_places() -> Vec<Case<ParabolicPlace<f64>>> {
    let mut cases = ParabolicPoint::cases();
    cases.retain(|Case { inputs: i, .. }| check_tangent([i.x1, i.x2, i.x3], i.g).is_ok());
    let [x1, x2, x3] = [[-0.1, 0.002], [1.0, -28000.0], [4.75, 0.001]].map(Vector2::from);
    let far = ParabolicPlace { x1, x2, x3, g: -0.0055 };
    cases.push(Case::hard("far-midside", "far from a short chord: Nᵢ′ t and Nᵢ t′ are nearly opposite", far));
    cases
}

/// A point on a segment of zero length.
fn no_segment() -> Case<LinearPlace<f64>> {
    let x = Vector2::new(1.0, 2.0);
    Case::invalid("coincident", "both nodes coincide", LinearPlace { x1: x, x2: x, g: 0.0 })
}

/// Points on parabolas without a tangent there.
fn no_parabola() -> [Case<ParabolicPlace<f64>>; 2] {
    let [x1, x2, x3] = [[1.0, 2.0], [2.0, 4.0], [5.0, 10.0]].map(Vector2::from);
    [
        Case::invalid("coincident", "two nodes coincide", ParabolicPlace { x1, x2: x1, x3, g: 0.5 }),
        Case::invalid("quarter-point-end", "X' = 0", ParabolicPlace { x1, x2, x3, g: -1.0 }),
    ]
}

fn straight(case: Case<LinearPlace<f64>>) -> Case<LinearLoads<f64>> {
    let LinearPlace { x1, x2, g } = case.inputs;
    Case::new(case.flag, case.id, case.comment, LinearLoads { x1, x2, g, area: 2.0, s11: 5.0, s12: -3.0 })
}

fn curved(case: Case<ParabolicPlace<f64>>) -> Case<ParabolicLoads<f64>> {
    let ParabolicPlace { x1, x2, x3, g } = case.inputs;
    Case::new(case.flag, case.id, case.comment, ParabolicLoads { x1, x2, x3, g, area: 2.0, s11: 5.0, s12: -3.0 })
}

impl LinearLoads<Octuple> {
    fn place(&self) -> LinearPlace<Octuple> {
        LinearPlace { x1: self.x1, x2: self.x2, g: self.g }
    }

    fn basis(&self) -> Basis<Octuple> {
        LocalBasis::eval(&Direction { dx: LinearPoint::eval(&self.place()).dx })
    }
}

impl ParabolicLoads<Octuple> {
    fn place(&self) -> ParabolicPlace<Octuple> {
        ParabolicPlace { x1: self.x1, x2: self.x2, x3: self.x3, g: self.g }
    }

    fn basis(&self) -> Basis<Octuple> {
        LocalBasis::eval(&Direction { dx: ParabolicPoint::eval(&self.place()).dx })
    }
}

/// The slave point and the nodes are in equilibrium, except for the moment of the shear, whose lever is the separation.
fn balance<const N: usize>(
    forces: [Vector; N],
    places: [Vector; N],
    [separation, area, s11, s12]: [Octuple; 4],
) -> Vec<Equation> {
    let force = area * (abs(s11) + abs(s12));
    let reach = places.iter().fold(Octuple::zero(), |reach, x| reach + abs(x.x) + abs(x.y));
    let sum = forces.iter().fold(Vector::zeros(), |sum, f| sum + f);
    let moment = forces.iter().zip(places).fold(Octuple::zero(), |sum, (f, x)| sum + x.perp(f));
    let levers = law::equal_with(moment, separation * area * s12, force * reach);
    [law::vanish([sum.x, sum.y], force), levers].concat()
}

/// Motions of the slave point and of the nodes.
fn motions<const N: usize>() -> [Vector; N] {
    [[0.75, -1.25], [2.5, 0.375], [-1.5, 0.625], [0.25, 1.75]].map(|[r, z]| Vector2::new(r.into(), z.into()))[..N]
        .try_into()
        .expect("there are four motions")
}

/// In these motions the work of the forces is that of the loads, of which the relative motion has these parts along n and t.
fn works<const N: usize>(
    forces: [Vector; N],
    motion_of_point: Vector,
    basis: &Basis<Octuple>,
    [area, s11, s12]: [Octuple; 3],
) -> Vec<Equation> {
    let motions = motions::<N>();
    let relative = motions[0] - motion_of_point;
    let work = forces.iter().zip(motions).fold(Octuple::zero(), |work, (f, by)| work + f.dot(&by));
    let expected = (s11 * basis.n.dot(&relative) - s12 * basis.t.dot(&relative)) * area;
    law::equal_all_with([(work, expected)], area * (abs(s11) + abs(s12)))
}

const VIRTUAL_WORK: &str =
    "in any motion they do the work of pressure and shear against the motion relative to the point of the segment";
const BALANCE: &str =
    "forces along the axis and along the radius balance, and so do moments but for that of the shear at the separation";

impl Proved for Linear {
    fn cases() -> Vec<Case<LinearLoads<f64>>> {
        let mut cases: Vec<_> = straight_places().into_iter().map(straight).collect();
        let here = cases[0].inputs;
        cases.extend([
            Case::hand("no-area", "a slave node on the axis", LinearLoads { area: 0.0, ..here }),
            Case::hand("no-shear", "the force is along the normal", LinearLoads { s12: 0.0, ..here }),
            Case::hand("no-pressure", "shear alone", LinearLoads { s11: 0.0, ..here }),
            Case::hard("large", "a pressure of 1e200", LinearLoads { s11: 1e200, ..here }),
        ]);
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearLoads<f64>>> {
        vec![straight(no_segment())]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(VIRTUAL_WORK, |i| {
                let (LinearForces { fs, f1, f2 }, [_, x1, x2]) = (Self::eval(i), motions());
                let point = LinearPoint::eval(&LinearPlace { x1, x2, g: i.g }).x;
                works([fs, f1, f2], point, &i.basis(), [i.area, i.s11, i.s12])
            }),
            Law::<Self>::new(BALANCE, |i| {
                let (LinearForces { fs, f1, f2 }, separation) = (Self::eval(i), Octuple::from(0.375));
                let n = i.basis().n;
                let xs = LinearPoint::eval(&i.place()).x + n * separation;
                balance([fs, f1, f2], [xs, i.x1, i.x2], [separation, i.area, i.s11, i.s12])
            }),
            Law::<Self>::new("it pushes along the normal and drags along the tangent", |i| {
                let (fs, Basis { t, n }) = (Self::eval(i).fs, i.basis());
                let size = i.area * (abs(i.s11) + abs(i.s12));
                law::equal_all_with([(fs.dot(&n), i.area * i.s11), (fs.dot(&t), -i.area * i.s12)], size)
            }),
        ]
    }
}

impl Proved for Parabolic {
    fn cases() -> Vec<Case<ParabolicLoads<f64>>> {
        let mut cases: Vec<_> = curved_places().into_iter().map(curved).collect();
        let here = cases[0].inputs;
        cases.extend([
            Case::hand("no-area", "a slave node on the axis", ParabolicLoads { area: 0.0, ..here }),
            Case::hand("no-shear", "the force is along the normal", ParabolicLoads { s12: 0.0, ..here }),
            Case::hand("no-pressure", "shear alone", ParabolicLoads { s11: 0.0, ..here }),
            Case::hard("large", "a pressure of 1e200", ParabolicLoads { s11: 1e200, ..here }),
        ]);
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicLoads<f64>>> {
        no_parabola().into_iter().map(curved).collect()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(VIRTUAL_WORK, |i| {
                let (ParabolicForces { fs, f1, f2, f3 }, [_, x1, x2, x3]) = (Self::eval(i), motions());
                let point = ParabolicPoint::eval(&ParabolicPlace { x1, x2, x3, g: i.g }).x;
                works([fs, f1, f2, f3], point, &i.basis(), [i.area, i.s11, i.s12])
            }),
            Law::<Self>::new(BALANCE, |i| {
                let (ParabolicForces { fs, f1, f2, f3 }, separation) = (Self::eval(i), Octuple::from(0.375));
                let n = i.basis().n;
                let xs = ParabolicPoint::eval(&i.place()).x + n * separation;
                balance([fs, f1, f2, f3], [xs, i.x1, i.x2, i.x3], [separation, i.area, i.s11, i.s12])
            }),
        ]
    }
}
