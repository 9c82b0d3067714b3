//! Coulomb friction: the condition of stick, and the force transmitted in slip.
//!
//! The normal force F_N and the friction coefficient μ are not negative. A tangential force has the sign of the motion that it
//! resists: if f_trial is positive, so are the transmitted force and the slip. It is conjugate to that motion: the force on the
//! moving node has the opposite sign. The yield function Φ = P − μ F_N is negative while the contact sticks and 0 while it slips;
//! it is never positive in an admissible state.

#[cfg(feature = "verify")]
mod proof;
pub(crate) mod response;
mod surface;

pub use response::{Response, Slid, Sliding};
pub use surface::{ReturnMap2d, Tangential2d, Trial2d};

use crate::fields;
use crate::formula::quantity::{F_TANGENTIAL, F_TRIAL, FN, MU, P, PHI};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, choice, sign};

fields! {
    /// Tangential traction, friction coefficient and normal force.
    pub struct Tractions<T> { p: T = P, mu: T = MU, r#fn: T = FN }
}
fields! {
    /// Yield function.
    pub struct YieldFunction<T> { phi: T = PHI }
}

/// The yield function: Φ = P − μ F_N; the contact sticks where Φ < 0 and slips at Φ = 0.
#[derive(Clone, Copy, Debug)]
pub struct Yield;

impl Formula for Yield {
    const SPEC: Spec = Spec::new("coulomb.yield", "Yield function", Document::SLOT.printed("Friction"))
        .equation(r"\Phi = P - \mu F_N")
        .eta(2.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Tractions<T>;
    type Outputs<T: Component> = YieldFunction<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Tractions<D>) -> YieldFunction<D> {
        YieldFunction { phi: i.p - i.mu * i.r#fn }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Tractions<D>) -> Jacobian<Self, D> {
        YieldFunction { phi: Tractions { p: D::one(), mu: -i.r#fn, r#fn: -i.mu } }
    }
}

fields! {
    /// The trial force, which would be transmitted if the contact stuck, and the friction parameters.
    pub struct Trial<T> { f_trial: T = F_TRIAL, mu: T = MU, r#fn: T = FN }
}
fields! {
    /// The force that friction transmits.
    pub struct Tangential<T> { f: T = F_TANGENTIAL }
}

/// The return map: f = f_trial while |f_trial| < μ F_N, else μ F_N sign(f_trial).
///
/// The comparison is made with one rounding, so that the branch is the exact one.
#[derive(Clone, Copy, Debug)]
pub struct ReturnMap;

impl<D: Scalar> Trial<D> {
    /// Whether the contact sticks: |f_trial| < μ F_N, with the product not rounded. Rounding can make two numbers equal, but
    /// never reverses their order.
    #[inline]
    pub(crate) fn sticks(&self) -> bool {
        let (force, limit) = (abs(self.f_trial), self.mu * self.r#fn);
        let is_less = || force < limit || (force == limit && self.mu.mul_add(self.r#fn, -force) > 0.0);
        let [sticks] = choice(|| [if is_less() { D::one() } else { D::zero() }]);
        sticks > 0.0
    }
}

impl Formula for ReturnMap {
    const SPEC: Spec = Spec::new(
        "coulomb.return_map",
        "Return map",
        Document::SLOT.ours(
            "Friction",
            "the page says when it sticks and that the force is then μ F_N; the return of a trial force is the usual one",
        ),
    )
        .equation(r"f = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Trial<T>;
    type Outputs<T: Component> = Tangential<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Trial<D>) -> Tangential<D> {
        let f = if i.sticks() { i.f_trial } else { i.mu * i.r#fn * sign(i.f_trial) };
        Tangential { f }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Trial<D>) -> Jacobian<Self, D> {
        let zero = D::zero();
        let s = sign(i.f_trial);
        let f = if i.sticks() {
            Trial { f_trial: D::one(), mu: zero, r#fn: zero }
        } else {
            Trial { f_trial: zero, mu: i.r#fn * s, r#fn: i.mu * s }
        };
        Tangential { f }
    }
}
