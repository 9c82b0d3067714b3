//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{Bending, HingeBending};
use crate::connector::ujoint::hinge::HingeTwist;
use crate::connector::ujoint::running::{LA, LS, M2, PARTS, RP};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};

impl Proved for HingeBending {
    fn cases() -> Vec<Case<Bending<f64>>> {
        let hand = Bending { f_bend: -8.0, m2: 304.0, la: 44.0, rp: 20.0 / 3.0, ls: 11.0 };
        let mut cases = vec![
            Case::running(
                "8 × 2.1/8, √(2.1² + 2.8²), 2 × 3.5/2",
                Bending { f_bend: PARTS[2], m2: M2, la: LA, rp: RP, ls: LS },
            ),
            Case::hand("pythagoras", "λ = 6.6 but for rounding: M_bend = 44, M_twist = 33, M_total = 55, F = 10", hand),
            Case::hand("force-alone", "M_bend = 44, F = 8", Bending { m2: 0.0, ..hand }),
            Case::hand(
                "moment-alone",
                "M_twist = 33: |F_bend| at 0",
                Bending { f_bend: 0.0, la: 33.0, rp: 5.0, ..hand },
            ),
            Case::limit("no-sleeve", "Ls = 0: M_total is left out", Bending { ls: 0.0, ..hand }),
            Case::limit("stubby", "λ → 0: the twisting moment does not bend", Bending { la: 1e-9, ..hand }),
            Case::limit("long", "λ → ∞: |m2|/8", Bending { la: 1e9, ..hand }),
            Case::hard("no-sleeve-unloaded", "Ls = 0 and no load", Bending { f_bend: 0.0, m2: 0.0, ls: 0.0, ..hand }),
            Case::hard("short-sleeve", "Ls of 1e-12", Bending { ls: 1e-12, ..hand }),
            Case::hard("vanishing-sleeve", "Ls of 1e-100", Bending { ls: 1e-100, ..hand }),
        ];
        cases.extend(hard::loads().into_iter().map(|load| {
            let [f_bend, m2] = load.value;
            Case::hard(format!("loads-{}", load.id), load.comment, Bending { f_bend, m2, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, Bending { m2: -2.5 * la, la, rp, ls: la, ..hand })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, size] = arm.value;
            Case::hard(arm.id, arm.comment, Bending { f_bend: 5.0 * size, m2: -11.0 * size, la, rp, ls: rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(Bending { f_bend: -8.0, m2: 304.0, la: 33.0, rp: 5.0, ls: 0.0 }, |i| [i.ls]),
            Kink::<Self>::of_abs(Bending { f_bend: 0.0, m2: 304.0, la: 33.0, rp: 5.0, ls: 11.0 }, |i| [i.f_bend]),
            Kink::<Self>::of_norm(Bending { f_bend: 0.0, m2: 0.0, la: 33.0, rp: 5.0, ls: 11.0 }, |i| [i.f_bend, i.m2]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "the contact force, half of it at either end of the sleeve, resists the moment: F Ls/2 = M_total",
                |i| {
                    let out = Self::eval(i);
                    law::equal(out.f_total_bend * i.ls * 0.5, out.m_total_hinge)
                },
            ),
            Law::<Self>::new("M_bend and M_twist are at right angles", |i| {
                let (out, twist) = (Self::eval(i), HingeTwist::eval(&i.twist()).m_twist_hinge);
                let squares = out.m_bend_hinge * out.m_bend_hinge + twist * twist;
                law::equal(out.m_total_hinge * out.m_total_hinge, squares)
            }),
        ]
    }
}
