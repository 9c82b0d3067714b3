//! Evidence for the formulas next door: cases, laws.

use super::{Forces, JointLoads, JointPlaces, JointRows, Rows};
use crate::Octuple;
use crate::cardan::turns;
use crate::element::join::{JoinRows, proof::balance, proof::equal_motions, proof::residuals};
use crate::element::motion::{Motion, derivative};
use crate::element::universal::{UniversalRow, proof::residual};
use crate::formula::Formula;
use crate::proof::{Case, Law, Proved, hard, law};
use nalgebra::Vector3;

impl JointRows<Octuple> {
    /// Row by row, with what is zero everywhere.
    fn rows(&self) -> [Motion; 4] {
        let Self { g1_ua, g1_ta, g1_ub, g2_ua, g2_ta, g2_ub, g3_ua, g3_ta, g3_ub, g_rot_ta, g_rot_tb } = *self;
        let [p, q, r] = JoinRows { g1_ua, g1_ta, g1_ub, g2_ua, g2_ta, g2_ub, g3_ua, g3_ta, g3_ub }.rows();
        [p, q, r, UniversalRow { g_rot_ta, g_rot_tb }.row()]
    }
}

/// Where nodes stand and how they are turned, at points of interest.
fn places() -> Vec<Case<JointPlaces<f64>>> {
    let axes = JointPlaces {
        e1a: Vector3::x(),
        e2a: Vector3::y(),
        e3a: Vector3::z(),
        e3b: Vector3::z(),
        xa: Vector3::new(1.0, 2.0, 3.0),
        xb: Vector3::new(4.0, 6.0, 15.0),
    };
    let [e1a, e2a, e3a] = hard::triad();
    let mut cases = vec![
        Case::hand("along-the-axes", "d = (3, 4, 12), i × d = (0, -12, 4), i × k = -j", axes),
        Case::hand(
            "in-one-place",
            "as it is built: no distance, the arms at right angles",
            JointPlaces { xb: axes.xa, ..axes },
        ),
    ];
    cases.extend(hard::places().into_iter().map(|place| {
        let [xa, xb] = place.value;
        Case::hard(place.id, place.comment, JointPlaces { e1a, e2a, e3a, e3b: e3a, xa, xb })
    }));
    cases.extend(turns::triads().into_iter().map(|pair| {
        let [[e1a, e2a, e3a], [.., e3b]] = pair.value;
        Case::hard(pair.id, pair.comment, JointPlaces { e1a, e2a, e3a, e3b, ..axes })
    }));
    cases
}

impl Proved for Rows {
    fn cases() -> Vec<Case<JointPlaces<f64>>> {
        places()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the derivatives of the residuals by translations and spins", |i| {
                let [p, q, r, s] = Self::eval(i).rows();
                let of = |k: usize| derivative(|motion| residuals(&i.positions(), motion)[k]);
                let turned = derivative(|motion| residual(&i.axes(), motion));
                let size = law::length(i.e1a) * law::length(i.e3b);
                let pairs = [s.ta, s.tb].into_iter().zip([turned.ta, turned.tb]);
                let turned = pairs.flat_map(|(left, right)| {
                    law::equal_all_with(left.iter().copied().zip(right.iter().copied()), size)
                });
                [equal_motions(&p, &of(0)), equal_motions(&q, &of(1)), equal_motions(&r, &of(2)), turned.collect()]
                    .concat()
            }),
            Law::<Self>::new("none does work where both nodes move as one body", |i| {
                Self::eval(i).rows().iter().flat_map(|row| balance(row, [i.xa, i.xb])).collect()
            }),
        ]
    }
}

impl Proved for Forces {
    fn cases() -> Vec<Case<JointLoads<f64>>> {
        let with = |case: Case<JointPlaces<f64>>| {
            let JointPlaces { e1a, e2a, e3a, e3b, xa, xb } = case.inputs;
            let loads = JointLoads { e1a, e2a, e3a, e3b, xa, xb, f1: 2.0, f2: -3.0, f3: 6.0, lambda_rot: -1.5 };
            Case::new(case.flag, case.id, case.comment, loads)
        };
        let mut cases: Vec<_> = places().into_iter().map(with).collect();
        let here = cases[0].inputs;
        cases.extend(hard::norms::<4>().into_iter().map(|load| {
            let [f1, f2, f3, lambda_rot] = load.value;
            Case::hard(format!("load-{}", load.id), load.comment, JointLoads { f1, f2, f3, lambda_rot, ..here })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "they are Rowsᵀ λ: what they do in any motion, the multipliers do on the residuals",
                |i| {
                    let JointLoads { e1a, e2a, e3a, e3b, xa, xb, f1, f2, f3, lambda_rot } = *i;
                    let [p, q, r, s] = Rows::eval(&JointPlaces { e1a, e2a, e3a, e3b, xa, xb }).rows();
                    let forces = Self::eval(i);
                    let ma = p.ta * f1 + q.ta * f2 + r.ta * f3 + s.ta * lambda_rot;
                    let force = law::length(e1a * f1) + law::length(e2a * f2) + law::length(e3a * f3);
                    let size = law::length(xb - xa) * force + law::length(e1a * lambda_rot) * law::length(e3b);
                    [
                        law::equal_vectors(forces.fa, p.ua * f1 + q.ua * f2 + r.ua * f3),
                        law::equal_all_with(forces.ma.iter().copied().zip(ma.iter().copied()), size),
                        law::equal_vectors(forces.fb, p.ub * f1 + q.ub * f2 + r.ub * f3),
                        law::equal_vectors(forces.mb, s.tb * lambda_rot),
                    ]
                    .concat()
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
