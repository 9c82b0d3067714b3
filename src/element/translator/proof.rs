//! Evidence for the formulas next door: cases, laws.

use super::{Forces, GeometricStiffness, Rows, TranslatorLoads, TranslatorPlaces, TranslatorRows};
use crate::Octuple;
use crate::connector::cardan::{Triads, turns};
use crate::connector::translator::{AllResiduals, Constraint, Placement};
use crate::element;
use crate::element::align::{self, AlignLoads, AlignRows};
use crate::element::join::proof::balance;
use crate::element::motion::{Motion, Moving, Tangent, derivative, still};
use crate::element::slot::SlotLoads;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use nalgebra::Vector3;
use num_traits::Zero;

/// The residuals of TRANSLATOR as the nodes move.
fn residuals(i: &TranslatorPlaces<Octuple>, motion: &Motion) -> [Moving; 5] {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let Triads { e1a, e2a, e3a, e1b, e2b, e3b } = align::proof::turned(&i.triads(), motion);
    let none = Placement::filled(still(Octuple::zero()));
    let AllResiduals { gy, gz, ur1, ur2, ur3 } =
        Constraint::eval(&Placement { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb, ..none });
    [gy, gz, ur1, ur2, ur3]
}

impl TranslatorRows<Octuple> {
    /// Row by row, with what is zero everywhere.
    fn rows(&self) -> [Motion; 5] {
        let Self { gy_ua, gy_ta, gy_ub, gz_ua, gz_ta, gz_ub, ur1_tb, ur2_tb, ur3_tb } = *self;
        let row = |ua, ta, ub| Motion { ua, ta, ub, ..Motion::none() };
        let [r1, r2, r3] = AlignRows { ur1_tb, ur2_tb, ur3_tb }.rows();
        [row(gy_ua, gy_ta, gy_ub), row(gz_ua, gz_ta, gz_ub), r1, r2, r3]
    }
}

/// Where the nodes stand along and beside a slot, and how they are turned, at points of interest.
fn places() -> Vec<Case<TranslatorPlaces<f64>>> {
    let here = [Vector3::new(1.0, 2.0, 3.0), Vector3::new(4.0, 6.0, 15.0)];
    let with = |case: Case<Triads<f64>>| {
        Case::new(case.flag, case.id, case.comment, TranslatorPlaces::new(&case.inputs, here))
    };
    let mut cases: Vec<_> = align::proof::triads().into_iter().map(with).collect();
    cases.extend(apart());
    cases
}

/// Where the nodes stand, at points of interest, and turned off the global axes.
fn apart() -> Vec<Case<TranslatorPlaces<f64>>> {
    let [a, b] = turns::at_angles([0.3, 0.4, -0.7].map(Octuple::from));
    let case = |place: hard::Hard<_>| {
        Case::hard(place.id, place.comment, TranslatorPlaces::new(&Triads::new(a, b), place.value))
    };
    let one_place = TranslatorPlaces::new(&Triads::new(a, a), [Vector3::zeros(); 2]);
    let mut cases = vec![Case::hand("in-one-place", "aligned, no distance: forces have no moment", one_place)];
    cases.extend(hard::places().into_iter().map(case));
    cases
}

fn invalid() -> Vec<Case<TranslatorPlaces<f64>>> {
    let with = |case: Case<Triads<f64>>| {
        Case::invalid(case.id, case.comment, TranslatorPlaces::new(&case.inputs, [Vector3::zeros(); 2]))
    };
    align::proof::invalid().into_iter().map(with).collect()
}

impl Proved for Rows {
    fn cases() -> Vec<Case<TranslatorPlaces<f64>>> {
        places()
    }

    fn invalid_cases() -> Vec<Case<TranslatorPlaces<f64>>> {
        invalid()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the derivatives of the residuals by translations and spins", |i| {
                let rows = Self::eval(i).rows();
                let compare = |k: usize| {
                    let (row, found) = (rows[k], derivative(|motion| residuals(i, motion)[k]));
                    let size = law::length(row.ta) + law::length(row.ub);
                    let pairs = [(row.ua, found.ua), (row.ta, found.ta), (row.ub, found.ub), (row.tb, found.tb)];
                    let equal = |(left, right): (Vector3<Octuple>, Vector3<Octuple>)| {
                        law::equal_all_with(left.iter().copied().zip(right.iter().copied()), size)
                    };
                    pairs.into_iter().flat_map(equal).collect::<Vec<_>>()
                };
                (0..5).flat_map(compare).collect()
            }),
            Law::<Self>::new("they do no work in a rigid-body motion", |i| {
                Self::eval(i).rows().iter().flat_map(|row| balance(row, [i.xa, i.xb])).collect()
            }),
        ]
    }
}

