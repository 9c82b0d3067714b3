//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{ContactForce, ContactLoads, Friction, FrictionLoads};
use crate::Octuple;
use crate::connector::slot::{self, SlotLoads};
use crate::formula::proof::Hard;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use num_traits::Zero;

impl Proved for ContactForce {
    fn cases() -> Vec<Case<ContactLoads<f64>>> {
        let mut cases = vec![
            Case::running("12 + 5 + 13", HAND),
            Case::limit("no-radius", "R_r = 0 ignores the torque: 5 + 13", ContactLoads { rr: 0.0, ..HAND }),
            Case::limit("no-length", "L = 0 ignores bending: 12 + 5", ContactLoads { l: 0.0, ..HAND }),
            Case::hand("slot", "without moments it is the contact force of a SLOT", {
                ContactLoads { m1: 0.0, m2: 0.0, m3: 0.0, ..HAND }
            }),
        ];
        let hard = hard_loads().into_iter();
        cases.extend(hard.map(|load| Case::hard(load.id, load.comment, load.value)));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(HAND, |i| [i.rr]),
            Kink::<Self>::switched_off(HAND, |i| [i.l]),
            Kink::<Self>::of_abs(HAND, |i| [i.m1]),
            Kink::<Self>::of_norm(HAND, |i| [i.f2, i.f3]),
            Kink::<Self>::of_norm(HAND, |i| [i.m2, i.m3]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("without moments, or without levers, it is the contact force of a SLOT", |i| {
                let zero = i.f2 * 0.0;
                let slot = slot::ContactForce::eval(&i.radial()).fc;
                let no_moments = ContactLoads { m1: zero, m2: zero, m3: zero, ..*i };
                let no_levers = ContactLoads { rr: zero, l: zero, ..*i };
                law::equal_all([(Self::eval(&no_moments).fc, slot), (Self::eval(&no_levers).fc, slot)])
            }),
            Law::<Self>::new("reversing any load does not change it", |i| {
                let fc = Self::eval(i).fc;
                let reversed = [
                    ContactLoads { f2: -i.f2, ..*i },
                    ContactLoads { f3: -i.f3, ..*i },
                    ContactLoads { m1: -i.m1, ..*i },
                    ContactLoads { m2: -i.m2, ..*i },
                    ContactLoads { m3: -i.m3, ..*i },
                ];
                law::equal_all(reversed.map(|loads| (Self::eval(&loads).fc, fc)))
            }),
            Law::<Self>::new("it is of degree 1 in the loads: the loads times their derivatives add up to it", |i| {
                let by = Self::jacobian(i).fc;
                let loads = [(i.f2, by.f2), (i.f3, by.f3), (i.m1, by.m1), (i.m2, by.m2), (i.m3, by.m3)];
                let sum = loads.iter().fold(Octuple::zero(), |sum, &(load, slope)| sum + load * slope);
                law::equal(sum, Self::eval(i).fc)
            }),
        ]
    }
}

