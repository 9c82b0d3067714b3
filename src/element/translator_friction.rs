//! The friction of TRANSLATOR after a motion, with its consistent tangent by all constraint forces and moments.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::slot_friction::SlotSlid;
use crate::connector::translator::{Friction, FrictionLoads};
use crate::contact::coulomb::{self, Slid, Sliding};
use crate::fields;
use crate::formula::quantity::{F2, F3, FC_INT, K_EL, L_OVERLAP, M1, M2, M3, MU, RR, U_SLIP_BEFORE, U1};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;

fields! {
    /// The motion along the slot, the state before it, the constraint forces and moments, and what the contact is made of.
    pub struct TranslatorSliding<T> {
        u1: T = U1, slip_before: T = U_SLIP_BEFORE, k_el: T = K_EL,
        f2: T = F2, f3: T = F3, m1: T = M1, m2: T = M2, m3: T = M3,
        rr: T = RR, l: T = L_OVERLAP, fc_int: T = FC_INT, mu: T = MU,
    }
}

impl<D: Scalar> TranslatorSliding<D> {
    /// What [`Friction`] takes; its own f1 has no part in the normal force.
    #[inline]
    fn loads(&self) -> FrictionLoads<D> {
        let Self { f2, f3, m1, m2, m3, rr, l, fc_int, mu, .. } = *self;
        FrictionLoads { f1: D::zero(), f2, f3, m1, m2, m3, rr, l, fc_int, mu }
    }
}

/// The friction of a TRANSLATOR after a motion: F_N from torque, radial force and bending, f1 and what has slipped from the
/// return map.
#[derive(Clone, Copy, Debug)]
pub struct Response;

impl Formula for Response {
    const SPEC: Spec = Spec::new(
        "translator.friction_response",
        "Friction of TRANSLATOR after a motion",
        Document::TRANSLATOR
            .ours("Friction", "the page prints F_N and the yield function; the response is the return map's"),
    )
        .equation(r"f_1 = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases},\quad f^{\mathrm{trial}} = k_{\mathrm{el}}(u_1-u_0^{\mathrm{slip}}),\quad u^{\mathrm{slip}} = u_1 - \frac{f_1}{k_{\mathrm{el}}}")
        .given(&[Given::new(r"F_N", &Friction::SPEC)])
        .eta(2.0, 3.0)
        .scale(1e80)
        .finite(Finite::Between);
    type Inputs<T: Component> = TranslatorSliding<T>;
    type Outputs<T: Component> = SlotSlid<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TranslatorSliding<D>) -> SlotSlid<D> {
        let TranslatorSliding { u1, slip_before, k_el, mu, .. } = *i;
        let r#fn = Friction::eval(&i.loads()).r#fn;
        let Slid { f, slip } = coulomb::Response::eval(&Sliding { u: u1, slip_before, k_el, mu, r#fn });
        SlotSlid { f1: f, slip }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &TranslatorSliding<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &TranslatorSliding<D>) -> ValueAndJacobian<Self, D> {
        let TranslatorSliding { u1, slip_before, k_el, mu, .. } = *i;
        let (friction, by_loads) = Friction::linearized(&i.loads());
        let (r#fn, normal) = (friction.r#fn, by_loads.r#fn);
        let (value, by) = coulomb::Response::linearized(&Sliding { u: u1, slip_before, k_el, mu, r#fn });
        let row = |by: Sliding<D>| TranslatorSliding {
            u1: by.u,
            slip_before: by.slip_before,
            k_el: by.k_el,
            f2: by.r#fn * normal.f2,
            f3: by.r#fn * normal.f3,
            m1: by.r#fn * normal.m1,
            m2: by.r#fn * normal.m2,
            m3: by.r#fn * normal.m3,
            rr: by.r#fn * normal.rr,
            l: by.r#fn * normal.l,
            fc_int: by.r#fn * normal.fc_int,
            mu: by.mu,
        };
        (SlotSlid { f1: value.f, slip: value.slip }, SlotSlid { f1: row(by.f), slip: row(by.slip) })
    }
}