/// With multipliers.
fn loaded(places: &TranslatorPlaces<f64>, [f2, f3]: [f64; 2], moments: [f64; 3]) -> TranslatorLoads<f64> {
    let TranslatorPlaces { e2a, e3a, xa, xb, .. } = *places;
    TranslatorLoads::new(&SlotLoads { e2a, e3a, xa, xb, f2, f3 }, &AlignLoads::new(&places.triads(), moments))
}

/// With multipliers at points of interest.
fn loads(places: Vec<Case<TranslatorPlaces<f64>>>) -> Vec<Case<TranslatorLoads<f64>>> {
    let here = apart()[1].inputs;
    let with = |case: Case<TranslatorPlaces<f64>>| {
        Case::new(case.flag, case.id, case.comment, loaded(&case.inputs, [-3.0, 6.0], [2.0, -1.5, 0.75]))
    };
    let mut cases: Vec<_> = places.into_iter().map(with).collect();
    cases.extend(hard::norms::<5>().into_iter().map(|load| {
        let [f2, f3, moments @ ..] = load.value;
        Case::hard(format!("load-{}", load.id), load.comment, loaded(&here, [f2, f3], moments))
    }));
    cases
}

fn invalid_loads() -> Vec<Case<TranslatorLoads<f64>>> {
    let with = |case: Case<TranslatorPlaces<f64>>| {
        Case::invalid(case.id, case.comment, loaded(&case.inputs, [1.0; 2], [1.0; 3]))
    };
    invalid().into_iter().map(with).collect()
}

/// The sizes of the terms of forces and of moments.
fn sizes(i: &TranslatorLoads<Octuple>) -> [Octuple; 2] {
    let force = law::length(i.e2a * i.f2) + law::length(i.e3a * i.f3);
    [force, force * law::length(i.xb - i.xa) + align::proof::size(&i.align())]
}

impl Proved for Forces {
    fn cases() -> Vec<Case<TranslatorLoads<f64>>> {
        loads(places())
    }

    fn invalid_cases() -> Vec<Case<TranslatorLoads<f64>>> {
        invalid_loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "they are Rowsᵀ λ: their work in any motion is that of the multipliers on the residuals",
                |i| {
                    let rows = Rows::eval(&TranslatorPlaces::new(&i.align().triads(), [i.xa, i.xb])).rows();
                    let [l1, l2, l3] = i.align().multipliers();
                    let sum = |of: fn(&Motion) -> Vector3<Octuple>| {
                        rows.iter().zip([i.f2, i.f3, l1, l2, l3]).map(|(row, m)| of(row) * m).sum::<Vector3<Octuple>>()
                    };
                    let (forces, [force, moment]) = (Self::eval(i), sizes(i));
                    let pairs = [
                        (forces.fa, sum(|row| row.ua), force),
                        (forces.ma, sum(|row| row.ta), moment),
                        (forces.fb, sum(|row| row.ub), force),
                        (forces.mb, sum(|row| row.tb), moment),
                    ];
                    let equal = |(left, right, size): (Vector3<Octuple>, Vector3<Octuple>, Octuple)| {
                        law::equal_all_with(left.iter().copied().zip(right.iter().copied()), size)
                    };
                    pairs.into_iter().flat_map(equal).collect()
                },
            ),
            Law::<Self>::new("forces and moments on both nodes balance", |i| {
                let forces = Self::eval(i);
                let row = Motion { ua: forces.fa, ta: forces.ma, ub: forces.fb, tb: forces.mb };
                balance(&row, [i.xa, i.xb])
            }),
        ]
    }
}

/// The nodal forces as the nodes move.
fn moving(i: &TranslatorLoads<Octuple>, motion: &Motion) -> element::Forces<Moving> {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let triads = align::proof::turned(&i.align().triads(), motion);
    let ([f2, f3], multipliers) = ([i.f2, i.f3].map(still), i.align().multipliers().map(still));
    let slot = SlotLoads { e2a: triads.e2a, e3a: triads.e3a, xa, xb, f2, f3 };
    Forces::eval(&TranslatorLoads::new(&slot, &AlignLoads::new(&triads, multipliers))).vector()
}

fn tangent(i: &TranslatorLoads<Octuple>) -> Tangent {
    let [force, _] = sizes(i);
    let moment = force * law::length(i.xb - i.xa) + align::proof::stiffness_size(&i.align());
    Tangent { matrix: GeometricStiffness::eval(i).matrix(), forces: Forces::eval(i).vector(), sizes: [force, moment] }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<TranslatorLoads<f64>>> {
        loads(places())
    }

    fn invalid_cases() -> Vec<Case<TranslatorLoads<f64>>> {
        invalid_loads()
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
                tangent(i).turns_with_the_body([i.xa, i.xb], i.e1a + i.e3b)
            }),
        ]
    }
}
