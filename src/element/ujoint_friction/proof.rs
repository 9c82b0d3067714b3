//! Evidence for the formula next door: cases, kinks, laws.

use super::{CrossSlid, CrossSliding, Response};
use crate::Octuple;
use crate::connector::ujoint::contact::proof::hard_cases;
use crate::connector::ujoint::{
    ContactMoments, CrossForces, Friction, FrictionLoads, JointLoads, NormalMomentPair, NormalMoments,
};
use crate::contact::coulomb::Sliding;
use crate::contact::coulomb::response::proof::{dissipates, not_positive};
use crate::formula::proof::{Case, Convention, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use nalgebra::Vector3;
use num_traits::Zero;

/// A point away from all kinks, which slips about both axes.
fn slipping() -> CrossSliding<f64> {
    CrossSliding {
        ur1: 0.5,
        ur3: -0.25,
        slip1_before: 0.25,
        slip3_before: 0.5,
        k_el1: 1e5,
        k_el3: 2e5,
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
        mc1_int: 1.0,
        mc3_int: -2.0,
        mu: 0.25,
    }
}

fn loaded(JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls }: JointLoads<f64>) -> CrossSliding<f64> {
    CrossSliding { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, ..slipping() }
}

/// The normal moments.
fn normal(i: &CrossSliding<Octuple>) -> NormalMomentPair<Octuple> {
    NormalMoments::eval(&i.moments(ContactMoments::eval(&i.loads())))
}

