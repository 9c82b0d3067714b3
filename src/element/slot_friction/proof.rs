//! Evidence for the formulas next door: cases, kinks, laws.

use super::{Response, Response2d, SlotSlid, SlotSliding, SlotSliding2d};
use crate::Octuple;
use crate::connector::slot::Friction;
use crate::contact::coulomb::response::proof::{dissipates, not_positive};
use crate::formula::proof::{Case, Convention, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{abs, norm};
use num_traits::Zero;

/// Sticks: 2 × 0.5 = 1 < 0.25 × 8.
const HAND: SlotSliding<f64> =
    SlotSliding { u1: 1.5, slip_before: 1.0, k_el: 2.0, f2: 3.0, f3: 4.0, fc_int: 3.0, mu: 0.25 };

/// Slips: 2 × 3 = 6 > 0.25 × 8.
const SLIPPING: SlotSliding<f64> = SlotSliding { u1: 4.0, ..HAND };

/// By how much the trial force is above what friction transmits.
fn beyond(i: &SlotSliding<Octuple>) -> Octuple {
    i.k_el * abs(i.u1 - i.slip_before) - i.mu * Friction::eval(&i.loads()).r#fn
}

impl Proved for Response {
    fn cases() -> Vec<Case<SlotSliding<f64>>> {
        vec![
            Case::hand("stick", "2 × 0.5 = 1 < 0.25 × (5 + 3): what has slipped stays", HAND),
            Case::hand("slip", "2 × 3 > 2: the force is 2, slipped are 4 - 1", SLIPPING),
            Case::hand("slip-back", "2 × -3: the force is -2, slipped are -2 + 1", SlotSliding { u1: -2.0, ..HAND }),
            Case::hand("frictionless", "μ = 0: all of the motion slips", SlotSliding { mu: 0.0, ..HAND }),
            Case::hard("tie", "the trial force is μ F_N: no Jacobian", SlotSliding { u1: 2.0, ..HAND }),
            Case::hard("unmoved", "at what has slipped: no force, sticks", SlotSliding { u1: 1.0, ..HAND }),
            Case::hard(
                "unloaded-stick",
                "no load across the slot, and the press fit holds: the load's norm has no part in the force",
                SlotSliding { f2: 0.0, f3: 0.0, ..HAND }.with_reach(0.25),
            ),
            Case::hard(
                "unloaded-slip",
                "no load across the slot: derivative 0 by convention",
                SlotSliding { f2: 0.0, f3: 0.0, ..SLIPPING },
            ),
            Case::hard(
                "cancelled",
                "F_C + F_C_int = 0: transmits nothing, derivative 0 by convention",
                SlotSliding { fc_int: -5.0, ..SLIPPING },
            ),
            Case::hard("stiff", "a stiffness of 1e12: nearly all slips", SlotSliding { k_el: 1e12, ..SLIPPING }),
            Case::hard("tiny", "loads of 1e-25", SlotSliding { f2: 3e-25, f3: -4e-25, fc_int: 0.0, ..SLIPPING }),
            Case::hard("huge", "loads of 1e25 stick", SlotSliding { f2: 3e25, f3: -4e25, ..HAND }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let zero = SlotSliding::filled(0.0);
        vec![
            Kink::<Self>::switch(
                r"k_{\mathrm{el}}\lvert u_1-u_0^{\mathrm{slip}}\rvert = \mu F_N",
                |i| beyond(i).is_zero(),
                SlotSliding { u1: 2.0, ..HAND },
                SlotSliding { u1: 1.0, ..zero },
            ),
            Kink::<Self>::new(
                Convention::Subgradient,
                r"f_2 = f_3 = 0,\ k_{\mathrm{el}}\lvert u_1-u_0^{\mathrm{slip}}\rvert > \mu F_N",
                |i| i.f2.is_zero() && i.f3.is_zero() && beyond(i) > 0.0,
                SlotSliding { f2: 0.0, f3: 0.0, ..SLIPPING },
                SlotSliding { f2: 1.0, ..zero },
            ),
            Kink::<Self>::subgradient(
                r"\sqrt{f_2^2 + f_3^2} + F_C^{\mathrm{int}} = 0",
                |i| norm([i.f2, i.f3]) + i.fc_int == 0.0,
                SlotSliding { fc_int: -5.0, ..SLIPPING },
                SlotSliding { fc_int: 1.0, ..zero },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ F_N: Φ ≤ 0", |i| {
                let loads = crate::connector::slot::SlotLoads { f1: Self::eval(i).f1, ..i.loads() };
                let friction = Friction::eval(&loads);
                not_positive(friction.phi, friction.p)
            }),
            Law::<Self>::new("slip dissipates: the force does no negative work on it", |i| {
                let SlotSlid { f1, slip } = Self::eval(i);
                dissipates(f1, slip, i.slip_before, i.u1)
            }),
            Law::<Self>::new(
                "in stick the tangent is the elastic stiffness, the constraint forces contribute nothing, and a closed cycle dissipates no energy",
                |i| {
                    let reach = i.mu * Friction::eval(&i.loads()).r#fn / i.k_el;
                    let at = |part: f64| SlotSliding { u1: i.slip_before + reach * part, ..*i };
                    let ([out, back], by) = ([0.75, -0.5].map(|part| Self::eval(&at(part))), Self::jacobian(&at(0.75)));
                    let zero = Octuple::zero();
                    law::equal_all([
                        (out.slip, i.slip_before),
                        (back.slip, i.slip_before),
                        (by.f1.u1, i.k_el),
                        (by.f1.f2, zero),
                        (by.f1.f3, zero),
                    ])
                },
            ),
            Law::<Self>::new(
                "in slip the tangent does not depend on the motion, and the constraint forces contribute μ ∂F_N",
                |i| {
                    let reach = i.mu * Friction::eval(&i.loads()).r#fn / i.k_el;
                    let by = Self::jacobian(&SlotSliding { u1: i.slip_before + reach * 1.5, ..*i }).f1;
                    let normal = Friction::jacobian(&i.loads()).r#fn;
                    law::equal_all([(by.u1, Octuple::zero()), (by.f2, i.mu * normal.f2), (by.f3, i.mu * normal.f3)])
                },
            ),
        ]
    }
}

impl SlotSliding<f64> {
    /// With this motion from what has slipped before.
    fn with_reach(self, reach: f64) -> Self {
        Self { u1: self.slip_before + reach, ..self }
    }
}

impl Proved for Response2d {
    fn cases() -> Vec<Case<SlotSliding2d<f64>>> {
        let flat = |case: Case<SlotSliding<f64>>| {
            let inputs = SlotSliding2d { f2: case.inputs.f2 / 3.0 * 5.0, ..SlotSliding2d::of_space(case.inputs) };
            Case::new(case.flag, case.id, case.comment, inputs)
        };
        Response::cases().into_iter().map(flat).collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        let (zero, hand) = (SlotSliding2d::filled(0.0), SlotSliding2d { f2: -5.0, ..SlotSliding2d::of_space(HAND) });
        vec![
            Kink::<Self>::switch(
                r"k_{\mathrm{el}}\lvert u_1-u_0^{\mathrm{slip}}\rvert = \mu F_N",
                |i| beyond(&i.in_space()).is_zero(),
                SlotSliding2d { u1: 2.0, ..hand },
                SlotSliding2d { u1: 1.0, ..zero },
            ),
            Kink::<Self>::new(
                Convention::Subgradient,
                r"f_2 = 0,\ k_{\mathrm{el}}\lvert u_1-u_0^{\mathrm{slip}}\rvert > \mu F_N",
                |i| i.f2.is_zero() && beyond(&i.in_space()) > 0.0,
                SlotSliding2d { f2: 0.0, u1: 4.0, ..hand },
                SlotSliding2d { f2: 1.0, ..zero },
            ),
            Kink::<Self>::subgradient(
                r"\lvert f_2\rvert + F_C^{\mathrm{int}} = 0",
                |i| abs(i.f2) + i.fc_int == 0.0,
                SlotSliding2d { fc_int: -5.0, u1: 4.0, ..hand },
                SlotSliding2d { fc_int: 1.0, ..zero },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the response in space, for either direction of the transverse force", |i| {
                let here = Self::eval(i);
                let across = SlotSliding { f2: Octuple::zero(), f3: i.f2, ..i.in_space() };
                let there = Response::eval(&across);
                law::equal_all([(here.f1, there.f1), (here.slip, there.slip)])
            }),
            Law::<Self>::new("slip dissipates: the force does no negative work on it", |i| {
                let SlotSlid { f1, slip } = Self::eval(i);
                dissipates(f1, slip, i.slip_before, i.u1)
            }),
        ]
    }
}
