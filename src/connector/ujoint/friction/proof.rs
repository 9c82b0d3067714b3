//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{Friction, FrictionLoads};
use crate::connector::ujoint::contact::proof::hard_cases;
use crate::connector::ujoint::{
    AllContactMoments, ContactMomentPair, ContactMoments, CrossForces, JointLoads, NormalMomentPair, NormalMoments,
};
use crate::formula::proof::{Case, Convention, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use nalgebra::Vector3;

impl Proved for Friction {
    fn cases() -> Vec<Case<FrictionLoads<f64>>> {
        let rest =
            FrictionLoads { m1: -20.0, m3: 30.0, mc1_int: 1.0, mc3_int: -2.0, mu: 0.25, ..FrictionLoads::filled(0.0) };
        let of = |case: Case<JointLoads<f64>>| Case {
            id: case.id,
            flag: case.flag,
            comment: case.comment,
            inputs: FrictionLoads::of(case.inputs, rest),
        };
        let mut cases: Vec<_> = hard_cases().into_iter().map(of).collect();
        let [running, hand] = [cases[0].inputs, cases[1].inputs];
        cases[0].inputs = FrictionLoads { m1: -5.0, m3: 9.0, ..running };
        cases[0].comment = "5 - 28.8425/4 sticks, 9 - 33.661/4 cannot be transmitted";
        cases.extend([
            Case::hand("frictionless", "μ = 0: Φ = |m|", FrictionLoads { mu: 0.0, ..hand }),
            Case::hand("no-press-fit", "no internal moments", FrictionLoads { mc1_int: 0.0, mc3_int: 0.0, ..hand }),
            Case::hard(
                "no-moment",
                "m1 = m3 = 0: derivative 0 by convention",
                FrictionLoads { m1: 0.0, m3: 0.0, ..hand },
            ),
        ]);
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        let convention = Convention::Subgradient;
        vec![
            Kink::<Self>::switched_off(regular(), |i| [i.ls]),
            Kink::<Self>::new(
                convention,
                r"F_{\mathrm{axial1}} = 0,\ \mu > 0",
                |i| i.mu > 0.0 && i.joint().at_centre().f_axial1 == 0.0,
                FrictionLoads { f1: 0.0, ..regular() },
                FrictionLoads { f1: 1.0, ..FrictionLoads::filled(0.0) },
            ),
            Kink::<Self>::new(
                convention,
                r"F_{\mathrm{axial3}} = 0,\ \mu > 0",
                |i| i.mu > 0.0 && i.joint().at_centre().f_axial3 == 0.0,
                FrictionLoads { f2: 0.0, f3: 0.0, ..regular() },
                FrictionLoads { f3: 1.0, ..FrictionLoads::filled(0.0) },
            ),
            Kink::<Self>::new(
                convention,
                r"F_{\mathrm{bend}} = m_2 = 0,\ \mu > 0",
                |i| {
                    let CrossForces { f_bend, .. } = i.joint().at_centre();
                    i.mu > 0.0 && i.m2 == 0.0 && f_bend == 0.0
                },
                FrictionLoads { f2: 0.0, f3: 0.0, m2: 0.0, ..regular() },
                FrictionLoads { m2: 1.0, ..FrictionLoads::filled(0.0) },
            ),
            Kink::<Self>::new(
                convention,
                "m_1 = 0",
                |i| i.m1 == 0.0,
                FrictionLoads { m1: 0.0, ..regular() },
                FrictionLoads { m1: 1.0, ..FrictionLoads::filled(0.0) },
            ),
            Kink::<Self>::new(
                convention,
                "m_3 = 0",
                |i| i.m3 == 0.0,
                FrictionLoads { m3: 0.0, ..regular() },
                FrictionLoads { m3: 1.0, ..FrictionLoads::filled(0.0) },
            ),
            Kink::<Self>::new(
                convention,
                r"M_{C1}^{\mathrm{int}} = 0,\ \mu > 0",
                |i| i.mu > 0.0 && i.mc1_int == 0.0,
                FrictionLoads { mc1_int: 0.0, ..regular() },
                FrictionLoads { mc1_int: 1.0, ..FrictionLoads::filled(0.0) },
            ),
            Kink::<Self>::new(
                convention,
                r"M_{C3}^{\mathrm{int}} = 0,\ \mu > 0",
                |i| i.mu > 0.0 && i.mc3_int == 0.0,
                FrictionLoads { mc3_int: 0.0, ..regular() },
                FrictionLoads { mc3_int: 1.0, ..FrictionLoads::filled(0.0) },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("reversing all loads does not change them", |i| {
                let out = Self::eval(i);
                let FrictionLoads { f1, f2, f3, m1, m2, m3, .. } = *i;
                let reversed = FrictionLoads { f1: -f1, f2: -f2, f3: -f3, m1: -m1, m2: -m2, m3: -m3, ..*i };
                let reversed = Self::eval(&reversed);
                law::equal_all([(out.phi1, reversed.phi1), (out.phi3, reversed.phi3)])
            }),
            Law::<Self>::new("at the friction moments μ M_N they are 0", |i| {
                let ContactMomentPair { mc1, mc3 } = ContactMoments::eval(&i.joint());
                let all = AllContactMoments { mc1, mc3, mc1_int: i.mc1_int, mc3_int: i.mc3_int };
                let NormalMomentPair { mn1, mn3 } = NormalMoments::eval(&all);
                let (m1, m3) = (i.mu * mn1, -i.mu * mn3);
                let out = Self::eval(&FrictionLoads { m1, m3, ..*i });
                let zero = num_traits::Zero::zero();
                [law::equal_with(out.phi1, zero, m1), law::equal_with(out.phi3, zero, m3)].concat()
            }),
        ]
    }
}

/// A point away from all kinks.
fn regular() -> FrictionLoads<f64> {
    FrictionLoads {
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
        m1: -20.0,
        m3: 30.0,
        mc1_int: 1.0,
        mc3_int: -2.0,
        mu: 0.25,
    }
}
