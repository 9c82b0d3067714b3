//! The contact force of torque, radial force and bending together, and the friction that it allows.

use super::{Bending, BendingForce, RadialForce, Torque, TorqueForce};
use crate::Octuple;
use crate::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{F1, F2, F3, FC_INT, L_OVERLAP, M1, M2, M3, MU, RR};
use crate::scalar::{Scalar, abs, sign};
use crate::slot::{self, Contact, ContactForces, CrossForces, FrictionOutputs, NormalForce, SlotLoads};
use crate::verify::hard::Hard;
use crate::verify::law;
use num_traits::Zero;

fields! {
    /// The constraint forces and moments, and the levers of the moments.
    pub struct ContactLoads<T> {
        f2: T = F2, f3: T = F3, m1: T = M1, m2: T = M2, m3: T = M3, rr: T = RR, l: T = L_OVERLAP,
    }
}

impl<T: Element> ContactLoads<T> {
    const fn torque(&self) -> Torque<T> {
        Torque { m1: self.m1, rr: self.rr }
    }
    const fn radial(&self) -> CrossForces<T> {
        CrossForces { f2: self.f2, f3: self.f3 }
    }
    const fn bending(&self) -> Bending<T> {
        Bending { m2: self.m2, m3: self.m3, l: self.l }
    }
}

impl<D: Scalar> ContactLoads<D> {
    #[inline]
    fn times(&self, k: D) -> Self {
        let Self { f2, f3, m1, m2, m3, rr, l } = *self;
        Self { f2: f2 * k, f3: f3 * k, m1: m1 * k, m2: m2 * k, m3: m3 * k, rr: rr * k, l: l * k }
    }
}

/// Contact force of a TRANSLATOR: `F_C = F_torq + F_r + F_bend`.
#[derive(Clone, Copy, Debug)]
pub struct ContactForce;

impl Formula for ContactForce {
    const SPEC: Spec = Spec {
        id: "translator.contact_force",
        title: "Contact force",
        latex: r"F_C = F_{\mathrm{torq}} + F_r + F_{\mathrm{bend}} = \left\lvert\frac{m_1}{R_r}\right\rvert + \sqrt{f_2^2 + f_3^2} + \sqrt{(\beta m_2)^2 + (\beta m_3)^2},\quad \beta = \frac{2}{L}",
        source: Source::TRANSLATOR.section("Friction"),
        eta: 2.0,
        eta_jacobian: 3.0,
        objective: true,
    };
    type Inputs<T: Element> = ContactLoads<T>;
    type Outputs<T: Element> = Contact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ContactLoads<D>) -> Contact<D> {
        let f_torq = TorqueForce::eval(&i.torque()).f_torq;
        let fr = RadialForce::eval(&i.radial()).fr;
        let f_bend = BendingForce::eval(&i.bending()).f_bend;
        Contact { fc: f_torq + fr + f_bend }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ContactLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ContactLoads<D>) -> (Contact<D>, Jacobian<Self, D>) {
        let (torque, by_torque) = TorqueForce::linearized(&i.torque());
        let (radial, by_radial) = RadialForce::linearized(&i.radial());
        let (bending, by_bending) = BendingForce::linearized(&i.bending());
        let Torque { m1, rr } = by_torque.f_torq;
        let CrossForces { f2, f3 } = by_radial.fr;
        let Bending { m2, m3, l } = by_bending.f_bend;
        let fc = torque.f_torq + radial.fr + bending.f_bend;
        (Contact { fc }, Contact { fc: ContactLoads { f2, f3, m1, m2, m3, rr, l } })
    }

    fn cases() -> Vec<Case<ContactLoads<f64>>> {
        let mut cases = vec![
            Case::hand("all", "12 + 5 + 13", HAND),
            Case::limit("no-radius", "R_r = 0 ignores the torque: 5 + 13", ContactLoads { rr: 0.0, ..HAND }),
            Case::limit("no-length", "L = 0 ignores bending: 12 + 5", ContactLoads { l: 0.0, ..HAND }),
            Case::limit("slot", "without moments it is the contact force of a SLOT", {
                ContactLoads { m1: 0.0, m2: 0.0, m3: 0.0, ..HAND }
            }),
        ];
        let hard = hard_loads().into_iter();
        cases.extend(hard.map(|load| Case::hard(load.id, load.comment, load.value)));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: "R_r = 0",
                convention: Convention::Switch,
                holds: |i| i.rr == 0.0,
                at: || ContactLoads { rr: 0.0, ..HAND },
                across: || ContactLoads { rr: 1.0, ..ContactLoads::filled(0.0) },
            },
            Kink {
                condition: "L = 0",
                convention: Convention::Switch,
                holds: |i| i.l == 0.0,
                at: || ContactLoads { l: 0.0, ..HAND },
                across: || ContactLoads { l: 1.0, ..ContactLoads::filled(0.0) },
            },
            Kink {
                condition: "m_1 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m1 == 0.0,
                at: || ContactLoads { m1: 0.0, ..HAND },
                across: || ContactLoads { m1: 1.0, ..ContactLoads::filled(0.0) },
            },
            Kink {
                condition: "f_2 = f_3 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f2 == 0.0 && i.f3 == 0.0,
                at: || ContactLoads { f2: 0.0, f3: 0.0, ..HAND },
                across: || ContactLoads { f2: 1.0, ..ContactLoads::filled(0.0) },
            },
            Kink {
                condition: "m_2 = m_3 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m2 == 0.0 && i.m3 == 0.0,
                at: || ContactLoads { m2: 0.0, m3: 0.0, ..HAND },
                across: || ContactLoads { m2: 1.0, ..ContactLoads::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "without moments, or without levers, it is the contact force of a SLOT",
                sides: |i| {
                    let zero = i.f2 * 0.0;
                    let slot = slot::ContactForce::eval(&i.radial()).fc;
                    let no_moments = ContactLoads { m1: zero, m2: zero, m3: zero, ..*i };
                    let no_levers = ContactLoads { rr: zero, l: zero, ..*i };
                    law::equal_all([(Self::eval(&no_moments).fc, slot), (Self::eval(&no_levers).fc, slot)])
                },
            },
            Law {
                statement: "reversing any load leaves it",
                sides: |i| {
                    let fc = Self::eval(i).fc;
                    let reversed = [
                        ContactLoads { f2: -i.f2, ..*i },
                        ContactLoads { f3: -i.f3, ..*i },
                        ContactLoads { m1: -i.m1, ..*i },
                        ContactLoads { m2: -i.m2, ..*i },
                        ContactLoads { m3: -i.m3, ..*i },
                    ];
                    law::equal_all(reversed.map(|loads| (Self::eval(&loads).fc, fc)))
                },
            },
            Law {
                statement: "it is of degree 1 in the loads: the loads times their derivatives add up to it",
                sides: |i| {
                    let by = Self::jacobian(i).fc;
                    let loads = [(i.f2, by.f2), (i.f3, by.f3), (i.m1, by.m1), (i.m2, by.m2), (i.m3, by.m3)];
                    let sum = loads.iter().fold(Octuple::zero(), |sum, &(load, slope)| sum + load * slope);
                    law::equal(sum, Self::eval(i).fc)
                },
            },
        ]
    }
}

