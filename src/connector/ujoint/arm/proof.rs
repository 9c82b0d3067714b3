//! Evidence for the formulas of the parent module: cases, laws.

use super::{Arm, AxialFactors, AxialShares, TwistFactors, TwistShares, phi, timoshenko};
use crate::Octuple;
use crate::connector::ujoint::running::{LA, RP};
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};

impl Proved for TwistFactors {
    fn cases() -> Vec<Case<Arm<f64>>> {
        let mut cases = vec![
            Case::running("φ = 2.2: 5/106, 63/212", Arm { la: LA, rp: RP }),
            Case::hand("lambda-6.6", "σ = 33/38: α = 33/304, β = 109/304", Arm { la: 33.0, rp: 5.0 }),
            Case::limit("stubby", "λ → 0: a rigid arm, α → 0, β → 1/4", Arm { la: 1e-9, rp: 1.0 }),
            Case::limit("long", "λ → ∞: a clamped Euler–Bernoulli arm, α → 1/8, β → 3/8", Arm { la: 1e9, rp: 1.0 }),
        ];
        cases.extend(of_arms());
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "moments about the centre: the hinges bear (β − α) on each of four arms, together the whole moment",
                |i| {
                    let TwistShares { alpha_twist, beta_twist } = Self::eval(i);
                    law::equal((beta_twist - alpha_twist) * 4.0, 1.0.into())
                },
            ),
            Law::<Self>::new(
                "an Euler–Bernoulli arm that ends in a rotational spring of stiffness 4EI/(La φ) gives the same α",
                |i| {
                    // Unit rotation at the centre, in units of EI/La: M = 4 + 2θ there, 2 + 4θ = −kθ at the spring.
                    let k = Octuple::from(4.0) / phi(i);
                    let theta = Octuple::from(-2.0) / (k + 4.0);
                    law::equal(Self::eval(i).alpha_twist, -k * theta / (theta * 2.0 + 4.0) * 0.25)
                },
            ),
            Law::<Self>::new(
                "the Timoshenko arm is met to first order in φ: α is above it by 6φ²/((8 + 6φ)(16 + 4φ))",
                |i| {
                    let phi = phi(i);
                    let above = phi * phi * 6.0 / ((phi * 6.0 + 8.0) * (phi * 4.0 + 16.0));
                    law::equal_with(Self::eval(i).alpha_twist - timoshenko(phi), above, timoshenko(phi))
                },
            ),
            Law::<Self>::new("α grows with λ, between 0 and 1/8", |i| {
                let (alpha, slope) = (Self::eval(i).alpha_twist, Self::jacobian(i).alpha_twist);
                let inside = alpha > 0.0 && alpha < 0.125 && slope.la > 0.0 && slope.rp < 0.0;
                law::equal(Octuple::from(f64::from(inside)), 1.0.into())
            }),
        ]
    }
}

impl Proved for AxialFactors {
    fn cases() -> Vec<Case<Arm<f64>>> {
        let mut cases = vec![
            Case::running("σ = 4/10: α = 0.35, β = 0.15", Arm { la: LA, rp: RP }),
            Case::hand("lambda-2", "σ = 4/10: α = 0.35, β = 0.15", Arm { la: 2.0, rp: 1.0 }),
            Case::hand("lambda-3", "σ = 9/15: α = 0.4, β = 0.1", Arm { la: 4.5, rp: 1.5 }),
            Case::hard("stubby", "λ → 0: four hinges share alike, α, β → 1/4", Arm { la: 1e-9, rp: 1.0 }),
            Case::hard("long", "λ → ∞: two hinges carry all, α → 1/2, β → 0", Arm { la: 1e9, rp: 1.0 }),
        ];
        cases.extend(of_arms());
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("the four hinges carry the whole force: 2α + 2β = 1", |i| {
                let AxialShares { alpha_axial, beta_axial } = Self::eval(i);
                law::equal((alpha_axial + beta_axial) * 2.0, 1.0.into())
            }),
            Law::<Self>::new("the shares are proportional to the stiffnesses: β/α = 3/(3 + λ²)", |i| {
                let AxialShares { alpha_axial, beta_axial } = Self::eval(i);
                let lambda = i.la / i.rp;
                law::equal(beta_axial * (lambda * lambda + 3.0), alpha_axial * 3.0)
            }),
            Law::<Self>::new("α grows with λ, between 1/4 and 1/2", |i| {
                let (alpha, slope) = (Self::eval(i).alpha_axial, Self::jacobian(i).alpha_axial);
                let inside = alpha > 0.25 && alpha < 0.5 && slope.la > 0.0 && slope.rp < 0.0;
                law::equal(Octuple::from(f64::from(inside)), 1.0.into())
            }),
        ]
    }
}

fn of_arms() -> impl Iterator<Item = Case<Arm<f64>>> {
    let subnormal = ["lambda-1e-160", "lambda-1e160"].into_iter().zip([[1e-160, 1.0], [1.0, 1e-160]]);
    let subnormal = subnormal.map(|(id, [la, rp])| Case::hard(id, "λ² or its inverse is subnormal", Arm { la, rp }));
    let of_arms = hard::arms().into_iter().map(|arm| {
        let [la, rp] = arm.value;
        Case::hard(arm.id, arm.comment, Arm { la, rp })
    });
    of_arms.chain(subnormal)
}
