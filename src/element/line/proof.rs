//! Evidence for the formulas of the parent module: cases, laws.

use super::{Forces, GeometricStiffness, JoinForces, JoinLoads, JoinRows, Positions, Rows};
use crate::Octuple;
use crate::Scalar;
use crate::element::motion::{Motion, Moving, Tangent, derivative, still};
use crate::element::{self, NodalForces};
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Law, Proved, hard, law};
use nalgebra::Vector3;
use num_traits::Zero;

type Vector = Vector3<Octuple>;

/// The residuals of JOIN under a motion of the nodes, without the initial position.
pub(in crate::element) fn residuals(i: &Positions<Octuple>, motion: &Motion) -> Vector3<Moving> {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let [e1a, e2a, e3a] = [i.e1a, i.e2a, i.e3a].map(|e| motion.of_a(e));
    let d = xb - xa;
    Vector3::new(e1a.dot(&d), e2a.dot(&d), e3a.dot(&d))
}

impl JoinRows<Octuple> {
    /// The rows as motions, including the parts that are always zero.
    pub(in crate::element) fn rows(&self) -> [Motion; 3] {
        let row = |ua: Vector, ta: Vector, ub: Vector| Motion { ua, ta, ub, ..Motion::none() };
        [
            row(self.g1_ua, self.g1_ta, self.g1_ub),
            row(self.g2_ua, self.g2_ta, self.g2_ub),
            row(self.g3_ua, self.g3_ta, self.g3_ub),
        ]
    }
}

/// Two derivatives with respect to translations and spins are equal.
pub(in crate::element) fn equal_motions(left: &Motion, right: &Motion) -> Vec<Equation> {
    let pairs = [(left.ua, right.ua), (left.ta, right.ta), (left.ub, right.ub), (left.tb, right.tb)];
    pairs.into_iter().flat_map(|(left, right)| law::equal_vectors(left, right)).collect()
}

/// A row does no work in a motion of both nodes as one body: the forces and moments of a unit multiplier balance.
pub(in crate::element) fn balance(row: &Motion, [xa, xb]: [Vector; 2]) -> Vec<Equation> {
    let arm = xb - xa;
    let size = law::length(row.ta) + law::length(row.tb) + law::length(arm) * law::length(row.ub);
    let moment = row.ta + row.tb + arm.cross(&row.ub);
    [law::equal_vectors(row.ua, -row.ub), law::vanish(moment.iter().copied(), size)].concat()
}

/// The positions of the nodes and the triad of a, at points of interest.
fn positions() -> Vec<Case<Positions<f64>>> {
    let [e1a, e2a, e3a] = hard::triad();
    let axes = Positions {
        e1a: Vector3::x(),
        e2a: Vector3::y(),
        e3a: Vector3::z(),
        xa: Vector3::new(1.0, 2.0, 3.0),
        xb: Vector3::new(4.0, 6.0, 15.0),
    };
    let mut cases = vec![
        Case::running("d = (3, 4, 12), and i × d = (0, -12, 4)", axes),
        Case::hand("in-one-place", "no distance, no moment", Positions { xb: axes.xa, ..axes }),
    ];
    cases.extend(hard::places().into_iter().map(|place| {
        let [xa, xb] = place.value;
        Case::hard(place.id, place.comment, Positions { e1a, e2a, e3a, xa, xb })
    }));
    cases
}

impl Proved for Rows {
    fn cases() -> Vec<Case<Positions<f64>>> {
        positions()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the derivatives of the residuals with respect to translations and spins", |i| {
                let rows = Self::eval(i).rows();
                let of = |k: usize| derivative(|motion| residuals(i, motion)[k]);
                (0..3).flat_map(|k| equal_motions(&rows[k], &of(k))).collect()
            }),
            Law::<Self>::new("they do no work in a rigid-body motion", |i| {
                Self::eval(i).rows().iter().flat_map(|row| balance(row, [i.xa, i.xb])).collect()
            }),
            Law::<Self>::new(
                "by the translation of b they are orthonormal on an orthonormal triad, so that no two are dependent",
                |i| {
                    let [e1a, e2a, e3a] = law::orthonormal([i.e1a, i.e2a, i.e3a]);
                    let [p, q, r] = Self::eval(&Positions { e1a, e2a, e3a, ..*i }).rows().map(|row| row.ub);
                    let one = Octuple::from(1.0);
                    let zero = Octuple::zero();
                    let products = [
                        (p.dot(&p), one),
                        (q.dot(&q), one),
                        (r.dot(&r), one),
                        (p.dot(&q), zero),
                        (q.dot(&r), zero),
                        (r.dot(&p), zero),
                    ];
                    law::equal_all_with(products, one)
                },
            ),
        ]
    }
}

