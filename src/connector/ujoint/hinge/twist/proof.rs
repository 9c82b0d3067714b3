//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{HingeTwist, Twist, TwistLoads};
use crate::connector::ujoint::running::{LA, M2, RP};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::number::scalar::abs;

impl Proved for HingeTwist {
    fn cases() -> Vec<Case<Twist<f64>>> {
        let hand = Twist { m2: -304.0, la: 33.0, rp: 5.0 };
        let mut cases = vec![
            Case::running("α = 5/106, β = 63/212: 2.8, 17.64/2.1", Twist { m2: M2, la: LA, rp: RP }),
            Case::hand("lambda-6.6", "α = 33/304, β = 109/304: M = 33, F = 109/33", hand),
            Case::limit("stubby", "λ → 0: no moment, a quarter of |m2|/La", Twist { m2: 8.0, la: 1e-9, rp: 1.0 }),
            Case::limit("long", "λ → ∞: |m2|/8, 3/8 of |m2|/La", Twist { m2: 8.0, la: 1e9, rp: 1.0 }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2] = load.value;
            Case::hard(format!("moment-{}", load.id), load.comment, Twist { m2, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, Twist { m2: -2.5 * la, la, rp })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, m2] = arm.value;
            Case::hard(arm.id, arm.comment, Twist { m2, la, rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_abs(Twist { m2: 0.0, la: 33.0, rp: 5.0 }, |i| [i.m2])]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("moments about the centre: four hinges bear F La − M each, together |m2|", |i| {
            let TwistLoads { m_twist_hinge, f_twist_hinge } = Self::eval(i);
            law::equal((f_twist_hinge * i.la - m_twist_hinge) * 4.0, abs(i.m2))
        })]
    }
}
