//! Evidence for the formulas of the parent module: cases, laws.

use super::{CrossAxes, GeometricStiffness, Moments, Rows, UniversalLoads, UniversalMoments, UniversalRow};
use crate::Octuple;
use crate::Scalar;
use crate::element::cardan::turns;
use crate::element::motion::{Motion, Moving, Tangent, derivative, still};
use crate::element::{self, NodalForces};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use nalgebra::Vector3;
use num_traits::Zero;

/// The residual of UNIVERSAL under a motion of the nodes, without its initial value.
pub(in crate::element) fn residual(i: &CrossAxes<Octuple>, motion: &Motion) -> Moving {
    let (e1a, e3b) = (motion.of_a(i.e1a), motion.of_b(i.e3b));
    e1a.dot(&e3b)
}

impl UniversalRow<Octuple> {
    /// The row as a motion, including the parts that are always zero.
    pub(in crate::element) fn row(&self) -> Motion {
        Motion { ta: self.g_rot_ta, tb: self.g_rot_tb, ..Motion::none() }
    }
}

/// The axes of a cross at points of interest.
fn axes() -> Vec<Case<CrossAxes<f64>>> {
    let straight = CrossAxes { e1a: Vector3::x(), e3b: Vector3::z() };
    let mut cases = vec![
        Case::hand("right-angle", "i × k = -j", straight),
        Case::hand(
            "3-4-5",
            "i × (0.6, 0, 0.8) = (0, -0.8, 0)",
            CrossAxes { e3b: Vector3::new(0.6, 0.0, 0.8), ..straight },
        ),
        Case::hand(
            "in-line",
            "the residual is at its largest, and no spin changes it",
            CrossAxes { e3b: Vector3::x(), ..straight },
        ),
        Case::running("i × e3b = (0, -0.64, -0.48)", CrossAxes { e3b: turns::PYTHAGOREAN[2], ..straight }),
    ];
    cases.extend(turns::triads().into_iter().map(|pair| {
        let [[e1a, ..], [.., e3b]] = pair.value;
        Case::hard(pair.id, pair.comment, CrossAxes { e1a, e3b })
    }));
    cases
}

impl Proved for Rows {
    fn cases() -> Vec<Case<CrossAxes<f64>>> {
        axes()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the residual with respect to the spins", |i| {
                let (row, found) = (Self::eval(i).row(), derivative(|motion| residual(i, motion)));
                let size = law::length(i.e1a) * law::length(i.e3b);
                let pairs = |left: Vector3<Octuple>, right: Vector3<Octuple>| {
                    law::equal_all_with(left.iter().copied().zip(right.iter().copied()), size)
                };
                [
                    pairs(row.ta, found.ta),
                    pairs(row.tb, found.tb),
                    law::vanish(found.ua.iter().chain(&found.ub).copied(), size),
                ]
                .concat()
            }),
            Law::<Self>::new("turning both nodes as one body changes nothing", |i| {
                let row = Self::eval(i);
                law::equal_vectors(row.g_rot_ta, -row.g_rot_tb)
            }),
            Law::<Self>::new("turning either shaft about itself changes nothing", |i| {
                let row = Self::eval(i);
                [law::no_work(row.g_rot_ta, i.e1a), law::no_work(row.g_rot_tb, i.e3b)].concat()
            }),
        ]
    }
}

/// The same with multipliers at points of interest.
fn loads() -> Vec<Case<UniversalLoads<f64>>> {
    let with = |case: Case<CrossAxes<f64>>| {
        let CrossAxes { e1a, e3b } = case.inputs;
        Case::new(case.flag, case.id, case.comment, UniversalLoads { e1a, e3b, lambda_rot: -1.5 })
    };
    let mut cases: Vec<_> = axes().into_iter().map(with).collect();
    let here = cases[1].inputs;
    cases.extend(hard::norms().into_iter().map(|load| {
        let [lambda_rot] = load.value;
        Case::hard(format!("moment-{}", load.id), "a moment of extreme size", UniversalLoads { lambda_rot, ..here })
    }));
    cases
}

impl Proved for Moments {
    fn cases() -> Vec<Case<UniversalLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "they are Rowsᵀ λ: their work in any motion is that of the multiplier on the residual",
            |i| {
                let UniversalLoads { e1a, e3b, lambda_rot } = *i;
                let row = Rows::eval(&CrossAxes { e1a, e3b });
                let moments = Self::eval(i);
                let on_a = law::equal_vectors(moments.ma, row.g_rot_ta * lambda_rot);
                [on_a, law::equal_vectors(moments.mb, row.g_rot_tb * lambda_rot)].concat()
            },
        )]
    }
}

/// The nodal forces under a motion of the nodes.
fn moving(i: &UniversalLoads<Octuple>, motion: &Motion) -> element::Forces<Moving> {
    let (e1a, e3b, lambda_rot) = (motion.of_a(i.e1a), motion.of_b(i.e3b), still(i.lambda_rot));
    whole(Moments::eval(&UniversalLoads { e1a, e3b, lambda_rot }))
}

/// The moments with the forces, which are zero.
fn whole<D: Scalar>(UniversalMoments { ma, mb }: UniversalMoments<D>) -> element::Forces<D> {
    let none = Vector3::from_element(D::zero());
    NodalForces { fa: none, ma, fb: none, mb }.vector()
}

fn tangent(i: &UniversalLoads<Octuple>) -> Tangent {
    let moment = law::length(i.e1a * i.lambda_rot) * law::length(i.e3b);
    let sizes = [Octuple::zero(), moment];
    Tangent { matrix: GeometricStiffness::eval(i).matrix(), forces: whole(Moments::eval(i)), sizes }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<UniversalLoads<f64>>> {
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
                tangent(i).turns_with_the_body([Vector3::from_element(Octuple::zero()); 2], i.e1a + i.e3b)
            }),
        ]
    }
}
