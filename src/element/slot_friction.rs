//! The friction of SLOT after a motion, with its consistent tangent: contact force, normal force and return map in one.
//!
//! The tangent is ∂(f1, u_slip)/∂(u1, f2, f3, …): in stick the stiffness k_el alone, in slip what the normal force does, which
//! makes a matrix unsymmetric. Without ∂(μ F_N)/∂(f2, f3) Newton's method converges linearly.

#![expect(clippy::inline_always, reason = "a call would write the results to memory, and wait for them there")]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::slot::{Friction, FrictionOutputs, SlotLoads};
use crate::contact::coulomb::{self, Slid, Sliding};
use crate::fields;
use crate::formula::quantity::{F1, F2, F3, FC_INT, K_EL, MU, U_SLIP, U_SLIP_BEFORE, U1};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;

fields! {
    /// The motion along the slot, the state before it, the constraint forces, and what the contact is made of.
    pub struct SlotSliding<T> {
        u1: T = U1, slip_before: T = U_SLIP_BEFORE, k_el: T = K_EL,
        f2: T = F2, f3: T = F3, fc_int: T = FC_INT, mu: T = MU,
    }
}
fields! {
    /// The friction force along the slot, and the state after the motion.
    pub struct SlotSlid<T> { f1: T = F1, slip: T = U_SLIP }
}

impl<D: Scalar> SlotSliding<D> {
    /// What [`Friction`] takes; its own f1 has no part in the normal force.
    #[inline]
    fn loads(&self) -> SlotLoads<D> {
        let Self { f2, f3, fc_int, mu, .. } = *self;
        SlotLoads { f1: D::zero(), f2, f3, fc_int, mu }
    }
}

/// The friction of a SLOT after a motion: F_N from the constraint forces, f1 and what has slipped from the return map.
///
/// f1 is conjugate to u1, as [`KineticForce`](crate::connector::slot::KineticForce) says: it acts on a, its opposite on b.
#[derive(Clone, Copy, Debug)]
pub struct Response;

impl Formula for Response {
    const SPEC: Spec = Spec::new(
        "slot.friction_response",
        "Friction of SLOT after a motion",
        Document::SLOT.ours("Friction", "the page prints F_N and the yield function; the response is the return map's"),
    )
        .equation(r"f_1 = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases},\quad f^{\mathrm{trial}} = k_{\mathrm{el}}(u_1-u_0^{\mathrm{slip}}),\quad u^{\mathrm{slip}} = u_1 - \frac{f_1}{k_{\mathrm{el}}}")
        .given(&[Given::new(r"F_N", &Friction::SPEC)])
        .eta(1.5, 2.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = SlotSliding<T>;
    type Outputs<T: Component> = SlotSlid<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotSliding<D>) -> SlotSlid<D> {
        let SlotSliding { u1, slip_before, k_el, mu, .. } = *i;
        let r#fn = Friction::eval(&i.loads()).r#fn;
        let Slid { f, slip } = coulomb::Response::eval(&Sliding { u: u1, slip_before, k_el, mu, r#fn });
        SlotSlid { f1: f, slip }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotSliding<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &SlotSliding<D>) -> ValueAndJacobian<Self, D> {
        let SlotSliding { u1, slip_before, k_el, mu, .. } = *i;
        let (FrictionOutputs { r#fn, .. }, FrictionOutputs { r#fn: normal, .. }) = Friction::linearized(&i.loads());
        let (value, by) = coulomb::Response::linearized(&Sliding { u: u1, slip_before, k_el, mu, r#fn });
        let row = |by: Sliding<D>| SlotSliding {
            u1: by.u,
            slip_before: by.slip_before,
            k_el: by.k_el,
            f2: by.r#fn * normal.f2,
            f3: by.r#fn * normal.f3,
            fc_int: by.r#fn * normal.fc_int,
            mu: by.mu,
        };
        (SlotSlid { f1: value.f, slip: value.slip }, SlotSlid { f1: row(by.f), slip: row(by.slip) })
    }
}

fields! {
    /// As [`SlotSliding`], in the plane.
    pub struct SlotSliding2d<T> {
        u1: T = U1, slip_before: T = U_SLIP_BEFORE, k_el: T = K_EL, f2: T = F2, fc_int: T = FC_INT, mu: T = MU,
    }
}

impl<D: Scalar> SlotSliding2d<D> {
    /// In space, where there is no f3.
    #[inline(always)]
    fn in_space(&self) -> SlotSliding<D> {
        let Self { u1, slip_before, k_el, f2, fc_int, mu } = *self;
        SlotSliding { u1, slip_before, k_el, f2, f3: D::zero(), fc_int, mu }
    }

    /// A gradient without what the plane has not.
    #[inline(always)]
    fn of_space(SlotSliding { u1, slip_before, k_el, f2, fc_int, mu, .. }: SlotSliding<D>) -> Self {
        Self { u1, slip_before, k_el, f2, fc_int, mu }
    }
}

/// The friction of a SLOT in the plane after a motion: [`Response`] without f3.
#[derive(Clone, Copy, Debug)]
pub struct Response2d;

impl Formula for Response2d {
    const SPEC: Spec = Spec::new(
        "slot.friction_response_2d",
        "Friction of SLOT in the plane after a motion",
        Document::SLOT.ours("Friction", "the page prints F_N and the yield function; the response is the return map's"),
    )
        .equation(r"f_1 = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases},\quad F_N = \left\lvert\lvert f_2\rvert + F_C^{\mathrm{int}}\right\rvert,\quad f^{\mathrm{trial}} = k_{\mathrm{el}}(u_1-u_0^{\mathrm{slip}}),\quad u^{\mathrm{slip}} = u_1 - \frac{f_1}{k_{\mathrm{el}}}")
        .eta(1.5, 2.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = SlotSliding2d<T>;
    type Outputs<T: Component> = SlotSlid<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotSliding2d<D>) -> SlotSlid<D> {
        Response::eval(&i.in_space())
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotSliding2d<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &SlotSliding2d<D>) -> ValueAndJacobian<Self, D> {
        let (value, SlotSlid { f1, slip }) = Response::linearized(&i.in_space());
        (value, SlotSlid { f1: SlotSliding2d::of_space(f1), slip: SlotSliding2d::of_space(slip) })
    }
}
