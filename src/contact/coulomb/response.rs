//! What a contact transmits after a motion: stick at a finite stiffness, the return map, and what has slipped.

#[cfg(feature = "verify")]
pub(crate) mod proof;

use super::{ReturnMap, Tangential, Trial};
use crate::fields;
use crate::formula::quantity::{F_TANGENTIAL, FN, K_EL, MOTION, MU, U_SLIP, U_SLIP_BEFORE};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::Scalar;

fields! {
    /// The motion, the state before it, and what the contact is made of.
    pub struct Sliding<T> {
        u: T = MOTION, slip_before: T = U_SLIP_BEFORE, k_el: T = K_EL, mu: T = MU, r#fn: T = FN,
    }
}
fields! {
    /// What is transmitted, and the state after the motion.
    pub struct Slid<T> { f: T = F_TANGENTIAL, slip: T = U_SLIP }
}

/// The tangential force after a motion, and what has slipped then: the trial force is k_el (u − u0_slip), the return map
/// cuts it down to μ F_N, and the rest of the motion has slipped.
///
/// The state is the motion at which the force would be 0. While the contact sticks it stays, to the last bit.
#[derive(Clone, Copy, Debug)]
pub struct Response;

impl<D: Scalar> Sliding<D> {
    /// From the motion to the next place without force.
    #[inline]
    fn trial(&self) -> Trial<D> {
        Trial { f_trial: self.k_el * (self.u - self.slip_before), mu: self.mu, r#fn: self.r#fn }
    }
}

impl Formula for Response {
    const SPEC: Spec = Spec::new(
        "coulomb.response",
        "Friction after a motion",
        Document::SLOT.ours(
            "Friction",
            "the page says when it sticks; stick at a finite stiffness, from the motion and what has slipped before, is the usual one",
        ),
    )
        .equation(r"f = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases},\quad f^{\mathrm{trial}} = k_{\mathrm{el}}(u-u_0^{\mathrm{slip}}),\quad u^{\mathrm{slip}} = u - \frac{f}{k_{\mathrm{el}}}")
        .eta(1.5, 1.5)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = Sliding<T>;
    type Outputs<T: Component> = Slid<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Sliding<D>) -> Slid<D> {
        let trial = i.trial();
        let f = ReturnMap::eval(&trial).f;
        Slid { f, slip: if trial.sticks() { i.slip_before } else { i.u - f / i.k_el } }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Sliding<D>) -> Jacobian<Self, D> {
        let (zero, one, trial) = (D::zero(), D::one(), i.trial());
        if trial.sticks() {
            return Slid {
                f: Sliding { u: i.k_el, slip_before: -i.k_el, k_el: i.u - i.slip_before, mu: zero, r#fn: zero },
                slip: Sliding { u: zero, slip_before: one, k_el: zero, mu: zero, r#fn: zero },
            };
        }
        let Tangential { f: by } = ReturnMap::jacobian(&trial);
        let (f, yielding) = (ReturnMap::eval(&trial).f, i.k_el.recip());
        let none = Sliding { u: zero, slip_before: zero, k_el: zero, mu: zero, r#fn: zero };
        Slid {
            f: Sliding { mu: by.mu, r#fn: by.r#fn, ..none },
            slip: Sliding {
                u: one,
                k_el: f * yielding * yielding,
                mu: -by.mu * yielding,
                r#fn: -by.r#fn * yielding,
                ..none
            },
        }
    }
}
