//! Evidence for the formulas of the parent module: cases, kinks, laws, other methods.

use super::{Contact, ContactForce, ContactForces, CrossForces, Friction, NormalForce, SlotLoads};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Method, Proved, hard, law};
use crate::number::scalar::{Scalar, norm};

impl Proved for ContactForce {
    fn cases() -> Vec<Case<CrossForces<f64>>> {
        let mut cases = vec![
            Case::running("3-4-5", CrossForces { f2: 3.0, f3: 4.0 }),
            Case::hand("plane", "in the plane f3 = 0 and the contact force is |f2|", CrossForces { f2: -2.0, f3: 0.0 }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f2, f3] = load.value;
            Case::hard(load.id, load.comment, CrossForces { f2, f3 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_norm(CrossForces { f2: 0.0, f3: 0.0 }, |i| [i.f2, i.f3])]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "turning the slot about its axis does not change it: only the length of (f2, f3) matters",
            |i| {
                law::equal_all([
                    (Self::eval(i).fc, Self::eval(&CrossForces { f2: i.f3, f3: -i.f2 }).fc),
                    (
                        Self::eval(i).fc * 5.0,
                        Self::eval(&CrossForces { f2: i.f2 * 3.0 - i.f3 * 4.0, f3: i.f2 * 4.0 + i.f3 * 3.0 }).fc,
                    ),
                ])
            },
        )]
    }

    fn methods() -> Vec<Method> {
        vec![Method::new::<Self>("plain", "plain square root of the sum", plain_contact_force, plain_contact_force)]
    }
}

impl Proved for NormalForce {
    fn cases() -> Vec<Case<ContactForces<f64>>> {
        let hand = ContactForces { fc: 5.0, fc_int: 1.0 };
        vec![
            Case::running("5 + 1", hand),
            Case::hand(
                "tension",
                "|5 - 9| = 4: an internal force against the contact force",
                ContactForces { fc_int: -9.0, ..hand },
            ),
            Case::hand("no-internal-force", "F_N = F_C", ContactForces { fc_int: 0.0, ..hand }),
            Case::hand("unloaded", "F_N = |F_C_int|", ContactForces { fc: 0.0, fc_int: -3.0 }),
            Case::hard("zero", "no force at all", ContactForces { fc: 0.0, fc_int: 0.0 }),
            Case::hard(
                "cancelled",
                "the forces cancel: derivative 0 by convention",
                ContactForces { fc: 5.0, fc_int: -5.0 },
            ),
            Case::hard(
                "ulp-above",
                "one ulp above cancellation",
                ContactForces { fc: 5.0_f64.next_up(), fc_int: -5.0 },
            ),
            Case::hard(
                "ulp-below",
                "one ulp below cancellation",
                ContactForces { fc: 5.0_f64.next_down(), fc_int: -5.0 },
            ),
            Case::hard("tiny", "forces of 1e-200", ContactForces { fc: 1e-200, fc_int: -3e-200 }),
            Case::hard("huge", "forces of 1e200", ContactForces { fc: 1e200, fc_int: -3e200 }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::subgradient(
            r"F_C + F_C^{\mathrm{int}} = 0",
            |i| i.fc + i.fc_int == 0.0,
            ContactForces { fc: 5.0, fc_int: -5.0 },
            ContactForces { fc: 1.0, fc_int: 0.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("reversing both forces does not change it", |i| {
            law::equal(Self::eval(i).r#fn, Self::eval(&ContactForces { fc: -i.fc, fc_int: -i.fc_int }).r#fn)
        })]
    }
}

impl Proved for Friction {
    fn cases() -> Vec<Case<SlotLoads<f64>>> {
        let hand = SlotLoads { f1: -2.0, f2: 3.0, f3: 4.0, fc_int: 1.0, mu: 0.25 };
        let mut cases = vec![
            Case::running("P = 2, F_N = 6, Φ = 2 - 1.5 = 0.5: f1 cannot be transmitted", hand),
            Case::hand("slip", "P = 1.5 = μ F_N: Φ = 0", SlotLoads { f1: 1.5, ..hand }),
            Case::hand("frictionless", "μ = 0: Φ = P", SlotLoads { mu: 0.0, ..hand }),
            Case::hard("no-axial-force", "f1 = 0: derivative 0 by convention", SlotLoads { f1: 0.0, ..hand }),
            Case::hard(
                "cancelled",
                "F_C + F_C_int = 0: derivative 0 by convention",
                SlotLoads { fc_int: -5.0, ..hand },
            ),
            Case::hard(
                "nearly-cancelled",
                "F_C + F_C_int of one ulp",
                SlotLoads { fc_int: -5.0_f64.next_up(), ..hand },
            ),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f1, f2, f3] = load.value;
            Case::hard(format!("loads-{}", load.id), load.comment, SlotLoads { f1, f2, f3, fc_int: 0.0, mu: 0.25 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::of_abs(SlotLoads { f1: 0.0, f2: 3.0, f3: 4.0, fc_int: 1.0, mu: 0.25 }, |i| [i.f1]),
            Kink::<Self>::of_norm(SlotLoads { f1: 1.0, f2: 0.0, f3: 0.0, fc_int: 1.0, mu: 0.25 }, |i| [i.f2, i.f3]),
            Kink::<Self>::subgradient(
                r"\sqrt{f_2^2 + f_3^2} + F_C^{\mathrm{int}} = 0",
                |i| norm([i.f2, i.f3]) + i.fc_int == 0.0,
                SlotLoads { f1: 1.0, f2: 3.0, f3: 4.0, fc_int: -5.0, mu: 0.25 },
                SlotLoads { f1: 0.0, f2: 3.0, f3: 4.0, fc_int: 0.0, mu: 0.0 },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("reversing f1, f2 or f3 does not change it", |i| {
                let out = Self::eval(i);
                let reversed = Self::eval(&SlotLoads { f1: -i.f1, f2: -i.f2, f3: -i.f3, ..*i });
                law::equal_all([(out.p, reversed.p), (out.r#fn, reversed.r#fn), (out.phi, reversed.phi)])
            }),
            Law::<Self>::new("at the friction force μ F_N the yield function is 0", |i| {
                let f1 = i.mu * Self::eval(i).r#fn;
                law::equal_with(Self::eval(&SlotLoads { f1, ..*i }).phi, num_traits::Zero::zero(), f1)
            }),
        ]
    }
}

/// The equation as printed, whose squares over- and underflow, and which has no derivative at zero.
fn plain_contact_force<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
    Contact { fc: (i.f2 * i.f2 + i.f3 * i.f3).sqrt() }
}
