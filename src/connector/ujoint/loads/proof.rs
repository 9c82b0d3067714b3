//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{CrossDirection, JoinForces, Reaction};
use crate::Octuple;
use crate::connector::ujoint::running::{E3B, FORCE};
use crate::element::cross::CrossAxes;
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::number::scalar::norm;
use nalgebra::Vector3;

impl Proved for Reaction {
    fn cases() -> Vec<Case<JoinForces<f64>>> {
        let [f1, f2, f3] = FORCE;
        let mut cases = vec![
            Case::running("√389.61, as 4.4, 17.5 and 8 along the cross have", JoinForces { f1, f2, f3 }),
            Case::hand("pythagoras", "3-4-12-13", JoinForces { f1: 3.0, f2: -4.0, f3: 12.0 }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f1, f2, f3] = load.value;
            Case::hard(load.id, load.comment, JoinForces { f1, f2, f3 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_norm(JoinForces { f1: 0.0, f2: 0.0, f3: 0.0 }, |i| [i.f1, i.f2, i.f3])]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("it is the length of f1 e1a + f2 e2a + f3 e3a on an orthonormal triad", |i| {
            let [e1a, e2a, e3a] = hard::triad().map(|e| e.map(Octuple::from));
            let [e1a, e2a, e3a] = law::orthonormal([e1a, e2a, e3a]);
            let f = e1a * i.f1 + e2a * i.f2 + e3a * i.f3;
            law::equal(Self::eval(i).fr, norm([f.x, f.y, f.z]))
        })]
    }
}

impl Proved for CrossDirection {
    fn cases() -> Vec<Case<CrossAxes<f64>>> {
        let [e1a, e2a, e3a] = hard::triad();
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let mut cases = vec![
            Case::running("x × (0, -0.6, 0.8)", CrossAxes { e1a: x, e3b: E3B }),
            Case::hand("straight", "x × z = -y", CrossAxes { e1a: x, e3b: z }),
            Case::hand("alpha-90", "b turned by 90° about e1a: x × -y = -z", CrossAxes { e1a: x, e3b: -y }),
            Case::hand("folded", "the axes of the cross coincide: no direction", CrossAxes { e1a: x, e3b: x }),
            Case::hard("off-axis", "e1a × e3a = -e2a, every component a difference", CrossAxes { e1a, e3b: e3a }),
            Case::hard("parallel", "the zero vector: every product cancels", CrossAxes { e1a, e3b: -e1a }),
        ];
        for (id, angle) in
            [("nearly-parallel-1e-4", 1e-4), ("nearly-parallel-1e-8", 1e-8), ("nearly-parallel-1e-12", 1e-12)]
        {
            let e3b = e1a + e2a * angle;
            cases.push(Case::hard(id, "axes of the cross that nearly coincide", CrossAxes { e1a, e3b }));
        }
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is perpendicular to both axes", |i| {
                let e_cross = Self::eval(i).e_cross;
                [law::no_work(e_cross, i.e1a), law::no_work(e_cross, i.e3b)].concat()
            }),
            Law::<Self>::new("exchanging the axes reverses it", |i| {
                let exchanged = Self::eval(&CrossAxes { e1a: i.e3b, e3b: i.e1a }).e_cross;
                law::equal_vectors(Self::eval(i).e_cross, -exchanged)
            }),
        ]
    }
}
