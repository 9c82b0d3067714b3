//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{Response, Slid, Sliding};
use crate::Octuple;
use crate::formula::proof::{Case, Equation, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use num_traits::Zero;

impl Proved for Response {
    fn cases() -> Vec<Case<Sliding<f64>>> {
        let hand = Sliding { du: 0.5, f_before: 0.25, k_stick: 2.0, mu: 0.5, r#fn: 4.0 };
        vec![
            Case::hand("stick", "0.25 + 2 × 0.5 < 2: no slip", hand),
            Case::running("0.25 + 2 × 3 = 6.25 > 2: slipped are 4.25/2", Sliding { du: 3.0, ..hand }),
            Case::hand("slip-back", "0.25 - 2 × 3: the force is -2, slipped are -3.75/2", Sliding { du: -3.0, ..hand }),
            Case::hand("frictionless", "μ = 0: all of the motion slips", Sliding { f_before: 0.0, mu: 0.0, ..hand }),
            Case::hand("open", "F_N = 0: the force is released, and slips too", Sliding { r#fn: 0.0, ..hand }),
            Case::hard("unmoved", "no motion: the force stays", Sliding { du: 0.0, ..hand }),
            Case::hard("released", "no motion, and less to hold it: it slips", Sliding { du: 0.0, r#fn: 0.25, ..hand }),
            Case::hard("tie", "0.25 + 2 × 0.875 = μ F_N: the Jacobian is not defined", Sliding { du: 0.875, ..hand }),
            Case::hard("tie-back", "the tie on the other side", Sliding { du: -1.125, ..hand }),
            Case::hard("ulp-inside", "one ulp inside the tie", Sliding { du: 0.875_f64.next_down(), ..hand }),
            Case::hard("ulp-outside", "one ulp outside the tie", Sliding { du: 0.875_f64.next_up(), ..hand }),
            Case::hard("stiff", "a stiffness of 1e12: nearly all slips", Sliding { du: 4.0, k_stick: 1e12, ..hand }),
            Case::hard("soft", "a stiffness of 1e-12 sticks", Sliding { k_stick: 1e-12, ..hand }),
            Case::hard("turned-back", "the motion takes all of the force back", Sliding { du: -0.125, ..hand }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"\lvert f^- + k_{\mathrm{stick}}\,\Delta u\rvert = \mu F_N",
            |i| abs(i.trial().f_trial) == i.mu * i.r#fn,
            Sliding { du: 0.875, f_before: 0.25, k_stick: 2.0, mu: 0.5, r#fn: 4.0 },
            Sliding { du: 1.0, ..Sliding::filled(0.0) },
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
                not_positive(-f * slip, abs(f) * size(i))
            }),
            Law::<Self>::new("what does not slip changes the force: f = f⁻ + k (Δu − Δs)", |i| {
                let Slid { f, slip } = Self::eval(i);
                law::equal_with(f, i.f_before + i.k_stick * (i.du - slip), i.k_stick * size(i))
            }),
            Law::<Self>::new("without motion the state after it does not change, while it can hold the force", |i| {
                let there = Self::eval(i);
                let again = Self::eval(&Sliding { du: Octuple::zero(), f_before: there.f, ..*i });
                [law::equal(there.f, again.f), law::equal_with(again.slip, Octuple::zero(), size(i))].concat()
            }),
            Law::<Self>::new(
                "a closed cycle in stick brings the force back and dissipates no energy, and the tangent is the stiffness in stick",
                |i| {
                    let reach = i.mu * i.r#fn / i.k_stick;
                    let from = |f_before, part: f64| Sliding { du: reach * part, f_before, ..*i };
                    let (start, out) = (Octuple::zero(), Self::eval(&from(Octuple::zero(), 0.75)));
                    let back = Self::eval(&from(out.f, -0.75));
                    let tangent = Self::jacobian(&from(start, 0.75));
                    [
                        law::equal_with(back.f, start, i.mu * i.r#fn),
                        law::equal_all([
                            (out.slip, Octuple::zero()),
                            (back.slip, Octuple::zero()),
                            (tangent.f.du, i.k_stick),
                            (tangent.slip.du, Octuple::zero()),
                        ]),
                    ]
                    .concat()
                },
            ),
            Law::<Self>::new("it is odd in the motion and the force before", |i| {
                let there = Self::eval(&Sliding { du: -i.du, f_before: -i.f_before, ..*i });
                let Slid { f, slip } = Self::eval(i);
                law::equal_all([(f, -there.f), (slip, -there.slip)])
            }),
        ]
    }
}

/// The size of the terms of the slip.
fn size(i: &Sliding<Octuple>) -> Octuple {
    abs(i.du) + (abs(i.f_before) + i.mu * i.r#fn) / i.k_stick
}

/// A number is not above 0, to within the rounding error of terms of this size.
pub(crate) fn not_positive(x: Octuple, term: Octuple) -> Vec<Equation> {
    let excess = if x > 0.0 { x } else { Octuple::zero() };
    law::equal_with(excess, Octuple::zero(), term)
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
            Response::jacobian(&Sliding { du: D::zero(), f_before: D::zero(), ..*i })
        }
    }

    impl Proved for AlwaysStick {
        fn cases() -> Vec<Case<Sliding<f64>>> {
            Response::cases()
        }
    }

    /// [`Response`] that slips against the force.
    #[derive(Clone, Copy)]
    struct SlipsBack;

    impl Formula for SlipsBack {
        const SPEC: Spec = Response::SPEC;
        type Inputs<T: Component> = Sliding<T>;
        type Outputs<T: Component> = Slid<T>;

        fn eval<D: Scalar>(i: &Sliding<D>) -> Slid<D> {
            let Slid { f, slip } = Response::eval(i);
            Slid { f, slip: -slip }
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
                not_positive(-f * slip, abs(f) * size(i))
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