/// By how much each trial moment is above what friction transmits.
fn beyond(i: &CrossSliding<Octuple>) -> [Octuple; 2] {
    i.sliding(normal(i)).map(|s| s.k_el * abs(s.u - s.slip_before) - s.mu * s.r#fn)
}

/// Whether no force acts along e1a, along e3b and across both, to rounding.
fn unloaded(i: &CrossSliding<Octuple>) -> [bool; 3] {
    let forces = [i.e1a * i.f1, i.e2a * i.f2, i.e3a * i.f3];
    let size = forces.iter().map(|&force| law::length(force)).sum::<Octuple>() * 1e-60;
    let CrossForces { f_axial1, f_axial3, f_bend } = i.loads().at_centre();
    let (along_e1a, along_e3b) = (size * law::length(i.e1a), size * law::length(i.e3b));
    [abs(f_axial1) <= along_e1a, abs(f_axial3) <= along_e3b, abs(f_bend) <= size]
}

impl Proved for Response {
    fn cases() -> Vec<Case<CrossSliding<f64>>> {
        let of = |case: Case<JointLoads<f64>>| Case::new(case.flag, case.id, case.comment, loaded(case.inputs));
        let mut cases: Vec<_> = hard_cases().into_iter().map(of).collect();
        let hand = slipping();
        let sticking = CrossSliding { k_el1: 16.0, k_el3: 4.0, ..hand };
        cases.extend([
            Case::hand("stick", "m1 = 16 × 0.25 = 4, m3 = 4 × -0.75 = -3: what has slipped stays", sticking),
            Case::hand("slips-about-e1a", "sticks about e3b", CrossSliding { k_el3: 4.0, ..hand }),
            Case::hand("slips-about-e3b", "sticks about e1a", CrossSliding { k_el1: 16.0, ..hand }),
            Case::hand("frictionless", "μ = 0: all of both turns slips", CrossSliding { mu: 0.0, ..hand }),
            Case::hard("unmoved", "no moment, sticks", CrossSliding { ur1: 0.25, ur3: 0.5, ..hand }),
            Case::hard("stiff", "a stiffness of 1e12: nearly all slips", CrossSliding { k_el1: 1e12, ..hand }),
            Case::hard(
                "far",
                "after many turns: the difference is taken before the product",
                CrossSliding { ur1: 1e8 + 0.25, slip1_before: 1e8, k_el1: 16.0, ..hand },
            ),
        ]);
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        let (zero, hand) = (CrossSliding::filled(0.0), slipping());
        // Exactly 13 and 14 are the normal moments: 3.25 and 3.5 are transmitted.
        let bent = CrossSliding { f1: 0.0, f3: 0.0, m2: 0.0, k_el1: 8.0, k_el3: 4.0, ..hand };
        let tie = |k, beyond: fn(&CrossSliding<Octuple>) -> Octuple, at, across| {
            let condition = format!(
                r"k_{{\mathrm{{el}},{k}}}\lvert u_{{r{k}}}-u_{{r{k},0}}^{{\mathrm{{slip}}}}\rvert = \mu M_{{N{k}}}"
            );
            Kink::<Self>::switch(condition, move |i| beyond(i).is_zero(), at, across)
        };
        // A corner of M_N1 or M_N3 is one of the moment about the same axis, where that slips.
        let corner = |k: usize, condition: &str, holds: fn(&CrossSliding<Octuple>) -> bool, at, across| {
            let axis = [1, 3][k];
            let slip = format!(
                r"k_{{\mathrm{{el}},{axis}}}\lvert u_{{r{axis}}}-u_{{r{axis},0}}^{{\mathrm{{slip}}}}\rvert > \mu M_{{N{axis}}}"
            );
            let holds = move |i: &CrossSliding<Octuple>| beyond(i)[k] > 0.0 && holds(i);
            Kink::<Self>::new(Convention::Subgradient, format!(r"{condition},\ {slip}"), holds, at, across)
        };
        let unbent = |k| {
            corner(
                k,
                r"F_{\mathrm{bend}} = m_2 = 0",
                |i| i.m2 == 0.0 && unloaded(i)[2],
                CrossSliding { f2: 0.0, f3: 0.0, m2: 0.0, ..hand },
                CrossSliding { m2: 1.0, ..zero },
            )
        };
        vec![
            tie(
                1,
                |i| beyond(i)[0],
                CrossSliding { k_el1: 16.0, ur1: hand.slip1_before + 3.25 / 16.0, ..bent },
                CrossSliding { ur1: 1.0, ..zero },
            ),
            tie(
                3,
                |i| beyond(i)[1],
                CrossSliding { k_el3: 16.0, ur3: hand.slip3_before - 3.5 / 16.0, ..bent },
                CrossSliding { ur3: 1.0, ..zero },
            ),
            Kink::<Self>::switched_off(hand, |i| [i.ls]),
            corner(
                0,
                r"F_{\mathrm{axial1}} = 0",
                |i| unloaded(i)[0],
                CrossSliding { f1: 0.0, ..hand },
                CrossSliding { f1: 1.0, ..zero },
            ),
            corner(
                1,
                r"F_{\mathrm{axial3}} = 0",
                |i| unloaded(i)[1],
                CrossSliding { f2: 0.0, f3: 0.0, ..hand },
                CrossSliding { f3: 1.0, ..zero },
            ),
            unbent(0),
            unbent(1),
            corner(
                0,
                r"M_{C1}^{\mathrm{int}} = 0",
                |i| i.mc1_int == 0.0,
                CrossSliding { mc1_int: 0.0, ..hand },
                CrossSliding { mc1_int: 1.0, ..zero },
            ),
            corner(
                1,
                r"M_{C3}^{\mathrm{int}} = 0",
                |i| i.mc3_int == 0.0,
                CrossSliding { mc3_int: 0.0, ..hand },
                CrossSliding { mc3_int: 1.0, ..zero },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ M_N: Φ1 ≤ 0 and Φ3 ≤ 0", |i| {
                let (CrossSlid { m1, m3, .. }, NormalMomentPair { mn1, mn3 }) = (Self::eval(i), normal(i));
                let CrossSliding { mc1_int, mc3_int, mu, .. } = *i;
                let rest = FrictionLoads { m1, m3, mc1_int, mc3_int, mu, ..FrictionLoads::filled(Octuple::zero()) };
                let phi = Friction::eval(&FrictionLoads::of(i.loads(), rest));
                [not_positive(phi.phi1, mu * mn1), not_positive(phi.phi3, mu * mn3)].concat()
            }),
            Law::<Self>::new("slip dissipates: the moments do no negative work on it", |i| {
                let CrossSlid { m1, m3, slip1, slip3 } = Self::eval(i);
                [dissipates(m1, slip1, i.slip1_before, i.ur1), dissipates(m3, slip3, i.slip3_before, i.ur3)].concat()
            }),
            Law::<Self>::new("each axis of the cross takes no part in the friction of the other", |i| {
                let one = Octuple::from(1.0);
                let turned = CrossSliding { ur3: i.ur3 + one, k_el3: i.k_el3 + one, mc3_int: i.mc3_int + one, ..*i };
                let (here, there) = (Self::eval(i), Self::eval(&turned));
                law::equal_all([(here.m1, there.m1), (here.slip1, there.slip1)])
            }),
            Law::<Self>::new(
                "in stick the tangent is the elastic stiffness, in slip the loads act by μ ∂M_N",
                |i| {
                    let [first, third] = i.sliding(normal(i));
                    let part_way = |part: f64| {
                        let at = |s: Sliding<Octuple>| s.slip_before + s.mu * s.r#fn / s.k_el * part;
                        Self::jacobian(&CrossSliding { ur1: at(first), ur3: at(third), ..*i })
                    };
                    let (stick, slip, zero) = (part_way(0.75), part_way(1.5), Octuple::zero());
                    let by = ContactMoments::jacobian(&i.loads());
                    let twice = i.mu * 2.0;
                    law::equal_all([
                        (stick.m1.ur1, i.k_el1),
                        (stick.m3.ur3, i.k_el3),
                        (stick.m1.f2, zero),
                        (stick.m3.m2, zero),
                        (slip.m1.ur1, zero),
                        (slip.m1.f2, twice * by.mc1.f2),
                        (slip.m1.m2, twice * by.mc1.m2),
                        (slip.m3.f1, twice * by.mc3.f1),
                        (slip.m3.m2, twice * by.mc3.m2),
                    ])
                },
            ),
        ]
    }
}
