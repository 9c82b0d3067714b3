//! β by the two-argument arc tangent, accurate up to ±90°.

#[cfg(feature = "verify")]
mod proof;

use super::{Triads, turn_gradients};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{BETA, E1A, E1B, E2B, E3B};
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, angles, atan2, has_length, norm, norm_and_direction};
use nalgebra::Vector3;

fields! {
    /// The first axis of a, and the triad of b.
    pub struct BetaAxes<T> {
        e1a: Vector3<T> = E1A, e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
    }
}
fields! {
    /// The second Cardan angle.
    pub struct Beta<T> { beta: T = BETA }
}

impl<T: Component> From<&Triads<T>> for BetaAxes<T> {
    #[inline]
    fn from(i: &Triads<T>) -> Self {
        Self { e1a: i.e1a, e1b: i.e1b, e2b: i.e2b, e3b: i.e3b }
    }
}

/// The second Cardan angle from its sine and its cosine: β = atan2(e1a·e3b, √((e1a·e1b)² + (e1a·e2b)²)).
///
/// On orthonormal triads it equals the documented arc sine. At ±90° it has a cone-like tip, since the cosine is a length: the
/// derivative there is 0 by convention.
#[derive(Clone, Copy, Debug)]
pub struct BetaTwoArgument;

impl Formula for BetaTwoArgument {
    const SPEC: Spec = Spec::new(
        "cardan.beta_two_argument",
        "Second Cardan angle, two-argument form",
        Document::TRANSLATOR.ours(
            "Description",
            "the page of ALIGN was not given; this form of the second angle is accurate up to 90°",
        ),
    )
        .equation(r"\beta = \operatorname{atan2}\!\left(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b},\ \sqrt{(\mathbf{e}_{1a}\cdot\mathbf{e}_{1b})^2 + (\mathbf{e}_{1a}\cdot\mathbf{e}_{2b})^2}\right)")
        // The largest η that `audit --attack` found is 2.08 for the value, and 3.33 is possible to first order; for the Jacobian 5.24
        // and 10.6.
        .eta(4.0, 11.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = BetaAxes<T>;
    type Outputs<T: Component> = Beta<T>;

    #[inline]
    fn eval<D: Scalar>(i: &BetaAxes<D>) -> Beta<D> {
        let cosine = norm([i.e1a.dot(&i.e1b), i.e1a.dot(&i.e2b)]);
        Beta { beta: atan2(i.e1a.dot(&i.e3b) + 0.0, cosine) }
    }

    /// The cosine is e1a·m with m = n1 e1b + n2 e2b, n the direction of (e1a·e1b, e1a·e2b), and does not depend on n to first
    /// order. So β is the angle of e1a between the axes m and e3b, with n held constant.
    #[inline]
    fn jacobian<D: Scalar>(i: &BetaAxes<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &BetaAxes<D>) -> ValueAndJacobian<Self, D> {
        let (cosine, [n1, n2]) = norm_and_direction([i.e1a.dot(&i.e1b), i.e1a.dot(&i.e2b)]);
        let m = i.e1b * n1 + i.e2b * n2;
        let sine = i.e1a.dot(&i.e3b);
        // β is 90° minus the angle from the other axis, which has the opposite derivative.
        // (m × e3b) × e1a is normal to e1a, as the derivative is. The difference would lose small components.
        let [[by_e1a, by_m, by_e3b]] =
            turn_gradients([[&i.e1a, &m, &i.e3b]], [cosine], [sine], |[v, p, q], _| p.cross(q).cross(v));
        let by = BetaAxes { e1a: by_e1a, e1b: by_m * n1, e2b: by_m * n2, e3b: by_e3b };
        // As an array of one angle the call is inlined, which makes the whole function a tenth faster; the bits are the same.
        let [beta] = angles([sine + 0.0], [cosine]);
        (Beta { beta }, Beta { beta: by })
    }

    #[inline]
    fn validate<D: Scalar>(i: &BetaAxes<D>) -> Result<(), Error> {
        if has_length([i.e1a.dot(&i.e1b), i.e1a.dot(&i.e2b), i.e1a.dot(&i.e3b)]) {
            return Ok(());
        }
        Err(Error::UndefinedAngle { angle: "beta", vector: "e1a", axes: "e1b, e2b and e3b" })
    }
}
