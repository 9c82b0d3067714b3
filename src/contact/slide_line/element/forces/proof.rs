//! Evidence for the formulas of the parent module: cases, laws.

use super::{Linear, LinearForces, LinearLoads, Parabolic, ParabolicForces, ParabolicLoads};
use crate::Octuple;
use crate::contact::slide_line::element::rows::{
    self,
    proof::{curved_places, equal_vectors, no_parabola, no_segment, straight_places},
};
use crate::contact::slide_line::{LinearPlace, LinearPoint, ParabolicPlace, ParabolicPoint, left};
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Law, Proved, law};
use crate::number::scalar::abs;
use nalgebra::Vector2;
use num_traits::Zero;

type Vector = Vector2<Octuple>;

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
}

impl ParabolicLoads<Octuple> {
    fn place(&self) -> ParabolicPlace<Octuple> {
        ParabolicPlace { x1: self.x1, x2: self.x2, x3: self.x3, g: self.g }
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

/// A S11 times the row of the separation minus A S12 times that of the slip.
fn worked<const N: usize>(e11: [Vector; N], e12: [Vector; N], [area, s11, s12]: [Octuple; 3]) -> [Vector; N] {
    std::array::from_fn(|k| (e11[k] * s11 - e12[k] * s12) * area)
}

const VIRTUAL_WORK: &str =
    "they are the rows times what works on them: the area times pressure and shear against the slip";
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
                let (forces, rows) = (Self::eval(i), rows::Linear::eval(&i.place()));
                let e11 = [rows.e11_us, rows.e11_u1, rows.e11_u2];
                let right = worked(e11, [rows.e12_us, rows.e12_u1, rows.e12_u2], [i.area, i.s11, i.s12]);
                equal_vectors([forces.fs, forces.f1, forces.f2], right, i.area * (abs(i.s11) + abs(i.s12)))
            }),
            Law::<Self>::new(BALANCE, |i| {
                let (LinearForces { fs, f1, f2 }, separation) = (Self::eval(i), Octuple::from(0.375));
                let n = rows::Linear::eval(&i.place()).e11_us;
                let xs = LinearPoint::eval(&i.place()).x + n * separation;
                balance([fs, f1, f2], [xs, i.x1, i.x2], [separation, i.area, i.s11, i.s12])
            }),
            Law::<Self>::new("it pushes along the normal and drags along the tangent", |i| {
                let (fs, n) = (Self::eval(i).fs, rows::Linear::eval(&i.place()).e11_us);
                let t = -left(n);
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
                let (forces, rows) = (Self::eval(i), rows::Parabolic::eval(&i.place()));
                let e11 = [rows.e11_us, rows.e11_u1, rows.e11_u2, rows.e11_u3];
                let e12 = [rows.e12_us, rows.e12_u1, rows.e12_u2, rows.e12_u3];
                let right = worked(e11, e12, [i.area, i.s11, i.s12]);
                let size = i.area * (abs(i.s11) + abs(i.s12));
                equal_vectors([forces.fs, forces.f1, forces.f2, forces.f3], right, size)
            }),
            Law::<Self>::new(BALANCE, |i| {
                let (ParabolicForces { fs, f1, f2, f3 }, separation) = (Self::eval(i), Octuple::from(0.375));
                let n = rows::Parabolic::eval(&i.place()).e11_us;
                let xs = ParabolicPoint::eval(&i.place()).x + n * separation;
                balance([fs, f1, f2, f3], [xs, i.x1, i.x2, i.x3], [separation, i.area, i.s11, i.s12])
            }),
        ]
    }
}
