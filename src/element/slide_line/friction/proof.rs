//! Evidence for the formula next door: cases, kinks, laws.

use super::{Response, Rubbing};
use crate::Octuple;
use crate::contact::coulomb::response::proof::not_positive;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use num_traits::Zero;

/// Sticks: 1 + 2 × 0.25 < 0.25 × 8.
const HAND: Rubbing<f64> = Rubbing { s11: 8.0, dslip: 0.25, s12_before: 1.0, k_el: 2.0, mu: 0.25 };

/// Slips: 1 + 2 × 2 > 0.25 × 8.
const SLIPPING: Rubbing<f64> = Rubbing { dslip: 2.0, ..HAND };

fn trial(i: &Rubbing<Octuple>) -> Octuple {
    i.s12_before + i.k_el * i.dslip
}

impl Proved for Response {
    fn cases() -> Vec<Case<Rubbing<f64>>> {
        vec![
            Case::hand("stick", "1 + 2 × 0.25 = 1.5 < 0.25 × 8", HAND),
            Case::hand("slip", "1 + 2 × 2 = 5: cut down to 2", SLIPPING),
            Case::hand("slip-back", "1 - 2 × 2 = -3: cut down to -2", Rubbing { dslip: -2.0, ..HAND }),
            Case::hand("open", "nothing is transmitted", Rubbing { s11: 0.0, ..HAND }),
            Case::hand("pulling", "a pressure that pulls transmits nothing", Rubbing { s11: -8.0, ..HAND }),
            Case::hand("frictionless", "μ = 0 transmits nothing", Rubbing { mu: 0.0, ..HAND }),
            Case::hand(
                "unloading",
                "less pressure than before: slips without a motion",
                Rubbing { s11: 2.0, dslip: 0.0, ..HAND },
            ),
            Case::hard("tie", "1 + 2 × 0.5 = μ S11: the Jacobian is not defined", Rubbing { dslip: 0.5, ..HAND }),
            Case::hard("cancelled", "the trial stress is 0: sticks", Rubbing { dslip: -0.5, ..HAND }),
            Case::hard(
                "nearly-cancelled",
                "a stress of 1e8 is taken back but for 1e-8",
                Rubbing { s12_before: 1e8, dslip: -1e8 + 1e-8, k_el: 1.0, ..HAND },
            ),
            Case::hard("stiff", "a stiffness of 1e12", Rubbing { k_el: 1e12, ..HAND }),
            Case::hard(
                "tiny",
                "stresses of 1e-200",
                Rubbing { s11: 8e-200, s12_before: 1e-200, dslip: 2e-201, ..HAND },
            ),
            Case::hard("huge", "stresses of 1e200", Rubbing { s11: 8e200, s12_before: 1e200, dslip: 1e200, ..HAND }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let zero = Rubbing::filled(0.0);
        vec![
            Kink::<Self>::switch(
                r"\lvert S^{\mathrm{trial}}\rvert = \mu S_{11}",
                |i| i.s11 > 0.0 && abs(trial(i)) == i.mu * i.s11,
                Rubbing { dslip: 0.5, ..HAND },
                Rubbing { dslip: 1.0, ..zero },
            ),
            Kink::<Self>::switch(
                r"S_{11} = 0",
                |i| i.s11.is_zero(),
                Rubbing { s11: 0.0, ..HAND },
                Rubbing { s11: 1.0, ..zero },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ S11, and is nothing where nothing pushes", |i| {
                let limit = if i.s11 > 0.0 { i.mu * i.s11 } else { Octuple::zero() };
                not_positive(abs(Self::eval(i).s12) - limit, limit)
            }),
            Law::<Self>::new("slip dissipates: the shear does no negative work on it", |i| {
                let s12 = Self::eval(i).s12;
                let slipped = i.dslip - (s12 - i.s12_before) / i.k_el;
                not_positive(-s12 * slipped, abs(s12) * (abs(i.dslip) + (abs(s12) + abs(i.s12_before)) / i.k_el))
            }),
            Law::<Self>::new("it is odd in slip and shear stress", |i| {
                let back = Rubbing { dslip: -i.dslip, s12_before: -i.s12_before, ..*i };
                law::equal(Self::eval(i).s12, -Self::eval(&back).s12)
            }),
            Law::<Self>::new(
                "in stick a closed cycle brings the shear stress back, and the tangent is the stiffness alone",
                |i| {
                    let s11 = abs(i.s11) + Octuple::from(1.0);
                    let reach = i.mu * s11 / i.k_el;
                    let from = Rubbing { s11, s12_before: i.mu * s11 * Octuple::from(0.25), dslip: reach * 0.5, ..*i };
                    let there = Self::eval(&from).s12;
                    let back = Self::eval(&Rubbing { s12_before: there, dslip: -from.dslip, ..from }).s12;
                    let by = Self::jacobian(&from).s12;
                    if i.mu.is_zero() {
                        return law::equal(there, Octuple::zero());
                    }
                    [
                        law::equal_with(back, from.s12_before, there),
                        law::equal_all([(by.dslip, i.k_el), (by.s11, Octuple::zero())]),
                    ]
                    .concat()
                },
            ),
            Law::<Self>::new("in slip the tangent does not depend on the slip, and the pressure contributes μ", |i| {
                let s11 = abs(i.s11) + Octuple::from(1.0);
                let by = Self::jacobian(&Rubbing {
                    s11,
                    dslip: (i.mu * s11 + abs(i.s12_before) + 1.0) * 2.0 / i.k_el,
                    ..*i
                });
                law::equal_all([(by.s12.dslip, Octuple::zero()), (by.s12.s11, i.mu)])
            }),
        ]
    }
}
