//! The normal moments of the hinges.

use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{MC1, MC1_INT, MC3, MC3_INT, MN1, MN3};
use crate::scalar::{Scalar, abs, sign};
use crate::verify::{hard, law};

fields! {
    /// Contact moments of the loads, and the internal ones.
    pub struct AllContactMoments<T> { mc1: T = MC1, mc3: T = MC3, mc1_int: T = MC1_INT, mc3_int: T = MC3_INT }
}
fields! {
    /// Normal moments about both axes of the cross.
    pub struct NormalMomentPair<T> { mn1: T = MN1, mn3: T = MN3 }
}

/// Normal moments: M_Nk = 2|M_Ck| + |M_Ck_int|; there are two hinges on each axis.
#[derive(Clone, Copy, Debug)]
pub struct NormalMoments;

impl Formula for NormalMoments {
    const SPEC: Spec = Spec {
        id: "ujoint.normal_moments",
        title: "Normal moments",
        latex: r"M_{Nk} = 2\lvert M_{Ck}\rvert + \lvert M_{Ck}^{\mathrm{int}}\rvert\quad (k = 1, 3)",
        source: Source::UJOINT.section("Friction"),
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = AllContactMoments<T>;
    type Outputs<T: Element> = NormalMomentPair<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AllContactMoments<D>) -> NormalMomentPair<D> {
        NormalMomentPair { mn1: abs(i.mc1) * 2.0 + abs(i.mc1_int), mn3: abs(i.mc3) * 2.0 + abs(i.mc3_int) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &AllContactMoments<D>) -> Jacobian<Self, D> {
        let zero = AllContactMoments::filled(D::zero());
        let slope = |factor: f64, x: D| D::from(factor * sign(x));
        NormalMomentPair {
            mn1: AllContactMoments { mc1: slope(2.0, i.mc1), mc1_int: slope(1.0, i.mc1_int), ..zero },
            mn3: AllContactMoments { mc3: slope(2.0, i.mc3), mc3_int: slope(1.0, i.mc3_int), ..zero },
        }
    }

    fn cases() -> Vec<Case<AllContactMoments<f64>>> {
        let hand = AllContactMoments { mc1: 5.0, mc3: 2.0, mc1_int: -1.0, mc3_int: 3.0 };
        let mut cases = vec![
            Case::hand("press-fit", "2 × 5 + 1, 2 × 2 + 3", hand),
            Case::limit("no-press-fit", "M_N = 2 M_C", AllContactMoments { mc1_int: 0.0, mc3_int: 0.0, ..hand }),
            Case::limit("unloaded", "M_N = |M_C_int|", AllContactMoments { mc1: 0.0, mc3: 0.0, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|moments| {
            let [mc1, mc3, mc1_int, mc3_int] = moments.value;
            Case::hard(moments.id, moments.comment, AllContactMoments { mc1, mc3, mc1_int, mc3_int })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        const AT: AllContactMoments<f64> = AllContactMoments { mc1: 5.0, mc3: 2.0, mc1_int: -1.0, mc3_int: 3.0 };
        const ZERO: AllContactMoments<f64> = AllContactMoments { mc1: 0.0, mc3: 0.0, mc1_int: 0.0, mc3_int: 0.0 };
        let convention = Convention::Subgradient;
        vec![
            Kink {
                condition: "M_{C1} = 0",
                convention,
                holds: |i| i.mc1 == 0.0,
                at: || AllContactMoments { mc1: 0.0, ..AT },
                across: || AllContactMoments { mc1: 1.0, ..ZERO },
            },
            Kink {
                condition: "M_{C3} = 0",
                convention,
                holds: |i| i.mc3 == 0.0,
                at: || AllContactMoments { mc3: 0.0, ..AT },
                across: || AllContactMoments { mc3: 1.0, ..ZERO },
            },
            Kink {
                condition: r"M_{C1}^{\mathrm{int}} = 0",
                convention,
                holds: |i| i.mc1_int == 0.0,
                at: || AllContactMoments { mc1_int: 0.0, ..AT },
                across: || AllContactMoments { mc1_int: 1.0, ..ZERO },
            },
            Kink {
                condition: r"M_{C3}^{\mathrm{int}} = 0",
                convention,
                holds: |i| i.mc3_int == 0.0,
                at: || AllContactMoments { mc3_int: 0.0, ..AT },
                across: || AllContactMoments { mc3_int: 1.0, ..ZERO },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "reversing any moment leaves them",
            sides: |i| {
                let out = Self::eval(i);
                let reversed = Self::eval(&AllContactMoments { mc1: -i.mc1, mc3_int: -i.mc3_int, ..*i });
                law::equal_all([(out.mn1, reversed.mn1), (out.mn3, reversed.mn3)])
            },
        }]
    }
}
