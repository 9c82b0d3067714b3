//! The forces in the slot that produce friction, and the friction they allow.

use crate::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::measure::Way;
use crate::quantity::{F1, F2, F3, FC, FC_INT, FN, MU, P, PHI};
use crate::scalar::{Scalar, abs, norm, norm_and_direction, sign};
use crate::verify::{hard, law};

fields! {
    /// Constraint force across the slot.
    pub struct CrossForces<T> { f2: T = F2, f3: T = F3 }
}
fields! {
    /// Contact force.
    pub struct Contact<T> { fc: T = FC }
}

/// The equation as it stands, whose squares over- and underflow, and which has no derivative at zero.
fn plain_contact_force<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
    Contact { fc: (i.f2 * i.f2 + i.f3 * i.f3).sqrt() }
}

/// Contact force that produces friction in a SLOT: F_C = √(f2² + f3²).
#[derive(Clone, Copy, Debug)]
pub struct ContactForce;

impl Formula for ContactForce {
    const SPEC: Spec = Spec {
        id: "slot.contact_force",
        title: "Contact force",
        latex: r"F_C = \sqrt{f_2^2 + f_3^2}",
        source: Source::SLOT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 2.0,
        objective: true,
    };
    type Inputs<T: Element> = CrossForces<T>;
    type Outputs<T: Element> = Contact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
        Contact { fc: norm([i.f2, i.f3]) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossForces<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &CrossForces<D>) -> (Contact<D>, Jacobian<Self, D>) {
        let (fc, [f2, f3]) = norm_and_direction([i.f2, i.f3]);
        (Contact { fc }, Contact { fc: CrossForces { f2, f3 } })
    }

