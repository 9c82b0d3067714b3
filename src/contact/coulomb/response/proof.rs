//! Evidence for the formula next door: cases, kinks, laws.

use super::{Response, Slid, Sliding};
use crate::Octuple;
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Kink, Law, Proved, law};
use crate::number::scalar::abs;
use num_traits::Zero;

impl Proved for Response {
    fn cases() -> Vec<Case<Sliding<f64>>> {
        let hand = Sliding { u: 1.5, slip_before: 1.0, k_el: 2.0, mu: 0.5, r#fn: 4.0 };
        vec![
            Case::hand("stick", "2 × 0.5 = 1 < 2: what has slipped stays", hand),
            Case::hand("slip", "2 × 3 = 6 > 2: slipped are 4 - 1", Sliding { u: 4.0, ..hand }),
            Case::hand("slip-back", "2 × -3: the force is -2, slipped are -2 + 1", Sliding { u: -2.0, ..hand }),
            Case::hand("frictionless", "μ = 0: all of the motion slips", Sliding { mu: 0.0, ..hand }),
            Case::hand("open", "F_N = 0: all of the motion slips", Sliding { r#fn: 0.0, ..hand }),
            Case::hard("unmoved", "at what has slipped: no force, sticks", Sliding { u: 1.0, ..hand }),
            Case::hard("tie", "2 × 1 = μ F_N: the Jacobian is not defined", Sliding { u: 2.0, ..hand }),
            Case::hard("tie-back", "the tie on the other side", Sliding { u: 0.0, ..hand }),
            Case::hard("ulp-inside", "one ulp inside the tie", Sliding { u: 2.0_f64.next_down(), ..hand }),
            Case::hard("ulp-outside", "one ulp outside the tie", Sliding { u: 2.0_f64.next_up(), ..hand }),
            Case::hard("stiff", "a stiffness of 1e12: all but 2e-12 slips", Sliding { u: 4.0, k_el: 1e12, ..hand }),
            Case::hard("soft", "a stiffness of 1e-12 sticks", Sliding { k_el: 1e-12, ..hand }),
            Case::hard(
                "far",
                "after a long way: the difference is taken before the product",
                Sliding { u: 1e8 + 0.25, slip_before: 1e8, ..hand },
            ),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"k_{\mathrm{el}}\lvert u-u_0^{\mathrm{slip}}\rvert = \mu F_N",
            |i| i.k_el * abs(i.u - i.slip_before) == i.mu * i.r#fn,
            Sliding { u: 2.0, slip_before: 1.0, k_el: 2.0, mu: 0.5, r#fn: 4.0 },
            Sliding { u: 1.0, slip_before: 0.0, k_el: 0.0, mu: 0.0, r#fn: 0.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ F_N", |i| {
                let limit = i.mu * i.r#fn;
                not_positive(abs(Self::eval(i).f) - limit, limit)
            }),
            Law::<Self>::new("slip dissipates: the force does no negative work on it", |i| {
                let Slid { f, slip } = Self::eval(i);
                dissipates(f, slip, i.slip_before, i.u)
            }),
            Law::<Self>::new("the force is the stiffness times the elastic part of the motion", |i| {
                let Slid { f, slip } = Self::eval(i);
                law::equal_with(f, i.k_el * (i.u - slip), i.k_el * (abs(i.u) + abs(slip)))
            }),
            Law::<Self>::new("the same motion from the state after it changes nothing", |i| {
                let there = Self::eval(i);
                let again = Self::eval(&Sliding { slip_before: there.slip, ..*i });
                let size = abs(i.u) + abs(there.slip);
                [
                    law::equal_with(there.f, again.f, i.k_el * size),
                    law::equal_with(there.slip, again.slip, size + there.f / i.k_el),
                ]
                .concat()
            }),
            Law::<Self>::new(
                "a closed cycle in stick does not change the state and dissipates no energy, and the tangent is the elastic stiffness",
                |i| {
                    let reach = i.mu * i.r#fn / i.k_el;
                    let at = |part: f64| Sliding { u: i.slip_before + reach * part, ..*i };
                    let (out, back) = (Self::eval(&at(0.75)), Self::eval(&at(-0.5)));
                    let tangent = Self::jacobian(&at(0.75));
                    law::equal_all([
                        (out.slip, i.slip_before),
                        (back.slip, i.slip_before),
                        (tangent.f.u, i.k_el),
                        (tangent.slip.u, Octuple::zero()),
                    ])
                },
            ),
            Law::<Self>::new("it is odd in the motion and the state", |i| {
                let there = Self::eval(&Sliding { u: -i.u, slip_before: -i.slip_before, ..*i });
                let Slid { f, slip } = Self::eval(i);
                law::equal_all([(f, -there.f), (slip, -there.slip)])
            }),
        ]
    }
}

/// A number is not above 0, to the rounding of terms of this size.
pub(crate) fn not_positive(x: Octuple, term: Octuple) -> Vec<Equation> {
    let excess = if x > 0.0 { x } else { Octuple::zero() };
    law::equal_with(excess, Octuple::zero(), term)
}

/// The force does no negative work on what slips.
pub(crate) fn dissipates(f: Octuple, slip: Octuple, before: Octuple, u: Octuple) -> Vec<Equation> {
    not_positive(-f * (slip - before), abs(f) * (abs(u) + abs(slip) + abs(before)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::{Component, Jacobian, Spec};
    use crate::number::scalar::Scalar;
    use crate::toolkit::verify::{Options, audit};

    /// [`Response`] with the tangent of stick in every state.
    #[derive(Clone, Copy)]
    struct AlwaysStick;

    impl Formula for AlwaysStick {
        const SPEC: Spec = Response::SPEC;
        type Inputs<T: Component> = Sliding<T>;
        type Outputs<T: Component> = Slid<T>;

        fn eval<D: Scalar>(i: &Sliding<D>) -> Slid<D> {
            Response::eval(i)
        }

        fn jacobian<D: Scalar>(i: &Sliding<D>) -> Jacobian<Self, D> {
            Response::jacobian(&Sliding { u: i.slip_before, ..*i })
        }
    }

    impl Proved for AlwaysStick {
        fn cases() -> Vec<Case<Sliding<f64>>> {
            Response::cases()
        }
    }

    /// [`Response`] whose state follows the motion with the other sign.
    #[derive(Clone, Copy)]
    struct SlipsBack;

    impl Formula for SlipsBack {
        const SPEC: Spec = Response::SPEC;
        type Inputs<T: Component> = Sliding<T>;
        type Outputs<T: Component> = Slid<T>;

        fn eval<D: Scalar>(i: &Sliding<D>) -> Slid<D> {
            let Slid { f, slip } = Response::eval(i);
            Slid { f, slip: i.slip_before * 2.0 - slip }
        }

        fn jacobian<D: Scalar>(i: &Sliding<D>) -> Jacobian<Self, D> {
            Response::jacobian(i)
        }
    }

    impl Proved for SlipsBack {
        fn cases() -> Vec<Case<Sliding<f64>>> {
            Response::cases()
        }

        fn laws() -> Vec<Law<Self>> {
            vec![Law::<Self>::new("slip dissipates", |i| {
                let Slid { f, slip } = Self::eval(i);
                dissipates(f, slip, i.slip_before, i.u)
            })]
        }
    }

    #[test]
    fn the_tangent_of_stick_for_slip_is_caught() {
        let options = Options { samples: 50, ..Options::default() };
        assert!(audit::<Response>(&options).no_claim_failed());
        assert!(audit::<AlwaysStick>(&options).closed_against_ad.unwrap().failures > 0);
    }

    #[test]
    fn slip_against_the_force_is_caught() {
        let options = Options { samples: 50, ..Options::default() };
        let claims = audit::<SlipsBack>(&options).laws;
        let claim = claims.iter().find(|claim| claim.claim.contains("slip dissipates"));
        assert!(claim.is_some_and(|claim| claim.failures > 0));
    }
}
