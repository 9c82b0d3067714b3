//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{AxialForces, HingeAxial};
use crate::connector::ujoint::running::{LA, PARTS, RP};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::number::scalar::abs;

impl Proved for HingeAxial {
    fn cases() -> Vec<Case<AxialForces<f64>>> {
        let hand = AxialForces { f_axial1: -20.0, f_axial3: 10.0, la: 2.0, rp: 1.0 };
        let [f_axial1, f_axial3, _] = PARTS;
        let mut cases = vec![
            Case::running(
                "0.35 × 4.4, 0.35 × 17.5, 0.15 × 17.5, 0.15 × 4.4",
                AxialForces { f_axial1, f_axial3, la: LA, rp: RP },
            ),
            Case::hand("lambda-2", "α = 0.35, β = 0.15: 7, 3.5 along, 1.5, 3 across", hand),
            Case::hard("stubby", "λ → 0: a quarter everywhere", AxialForces { la: 1e-9, ..hand }),
            Case::hard("long", "λ → ∞: half along, nothing across", AxialForces { la: 1e9, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f_axial1, f_axial3] = load.value;
            Case::hard(format!("forces-{}", load.id), load.comment, AxialForces { f_axial1, f_axial3, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, AxialForces { la, rp, ..hand })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, size] = arm.value;
            let (f_axial1, f_axial3) = (-3.0 * size, 7.0 * size);
            Case::hard(arm.id, arm.comment, AxialForces { f_axial1, f_axial3, la, rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::of_abs(AxialForces { f_axial1: 0.0, f_axial3: 10.0, la: 2.0, rp: 1.0 }, |i| [i.f_axial1]),
            Kink::<Self>::of_abs(AxialForces { f_axial1: -20.0, f_axial3: 0.0, la: 2.0, rp: 1.0 }, |i| [i.f_axial3]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("two hinges along the force and two transverse to it take all of it", |i| {
            let out = Self::eval(i);
            law::equal_all([
                ((out.f_axial_hinge1 + out.f_transv_hinge3) * 2.0, abs(i.f_axial1)),
                ((out.f_axial_hinge3 + out.f_transv_hinge1) * 2.0, abs(i.f_axial3)),
            ])
        })]
    }
}
