//! The return map on a surface, where the tangential force has two components.

#![expect(
    clippy::inline_always,
    reason = "value and gradients share the direction where they are compiled as one piece"
)]

#[cfg(feature = "verify")]
mod proof;

use super::Trial;
use crate::fields;
use crate::formula::quantity::{F_TANGENTIAL_SURFACE, F_TRIAL_SURFACE, FN, MU};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, norm_and_direction};
use nalgebra::Vector2;

fields! {
    /// The trial force on a surface, which would be transmitted if the contact stuck, and the friction parameters.
    pub struct Trial2d<T> { f_trial: Vector2<T> = F_TRIAL_SURFACE, mu: T = MU, r#fn: T = FN }
}
fields! {
    /// The force on a surface that friction transmits.
    pub struct Tangential2d<T> { f: Vector2<T> = F_TANGENTIAL_SURFACE }
}

/// The return map on a surface: f_trial while |f_trial| < μ F_N, else cut down to μ F_N in its direction.
///
/// The friction is isotropic. In slip the tangent retains the direction normal to the force: if the trial force rotates, the
/// friction force rotates with it.
#[derive(Clone, Copy, Debug)]
pub struct ReturnMap2d;

/// The trial force, and whether the contact sticks under it.
struct Tried<D> {
    length: D,
    along: Vector2<D>,
    sticks: bool,
}

impl<D: Scalar> Trial2d<D> {
    /// A force of 0 has no direction of slip.
    #[inline(always)]
    fn tried(&self) -> Tried<D> {
        let (length, along) = norm_and_direction::<D, 2>(self.f_trial.into());
        let sticks = (Trial { f_trial: length, mu: self.mu, r#fn: self.r#fn }).sticks() || length == 0.0;
        Tried { length, along: along.into(), sticks }
    }

    /// The transmitted force.
    #[inline(always)]
    fn transmitted(&self, tried: &Tried<D>) -> Vector2<D> {
        if tried.sticks { self.f_trial } else { tried.along * (self.mu * self.r#fn) }
    }
}

impl Formula for ReturnMap2d {
    const SPEC: Spec = Spec::new(
        "coulomb.return_map_2d",
        "Return map on a surface",
        Document::SLOT.ours(
            "Friction",
            "the page has one direction of sliding; on a surface the force has the direction of the trial force",
        ),
    )
        .equation(r"\mathbf{f} = \begin{cases} \mathbf{f}^{\mathrm{trial}} & \lvert\mathbf{f}^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N\,\mathbf{f}^{\mathrm{trial}}/\lvert\mathbf{f}^{\mathrm{trial}}\rvert & \text{otherwise}\end{cases}")
        .eta(2.5, 4.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = Trial2d<T>;
    type Outputs<T: Component> = Tangential2d<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Trial2d<D>) -> Tangential2d<D> {
        Tangential2d { f: i.transmitted(&i.tried()) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Trial2d<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Trial2d<D>) -> ValueAndJacobian<Self, D> {
        let (zero, one, tried @ Tried { length, along, sticks }) = (D::zero(), D::one(), i.tried());
        // The slipping case is always computed and then selected: a branch would be mispredicted at every other point.
        let across = Vector2::new(-along.y, along.x);
        let turned = across * (i.mu * i.r#fn / length);
        let slipping = |k: usize| Trial2d { f_trial: turned * across[k], mu: i.r#fn * along[k], r#fn: i.mu * along[k] };
        let sticking = |f_trial| Trial2d { f_trial, mu: zero, r#fn: zero };
        let x = if sticks { sticking(Vector2::new(one, zero)) } else { slipping(0) };
        let y = if sticks { sticking(Vector2::new(zero, one)) } else { slipping(1) };
        let f = i.transmitted(&tried);
        (Tangential2d { f }, Tangential2d { f: Vector2::new(x, y) })
    }
}
