//! Evidence for the formulas next door: cases, laws.

use super::{Forces, GeometricStiffness, Rows, SlotLoads, SlotPlaces, SlotRows};
use crate::Octuple;
use crate::connector::slot::{Constraint, ConstraintForce, CrossFrame, Residuals, SlotPositions};
use crate::element;
use crate::element::join::proof::{balance, equal_motions, whole};
use crate::element::motion::{Motion, Moving, Tangent, derivative, still};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use nalgebra::Vector3;
use num_traits::Zero;

/// The residuals of SLOT as the nodes move.
fn residuals(i: &SlotPlaces<Octuple>, motion: &Motion) -> Residuals<Moving> {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let ([e2a, e3a], y0) = ([i.e2a, i.e3a].map(|e| motion.of_a(e)), still(Octuple::zero()));
    Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0: y0 })
}

impl SlotRows<Octuple> {
    /// Row by row, with what is zero everywhere.
    fn rows(&self) -> [Motion; 2] {
        let none = Motion::none();
        [
            Motion { ua: self.gy_ua, ta: self.gy_ta, ub: self.gy_ub, ..none },
            Motion { ua: self.gz_ua, ta: self.gz_ta, ub: self.gz_ub, ..none },
        ]
    }
}

/// Where nodes stand and how a is turned, at points of interest.
fn places() -> Vec<Case<SlotPlaces<f64>>> {
    let [_, e2a, e3a] = hard::triad();
    let axes = SlotPlaces {
        e2a: Vector3::y(),
        e3a: Vector3::z(),
        xa: Vector3::new(1.0, 2.0, 3.0),
        xb: Vector3::new(4.0, 6.0, 15.0),
    };
    let mut cases = vec![
        Case::hand("along-the-axes", "d = (3, 4, 12), j × d = (12, 0, -3), k × d = (-4, 3, 0)", axes),
        Case::hand("in-one-place", "no distance, no moment", SlotPlaces { xb: axes.xa, ..axes }),
    ];
    cases.extend(hard::places().into_iter().map(|place| {
        let [xa, xb] = place.value;
        Case::hard(place.id, place.comment, SlotPlaces { e2a, e3a, xa, xb })
    }));
    cases
}

/// The same, with forces at points of interest.
fn loads() -> Vec<Case<SlotLoads<f64>>> {
    let with = |case: Case<SlotPlaces<f64>>| {
        let SlotPlaces { e2a, e3a, xa, xb } = case.inputs;
        Case::new(case.flag, case.id, case.comment, SlotLoads { e2a, e3a, xa, xb, f2: -3.0, f3: 6.0 })
    };
    let mut cases: Vec<_> = places().into_iter().map(with).collect();
    let here = cases[0].inputs;
    cases.extend(hard::norms::<2>().into_iter().map(|load| {
        let [f2, f3] = load.value;
        Case::hard(format!("force-{}", load.id), load.comment, SlotLoads { f2, f3, ..here })
    }));
    cases
}

impl Proved for Rows {
    fn cases() -> Vec<Case<SlotPlaces<f64>>> {
        places()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the derivatives of the residuals by translations and spins", |i| {
                let [y, z] = Self::eval(i).rows();
                let by_y = derivative(|motion| residuals(i, motion).gy);
                let by_z = derivative(|motion| residuals(i, motion).gz);
                [equal_motions(&y, &by_y), equal_motions(&z, &by_z)].concat()
            }),
            Law::<Self>::new("they do no work in a rigid-body motion", |i| {
                Self::eval(i).rows().iter().flat_map(|row| balance(row, [i.xa, i.xb])).collect()
            }),
        ]
    }
}

impl Proved for Forces {
    fn cases() -> Vec<Case<SlotLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are Rowsᵀ λ, and on b the documented force", |i| {
                let SlotLoads { e2a, e3a, xa, xb, f2, f3 } = *i;
                let [y, z] = Rows::eval(&SlotPlaces { e2a, e3a, xa, xb }).rows();
                let forces = Self::eval(i);
                let ma = y.ta * f2 + z.ta * f3;
                let size = tangent(i).sizes[1];
                [
                    law::equal_vectors(forces.fa, y.ua * f2 + z.ua * f3),
                    law::equal_all_with(forces.ma.iter().copied().zip(ma.iter().copied()), size),
                    law::equal_vectors(forces.fb, y.ub * f2 + z.ub * f3),
                    law::equal_vectors(forces.fb, ConstraintForce::eval(&CrossFrame { e2a, e3a, f2, f3 }).f),
                ]
                .concat()
            }),
            Law::<Self>::new("forces and moments on both nodes balance", |i| {
                let forces = Self::eval(i);
                let row = Motion { ua: forces.fa, ta: forces.ma, ub: forces.fb, ..Motion::none() };
                balance(&row, [i.xa, i.xb])
            }),
        ]
    }
}

/// The nodal forces as the nodes move.
fn moving(i: &SlotLoads<Octuple>, motion: &Motion) -> element::Forces<Moving> {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let ([e2a, e3a], [f2, f3]) = ([i.e2a, i.e3a].map(|e| motion.of_a(e)), [i.f2, i.f3].map(still));
    whole(Forces::eval(&SlotLoads { e2a, e3a, xa, xb, f2, f3 }))
}

fn tangent(i: &SlotLoads<Octuple>) -> Tangent {
    let force = law::length(i.e2a * i.f2) + law::length(i.e3a * i.f3);
    let sizes = [force, force * law::length(i.xb - i.xa)];
    Tangent { matrix: GeometricStiffness::eval(i).matrix(), forces: whole(Forces::eval(i)), sizes }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<SlotLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the nodal forces by translations and spins", |i| {
                tangent(i).derives(|motion| moving(i, motion))
            }),
            Law::<Self>::new("it is symmetric but for each node's own spin, where K − Kᵀ = −[m×]", |i| {
                tangent(i).is_symmetric_but_for_own_spins()
            }),
            Law::<Self>::new("where both nodes turn as one body, forces and moments turn with them", |i| {
                tangent(i).turns_with_the_body([i.xa, i.xb], i.e2a + i.e3a)
            }),
        ]
    }
}
