//! The forces in the slot that produce friction, and the friction they allow.

#[cfg(feature = "verify")]
mod proof;

use crate::contact::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::quantity::{F1, F2, F3, FC, FC_INT, FN, MU, P, PHI};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, norm, norm_and_direction, sign};

fields! {
    /// Constraint force normal to the slot.
    pub struct CrossForces<T> { f2: T = F2, f3: T = F3 }
}
fields! {
    /// Contact force.
    pub struct Contact<T> { fc: T = FC }
}

/// Contact force that produces friction in a SLOT: F_C = √(f2² + f3²).
#[derive(Clone, Copy, Debug)]
pub struct ContactForce;

impl Formula for ContactForce {
    const SPEC: Spec =
        Spec::new("slot.contact_force", "Contact force", Document::SLOT.reconstructed("Friction", "the root was lost"))
            .equation(r"F_C = \sqrt{f_2^2 + f_3^2}")
            .eta(1.0, 3.0)
            .scale(1e250)
            .finite(Finite::Below);
    type Inputs<T: Component> = CrossForces<T>;
    type Outputs<T: Component> = Contact<T>;

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
    const SPEC: Spec = Spec::new("slot.normal_force", "Normal force", Document::SLOT.printed("Friction"))
        .equation(r"F_N = \lvert F_C + F_C^{\mathrm{int}}\rvert")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = ContactForces<T>;
    type Outputs<T: Component> = Normal<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ContactForces<D>) -> Normal<D> {
        Normal { r#fn: abs(i.fc + i.fc_int) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ContactForces<D>) -> Jacobian<Self, D> {
        let s = sign(i.fc + i.fc_int);
        Normal { r#fn: ContactForces { fc: s, fc_int: s } }
    }

    // ANCHOR_END: normal_force
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
    const SPEC: Spec = Spec::new(
        "slot.friction",
        "Friction",
        Document::SLOT.reconstructed("Friction", "the root in F_C was lost"),
    )
        .equation(r"P = \lvert f_1\rvert,\quad F_N = \left\lvert\sqrt{f_2^2+f_3^2} + F_C^{\mathrm{int}}\right\rvert,\quad \Phi = P - \mu F_N")
        .eta(4.0, 4.0)
        .scale(1e120)
        .finite(Finite::Below);
    type Inputs<T: Component> = SlotLoads<T>;
    type Outputs<T: Component> = FrictionOutputs<T>;

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
        let (s1, s) = (sign(i.f1), sign(sum));
        let slope = -i.mu * s; // ∂Φ/∂(F_C + F_C_int)
        let jacobian = FrictionOutputs {
            p: SlotLoads { f1: s1, f2: zero, f3: zero, fc_int: zero, mu: zero },
            r#fn: SlotLoads { f1: zero, f2: s * n2, f3: s * n3, fc_int: s, mu: zero },
            phi: SlotLoads { f1: s1, f2: slope * n2, f3: slope * n3, fc_int: slope, mu: -r#fn },
        };
        (value, jacobian)
    }
}
