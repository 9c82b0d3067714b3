//! The friction that the normal moments allow.

use super::contact::hard_cases;
use super::{
    AllContactMoments, ContactMomentPair, ContactMoments, CrossForces, JointLoads, NormalMomentPair, NormalMoments,
};
use crate::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    CROSS_M1, CROSS_M3, E1A, E2A, E3A, E3B, F1, F2, F3, LA, LS, MC1_INT, MC3_INT, MU, PHI1, PHI3, RA, RP, TWIST_M2,
};
use crate::scalar::{Scalar, abs, sign};
use crate::verify::law;
use nalgebra::Vector3;

fields! {
    /// As [`JointLoads`], then the moments about the free axes and the friction parameters.
    pub struct FrictionLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = F1, f2: T = F2, f3: T = F3, m2: T = TWIST_M2, rp: T = RP, la: T = LA, ra: T = RA, ls: T = LS,
        m1: T = CROSS_M1, m3: T = CROSS_M3, mc1_int: T = MC1_INT, mc3_int: T = MC3_INT, mu: T = MU,
    }
}
fields! {
    /// Yield functions about both axes of the cross.
    pub struct YieldPair<T> { phi1: T = PHI1, phi3: T = PHI3 }
}

impl<T: Element> FrictionLoads<T> {
    /// Without what [`ContactMoments`] does not take.
    pub(super) const fn joint(&self) -> JointLoads<T> {
        let Self { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, .. } = *self;
        JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls }
    }

    /// From its two halves, the second taken from `rest`.
    pub(super) const fn of(joint: JointLoads<T>, rest: Self) -> Self {
        let JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls } = joint;
        Self { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, ..rest }
    }
}

impl<D: Scalar> FrictionLoads<D> {
    /// The contact moments of the loads, with the internal ones.
    #[inline]
    fn moments(&self, ContactMomentPair { mc1, mc3 }: ContactMomentPair<D>) -> AllContactMoments<D> {
        AllContactMoments { mc1, mc3, mc1_int: self.mc1_int, mc3_int: self.mc3_int }
    }

