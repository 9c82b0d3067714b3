//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{ContactMomentPair, ContactMoments, JointLoads};
use crate::Octuple;
use crate::connector::ujoint::decomposition::proof::{HardLoads, hard_loads};
use crate::connector::ujoint::running::{E3B, FORCE, LA, LS, M2, RP};
use crate::connector::ujoint::{
    Arm, AxialForces, Bending, CentreLoads, CrossForces, CrossLoads, HingeAxial, HingeBending, HingeTransverse,
    TwistFactors,
};
use crate::formula::proof::{Case, Equation, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use nalgebra::Vector3;

impl Proved for ContactMoments {
    fn cases() -> Vec<Case<JointLoads<f64>>> {
        hard_cases()
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(hand(), |i| [i.ls]),
            Kink::<Self>::subgradient(
                r"F_{\mathrm{axial1}} = 0",
                |i| i.at_centre().f_axial1 == 0.0,
                JointLoads { f1: 0.0, ..hand() },
                JointLoads { f1: 1.0, ..JointLoads::filled(0.0) },
            ),
            Kink::<Self>::subgradient(
                r"F_{\mathrm{axial3}} = 0",
                |i| i.at_centre().f_axial3 == 0.0,
                JointLoads { f2: 0.0, f3: 0.0, ..hand() },
                JointLoads { f3: 1.0, ..JointLoads::filled(0.0) },
            ),
            Kink::<Self>::subgradient(
                r"F_{\mathrm{bend}} = m_2 = 0",
                |i| i.m2 == 0.0 && i.at_centre().f_bend == 0.0,
                JointLoads { f2: 0.0, f3: 0.0, m2: 0.0, ..hand() },
                JointLoads { m2: 1.0, ..JointLoads::filled(0.0) },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("reversing all loads does not change them", |i| {
                let reversed = JointLoads { f1: -i.f1, f2: -i.f2, f3: -i.f3, m2: -i.m2, ..*i };
                equal_pairs(Self::eval(i), Self::eval(&reversed))
            }),
            Law::<Self>::new("they are of first degree in the loads: f·∂M/∂f + m2 ∂M/∂m2 = M", |i| {
                let (m, by) = Self::linearized(i);
                let along = |by: JointLoads<_>| by.f1 * i.f1 + by.f2 * i.f2 + by.f3 * i.f3 + by.m2 * i.m2;
                law::equal_all([(along(by.mc1), m.mc1), (along(by.mc3), m.mc3)])
            }),
            Law::<Self>::new("exchanging the axes of the cross under the same force exchanges them", |i| {
                let force = i.e1a * i.f1 + i.cross_loads().force_beside_e1a();
                let (one, zero) = (Octuple::from(1.0), Octuple::from(0.0));
                let exchanged = JointLoads { e1a: i.e3b, e2a: force, e3b: i.e1a, f1: zero, f2: one, f3: zero, ..*i };
                let ContactMomentPair { mc1, mc3 } = Self::eval(&exchanged);
                equal_pairs(Self::eval(i), ContactMomentPair { mc1: mc3, mc3: mc1 })
            }),
            Law::<Self>::new("the twisting moment alone makes both |m2| (β Rp/La + 2α Rp/Ls)", |i| {
                let zero = Octuple::from(0.0);
                let ContactMomentPair { mc1, mc3 } = Self::eval(&JointLoads { f1: zero, f2: zero, f3: zero, ..*i });
                let shares = TwistFactors::eval(&Arm { la: i.la, rp: i.rp });
                let m = abs(i.m2) * i.rp * (shares.beta_twist / i.la + shares.alpha_twist * 2.0 / i.ls);
                law::equal_all([(mc1, m), (mc3, m)])
            }),
            Law::<Self>::new("the separate formulas of its steps give the same", |i| {
                let JointLoads { m2, la, rp, ra, ls, .. } = *i;
                let CrossForces { f_axial1, f_axial3, f_bend } = i.at_centre();
                let axial = HingeAxial::eval(&AxialForces { f_axial1, f_axial3, la, rp });
                let total = HingeTransverse::eval(&CentreLoads { f_axial1, f_axial3, f_bend, m2, la, rp });
                let bend = HingeBending::eval(&Bending { f_bend, m2, la, rp, ls }).f_total_bend;
                let mc1 = axial.f_axial_hinge1 * ra + (total.f_total_hinge1 + bend) * rp;
                let mc3 = axial.f_axial_hinge3 * ra + (total.f_total_hinge3 + bend) * rp;
                equal_pairs(Self::eval(i), ContactMomentPair { mc1, mc3 })
            }),
        ]
    }
}

fn equal_pairs(left: ContactMomentPair<Octuple>, right: ContactMomentPair<Octuple>) -> Vec<Equation> {
    law::equal_all([(left.mc1, right.mc1), (left.mc3, right.mc3)])
}

/// The cases of the contact moments, and of formulas that use them.
pub(crate) fn hard_cases() -> Vec<Case<JointLoads<f64>>> {
    let hand = hand();
    let mut cases = vec![
        Case::running("1.54 × 0.5 + (9.025 + 3.5) × 1.05, 6.125 × 0.5 + (8.66 + 3.5) × 1.05", running()),
        Case::hand("straight", "α_axial = 0.35, β_axial = 0.15, F_bend = 16, M_bend = 4", hand),
        Case::hand("no-twist", "√(4² + 12²) and 5, 2 × 4/4 each", JointLoads { m2: 0.0, ..hand }),
        Case::hand("bend-alone", "16/4 and 2 × 4/4: 6 each", JointLoads { f1: 0.0, f3: 0.0, m2: 0.0, ..hand }),
        Case::limit("no-axial-arm", "Ra = 0: the axial forces do not rub", JointLoads { ra: 0.0, ..hand }),
        Case::limit("no-sleeve", "Ls = 0: the bending moments do not press", JointLoads { ls: 0.0, ..hand }),
        Case::limit("neither", "Ra = Ls = 0", JointLoads { ra: 0.0, ls: 0.0, ..hand }),
    ];
    let [e1a, e2a, e3a] = hard::triad();
    let off_axis = JointLoads { e1a, e2a, e3a, e3b: e3a * 0.8 - e2a * 0.6, ..hand };
    cases.extend(hard_loads().into_iter().map(|HardLoads { id, comment, inputs }| {
        let CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 } = inputs;
        Case::hard(id, comment, JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2: 0.0, ..hand })
    }));
    for size in [1e-150, 1e-100, 1e100, 1e150] {
        let [f1, f2, f3, m2] = [3.0, -4.0, 12.0, -5.0].map(|load| load * size);
        cases.push(Case::hard(
            format!("loads-{size:e}"),
            "loads of extreme size",
            JointLoads { f1, f2, f3, m2, ..off_axis },
        ));
    }
    for (id, m2) in [("m2-alone", -2.5), ("m2-alone-1e-150", 1e-150), ("m2-alone-1e150", -1e150)] {
        let alone = JointLoads { f1: 0.0, f2: 0.0, f3: 0.0, m2, ..off_axis };
        cases.push(Case::hard(id, "the twisting moment alone", alone));
    }
    cases.extend(hard::arms().into_iter().map(|arm| {
        let [la, rp] = arm.value;
        let larger = if la > rp { la } else { rp };
        Case::hard(arm.id, arm.comment, JointLoads { la, rp, m2: -2.5 * la, ra: rp, ls: larger, ..off_axis })
    }));
    cases.extend(hard::loaded_arms().into_iter().map(|arm| {
        let [la, rp, size] = arm.value;
        let [f1, f2, f3, m2] = [3.0, -4.0, 12.0, -5.0].map(|load| load * size);
        Case::hard(arm.id, arm.comment, JointLoads { f1, f2, f3, m2, la, rp, ra: rp, ls: la, ..off_axis })
    }));
    cases
}

/// The state that the chapter follows.
fn running() -> JointLoads<f64> {
    let [f1, f2, f3] = FORCE;
    JointLoads { e3b: E3B, f1, f2, f3, m2: M2, rp: RP, la: LA, ls: LS, ..hand() }
}

/// The global axes and α = 0: F_axial1 = 20, F_axial3 = 80, F_bend = 16.
pub(crate) fn hand() -> JointLoads<f64> {
    JointLoads {
        e1a: Vector3::x(),
        e2a: Vector3::y(),
        e3a: Vector3::z(),
        e3b: Vector3::z(),
        f1: 20.0,
        f2: -16.0,
        f3: 80.0,
        m2: 152.0,
        rp: 1.0,
        la: 2.0,
        ra: 0.5,
        ls: 4.0,
    }
}