/// The same with forces at points of interest.
fn loads() -> Vec<Case<JoinLoads<f64>>> {
    let with = |case: Case<Positions<f64>>, [f1, f2, f3]: [f64; 3]| {
        let Positions { e1a, e2a, e3a, xa, xb } = case.inputs;
        Case::new(case.flag, case.id, case.comment, JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 })
    };
    let mut cases: Vec<_> = positions().into_iter().map(|case| with(case, [2.0, -3.0, 6.0])).collect();
    let here = cases[0].inputs;
    cases.extend(hard::norms::<3>().into_iter().map(|load| {
        let [f1, f2, f3] = load.value;
        Case::hard(format!("force-{}", load.id), load.comment, JoinLoads { f1, f2, f3, ..here })
    }));
    cases
}

impl Proved for Forces {
    fn cases() -> Vec<Case<JoinLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "they are Rowsᵀ λ: their work in any motion is that of the multipliers on the residuals",
                |i| {
                    let JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 } = *i;
                    let [p, q, r] = Rows::eval(&Positions { e1a, e2a, e3a, xa, xb }).rows();
                    let forces = Self::eval(i);
                    let size =
                        law::length(xb - xa) * (law::length(e1a * f1) + law::length(e2a * f2) + law::length(e3a * f3));
                    let ma = p.ta * f1 + q.ta * f2 + r.ta * f3;
                    let moments = law::equal_all_with(forces.ma.iter().copied().zip(ma.iter().copied()), size);
                    let fa = p.ua * f1 + q.ua * f2 + r.ua * f3;
                    let fb = p.ub * f1 + q.ub * f2 + r.ub * f3;
                    [law::equal_vectors(forces.fa, fa), moments, law::equal_vectors(forces.fb, fb)].concat()
                },
            ),
            Law::<Self>::new("forces and moments on both nodes balance", |i| {
                let forces = Self::eval(i);
                let row = Motion { ua: forces.fa, ta: forces.ma, ub: forces.fb, ..Motion::none() };
                balance(&row, [i.xa, i.xb])
            }),
        ]
    }
}

/// The nodal forces under a motion of the nodes.
fn moving(i: &JoinLoads<Octuple>, motion: &Motion) -> element::Forces<Moving> {
    let [xa, xb] = motion.places([i.xa, i.xb]);
    let [e1a, e2a, e3a] = [i.e1a, i.e2a, i.e3a].map(|e| motion.of_a(e));
    let [f1, f2, f3] = [i.f1, i.f2, i.f3].map(still);
    whole(Forces::eval(&JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 }))
}

/// The forces with the moment on b, which is zero.
pub(in crate::element) fn whole<D: Scalar>(JoinForces { fa, ma, fb }: JoinForces<D>) -> element::Forces<D> {
    NodalForces { fa, ma, fb, mb: Vector3::from_element(D::zero()) }.vector()
}

fn tangent(i: &JoinLoads<Octuple>) -> Tangent {
    let force = law::length(i.e1a * i.f1) + law::length(i.e2a * i.f2) + law::length(i.e3a * i.f3);
    let sizes = [force, force * law::length(i.xb - i.xa)];
    Tangent { matrix: GeometricStiffness::eval(i).matrix(), forces: whole(Forces::eval(i)), sizes }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<JoinLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the nodal forces with respect to translations and spins", |i| {
                tangent(i).derives(|motion| moving(i, motion))
            }),
            Law::<Self>::new("it is symmetric but for each node's own spin, where K − Kᵀ = −[m×]", |i| {
                tangent(i).is_symmetric_but_for_own_spins()
            }),
            Law::<Self>::new("where both nodes turn as one body, forces and moments turn with them", |i| {
                tangent(i).turns_with_the_body([i.xa, i.xb], i.e1a + i.e2a)
            }),
        ]
    }
}
