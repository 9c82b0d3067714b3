//! The force that a contact transmits after a motion: stick at a finite stiffness, the return map, and the slip.

#[cfg(feature = "verify")]
pub(crate) mod proof;

use super::{ReturnMap, Tangential, Trial};
use crate::fields;
use crate::formula::quantity::{DU, F_BEFORE, F_TANGENTIAL, FN, K_STICK, MU, SLIP};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::Scalar;

fields! {
    /// The motion since the last state, the force in that state, and the parameters of the contact.
    pub struct Sliding<T> { du: T = DU, f_before: T = F_BEFORE, k_stick: T = K_STICK, mu: T = MU, r#fn: T = FN }
}
fields! {
    /// The transmitted force, and the increment of slip.
    pub struct Slid<T> { f: T = F_TANGENTIAL, slip: T = SLIP }
}

/// The friction force after an increment of motion: the trial force is f⁻ + k Δu, the return map cuts it down to μ F_N, and the part
/// of the motion that does not change the force has slipped, Δs = Δu − (f − f⁻)/k.
///
/// The state is the force f⁻ in the last converged increment, 0 at the start. In stick Δs is exactly 0. It is the one law of friction
/// here: of forces and displacements, of moments and rotations, of shear stresses along a slide line.
#[derive(Clone, Copy, Debug)]
pub struct Response;

impl<D: Scalar> Sliding<D> {
    #[inline]
    fn trial(&self) -> Trial<D> {
        Trial { f_trial: self.f_before + self.k_stick * self.du, mu: self.mu, r#fn: self.r#fn }
    }

    /// The force and the slip, from the trial force.
    #[inline]
    fn slid(&self, trial: &Trial<D>) -> Slid<D> {
        let f = ReturnMap::eval(trial).f;
        // Computed from the trial force, the slip would lose the digits of the previous force if the motion is large.
        Slid { f, slip: if trial.sticks() { D::zero() } else { self.du - (f - self.f_before) / self.k_stick } }
    }

    /// The friction force, with its derivatives with respect to the motion and to the loads that press, from those of the normal
    /// force.
    #[inline]
    pub(crate) fn under<const N: usize>(&self, normal_by_loads: [D; N]) -> (D, D, [D; N]) {
        let (Slid { f, .. }, Slid { f: by, .. }) = Response::linearized(self);
        (f, by.du, normal_by_loads.map(|x| by.r#fn * x))
    }
}

impl Formula for Response {
    const SPEC: Spec = Spec::new(
        "coulomb.response",
        "Friction after a motion",
        Document::SLOT.ours(
            "Friction",
            "the page says when it sticks; stick at a finite stiffness, from the force before and the motion since, is the usual one",
        ),
    )
        .equation(r"f = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases},\quad f^{\mathrm{trial}} = f^- + k_{\mathrm{stick}}\,\Delta u,\quad \Delta s = \Delta u - \frac{f - f^-}{k_{\mathrm{stick}}}")
        .eta(2.0, 4.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Sliding<T>;
    type Outputs<T: Component> = Slid<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Sliding<D>) -> Slid<D> {
        i.slid(&i.trial())
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Sliding<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Sliding<D>) -> ValueAndJacobian<Self, D> {
        let (zero, one, trial) = (D::zero(), D::one(), i.trial());
        let (value, none) = (i.slid(&trial), Sliding { du: zero, f_before: zero, k_stick: zero, mu: zero, r#fn: zero });
        if trial.sticks() {
            let f = Sliding { du: i.k_stick, f_before: one, k_stick: i.du, ..none };
            return (value, Slid { f, slip: none });
        }
        let (Tangential { f: by }, yielding) = (ReturnMap::jacobian(&trial), i.k_stick.recip());
        let slip = Sliding {
            du: one,
            f_before: yielding,
            k_stick: (value.f - i.f_before) * yielding * yielding,
            mu: -by.mu * yielding,
            r#fn: -by.r#fn * yielding,
        };
        (value, Slid { f: Sliding { mu: by.mu, r#fn: by.r#fn, ..none }, slip })
    }
}
