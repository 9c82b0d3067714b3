//! Evidence for the formulas next door: cases, laws.

use super::{Forces, GeometricStiffness, JointLoads, JointPlaces, JointRows, Rows};
use crate::Octuple;
use crate::connector::cardan::turns;
use crate::element;
use crate::element::join::{
    JoinRows,
    proof::{balance, equal_motions, residuals},
};
use crate::element::motion::{Motion, Moving, Tangent, derivative, still};
use crate::element::universal::{UniversalRow, proof::residual};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
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
    let mut cases = apart();
    let here = cases[0].inputs;
    cases.extend(turns::triads().into_iter().map(|pair| {
        let [[e1a, e2a, e3a], [.., e3b]] = pair.value;
        Case::hard(pair.id, pair.comment, JointPlaces { e1a, e2a, e3a, e3b, ..here })
    }));
    cases
}

/// Where nodes stand, at points of interest.
fn apart() -> Vec<Case<JointPlaces<f64>>> {
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
            Law::<Self>::new("they do no work in a rigid-body motion", |i| {
                Self::eval(i).rows().iter().flat_map(|row| balance(row, [i.xa, i.xb])).collect()
            }),
        ]
    }
}

/// With multipliers at points of interest.
fn loads(places: Vec<Case<JointPlaces<f64>>>) -> Vec<Case<JointLoads<f64>>> {
    let with = |case: Case<JointPlaces<f64>>| {
        let JointPlaces { e1a, e2a, e3a, e3b, xa, xb } = case.inputs;
        let loads = JointLoads { e1a, e2a, e3a, e3b, xa, xb, f1: 2.0, f2: -3.0, f3: 6.0, lambda_rot: -1.5 };
        Case::new(case.flag, case.id, case.comment, loads)
    };
    let mut cases: Vec<_> = places.into_iter().map(with).collect();
    let here = cases[0].inputs;
    cases.extend(hard::norms::<4>().into_iter().map(|load| {
        let [f1, f2, f3, lambda_rot] = load.value;
        Case::hard(format!("load-{}", load.id), load.comment, JointLoads { f1, f2, f3, lambda_rot, ..here })
    }));
    cases
}

impl Proved for Forces {
    fn cases() -> Vec<Case<JointLoads<f64>>> {
        loads(places())
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "they are Rowsᵀ λ: their work in any motion is that of the multipliers on the residuals",
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

/// The nodal forces as the nodes move.
fn moving(i: &JointLoads<Octuple>, motion: &Motion) -> element::Forces<Moving> {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let [e1a, e2a, e3a] = [i.e1a, i.e2a, i.e3a].map(|e| motion.of_a(e));
    let [f1, f2, f3, lambda_rot] = [i.f1, i.f2, i.f3, i.lambda_rot].map(still);
    Forces::eval(&JointLoads { e1a, e2a, e3a, e3b: motion.of_b(i.e3b), xa, xb, f1, f2, f3, lambda_rot }).vector()
}

fn tangent(i: &JointLoads<Octuple>) -> Tangent {
    let force = law::length(i.e1a * i.f1) + law::length(i.e2a * i.f2) + law::length(i.e3a * i.f3);
    let moment = law::length(i.e1a * i.lambda_rot) * law::length(i.e3b);
    let sizes = [force, force * law::length(i.xb - i.xa) + moment];
    Tangent { matrix: GeometricStiffness::eval(i).matrix(), forces: Forces::eval(i).vector(), sizes }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<JointLoads<f64>>> {
        loads(apart())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Stiffness;
    use crate::toolkit::verify::exactly;
    use num_traits::One;

    fn here() -> JointLoads<Octuple> {
        let [e1a, e2a, e3a] = hard::triad();
        let (xa, xb, e3b) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(4.0, 6.0, 15.0), Vector3::new(0.6, 0.0, 0.8));
        exactly::<Forces>(&JointLoads { e1a, e2a, e3a, e3b, xa, xb, f1: 2.0, f2: -3.0, f3: 6.0, lambda_rot: -1.5 })
    }

    /// Whether the laws of the geometric stiffness find it wrong.
    fn is_caught(i: &JointLoads<Octuple>, matrix: &Stiffness<Octuple>) -> bool {
        let planted = Tangent { matrix: *matrix, ..tangent(i) };
        let laws = [planted.derives(|motion| moving(i, motion)), planted.is_symmetric_but_for_own_spins()].concat();
        laws.iter().any(|equation| law::residual(equation) > 1e-60)
    }

    #[test]
    fn planted_errors_of_the_stiffness_are_caught_by_its_laws() {
        let i = here();
        let right = tangent(&i).matrix;
        assert!(!is_caught(&i, &right));
        assert!(is_caught(&i, &right.transpose()), "transposed");
        assert!(is_caught(&i, &-right), "the other sign");
        let half = Octuple::from(0.5);
        assert!(is_caught(&i, &((right + right.transpose()) * half)), "symmetrised");
        for (row, column) in [(0, 3), (3, 0), (3, 3), (3, 6), (3, 9), (6, 3), (9, 3), (9, 9)] {
            let mut without = right;
            without.fixed_view_mut::<3, 3>(row, column).fill(Octuple::one() * 0.0);
            assert!(is_caught(&i, &without), "without the block at {row}, {column}");
        }
    }
}