    /// Φ for these normal moments.
    #[inline]
    fn yields(&self, mn1: D, mn3: D) -> YieldPair<D> {
        let phi = |m, normal| Yield::eval(&Tractions { p: abs(m), mu: self.mu, r#fn: normal }).phi;
        YieldPair { phi1: phi(self.m1, mn1), phi3: phi(self.m3, mn3) }
    }
}

/// The friction of a universal joint about both axes of its cross: Φk = |mk| − μ M_Nk.
#[derive(Clone, Copy, Debug)]
pub struct Friction;

impl Formula for Friction {
    const SPEC: Spec = Spec {
        id: "ujoint.friction",
        title: "Friction",
        latex: r"\Phi_k = \lvert m_k\rvert - \mu M_{Nk}\quad (k = 1, 3)",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 6.0,
        objective: true,
    };
    type Inputs<T: Element> = FrictionLoads<T>;
    type Outputs<T: Element> = YieldPair<T>;

    fn eval<D: Scalar>(i: &FrictionLoads<D>) -> YieldPair<D> {
        let NormalMomentPair { mn1, mn3 } = NormalMoments::eval(&i.moments(ContactMoments::eval(&i.joint())));
        i.yields(mn1, mn3)
    }

    fn jacobian<D: Scalar>(i: &FrictionLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    fn linearized<D: Scalar>(i: &FrictionLoads<D>) -> (YieldPair<D>, Jacobian<Self, D>) {
        let (moments, contact) = ContactMoments::linearized(&i.joint());
        let (NormalMomentPair { mn1, mn3 }, normal) = NormalMoments::linearized(&i.moments(moments));
        let mu = i.mu;
        let zero = FrictionLoads::filled(D::zero());
        // −μ times the derivative of the normal moment by all that it hangs on.
        let of_contact = |by: D, contact: JointLoads<D>| {
            let factor = -mu * by;
            let scaled = JointLoads {
                e1a: contact.e1a * factor,
                e2a: contact.e2a * factor,
                e3a: contact.e3a * factor,
                e3b: contact.e3b * factor,
                f1: contact.f1 * factor,
                f2: contact.f2 * factor,
                f3: contact.f3 * factor,
                m2: contact.m2 * factor,
                rp: contact.rp * factor,
                la: contact.la * factor,
                ra: contact.ra * factor,
                ls: contact.ls * factor,
            };
            FrictionLoads::of(scaled, zero)
        };
        let (row1, row3) = (of_contact(normal.mn1.mc1, contact.mc1), of_contact(normal.mn3.mc3, contact.mc3));
        let rows = YieldPair {
            phi1: FrictionLoads { m1: D::from(sign(i.m1)), mc1_int: -mu * normal.mn1.mc1_int, mu: -mn1, ..row1 },
            phi3: FrictionLoads { m3: D::from(sign(i.m3)), mc3_int: -mu * normal.mn3.mc3_int, mu: -mn3, ..row3 },
        };
        (i.yields(mn1, mn3), rows)
    }

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
        if let Some(hand) = cases.first().map(|case| case.inputs) {
            cases.extend([
                Case::limit("frictionless", "μ = 0: Φ = |m|", FrictionLoads { mu: 0.0, ..hand }),
                Case::limit(
                    "no-press-fit",
                    "no internal moments",
                    FrictionLoads { mc1_int: 0.0, mc3_int: 0.0, ..hand },
                ),
                Case::hard(
                    "no-moment",
                    "m1 = m3 = 0: derivative 0 by convention",
                    FrictionLoads { m1: 0.0, m3: 0.0, ..hand },
                ),
            ]);
        }
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        let convention = Convention::Subgradient;
        vec![
            Kink {
                condition: "R_a = 0",
                convention: Convention::Switch,
                holds: |i| i.ra == 0.0,
                at: || FrictionLoads { ra: 0.0, ..regular() },
                across: || FrictionLoads { ra: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "L_s = 0",
                convention: Convention::Switch,
                holds: |i| i.ls == 0.0,
                at: || FrictionLoads { ls: 0.0, ..regular() },
                across: || FrictionLoads { ls: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{axial1}} = 0,\ \mu > 0",
                convention,
                holds: |i| i.mu > 0.0 && i.joint().at_centre().f_axial1 == 0.0,
                at: || FrictionLoads { f1: 0.0, ..regular() },
                across: || FrictionLoads { f1: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{axial3}} = 0,\ \mu > 0",
                convention,
                holds: |i| i.mu > 0.0 && i.joint().at_centre().f_axial3 == 0.0,
                at: || FrictionLoads { f2: 0.0, f3: 0.0, ..regular() },
                across: || FrictionLoads { f3: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{bend}} = m_2 = 0,\ \mu > 0",
                convention,
                holds: |i| {
                    let CrossForces { f_bend, .. } = i.joint().at_centre();
                    i.mu > 0.0 && i.m2 == 0.0 && f_bend == 0.0
                },
                at: || FrictionLoads { f2: 0.0, f3: 0.0, m2: 0.0, ..regular() },
                across: || FrictionLoads { m2: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "m_1 = 0",
                convention,
                holds: |i| i.m1 == 0.0,
                at: || FrictionLoads { m1: 0.0, ..regular() },
                across: || FrictionLoads { m1: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "m_3 = 0",
                convention,
                holds: |i| i.m3 == 0.0,
                at: || FrictionLoads { m3: 0.0, ..regular() },
                across: || FrictionLoads { m3: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: r"M_{C1}^{\mathrm{int}} = 0,\ \mu > 0",
                convention,
                holds: |i| i.mu > 0.0 && i.mc1_int == 0.0,
                at: || FrictionLoads { mc1_int: 0.0, ..regular() },
                across: || FrictionLoads { mc1_int: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: r"M_{C3}^{\mathrm{int}} = 0,\ \mu > 0",
                convention,
                holds: |i| i.mu > 0.0 && i.mc3_int == 0.0,
                at: || FrictionLoads { mc3_int: 0.0, ..regular() },
                across: || FrictionLoads { mc3_int: 1.0, ..FrictionLoads::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "reversing all loads leaves them",
                sides: |i| {
                    let out = Self::eval(i);
                    let FrictionLoads { f1, f2, f3, m1, m2, m3, .. } = *i;
                    let reversed = FrictionLoads { f1: -f1, f2: -f2, f3: -f3, m1: -m1, m2: -m2, m3: -m3, ..*i };
                    let reversed = Self::eval(&reversed);
                    law::equal_all([(out.phi1, reversed.phi1), (out.phi3, reversed.phi3)])
                },
            },
            Law {
                statement: "at the friction moments μ M_N they are 0",
                sides: |i| {
                    let ContactMomentPair { mc1, mc3 } = ContactMoments::eval(&i.joint());
                    let all = AllContactMoments { mc1, mc3, mc1_int: i.mc1_int, mc3_int: i.mc3_int };
                    let NormalMomentPair { mn1, mn3 } = NormalMoments::eval(&all);
                    let (m1, m3) = (i.mu * mn1, -i.mu * mn3);
                    let out = Self::eval(&FrictionLoads { m1, m3, ..*i });
                    let zero = num_traits::Zero::zero();
                    [law::equal_with(out.phi1, zero, m1), law::equal_with(out.phi3, zero, m3)].concat()
                },
            },
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