/// 12 + 5 + 13: every part a whole number.
const HAND: ContactLoads<f64> = ContactLoads { f2: 3.0, f3: 4.0, m1: -6.0, m2: 5.0, m3: -12.0, rr: 0.5, l: 2.0 };

/// One load alone, each in turn; loads and levers of extreme size; levers of 0.
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

fields! {
    /// All loads of a TRANSLATOR, and its friction parameters.
    pub struct FrictionLoads<T> {
        f1: T = F1, f2: T = F2, f3: T = F3, m1: T = M1, m2: T = M2, m3: T = M3,
        rr: T = RR, l: T = L_OVERLAP, fc_int: T = FC_INT, mu: T = MU,
    }
}

impl<T: Element> FrictionLoads<T> {
    #[inline]
    const fn new(f1: T, contact: &ContactLoads<T>, fc_int: T, mu: T) -> Self {
        let ContactLoads { f2, f3, m1, m2, m3, rr, l } = *contact;
        Self { f1, f2, f3, m1, m2, m3, rr, l, fc_int, mu }
    }

    const fn contact(&self) -> ContactLoads<T> {
        let Self { f2, f3, m1, m2, m3, rr, l, .. } = *self;
        ContactLoads { f2, f3, m1, m2, m3, rr, l }
    }
}

/// The friction of a TRANSLATOR: `P = |f1|`, `F_N = |F_C + F_C_int|`, `Φ = P − μ F_N`.
#[derive(Clone, Copy, Debug)]
pub struct Friction;

impl Formula for Friction {
    const SPEC: Spec = Spec {
        id: "translator.friction",
        title: "Friction",
        latex: r"P = \lvert f_1\rvert,\quad F_N = \left\lvert F_C + F_C^{\mathrm{int}}\right\rvert,\quad \Phi = P - \mu F_N",
        source: Source::TRANSLATOR.section("Friction"),
        eta: 4.0,
        eta_jacobian: 3.0,
        objective: true,
    };
    type Inputs<T: Element> = FrictionLoads<T>;
    type Outputs<T: Element> = FrictionOutputs<T>;

