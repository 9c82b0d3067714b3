//! The total contact force from torque, radial force and bending, and the friction that it allows.

#![expect(clippy::inline_always, reason = "a call would write the loads to memory, and wait for them there")]

#[cfg(feature = "verify")]
mod proof;

use super::{Bending, BendingForce, RadialForce, Torque, TorqueForce};
use crate::connector::slot::{Contact, ContactForces, CrossForces, FrictionOutputs, NormalForce};
use crate::contact::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::quantity::{F1, F2, F3, FC_INT, L_OVERLAP, M1, M2, M3, MU, RR};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, sign};

fields! {
    /// The constraint forces and moments, and the levers of the moments.
    pub struct ContactLoads<T> {
        f2: T = F2, f3: T = F3, m1: T = M1, m2: T = M2, m3: T = M3, rr: T = RR, l: T = L_OVERLAP,
    }
}

impl<T: Component> ContactLoads<T> {
    #[inline]
    const fn torque(&self) -> Torque<T> {
        Torque { m1: self.m1, rr: self.rr }
    }
    #[inline]
    const fn radial(&self) -> CrossForces<T> {
        CrossForces { f2: self.f2, f3: self.f3 }
    }
    #[inline]
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
    const SPEC: Spec = Spec::new(
        "translator.contact_force",
        "Contact force",
        Document::TRANSLATOR.reconstructed("Friction", "both roots and the quotients by R_r and L were lost"),
    )
        .equation(r"\begin{aligned} F_C &= F_{\mathrm{torq}} + F_r + F_{\mathrm{bend}} = \begin{cases} \lvert m_1/R_r\rvert & R_r > 0 \\ 0 & R_r = 0 \end{cases} + \sqrt{f_2^2 + f_3^2} + \sqrt{(\beta m_2)^2 + (\beta m_3)^2}, \\ \beta &= \begin{cases} 2/L & L > 0 \\ 0 & L = 0 \end{cases} \end{aligned}")
.given(&[Given::new(r"F_{\mathrm{torq}}", &TorqueForce::SPEC), Given::new(r"F_r", &RadialForce::SPEC), Given::new(r"F_{\mathrm{bend}}", &BendingForce::SPEC)])
        .eta(2.0, 3.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = ContactLoads<T>;
    type Outputs<T: Component> = Contact<T>;

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

    #[inline(always)]
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
}

fields! {
    /// All loads of a TRANSLATOR, and its friction parameters.
    pub struct FrictionLoads<T> {
        f1: T = F1, f2: T = F2, f3: T = F3, m1: T = M1, m2: T = M2, m3: T = M3,
        rr: T = RR, l: T = L_OVERLAP, fc_int: T = FC_INT, mu: T = MU,
    }
}

impl<T: Component> FrictionLoads<T> {
    #[inline]
    const fn new(f1: T, contact: &ContactLoads<T>, fc_int: T, mu: T) -> Self {
        let ContactLoads { f2, f3, m1, m2, m3, rr, l } = *contact;
        Self { f1, f2, f3, m1, m2, m3, rr, l, fc_int, mu }
    }

    #[inline]
    const fn contact(&self) -> ContactLoads<T> {
        let Self { f2, f3, m1, m2, m3, rr, l, .. } = *self;
        ContactLoads { f2, f3, m1, m2, m3, rr, l }
    }
}

/// The friction of a TRANSLATOR: `P = |f1|`, `F_N = |F_C + F_C_int|`, `Φ = P − μ F_N`.
#[derive(Clone, Copy, Debug)]
pub struct Friction;

impl Formula for Friction {
    const SPEC: Spec = Spec::new("translator.friction", "Friction", Document::TRANSLATOR.printed("Friction"))
        .equation(r"P = \lvert f_1\rvert,\quad F_N = \left\lvert F_C + F_C^{\mathrm{int}}\right\rvert,\quad \Phi = P - \mu F_N")
.given(&[Given::new(r"F_C", &ContactForce::SPEC)])
        // The largest η that `audit --attack` found is 2.14 for the value, and 2.5 is possible to first order; for the Jacobian 2.14 and 4.
        .eta(4.0, 4.0)
        .scale(1e80)
        .finite(Finite::Between);
    type Inputs<T: Component> = FrictionLoads<T>;
    type Outputs<T: Component> = FrictionOutputs<T>;

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

    #[inline(always)]
    fn linearized<D: Scalar>(i: &FrictionLoads<D>) -> (FrictionOutputs<D>, Jacobian<Self, D>) {
        let zero = D::zero();
        let (Contact { fc }, Contact { fc: by }) = ContactForce::linearized(&i.contact());
        let (p, sum) = (abs(i.f1), fc + i.fc_int);
        let r#fn = NormalForce::eval(&ContactForces { fc, fc_int: i.fc_int }).r#fn;
        let phi = Yield::eval(&Tractions { p, mu: i.mu, r#fn }).phi;
        let (s1, s) = (sign(i.f1), sign(sum));
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
}