    fn cases() -> Vec<Case<CrossForces<f64>>> {
        let mut cases = vec![
            Case::hand("pythagoras", "3-4-5", CrossForces { f2: 3.0, f3: 4.0 }),
            Case::limit(
                "plane",
                "in the plane f3 = 0 and the contact force is |f2|",
                CrossForces { f2: -2.0, f3: 0.0 },
            ),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f2, f3] = load.value;
            Case::hard(load.id, load.comment, CrossForces { f2, f3 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: "f_2 = f_3 = 0",
            convention: Convention::Subgradient,
            holds: |i| i.f2 == 0.0 && i.f3 == 0.0,
            at: || CrossForces { f2: 0.0, f3: 0.0 },
            across: || CrossForces { f2: 1.0, f3: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "turning the slot about its axis leaves it: only the size of (f2, f3) counts",
            sides: |i| {
                law::equal_all([
                    (Self::eval(i).fc, Self::eval(&CrossForces { f2: i.f3, f3: -i.f2 }).fc),
                    (
                        Self::eval(i).fc * 5.0,
                        Self::eval(&CrossForces { f2: i.f2 * 3.0 - i.f3 * 4.0, f3: i.f2 * 4.0 + i.f3 * 3.0 }).fc,
                    ),
                ])
            },
        }]
    }

    fn ways() -> Vec<Way> {
        vec![Way::new::<Self>("plain", "plain square root of the sum", plain_contact_force, plain_contact_force)]
    }
}

// ANCHOR: normal_force
fields! {
    /// Contact force of the loads, and the internal one.
    pub struct ContactForces<T> { fc: T = FC, fc_int: T = FC_INT }
}
fields! {
    /// Normal force.
    pub struct Normal<T> { r#fn: T = FN }
}

/// Normal force of the friction law: F_N = |F_C + F_C_int|.
#[derive(Clone, Copy, Debug)]
pub struct NormalForce;

impl Formula for NormalForce {
    const SPEC: Spec = Spec {
        id: "slot.normal_force",
        title: "Normal force",
        latex: r"F_N = \lvert F_C + F_C^{\mathrm{int}}\rvert",
        source: Source::SLOT.section("Friction"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = ContactForces<T>;
    type Outputs<T: Element> = Normal<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ContactForces<D>) -> Normal<D> {
        Normal { r#fn: abs(i.fc + i.fc_int) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ContactForces<D>) -> Jacobian<Self, D> {
        let s = D::from(sign(i.fc + i.fc_int));
        Normal { r#fn: ContactForces { fc: s, fc_int: s } }
    }

    // ANCHOR_END: normal_force

    fn cases() -> Vec<Case<ContactForces<f64>>> {
        let hand = ContactForces { fc: 5.0, fc_int: 2.0 };
        vec![
            Case::hand("press-fit", "5 + 2", hand),
            Case::hand(
                "tension",
                "|5 - 9| = 4: an internal force against the contact force",
                ContactForces { fc_int: -9.0, ..hand },
            ),
            Case::limit("no-internal-force", "F_N = F_C", ContactForces { fc_int: 0.0, ..hand }),
            Case::limit("unloaded", "F_N = |F_C_int|", ContactForces { fc: 0.0, fc_int: -3.0 }),
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
        vec![Kink {
            condition: r"F_C + F_C^{\mathrm{int}} = 0",
            convention: Convention::Subgradient,
            holds: |i| i.fc + i.fc_int == 0.0,
            at: || ContactForces { fc: 5.0, fc_int: -5.0 },
            across: || ContactForces { fc: 1.0, fc_int: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "reversing both forces leaves it",
            sides: |i| law::equal(Self::eval(i).r#fn, Self::eval(&ContactForces { fc: -i.fc, fc_int: -i.fc_int }).r#fn),
        }]
    }
}

fields! {
    /// The forces in the slot, and its friction parameters.
    pub struct SlotLoads<T> { f1: T = F1, f2: T = F2, f3: T = F3, fc_int: T = FC_INT, mu: T = MU }
}
fields! {
    /// Tangential traction, normal force and yield function.
    pub struct FrictionOutputs<T> { p: T = P, r#fn: T = FN, phi: T = PHI }
}

/// The friction of a SLOT: P = |f1|, F_N = |√(f2² + f3²) + F_C_int|, Φ = P − μ F_N.
#[derive(Clone, Copy, Debug)]
pub struct Friction;

impl Formula for Friction {
    const SPEC: Spec = Spec {
        id: "slot.friction",
        title: "Friction",
        latex: r"P = \lvert f_1\rvert,\quad F_N = \left\lvert\sqrt{f_2^2+f_3^2} + F_C^{\mathrm{int}}\right\rvert,\quad \Phi = P - \mu F_N",
        source: Source::SLOT.section("Friction"),
        eta: 4.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = SlotLoads<T>;
    type Outputs<T: Element> = FrictionOutputs<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotLoads<D>) -> FrictionOutputs<D> {
        let fc = ContactForce::eval(&CrossForces { f2: i.f2, f3: i.f3 }).fc;
        let r#fn = NormalForce::eval(&ContactForces { fc, fc_int: i.fc_int }).r#fn;
        let p = abs(i.f1);
        FrictionOutputs { p, r#fn, phi: Yield::eval(&Tractions { p, mu: i.mu, r#fn }).phi }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &SlotLoads<D>) -> (FrictionOutputs<D>, Jacobian<Self, D>) {
        let zero = D::zero();
        let (fc, [n2, n3]) = norm_and_direction([i.f2, i.f3]);
        let (p, sum) = (abs(i.f1), fc + i.fc_int);
        let r#fn = NormalForce::eval(&ContactForces { fc, fc_int: i.fc_int }).r#fn;
        let value = FrictionOutputs { p, r#fn, phi: Yield::eval(&Tractions { p, mu: i.mu, r#fn }).phi };
        let (s1, s) = (D::from(sign(i.f1)), D::from(sign(sum)));
        let slope = -i.mu * s; // ∂Φ/∂(F_C + F_C_int)
        let jacobian = FrictionOutputs {
            p: SlotLoads { f1: s1, f2: zero, f3: zero, fc_int: zero, mu: zero },
            r#fn: SlotLoads { f1: zero, f2: s * n2, f3: s * n3, fc_int: s, mu: zero },
            phi: SlotLoads { f1: s1, f2: slope * n2, f3: slope * n3, fc_int: slope, mu: -r#fn },
        };
        (value, jacobian)
    }

    fn cases() -> Vec<Case<SlotLoads<f64>>> {
        let hand = SlotLoads { f1: -2.0, f2: 3.0, f3: 4.0, fc_int: 1.0, mu: 0.25 };
        let mut cases = vec![
            Case::hand("stick", "P = 2, F_N = 6, Φ = 2 - 1.5 = 0.5: f1 cannot be transmitted", hand),
            Case::hand("slip", "P = 1.5 = μ F_N: Φ = 0", SlotLoads { f1: 1.5, ..hand }),
            Case::limit("frictionless", "μ = 0: Φ = P", SlotLoads { mu: 0.0, ..hand }),
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
            Kink {
                condition: "f_1 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f1 == 0.0,
                at: || SlotLoads { f1: 0.0, f2: 3.0, f3: 4.0, fc_int: 1.0, mu: 0.25 },
                across: || SlotLoads { f1: 1.0, f2: 0.0, f3: 0.0, fc_int: 0.0, mu: 0.0 },
            },
            Kink {
                condition: "f_2 = f_3 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f2 == 0.0 && i.f3 == 0.0,
                at: || SlotLoads { f1: 1.0, f2: 0.0, f3: 0.0, fc_int: 1.0, mu: 0.25 },
                across: || SlotLoads { f1: 0.0, f2: 1.0, f3: 0.0, fc_int: 0.0, mu: 0.0 },
            },
            Kink {
                condition: r"F_C + F_C^{\mathrm{int}} = 0",
                convention: Convention::Subgradient,
                holds: |i| norm([i.f2, i.f3]) + i.fc_int == 0.0,
                at: || SlotLoads { f1: 1.0, f2: 3.0, f3: 4.0, fc_int: -5.0, mu: 0.25 },
                across: || SlotLoads { f1: 0.0, f2: 3.0, f3: 4.0, fc_int: 0.0, mu: 0.0 },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "reversing f1, f2 or f3 leaves it",
                sides: |i| {
                    let out = Self::eval(i);
                    let reversed = Self::eval(&SlotLoads { f1: -i.f1, f2: -i.f2, f3: -i.f3, ..*i });
                    law::equal_all([(out.p, reversed.p), (out.r#fn, reversed.r#fn), (out.phi, reversed.phi)])
                },
            },
            Law {
                statement: "at the friction force μ F_N the yield function is 0",
                sides: |i| {
                    let f1 = i.mu * Self::eval(i).r#fn;
                    law::equal_with(Self::eval(&SlotLoads { f1, ..*i }).phi, num_traits::Zero::zero(), f1)
                },
            },
        ]
    }
}
