//! The three angles as documented, β by the arc sine.

#![expect(clippy::inline_always, reason = "a call would write the vectors to memory, and wait for them there")]

#[cfg(feature = "verify")]
mod proof;

use super::arc_sine::{arc_sine, arc_sine_slope, check_arc_sine};
use super::{Triads, check_turns};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{ALPHA, BETA, GAMMA};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec};
use crate::number::scalar::Scalar;

fields! {
    /// Cardan angles of b relative to a.
    pub struct Angles<T> { alpha: T = ALPHA, beta: T = BETA, gamma: T = GAMMA }
}

/// Cardan angles: α = −atan2(e2a·e3b, e3a·e3b), β = asin(e1a·e3b), γ = −atan2(e1a·e2b, e1a·e1b).
///
/// |e1a·e3b| > 1 is rejected. At exactly ±1 the arc sine ends with a vertical tangent: β is ±90°, and its derivative, which is infinite, is replaced by 0, that of the constant beyond.
#[derive(Clone, Copy, Debug)]
pub struct CardanAngles;

impl Formula for CardanAngles {
    const SPEC: Spec = Spec::new(
        "cardan.angles",
        "Cardan angles",
        Document::TRANSLATOR.ours(
            "Description",
            "the page of ALIGN was not given; these are the angles of three turns about 1, 2 and 3",
        ),
    )
        .equation(r"\alpha = -\operatorname{atan2}(\mathbf{e}_{2a}\cdot\mathbf{e}_{3b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}),\quad \beta = \arcsin(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b}),\quad \gamma = -\operatorname{atan2}(\mathbf{e}_{1a}\cdot\mathbf{e}_{2b},\ \mathbf{e}_{1a}\cdot\mathbf{e}_{1b})")
        // The largest η that `audit --attack` found is 0.911 for the value, and 2 is possible to first order; for the Jacobian 2.39 and 4.
        .eta(3.0, 4.0)
        .normwise(3.0, 4.5)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Triads<T>;
    type Outputs<T: Component> = Angles<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Triads<D>) -> Angles<D> {
        let [alpha, gamma] = i.alpha_and_gamma();
        Angles { alpha, beta: arc_sine(&i.e1a, &i.e3b), gamma }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Triads<D>) -> Jacobian<Self, D> {
        let zero = Triads::filled(D::zero());
        let [slope, _] = arc_sine_slope(&i.e1a, &i.e3b);
        let beta = Triads { e1a: i.e3b * slope, e3b: i.e1a * slope, ..zero };
        let [alpha, gamma] = i.alpha_and_gamma_gradients();
        Angles { alpha, beta, gamma }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
        check_arc_sine(&i.e1a, &i.e3b)?;
        check_turns(i)
    }
}
