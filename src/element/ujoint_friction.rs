//! The friction of UJOINT after turns about both axes of its cross, with its consistent tangent by all constraint forces.

#![expect(
    clippy::inline_always,
    reason = "a call would write the moments to memory, and keep rows from being computed together"
)]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::ujoint::{
    AllContactMoments, ContactMomentPair, ContactMoments, JointLoads, NormalMomentPair, NormalMoments,
};
use crate::contact::coulomb::{self, Slid, Sliding};
use crate::fields;
use crate::formula::quantity::{
    CROSS_M1, CROSS_M3, E1A, E2A, E3A, E3B, F2, F3, JOIN_F1, K_EL_R1, K_EL_R3, LA, LS, MC1_INT, MC3_INT, MU, RA, RP,
    TURN1, TURN1_SLIP, TURN1_SLIP_BEFORE, TURN3, TURN3_SLIP, TURN3_SLIP_BEFORE, TWIST_M2,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The turns about both axes of the cross, the state before them, how the nodes are turned, the constraint forces and
    /// moment, and what the contact is made of.
    pub struct CrossSliding<T> {
        ur1: T = TURN1, ur3: T = TURN3, slip1_before: T = TURN1_SLIP_BEFORE, slip3_before: T = TURN3_SLIP_BEFORE,
        k_el1: T = K_EL_R1, k_el3: T = K_EL_R3,
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = JOIN_F1, f2: T = F2, f3: T = F3, m2: T = TWIST_M2, rp: T = RP, la: T = LA, ra: T = RA, ls: T = LS,
        mc1_int: T = MC1_INT, mc3_int: T = MC3_INT, mu: T = MU,
    }
}
fields! {
    /// The friction moments about both axes of the cross, and the state after the turns.
    pub struct CrossSlid<T> { m1: T = CROSS_M1, m3: T = CROSS_M3, slip1: T = TURN1_SLIP, slip3: T = TURN3_SLIP }
}

impl<D: Scalar> CrossSliding<D> {
    /// What [`ContactMoments`] takes.
    #[inline]
    fn loads(&self) -> JointLoads<D> {
        let Self { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, .. } = *self;
        JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls }
    }

    /// A gradient by what [`ContactMoments`] takes.
    #[inline]
    fn by_loads(loads: JointLoads<D>) -> Self {
        let JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls } = loads;
        Self { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, ..Self::filled(D::zero()) }
    }

    /// The contact moments of the loads, with the internal ones.
    #[inline]
    fn moments(&self, ContactMomentPair { mc1, mc3 }: ContactMomentPair<D>) -> AllContactMoments<D> {
        AllContactMoments { mc1, mc3, mc1_int: self.mc1_int, mc3_int: self.mc3_int }
    }

    /// What is turned about each axis, under these normal moments.
    #[inline]
    fn sliding(&self, NormalMomentPair { mn1, mn3 }: NormalMomentPair<D>) -> [Sliding<D>; 2] {
        let Self { ur1, ur3, slip1_before, slip3_before, k_el1, k_el3, mu, .. } = *self;
        [
            Sliding { u: ur1, slip_before: slip1_before, k_el: k_el1, mu, r#fn: mn1 },
            Sliding { u: ur3, slip_before: slip3_before, k_el: k_el3, mu, r#fn: mn3 },
        ]
    }
}

/// The friction of a UJOINT after turns about both axes of its cross: M_N1 and M_N3 from the constraint forces and moment,
/// m1, m3 and what has slipped from a return map about each axis.
///
/// m1 and m3 are conjugate to the turns: they act on a, their opposites on b.
#[derive(Clone, Copy, Debug)]
pub struct Response;

impl Formula for Response {
    const SPEC: Spec = Spec::new(
        "ujoint.friction_response",
        "Friction of UJOINT after turns",
        Document::UJOINT
            .ours("Friction", "the page prints M_N and the yield functions; the response is the return map's"),
    )
        .equation(r"m_k = \begin{cases} m_k^{\mathrm{trial}} & \lvert m_k^{\mathrm{trial}}\rvert < \mu M_{Nk} \\ \mu M_{Nk} \operatorname{sign} m_k^{\mathrm{trial}} & \text{otherwise}\end{cases},\quad m_k^{\mathrm{trial}} = k_{\mathrm{el},k}(u_{rk}-u_{rk,0}^{\mathrm{slip}}),\quad u_{rk}^{\mathrm{slip}} = u_{rk} - \frac{m_k}{k_{\mathrm{el},k}}\quad (k = 1, 3)")
        .given(&[
            Given::new(r"M_{N1},\ M_{N3}", &NormalMoments::SPEC),
            Given::new(r"M_{C1},\ M_{C3}", &ContactMoments::SPEC),
        ])
        .eta(2.0, 6.0)
        .scale(1e50)
        .finite(Finite::Between);
    type Inputs<T: Component> = CrossSliding<T>;
    type Outputs<T: Component> = CrossSlid<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossSliding<D>) -> CrossSlid<D> {
        let normal = NormalMoments::eval(&i.moments(ContactMoments::eval(&i.loads())));
        let [first, third] = i.sliding(normal).map(|sliding| coulomb::Response::eval(&sliding));
        CrossSlid { m1: first.f, m3: third.f, slip1: first.slip, slip3: third.slip }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossSliding<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &CrossSliding<D>) -> ValueAndJacobian<Self, D> {
        let (moments, contact) = ContactMoments::linearized(&i.loads());
        let (normal, by) = NormalMoments::linearized(&i.moments(moments));
        let [first, third] = i.sliding(normal).map(|sliding| coulomb::Response::linearized(&sliding));
        let row1 = |slid: Sliding<D>| CrossSliding {
            ur1: slid.u,
            slip1_before: slid.slip_before,
            k_el1: slid.k_el,
            mc1_int: slid.r#fn * by.mn1.mc1_int,
            mu: slid.mu,
            ..CrossSliding::by_loads(contact.mc1.times(slid.r#fn * by.mn1.mc1))
        };
        let row3 = |slid: Sliding<D>| CrossSliding {
            ur3: slid.u,
            slip3_before: slid.slip_before,
            k_el3: slid.k_el,
            mc3_int: slid.r#fn * by.mn3.mc3_int,
            mu: slid.mu,
            ..CrossSliding::by_loads(contact.mc3.times(slid.r#fn * by.mn3.mc3))
        };
        let (Slid { f: m1, slip: slip1 }, Slid { f: m3, slip: slip3 }) = (first.0, third.0);
        let value = CrossSlid { m1, m3, slip1, slip3 };
        (
            value,
            CrossSlid {
                m1: row1(first.1.f),
                m3: row3(third.1.f),
                slip1: row1(first.1.slip),
                slip3: row3(third.1.slip),
            },
        )
    }
}
