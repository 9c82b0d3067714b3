//! The loads that press the parts of a TRANSLATOR together: torque, radial force and bending, each separately.

#![expect(clippy::inline_always, reason = "a call would write the loads to memory, and wait for them there")]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::slot::{self, CrossForces};
use crate::fields;
use crate::formula::quantity::{F_BEND, F_TORQ, FR, L_OVERLAP, M_BEND, M_TORQ, M1, M2, M3, RR};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, norm, norm_and_direction, sign};

fields! {
    /// The torque, and its lever.
    pub struct Torque<T> { m1: T = M1, rr: T = RR }
}
fields! {
    /// Magnitude of the torque, and the contact force due to it.
    pub struct TorqueContact<T> { m_torq: T = M_TORQ, f_torq: T = F_TORQ }
}

/// Contact force from torque: `M_torq = |m1|`, `F_torq = M_torq/R_r`; 0 if `R_r = 0`.
#[derive(Clone, Copy, Debug)]
pub struct TorqueForce;

impl Formula for TorqueForce {
    const SPEC: Spec = Spec::new(
        "translator.torque_force",
        "Contact force from torque",
        Document::TRANSLATOR.reconstructed("Friction", "the quotient by R_r was lost"),
    )
        .equation(r"M_{\mathrm{torq}} = \lvert m_1\rvert,\quad F_{\mathrm{torq}} = \begin{cases} M_{\mathrm{torq}}/R_r & R_r > 0 \\ 0 & R_r = 0 \end{cases}")
        .eta(0.5, 0.5)
        .scale(1e80)
        .finite(Finite::Between);
    type Inputs<T: Component> = Torque<T>;
    type Outputs<T: Component> = TorqueContact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Torque<D>) -> TorqueContact<D> {
        let m_torq = abs(i.m1);
        TorqueContact { m_torq, f_torq: if i.rr == 0.0 { D::zero() } else { m_torq / i.rr } }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Torque<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Torque<D>) -> (TorqueContact<D>, Jacobian<Self, D>) {
        let (zero, s) = (D::zero(), sign(i.m1));
        let TorqueContact { m_torq, f_torq } = Self::eval(i);
        let by_lever =
            if i.rr == 0.0 { Torque { m1: zero, rr: zero } } else { Torque { m1: s / i.rr, rr: -f_torq / i.rr } };
        (TorqueContact { m_torq, f_torq }, TorqueContact { m_torq: Torque { m1: s, rr: zero }, f_torq: by_lever })
    }
}

fields! {
    /// Contact force due to the force normal to the slot.
    pub struct RadialContact<T> { fr: T = FR }
}

/// Contact force due to the force normal to the slot, the same as in a SLOT: `F_r = √(f2² + f3²)`.
#[derive(Clone, Copy, Debug)]
pub struct RadialForce;

impl Formula for RadialForce {
    const SPEC: Spec = Spec::new(
        "translator.radial_force",
        "Radial contact force",
        Document::TRANSLATOR.reconstructed("Friction", "the root was lost"),
    )
    .equation(r"F_r = \sqrt{f_2^2 + f_3^2}")
    .accurate_as(&slot::ContactForce::SPEC);
    type Inputs<T: Component> = CrossForces<T>;
    type Outputs<T: Component> = RadialContact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossForces<D>) -> RadialContact<D> {
        RadialContact { fr: slot::ContactForce::eval(i).fc }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossForces<D>) -> Jacobian<Self, D> {
        RadialContact { fr: slot::ContactForce::jacobian(i).fc }
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &CrossForces<D>) -> (RadialContact<D>, Jacobian<Self, D>) {
        let (value, jacobian) = slot::ContactForce::linearized(i);
        (RadialContact { fr: value.fc }, RadialContact { fr: jacobian.fc })
    }
}

fields! {
    /// The bending moments, and the length over which they are carried.
    pub struct Bending<T> { m2: T = M2, m3: T = M3, l: T = L_OVERLAP }
}
fields! {
    /// Magnitude of the bending moment, and the contact force due to it.
    pub struct BendingContact<T> { m_bend: T = M_BEND, f_bend: T = F_BEND }
}

/// Contact force from bending: `M_bend = √(m2² + m3²)`, `F_bend = 2 M_bend/L`; 0 if L = 0.
#[derive(Clone, Copy, Debug)]
pub struct BendingForce;

impl Formula for BendingForce {
    const SPEC: Spec = Spec::new(
        "translator.bending_force",
        "Contact force from bending",
        Document::TRANSLATOR.reconstructed("Friction", "the root and the quotient by L were lost"),
    )
        .equation(r"M_{\mathrm{bend}} = \sqrt{m_2^2 + m_3^2},\quad F_{\mathrm{bend}} = \begin{cases} 2 M_{\mathrm{bend}}/L & L > 0 \\ 0 & L = 0 \end{cases}")
        .eta(1.0, 3.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = Bending<T>;
    type Outputs<T: Component> = BendingContact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Bending<D>) -> BendingContact<D> {
        let m_bend = norm([i.m2, i.m3]);
        BendingContact { m_bend, f_bend: if i.l == 0.0 { D::zero() } else { m_bend * 2.0 / i.l } }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Bending<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Bending<D>) -> (BendingContact<D>, Jacobian<Self, D>) {
        let zero = D::zero();
        let (m_bend, [n2, n3]) = norm_and_direction([i.m2, i.m3]);
        let by_moment = Bending { m2: n2, m3: n3, l: zero };
        let (f_bend, by_length) = if i.l == 0.0 {
            (zero, Bending { m2: zero, m3: zero, l: zero })
        } else {
            let (f_bend, per) = (m_bend * 2.0 / i.l, i.l.recip());
            (f_bend, Bending { m2: n2 * 2.0 * per, m3: n3 * 2.0 * per, l: -(f_bend * per) })
        };
        (BendingContact { m_bend, f_bend }, BendingContact { m_bend: by_moment, f_bend: by_length })
    }
}
