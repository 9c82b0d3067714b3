//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{CentreLoads, HingeTransverse};
use crate::connector::ujoint::running::{LA, M2, PARTS, RP};
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};

impl Proved for HingeTransverse {
    fn cases() -> Vec<Case<CentreLoads<f64>>> {
        let hand = CentreLoads { f_axial1: 80.0, f_axial3: -20.0, f_bend: 16.0, m2: 0.0, la: 2.0, rp: 1.0 };
        let [f_axial1, f_axial3, f_bend] = PARTS;
        let mut cases = vec![
            Case::running(
                "√(2² + 8.4² + 2.625²), √(2² + 8.4² + 0.66²)",
                CentreLoads { f_axial1, f_axial3, f_bend, m2: M2, la: LA, rp: RP },
            ),
            Case::hand("no-twist", "β = 0.15: √(4² + 3²) = 5, √(4² + 12²)", hand),
            Case::hand(
                "bending-alone",
                "a quarter of the force on each hinge",
                CentreLoads { f_axial1: 0.0, f_axial3: 0.0, ..hand },
            ),
            Case::hard("stubby", "λ → 0: quarters of all three", CentreLoads { m2: 8e-9, la: 1e-9, ..hand }),
            Case::hard(
                "long",
                "λ → ∞: 3/8 of |m2|/La, nothing of the other axis",
                CentreLoads { m2: 8e9, la: 1e9, ..hand },
            ),
        ];
        cases.extend(hard::loads().into_iter().map(|load| {
            let [f_axial1, f_axial3, f_bend, m2] = load.value;
            Case::hard(
                format!("loads-{}", load.id),
                load.comment,
                CentreLoads { f_axial1, f_axial3, f_bend, m2, ..hand },
            )
        }));
        for (id, [f_axial1, f_axial3, f_bend, m2]) in [
            ("f_axial3-alone", [0.0, -2.5, 0.0, 0.0]),
            ("f_bend-alone", [0.0, 0.0, 2.5, 0.0]),
            ("f_axial1-missing", [0.0, 1.0, 2.0, 3.0]),
            ("f_axial3-missing", [1.0, 0.0, 2.0, 3.0]),
            ("f_bend-missing", [1.0, -1.0, 0.0, 3.0]),
        ] {
            cases.push(Case::hard(id, "loads that are 0", CentreLoads { f_axial1, f_axial3, f_bend, m2, ..hand }));
        }
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, CentreLoads { m2: -2.5 * la, la, rp, ..hand })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, size] = arm.value;
            let [f_axial1, f_axial3, f_bend, m2] = [-3.0, 7.0, 5.0, -11.0].map(|load| load * size);
            Case::hard(arm.id, arm.comment, CentreLoads { f_axial1, f_axial3, f_bend, m2, la, rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::of_norm(CentreLoads { f_axial1: 80.0, la: 2.0, rp: 1.0, ..CentreLoads::filled(0.0) }, |i| {
                [i.f_bend, i.m2, i.f_axial3]
            }),
            Kink::<Self>::of_norm(CentreLoads { f_axial3: -20.0, la: 2.0, rp: 1.0, ..CentreLoads::filled(0.0) }, |i| {
                [i.f_bend, i.m2, i.f_axial1]
            }),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("reversing any load does not change it", |i| {
                let out = Self::eval(i);
                let reversed = [
                    CentreLoads { f_axial1: -i.f_axial1, f_bend: -i.f_bend, ..*i },
                    CentreLoads { f_axial3: -i.f_axial3, m2: -i.m2, ..*i },
                ];
                let pairs = reversed.iter().flat_map(|reversed| {
                    let reversed = Self::eval(reversed);
                    [(out.f_total_hinge1, reversed.f_total_hinge1), (out.f_total_hinge3, reversed.f_total_hinge3)]
                });
                law::equal_all(pairs)
            }),
            Law::<Self>::new("exchanging the axial forces exchanges the hinges", |i| {
                let out = Self::eval(i);
                let exchanged = Self::eval(&CentreLoads { f_axial1: i.f_axial3, f_axial3: i.f_axial1, ..*i });
                law::equal_all([
                    (out.f_total_hinge1, exchanged.f_total_hinge3),
                    (out.f_total_hinge3, exchanged.f_total_hinge1),
                ])
            }),
        ]
    }
}
