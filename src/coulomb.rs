//! Coulomb friction: when a contact sticks, and what it transmits when it slips.

use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{F_TANGENTIAL, F_TRIAL, FN, MU, P, PHI};
use crate::scalar::{Scalar, abs, sign};
use crate::verify::law;

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
    const SPEC: Spec = Spec {
        id: "coulomb.yield",
        title: "Yield function",
        latex: r"\Phi = P - \mu F_N",
        source: Source::SLOT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = Tractions<T>;
    type Outputs<T: Element> = YieldFunction<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Tractions<D>) -> YieldFunction<D> {
        YieldFunction { phi: i.p - i.mu * i.r#fn }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Tractions<D>) -> Jacobian<Self, D> {
        YieldFunction { phi: Tractions { p: D::one(), mu: -i.r#fn, r#fn: -i.mu } }
    }

    fn cases() -> Vec<Case<Tractions<f64>>> {
        let hand = Tractions { p: 1.0, mu: 0.25, r#fn: 6.0 };
        vec![
            Case::hand("stick", "1 - 0.25 × 6 = -0.5", hand),
            Case::limit("slip", "P = μ F_N: Φ = 0", Tractions { p: 1.5, ..hand }),
            Case::limit("frictionless", "μ = 0: Φ = P", Tractions { mu: 0.0, ..hand }),
            Case::limit("open", "F_N = 0: Φ = P", Tractions { r#fn: 0.0, ..hand }),
            Case::hard("zero", "no force at all", Tractions { p: 0.0, ..hand }),
            Case::hard(
                "cancelled",
                "μ F_N is not a double: Φ is the rounding error of the product",
                Tractions { p: 0.1 * 0.3, mu: 0.1, r#fn: 0.3 },
            ),
            Case::hard("tiny", "forces of 1e-200", Tractions { p: 1e-200, mu: 0.3, r#fn: 7e-200 }),
            Case::hard("huge", "forces of 1e200", Tractions { p: 1e200, mu: 0.3, r#fn: 7e200 }),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "at P = μ F_N it is 0",
            sides: |i| {
                let p = i.mu * i.r#fn;
                law::equal_with(Self::eval(&Tractions { p, ..*i }).phi, num_traits::Zero::zero(), p)
            },
        }]
    }
}

fields! {
    /// The force that would be transmitted if the contact stuck, and the friction parameters.
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

/// Whether the contact sticks: |f_trial| < μ F_N, with the product not rounded.
fn sticks<D: Scalar>(i: &Trial<D>) -> bool {
    i.mu.mul_add(i.r#fn, -abs(i.f_trial)) > 0.0
}

impl Formula for ReturnMap {
    const SPEC: Spec = Spec {
        id: "coulomb.return_map",
        title: "Return map",
        latex: r"f = \begin{cases} f^{\mathrm{trial}} & \lvert f^{\mathrm{trial}}\rvert < \mu F_N \\ \mu F_N \operatorname{sign} f^{\mathrm{trial}} & \text{otherwise}\end{cases}",
        source: Source::SLOT.section("Friction"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = Trial<T>;
    type Outputs<T: Element> = Tangential<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Trial<D>) -> Tangential<D> {
        let f = if sticks(i) { i.f_trial } else { i.mu * i.r#fn * sign(i.f_trial) };
        Tangential { f }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Trial<D>) -> Jacobian<Self, D> {
        let zero = D::zero();
        let s = sign(i.f_trial);
        let f = if sticks(i) {
            Trial { f_trial: D::one(), mu: zero, r#fn: zero }
        } else {
            Trial { f_trial: zero, mu: i.r#fn * s, r#fn: i.mu * s }
        };
        Tangential { f }
    }

    fn cases() -> Vec<Case<Trial<f64>>> {
        let hand = Trial { f_trial: 1.0, mu: 0.5, r#fn: 4.0 };
        vec![
            Case::hand("stick", "1 < 0.5 × 4", hand),
            Case::hand("slip", "3 > 0.5 × 4: 2 is transmitted", Trial { f_trial: 3.0, ..hand }),
            Case::hand("slip-back", "the friction force follows the sign", Trial { f_trial: -3.0, ..hand }),
            Case::limit("frictionless", "μ = 0 transmits nothing", Trial { mu: 0.0, ..hand }),
            Case::limit("open", "F_N = 0 transmits nothing", Trial { r#fn: 0.0, ..hand }),
            Case::hard("unloaded", "f_trial = 0 sticks", Trial { f_trial: 0.0, ..hand }),
            Case::hard(
                "tie",
                "|f_trial| = μ F_N: the value is defined, the Jacobian is not",
                Trial { f_trial: 2.0, ..hand },
            ),
            Case::hard("tie-back", "the tie on the other side", Trial { f_trial: -2.0, ..hand }),
            Case::hard("ulp-inside", "one ulp inside the tie", Trial { f_trial: 2.0_f64.next_down(), ..hand }),
            Case::hard("ulp-outside", "one ulp outside the tie", Trial { f_trial: 2.0_f64.next_up(), ..hand }),
            Case::hard(
                "rounded-tie",
                "f_trial is the rounded product μ F_N, which the exact one is not",
                Trial { f_trial: 0.1 * 0.3, mu: 0.1, r#fn: 0.3 },
            ),
            Case::hard("nothing", "all zero", Trial { f_trial: 0.0, mu: 0.0, r#fn: 0.0 }),
            Case::hard("tiny", "forces of 1e-200", Trial { f_trial: 1e-200, mu: 0.3, r#fn: 7e-200 }),
            Case::hard("huge", "forces of 1e200", Trial { f_trial: -1e200, mu: 0.3, r#fn: 2e200 }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\lvert f^{\mathrm{trial}}\rvert = \mu F_N",
            convention: Convention::Switch,
            holds: |i| abs(i.f_trial) == i.mu * i.r#fn,
            at: || Trial { f_trial: 2.0, mu: 0.5, r#fn: 4.0 },
            across: || Trial { f_trial: 1.0, mu: 0.0, r#fn: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "what is transmitted never exceeds μ F_N: Φ(|f|) ≤ 0",
                sides: |i| {
                    let phi = Yield::eval(&Tractions { p: abs(Self::eval(i).f), mu: i.mu, r#fn: i.r#fn }).phi;
                    law::equal_with(
                        if phi > 0.0 { phi } else { num_traits::Zero::zero() },
                        num_traits::Zero::zero(),
                        i.mu * i.r#fn,
                    )
                },
            },
            Law {
                statement: "it is odd in f_trial",
                sides: |i| law::equal(Self::eval(i).f, -Self::eval(&Trial { f_trial: -i.f_trial, ..*i }).f),
            },
            Law {
                statement: "mapping twice changes nothing more",
                sides: |i| {
                    let f = Self::eval(i).f;
                    law::equal(Self::eval(&Trial { f_trial: f, ..*i }).f, f)
                },
            },
        ]
    }
}
