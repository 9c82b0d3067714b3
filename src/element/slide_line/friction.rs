//! The shear stress of the contact after a slip, with its consistent tangent.

#[cfg(feature = "verify")]
mod proof;

use crate::contact::coulomb::{ReturnMap, Trial};
use crate::fields;
use crate::formula::quantity::{DSLIP, MU, S11, S12, S12_BEFORE, SHEAR_STIFFNESS};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::Scalar;

fields! {
    /// Pressure, slip increment, shear stress before, and what the contact is made of.
    pub struct Rubbing<T> {
        s11: T = S11, dslip: T = DSLIP, s12_before: T = S12_BEFORE, k_el: T = SHEAR_STIFFNESS, mu: T = MU,
    }
}
fields! {
    /// The shear stress.
    pub struct Shear<T> { s12: T = S12 }
}

impl<D: Scalar> Rubbing<D> {
    /// What would be transmitted if the contact stuck; nothing where it does not push.
    #[inline]
    fn trial(&self) -> Option<Trial<D>> {
        let f_trial = self.s12_before + self.k_el * self.dslip;
        (self.s11 > 0.0).then_some(Trial { f_trial, mu: self.mu, r#fn: self.s11 })
    }
}

/// The shear stress of a contact after a slip increment: the return map of what it was and k_el times the slip, under the pressure.
///
/// In slip it is μ S11, and so is its derivative by the pressure: where the pressure follows from places, that makes the matrix
/// unsymmetric.
#[derive(Clone, Copy, Debug)]
pub struct Response;

impl Formula for Response {
    const SPEC: Spec = Spec::new(
        "slide_line.friction_response",
        "Shear stress of contact after a slip",
        Document::SLIDE_LINE.ours(
            "Defining nondefault mechanical surface interactions with slide line elements",
            "the section names friction; the return map of a trial stress is the usual one",
        ),
    )
        .equation(r"S_{12} = \begin{cases} S^{\mathrm{trial}} & S_{11} > 0,\ \lvert S^{\mathrm{trial}}\rvert < \mu S_{11} \\ \mu S_{11} \operatorname{sign} S^{\mathrm{trial}} & S_{11} > 0 \\ 0 & \text{otherwise}\end{cases},\quad S^{\mathrm{trial}} = S_{12}^{\mathrm{before}} + k_{\mathrm{el}}\,\Delta E_{12}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Rubbing<T>;
    type Outputs<T: Component> = Shear<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Rubbing<D>) -> Shear<D> {
        Shear { s12: i.trial().map_or(D::zero(), |trial| ReturnMap::eval(&trial).f) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Rubbing<D>) -> Jacobian<Self, D> {
        let Some(trial) = i.trial() else { return Shear { s12: Rubbing::filled(D::zero()) } };
        let by = ReturnMap::jacobian(&trial).f;
        Shear {
            s12: Rubbing {
                s11: by.r#fn,
                dslip: by.f_trial * i.k_el,
                s12_before: by.f_trial,
                k_el: by.f_trial * i.dslip,
                mu: by.mu,
            },
        }
    }
}
