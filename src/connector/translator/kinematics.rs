//! The five residuals: SLOT's two and ALIGN's three.

#![expect(clippy::inline_always, reason = "a call would write the vectors to memory, and wait for them there")]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::align::{self, Misalignment, Orientations};
use crate::connector::slot::{self, Residuals, SlotPositions};
use crate::element::cardan::{CardanAngles, Oriented, Triads};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA0, BETA0, E1A, E1B, E2A, E2B, E3A, E3B, GAMMA0, GY, GZ, UR1, UR2, UR3, XA, XB, Y0, Z0,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Given, Jacobian, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The positions and triads of both nodes, and the initial position and angles.
    pub struct Placement<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
        y0: T = Y0, z0: T = Z0, alpha0: T = ALPHA0, beta0: T = BETA0, gamma0: T = GAMMA0,
    }
}
fields! {
    /// The deviations of b from the slot and from its initial orientation.
    pub struct AllResiduals<T> { gy: T = GY, gz: T = GZ, ur1: T = UR1, ur2: T = UR2, ur3: T = UR3 }
}

impl<T: Component> Placement<T> {
    /// Combines the inputs of SLOT and ALIGN.
    #[inline]
    pub const fn new(slot: &SlotPositions<T>, align: &Orientations<T>) -> Self {
        let SlotPositions { xa, xb, y0, z0, .. } = *slot;
        let Orientations { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 } = *align;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb, y0, z0, alpha0, beta0, gamma0 }
    }

    /// The inputs of SLOT.
    #[inline]
    pub const fn slot(&self) -> SlotPositions<T> {
        let Self { e2a, e3a, xa, xb, y0, z0, .. } = *self;
        SlotPositions { e2a, e3a, xa, xb, y0, z0 }
    }

    /// The inputs of ALIGN.
    #[inline]
    pub const fn align(&self) -> Orientations<T> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0, .. } = *self;
        Orientations { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 }
    }
}

impl<D: Scalar> Oriented<D> for Placement<D> {
    #[inline(always)]
    fn triads(&self) -> Triads<D> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, .. } = self;
        Triads::by_components([e1a, e2a, e3a], [e1b, e2b, e3b])
    }
    #[inline(always)]
    fn of(triads: Triads<D>) -> Self {
        Self::new(&SlotPositions::filled(D::zero()), &Orientations::of(triads))
    }
}

/// The five conditions of a TRANSLATOR: those of SLOT and those of ALIGN.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "translator.constraint",
        "Constraint",
        Document::TRANSLATOR.ours("Description", "g_y and g_z are printed for SLOT; the page of ALIGN was not given"),
    )
        .equation(r"\begin{aligned} g_y &= \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - y_0, & g_z &= \mathbf{e}_{3a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - z_0,\\ u_{r1} &= \alpha - \alpha_0, & u_{r2} &= \beta - \beta_0,\quad u_{r3} = \gamma - \gamma_0 \end{aligned}")
.given(&[Given::new(r"\alpha,\ \beta,\ \gamma", &CardanAngles::SPEC)])
        // The largest η that `audit --attack` found is 1.65 for the value, and 3 is possible to first order; for the Jacobian 2.43
        // and 4.
        .eta(3.0, 4.0)
        .normwise(3.0, 4.5)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Placement<T>;
    type Outputs<T: Component> = AllResiduals<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Placement<D>) -> AllResiduals<D> {
        let Misalignment { ur1, ur2, ur3 } = align::Constraint::eval(&i.align());
        let Residuals { gy, gz } = slot::Constraint::eval(&i.slot());
        AllResiduals { gy, gz, ur1, ur2, ur3 }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Placement<D>) -> Jacobian<Self, D> {
        let Misalignment { ur1, ur2, ur3 } = align::Constraint::jacobian(&i.align());
        let Residuals { gy, gz } = slot::Constraint::jacobian(&i.slot());
        let zero = D::zero();
        let of_slot = |g: SlotPositions<D>| {
            let SlotPositions { e2a, e3a, xa, xb, y0, z0 } = g;
            Placement { e2a, e3a, xa, xb, y0, z0, ..Placement::filled(zero) }
        };
        let of_align = |g| Placement::new(&SlotPositions::filled(zero), &g);
        AllResiduals { gy: of_slot(gy), gz: of_slot(gz), ur1: of_align(ur1), ur2: of_align(ur2), ur3: of_align(ur3) }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Placement<D>) -> Result<(), Error> {
        align::Constraint::validate(&i.align())
    }
}