impl Proved for Friction {
    fn cases() -> Vec<Case<FrictionLoads<f64>>> {
        let hand = FrictionLoads::new(-6.0, &HAND, 2.0, 0.25);
        let mut cases = vec![
            Case::running("F_N = 30 + 2, Φ = 6 - 8: sticks", hand),
            Case::hand("slip", "P = 8 = μ F_N: Φ = 0", FrictionLoads { f1: 8.0, ..hand }),
            Case::hand("frictionless", "μ = 0: Φ = P", FrictionLoads { mu: 0.0, ..hand }),
            Case::limit("no-levers", "R_r = L = 0: the friction of a SLOT", FrictionLoads { rr: 0.0, l: 0.0, ..hand }),
            Case::hard("no-axial-force", "f1 = 0: derivative 0 by convention", FrictionLoads { f1: 0.0, ..hand }),
            Case::hard("cancelled", "F_C + F_C_int = 0: derivative 0 by convention", {
                FrictionLoads { fc_int: -30.0, ..hand }
            }),
            Case::hard("nearly-cancelled", "F_C + F_C_int of one ulp", {
                FrictionLoads { fc_int: -30.0_f64.next_up(), ..hand }
            }),
        ];
        cases.extend(hard_loads().into_iter().map(|load| {
            let inputs = FrictionLoads::new(load.value.m1, &load.value, load.value.f2, 0.25);
            Case::hard(format!("loads-{}", load.id), load.comment, inputs)
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(on_kink(ContactLoads { rr: 0.0, ..HAND }), |i| [i.rr]),
            Kink::<Self>::switched_off(on_kink(ContactLoads { l: 0.0, ..HAND }), |i| [i.l]),
            Kink::<Self>::of_abs(on_kink(HAND), |i| [i.f1]),
            Kink::<Self>::of_abs(on_kink(ContactLoads { m1: 0.0, ..HAND }), |i| [i.m1]),
            Kink::<Self>::of_norm(on_kink(ContactLoads { f2: 0.0, f3: 0.0, ..HAND }), |i| [i.f2, i.f3]),
            Kink::<Self>::of_norm(on_kink(ContactLoads { m2: 0.0, m3: 0.0, ..HAND }), |i| [i.m2, i.m3]),
            Kink::<Self>::subgradient(
                r"F_C + F_C^{\mathrm{int}} = 0",
                |i| ContactForce::eval(&i.contact()).fc + i.fc_int == 0.0,
                FrictionLoads { fc_int: -30.0, ..on_kink(HAND) },
                FrictionLoads { fc_int: 1.0, ..FrictionLoads::filled(0.0) },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("without moments it is the friction of a SLOT", |i| {
                let zero = Octuple::zero();
                let here = Self::eval(&FrictionLoads { m1: zero, m2: zero, m3: zero, ..*i });
                let FrictionLoads { f1, f2, f3, fc_int, mu, .. } = *i;
                let slot = slot::Friction::eval(&SlotLoads { f1, f2, f3, fc_int, mu });
                law::equal_all([(here.p, slot.p), (here.r#fn, slot.r#fn), (here.phi, slot.phi)])
            }),
            Law::<Self>::new("reversing all forces and moments does not change it", |i| {
                let [f1, f2, f3, m1, m2, m3] = [i.f1, i.f2, i.f3, i.m1, i.m2, i.m3].map(|load| -load);
                let (here, there) = (Self::eval(i), Self::eval(&FrictionLoads { f1, f2, f3, m1, m2, m3, ..*i }));
                law::equal_all([(here.p, there.p), (here.r#fn, there.r#fn), (here.phi, there.phi)])
            }),
            Law::<Self>::new("at the friction force μ F_N the yield function is 0", |i| {
                let f1 = i.mu * Self::eval(i).r#fn;
                law::equal_with(Self::eval(&FrictionLoads { f1, ..*i }).phi, Octuple::zero(), f1)
            }),
        ]
    }
}

/// Each load alone; loads and levers of extreme size; levers of 0.
fn hard_loads() -> Vec<Hard<ContactLoads<f64>>> {
    let none = ContactLoads { f2: 0.0, f3: 0.0, m1: 0.0, m2: 0.0, m3: 0.0, ..HAND };
    let scaled = |by: f64| ContactLoads {
        f2: HAND.f2 * by,
        f3: HAND.f3 * by,
        m1: HAND.m1 * by,
        m2: HAND.m2 * by,
        m3: HAND.m3 * by,
        ..HAND
    };
    let alone = "one load alone: the others have derivative 0 by convention";
    let hard = |id, comment, value| Hard { id, comment, value };
    vec![
        hard("unloaded", "no load at all: derivative 0 by convention", none),
        hard("f2-alone", alone, ContactLoads { f2: -3.0, ..none }),
        hard("f3-alone", alone, ContactLoads { f3: 4.0, ..none }),
        hard("m1-alone", alone, ContactLoads { m1: -6.0, ..none }),
        hard("m2-alone", alone, ContactLoads { m2: 5.0, ..none }),
        hard("m3-alone", alone, ContactLoads { m3: -12.0, ..none }),
        hard(
            "no-levers",
            "neither radius nor length: bending and torque are ignored",
            ContactLoads { rr: 0.0, l: 0.0, ..HAND },
        ),
        hard("nothing", "no load and no levers", ContactLoads { rr: 0.0, l: 0.0, ..none }),
        hard("tiny", "loads of 1e-200: squares underflow", scaled(1e-200)),
        hard("huge", "loads of 1e200: squares overflow", scaled(1e200)),
        hard("subnormal", "subnormal loads", scaled(1e-310)),
        hard(
            "uneven",
            "parts of very different size",
            ContactLoads { f2: 1e-17, f3: 1.0, m1: 1e-150, m2: 1e150, ..HAND },
        ),
        hard("thin", "levers of 1e-12", ContactLoads { rr: 1e-12, l: 1e-12, ..HAND }),
        hard("thick", "levers of 1e12", ContactLoads { rr: 1e12, l: 1e12, ..HAND }),
    ]
}

/// 12 + 5 + 13: every part a whole number.
const HAND: ContactLoads<f64> = ContactLoads { f2: 3.0, f3: 4.0, m1: -6.0, m2: 5.0, m3: -12.0, rr: 0.5, l: 2.0 };

/// Loads next to a kink that is not one of f1 or of the sum.
fn on_kink(contact: ContactLoads<f64>) -> FrictionLoads<f64> {
    FrictionLoads::new(1.0, &contact, 1.0, 0.25)
}
