//! The friction that the normal moments allow.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::{AllContactMoments, ContactMomentPair, ContactMoments, JointLoads, NormalMomentPair, NormalMoments};
use crate::contact::coulomb::{Tractions, Yield};
use crate::fields;
use crate::formula::quantity::{
    CROSS_M1, CROSS_M3, E1A, E2A, E3A, E3B, F2, F3, JOIN_F1, LA, LS, MC1_INT, MC3_INT, MU, PHI1, PHI3, RA, RP, TWIST_M2,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Given, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, sign};
use nalgebra::Vector3;

fields! {
    /// The inputs of [`JointLoads`], then the moments about the free axes and the friction parameters.
    pub struct FrictionLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = JOIN_F1, f2: T = F2, f3: T = F3, m2: T = TWIST_M2, rp: T = RP, la: T = LA, ra: T = RA, ls: T = LS,
        m1: T = CROSS_M1, m3: T = CROSS_M3, mc1_int: T = MC1_INT, mc3_int: T = MC3_INT, mu: T = MU,
    }
}
fields! {
    /// Yield functions about both axes of the cross.
    pub struct YieldPair<T> { phi1: T = PHI1, phi3: T = PHI3 }
}

impl<T: Component> FrictionLoads<T> {
    /// The inputs of [`ContactMoments`].
    #[inline]
    pub(super) const fn joint(&self) -> JointLoads<T> {
        let Self { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, .. } = *self;
        JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls }
    }

    /// Combines the joint loads with the other fields, taken from `rest`.
    #[inline]
    pub(crate) const fn of(joint: JointLoads<T>, rest: Self) -> Self {
        let JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls } = joint;
        Self { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, ..rest }
    }
}

impl<D: Scalar> FrictionLoads<D> {
    /// The contact moments of the loads, with the internal ones.
    #[inline]
    fn moments(&self, ContactMomentPair { mc1, mc3 }: ContactMomentPair<D>) -> AllContactMoments<D> {
        AllContactMoments { mc1, mc3, mc1_int: self.mc1_int, mc3_int: self.mc3_int }
    }

    /// Φ for these normal moments.
    #[inline]
    fn yields(&self, mn1: D, mn3: D) -> YieldPair<D> {
        let phi = |m, normal| Yield::eval(&Tractions { p: abs(m), mu: self.mu, r#fn: normal }).phi;
        YieldPair { phi1: phi(self.m1, mn1), phi3: phi(self.m3, mn3) }
    }
}

/// The friction of a universal joint about both axes of its cross: Φk = |mk| − μ M_Nk.
#[derive(Clone, Copy, Debug)]
pub struct Friction;

impl Formula for Friction {
    const SPEC: Spec = Spec::new("ujoint.friction", "Friction", Document::UJOINT.printed("Friction"))
        .equation(r"\Phi_k = \lvert m_k\rvert - \mu M_{Nk}\quad (k = 1, 3)")
        .given(&[
            Given::new(r"M_{N1},\ M_{N3}", &NormalMoments::SPEC),
            Given::new(r"M_{C1},\ M_{C3}", &ContactMoments::SPEC),
        ])
        // The largest η that `audit --attack` found is 1 for the value, and 1 is possible to first order; for the Jacobian 3.78 and 16.3.
        .eta(4.0, 6.0)
        .normwise(4.0, 18.0)
        .scale(1e50)
        .finite(Finite::Between);
    type Inputs<T: Component> = FrictionLoads<T>;
    type Outputs<T: Component> = YieldPair<T>;

    #[inline]
    fn eval<D: Scalar>(i: &FrictionLoads<D>) -> YieldPair<D> {
        let NormalMomentPair { mn1, mn3 } = NormalMoments::eval(&i.moments(ContactMoments::eval(&i.joint())));
        i.yields(mn1, mn3)
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &FrictionLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &FrictionLoads<D>) -> (YieldPair<D>, Jacobian<Self, D>) {
        let (moments, contact) = ContactMoments::linearized(&i.joint());
        let (NormalMomentPair { mn1, mn3 }, normal) = NormalMoments::linearized(&i.moments(moments));
        let mu = i.mu;
        let zero = FrictionLoads::filled(D::zero());
        // −μ times the derivatives of the normal moment with respect to all its inputs.
        let of_contact = |by: D, contact: JointLoads<D>| FrictionLoads::of(contact.times(-mu * by), zero);
        let (row1, row3) = (of_contact(normal.mn1.mc1, contact.mc1), of_contact(normal.mn3.mc3, contact.mc3));
        let rows = YieldPair {
            phi1: FrictionLoads { m1: sign(i.m1), mc1_int: -mu * normal.mn1.mc1_int, mu: -mn1, ..row1 },
            phi3: FrictionLoads { m3: sign(i.m3), mc3_int: -mu * normal.mn3.mc3_int, mu: -mn3, ..row3 },
        };
        (i.yields(mn1, mn3), rows)
    }
}
