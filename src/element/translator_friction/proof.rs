//! Evidence for the formula next door: cases, kinks, laws.

use super::{Response, TranslatorSliding};
use crate::Octuple;
use crate::connector::translator::{Friction, FrictionLoads};
use crate::contact::coulomb::response::proof::{dissipates, not_positive};
use crate::element::slot_friction::{self, SlotSlid, SlotSliding};
use crate::formula::proof::{Case, Convention, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use num_traits::Zero;

/// F_N = 12 + 5 + 13 + 2 = 32; sticks: 2 × 0.5 = 1 < 0.25 × 32.
const HAND: TranslatorSliding<f64> = TranslatorSliding {
    u1: 1.5,
    slip_before: 1.0,
    k_el: 2.0,
    f2: 3.0,
    f3: 4.0,
    m1: -6.0,
    m2: 5.0,
    m3: -12.0,
    rr: 0.5,
    l: 2.0,
    fc_int: 2.0,
    mu: 0.25,
};

/// Slips: 2 × 9 > 0.25 × 32.
const SLIPPING: TranslatorSliding<f64> = TranslatorSliding { u1: 10.0, ..HAND };

/// By how much the trial force is above what friction transmits.
fn beyond(i: &TranslatorSliding<Octuple>) -> Octuple {
    i.k_el * abs(i.u1 - i.slip_before) - i.mu * Friction::eval(&i.loads()).r#fn
}

/// Whether it slips where these are all 0: there is the corner of a norm or of an absolute value.
fn slips_without(i: &TranslatorSliding<Octuple>, parts: &[Octuple]) -> bool {
    parts.iter().all(Zero::is_zero) && beyond(i) > 0.0
}

impl Proved for Response {
    fn cases() -> Vec<Case<TranslatorSliding<f64>>> {
        let unloaded = TranslatorSliding { f2: 0.0, f3: 0.0, m1: 0.0, m2: 0.0, m3: 0.0, ..SLIPPING };
        let alone = "one load alone: the others have derivative 0 by convention";
        vec![
            Case::hand("stick", "2 × 0.5 = 1 < 0.25 × (12 + 5 + 13 + 2): what has slipped stays", HAND),
            Case::hand("slip", "2 × 9 > 8: the force is 8, slipped are 10 - 4", SLIPPING),
            Case::hand("slip-back", "the force is -8", TranslatorSliding { u1: -10.0, ..HAND }),
            Case::hand("frictionless", "μ = 0: all of the motion slips", TranslatorSliding { mu: 0.0, ..HAND }),
            Case::hard("tie", "the trial force is μ F_N: no Jacobian", TranslatorSliding { u1: 5.0, ..HAND }),
            Case::hard("unmoved", "no force, sticks", TranslatorSliding { u1: 1.0, ..HAND }),
            Case::hard("unloaded-slip", "no load: derivative 0 by convention", unloaded),
            Case::hard("f2-alone", alone, TranslatorSliding { f2: -3.0, ..unloaded }),
            Case::hard("m1-alone", alone, TranslatorSliding { m1: -6.0, ..unloaded }),
            Case::hard("m3-alone", alone, TranslatorSliding { m3: -12.0, ..unloaded }),
            Case::hard(
                "cancelled",
                "F_C + F_C_int = 0: transmits nothing, derivative 0 by convention",
                TranslatorSliding { fc_int: -30.0, ..SLIPPING },
            ),
            Case::hard("stiff", "a stiffness of 1e12: nearly all slips", TranslatorSliding { k_el: 1e12, ..SLIPPING }),
            Case::hard("huge", "loads of 1e25 stick", TranslatorSliding { f2: 3e25, m3: -4e25, ..HAND }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let zero = TranslatorSliding::filled(0.0);
        let slips = r"\ k_{\mathrm{el}}\lvert u_1-u_0^{\mathrm{slip}}\rvert > \mu F_N";
        let corner = |condition: &str, holds: fn(&TranslatorSliding<Octuple>) -> bool, at, across| {
            Kink::<Self>::new(Convention::Subgradient, format!("{condition},{slips}"), holds, at, across)
        };
        vec![
            Kink::<Self>::switch(
                r"k_{\mathrm{el}}\lvert u_1-u_0^{\mathrm{slip}}\rvert = \mu F_N",
                |i| beyond(i).is_zero(),
                TranslatorSliding { u1: 5.0, ..HAND },
                TranslatorSliding { u1: 1.0, ..zero },
            ),
            Kink::<Self>::switched_off(TranslatorSliding { rr: 0.0, ..SLIPPING }, |i| [i.rr]),
            Kink::<Self>::switched_off(TranslatorSliding { l: 0.0, ..SLIPPING }, |i| [i.l]),
            corner(
                "f_2 = f_3 = 0",
                |i| slips_without(i, &[i.f2, i.f3]),
                TranslatorSliding { f2: 0.0, f3: 0.0, ..SLIPPING },
                TranslatorSliding { f2: 1.0, ..zero },
            ),
            corner(
                "m_1 = 0",
                |i| slips_without(i, &[i.m1]),
                TranslatorSliding { m1: 0.0, ..SLIPPING },
                TranslatorSliding { m1: 1.0, ..zero },
            ),
            corner(
                "m_2 = m_3 = 0",
                |i| slips_without(i, &[i.m2, i.m3]),
                TranslatorSliding { m2: 0.0, m3: 0.0, ..SLIPPING },
                TranslatorSliding { m2: 1.0, ..zero },
            ),
            Kink::<Self>::subgradient(
                r"F_N = 0",
                |i| Friction::eval(&i.loads()).r#fn.is_zero(),
                TranslatorSliding { fc_int: -30.0, ..SLIPPING },
                TranslatorSliding { fc_int: 1.0, ..zero },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ F_N: Φ ≤ 0", |i| {
                let friction = Friction::eval(&FrictionLoads { f1: Self::eval(i).f1, ..i.loads() });
                not_positive(friction.phi, friction.p)
            }),
            Law::<Self>::new("slip dissipates: the force does no negative work on it", |i| {
                let SlotSlid { f1, slip } = Self::eval(i);
                dissipates(f1, slip, i.slip_before, i.u1)
            }),
            Law::<Self>::new("without moments it is the response of a SLOT, with its tangent", |i| {
                let zero = Octuple::zero();
                let TranslatorSliding { u1, slip_before, k_el, f2, f3, fc_int, mu, .. } = *i;
                let slot = SlotSliding { u1, slip_before, k_el, f2, f3, fc_int, mu };
                let (here, by) = Self::linearized(&TranslatorSliding { m1: zero, m2: zero, m3: zero, ..*i });
                let (there, of_slot) = slot_friction::Response::linearized(&slot);
                law::equal_all([
                    (here.f1, there.f1),
                    (here.slip, there.slip),
                    (by.f1.u1, of_slot.f1.u1),
                    (by.f1.f2, of_slot.f1.f2),
                    (by.f1.mu, of_slot.f1.mu),
                ])
            }),
            Law::<Self>::new(
                "in stick the tangent is the elastic stiffness, in slip the loads contribute μ ∂F_N",
                |i| {
                    let reach = i.mu * Friction::eval(&i.loads()).r#fn / i.k_el;
                    let by =
                        |part: f64| Self::jacobian(&TranslatorSliding { u1: i.slip_before + reach * part, ..*i }).f1;
                    let (stick, slip, zero) = (by(0.75), by(1.5), Octuple::zero());
                    let normal = Friction::jacobian(&i.loads()).r#fn;
                    law::equal_all([
                        (stick.u1, i.k_el),
                        (stick.f2, zero),
                        (stick.m1, zero),
                        (slip.u1, zero),
                        (slip.f2, i.mu * normal.f2),
                        (slip.m1, i.mu * normal.m1),
                        (slip.m3, i.mu * normal.m3),
                    ])
                },
            ),
        ]
    }
}
