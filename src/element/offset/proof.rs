//! Evidence for the formula of the parent module: cases, laws.

use super::{Arm, ArmActions, ArmLoads};
use crate::element::motion::{Motion, derivative, still};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use nalgebra::{Matrix3, Vector3};

impl Proved for Arm {
    fn cases() -> Vec<Case<ArmLoads<f64>>> {
        let hand = ArmLoads { r: Vector3::y() * 2.0, f: Vector3::x() * 3.0, m: Vector3::z() };
        let mut cases = vec![
            Case::hand("lever", "2 j × 3 i = -6 k", hand),
            Case::hand(
                "no-arm",
                "the moment stays, nothing changes with the spin",
                ArmLoads { r: Vector3::zeros(), ..hand },
            ),
            Case::hand(
                "pulled",
                "a force along the arm: no moment, K = -6 across",
                ArmLoads { f: Vector3::y() * 3.0, ..hand },
            ),
            Case::hand("pushed", "against it: K = 6 across", ArmLoads { f: Vector3::y() * -3.0, ..hand }),
            Case::running(
                "r × f = (18, -2, -7)",
                ArmLoads {
                    r: Vector3::new(1.0, 2.0, 2.0),
                    f: Vector3::new(2.0, -3.0, 6.0),
                    m: Vector3::new(2.0, -1.0, 3.0),
                },
            ),
        ];
        let [e1, e2, e3] = hard::triad();
        cases.push(Case::hard("across", "arm and force across, off the axes", ArmLoads { r: e1, f: e2, m: -e3 }));
        cases.extend([1e-150, 1e-12, 1e12, 1e150].map(|size| {
            let comment = "an arm and forces of extreme size";
            Case::hard(format!("size-{size:e}"), comment, ArmLoads { r: e1 * size, f: e3 * size, m: e2 * size })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("the work in any motion of the node is that at the end of the arm", |i| {
                // θ × r is the displacement of the end; three spins determine the moment.
                let work = |spin: Vector3<_>| i.f.dot(&spin.cross(&i.r)) + i.m.dot(&spin);
                let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
                let size = law::length(i.f) * law::length(i.r) + law::length(i.m);
                let moment = Self::eval(i).m_node;
                law::equal_all_with(axes.into_iter().map(|axis| (moment.dot(&axis), work(axis))), size)
            }),
            Law::<Self>::new(
                "K is the derivative of the moment with respect to the spin, the force and the moment m held",
                |i| {
                    let rows: Vec<_> = (0..3)
                        .map(|k| {
                            derivative(|motion: &Motion| {
                                let r = motion.of_a(i.r);
                                Self::eval(&ArmLoads { r, f: i.f.map(still), m: i.m.map(still) }).m_node[k]
                            })
                        })
                        .collect();
                    let found = Matrix3::from_fn(|row, column| rows[row].ta[column]);
                    let ArmActions { k_arm, .. } = Self::eval(i);
                    let size = law::length(i.f) * law::length(i.r);
                    law::equal_all_with(k_arm.iter().copied().zip(found.iter().copied()), size)
                },
            ),
            Law::<Self>::new("K − Kᵀ is −[(r × f)×]", |i| {
                let ArmActions { k_arm, .. } = Self::eval(i);
                let expected = -crate::element::products::skew(&i.r.cross(&i.f));
                let pairs: Vec<_> = (k_arm - k_arm.transpose()).iter().copied().zip(expected.iter().copied()).collect();
                law::equal_all_with(pairs, law::length(i.f) * law::length(i.r))
            }),
        ]
    }
}
