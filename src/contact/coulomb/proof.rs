//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{ReturnMap, Tractions, Trial, Yield};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::number::scalar::abs;

impl Proved for Yield {
    fn cases() -> Vec<Case<Tractions<f64>>> {
        let hand = Tractions { p: 1.0, mu: 0.25, r#fn: 6.0 };
        vec![
            Case::hand("stick", "1 - 0.25 × 6 = -0.5", hand),
            Case::limit("slip", "P = μ F_N: Φ = 0", Tractions { p: 1.5, ..hand }),
            Case::hand("frictionless", "μ = 0: Φ = P", Tractions { mu: 0.0, ..hand }),
            Case::hand("open", "F_N = 0: Φ = P", Tractions { r#fn: 0.0, ..hand }),
            Case::hard("zero", "no force at all", Tractions { p: 0.0, ..hand }),
            Case::hard(
                "cancelled",
                "μ F_N is not a double: Φ is the rounding error of the product",
                Tractions { p: 0.1 * 0.3, mu: 0.1, r#fn: 0.3 },
            ),
            Case::hard("tiny", "forces of 1e-200", Tractions { p: 1e-200, mu: 0.3, r#fn: 7e-200 }),
            Case::hard("huge", "forces of 1e200", Tractions { p: 1e200, mu: 0.3, r#fn: 7e200 }),
            Case::running("6.25 - 0.5 × 4 cannot be transmitted", Tractions { p: 6.25, mu: 0.5, r#fn: 4.0 }),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("at P = μ F_N it is 0", |i| {
            let p = i.mu * i.r#fn;
            law::equal_with(Self::eval(&Tractions { p, ..*i }).phi, num_traits::Zero::zero(), p)
        })]
    }
}

impl Proved for ReturnMap {
    fn cases() -> Vec<Case<Trial<f64>>> {
        let hand = Trial { f_trial: 1.0, mu: 0.5, r#fn: 4.0 };
        vec![
            Case::hand("stick", "1 < 0.5 × 4", hand),
            Case::hand("slip", "3 > 0.5 × 4: 2 is transmitted", Trial { f_trial: 3.0, ..hand }),
            Case::hand("slip-back", "the friction force follows the sign", Trial { f_trial: -3.0, ..hand }),
            Case::hand("frictionless", "μ = 0 transmits nothing", Trial { mu: 0.0, ..hand }),
            Case::hand("open", "F_N = 0 transmits nothing", Trial { r#fn: 0.0, ..hand }),
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
            Case::running("6.25 > 0.5 × 4: 2 is transmitted", Trial { f_trial: 6.25, ..hand }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"\lvert f^{\mathrm{trial}}\rvert = \mu F_N",
            |i| abs(i.f_trial) == i.mu * i.r#fn,
            Trial { f_trial: 2.0, mu: 0.5, r#fn: 4.0 },
            Trial { f_trial: 1.0, mu: 0.0, r#fn: 0.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ F_N: Φ(|f|) ≤ 0", |i| {
                let phi = Yield::eval(&Tractions { p: abs(Self::eval(i).f), mu: i.mu, r#fn: i.r#fn }).phi;
                law::equal_with(
                    if phi > 0.0 { phi } else { num_traits::Zero::zero() },
                    num_traits::Zero::zero(),
                    i.mu * i.r#fn,
                )
            }),
            Law::<Self>::new("it is odd in f_trial", |i| {
                law::equal(Self::eval(i).f, -Self::eval(&Trial { f_trial: -i.f_trial, ..*i }).f)
            }),
            Law::<Self>::new("mapping twice changes nothing more", |i| {
                let f = Self::eval(i).f;
                law::equal(Self::eval(&Trial { f_trial: f, ..*i }).f, f)
            }),
        ]
    }
}