    #[inline]
    fn eval<D: Scalar>(i: &FrictionLoads<D>) -> FrictionOutputs<D> {
        let fc = ContactForce::eval(&i.contact()).fc;
        let r#fn = NormalForce::eval(&ContactForces { fc, fc_int: i.fc_int }).r#fn;
        let p = abs(i.f1);
        FrictionOutputs { p, r#fn, phi: Yield::eval(&Tractions { p, mu: i.mu, r#fn }).phi }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &FrictionLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &FrictionLoads<D>) -> (FrictionOutputs<D>, Jacobian<Self, D>) {
        let zero = D::zero();
        let (Contact { fc }, Contact { fc: by }) = ContactForce::linearized(&i.contact());
        let (p, sum) = (abs(i.f1), fc + i.fc_int);
        let r#fn = NormalForce::eval(&ContactForces { fc, fc_int: i.fc_int }).r#fn;
        let phi = Yield::eval(&Tractions { p, mu: i.mu, r#fn }).phi;
        let (s1, s) = (D::from(sign(i.f1)), D::from(sign(sum)));
        let none = ContactLoads { f2: zero, f3: zero, m1: zero, m2: zero, m3: zero, rr: zero, l: zero };
        let slope = -i.mu * s; // ∂Φ/∂(F_C + F_C_int)
        (
            FrictionOutputs { p, r#fn, phi },
            FrictionOutputs {
                p: FrictionLoads::new(s1, &none, zero, zero),
                r#fn: FrictionLoads::new(zero, &by.times(s), s, zero),
                phi: FrictionLoads::new(s1, &by.times(slope), slope, -r#fn),
            },
        )
    }

    fn cases() -> Vec<Case<FrictionLoads<f64>>> {
        let hand = FrictionLoads::new(-6.0, &HAND, 2.0, 0.25);
        let mut cases = vec![
            Case::hand("stick", "F_N = 30 + 2, Φ = 6 - 8: sticks", hand),
            Case::hand("slip", "P = 8 = μ F_N: Φ = 0", FrictionLoads { f1: 8.0, ..hand }),
            Case::limit("frictionless", "μ = 0: Φ = P", FrictionLoads { mu: 0.0, ..hand }),
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
            Kink {
                condition: "R_r = 0",
                convention: Convention::Switch,
                holds: |i| i.rr == 0.0,
                at: || on_kink(ContactLoads { rr: 0.0, ..HAND }),
                across: || FrictionLoads { rr: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "L = 0",
                convention: Convention::Switch,
                holds: |i| i.l == 0.0,
                at: || on_kink(ContactLoads { l: 0.0, ..HAND }),
                across: || FrictionLoads { l: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "f_1 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f1 == 0.0,
                at: || FrictionLoads { f1: 0.0, ..on_kink(HAND) },
                across: || FrictionLoads { f1: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "m_1 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m1 == 0.0,
                at: || on_kink(ContactLoads { m1: 0.0, ..HAND }),
                across: || FrictionLoads { m1: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "f_2 = f_3 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f2 == 0.0 && i.f3 == 0.0,
                at: || on_kink(ContactLoads { f2: 0.0, f3: 0.0, ..HAND }),
                across: || FrictionLoads { f2: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: "m_2 = m_3 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m2 == 0.0 && i.m3 == 0.0,
                at: || on_kink(ContactLoads { m2: 0.0, m3: 0.0, ..HAND }),
                across: || FrictionLoads { m2: 1.0, ..FrictionLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_C + F_C^{\mathrm{int}} = 0",
                convention: Convention::Subgradient,
                holds: |i| ContactForce::eval(&i.contact()).fc + i.fc_int == 0.0,
                at: || FrictionLoads { fc_int: -30.0, ..on_kink(HAND) },
                across: || FrictionLoads { fc_int: 1.0, ..FrictionLoads::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "without moments it is the friction of a SLOT",
                sides: |i| {
                    let zero = Octuple::zero();
                    let here = Self::eval(&FrictionLoads { m1: zero, m2: zero, m3: zero, ..*i });
                    let FrictionLoads { f1, f2, f3, fc_int, mu, .. } = *i;
                    let slot = slot::Friction::eval(&SlotLoads { f1, f2, f3, fc_int, mu });
                    law::equal_all([(here.p, slot.p), (here.r#fn, slot.r#fn), (here.phi, slot.phi)])
                },
            },
            Law {
                statement: "reversing all forces and moments leaves it",
                sides: |i| {
                    let [f1, f2, f3, m1, m2, m3] = [i.f1, i.f2, i.f3, i.m1, i.m2, i.m3].map(|load| -load);
                    let (here, there) = (Self::eval(i), Self::eval(&FrictionLoads { f1, f2, f3, m1, m2, m3, ..*i }));
                    law::equal_all([(here.p, there.p), (here.r#fn, there.r#fn), (here.phi, there.phi)])
                },
            },
            Law {
                statement: "at the friction force μ F_N the yield function is 0",
                sides: |i| {
                    let f1 = i.mu * Self::eval(i).r#fn;
                    law::equal_with(Self::eval(&FrictionLoads { f1, ..*i }).phi, Octuple::zero(), f1)
                },
            },
        ]
    }
}

/// Loads beside a kink that is not one of f1 or of the sum.
fn on_kink(contact: ContactLoads<f64>) -> FrictionLoads<f64> {
    FrictionLoads::new(1.0, &contact, 1.0, 0.25)
}
