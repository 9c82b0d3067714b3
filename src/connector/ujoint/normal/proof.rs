//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{AllContactMoments, NormalMoments};
use crate::formula::Formula;
use crate::formula::proof::{Case, Convention, Kink, Law, Proved, hard, law};

impl Proved for NormalMoments {
    fn cases() -> Vec<Case<AllContactMoments<f64>>> {
        let hand = AllContactMoments { mc1: 5.0, mc3: 2.0, mc1_int: -1.0, mc3_int: 3.0 };
        let running = AllContactMoments { mc1: 13.92125, mc3: 15.8305, mc1_int: 1.0, mc3_int: -2.0 };
        let mut cases = vec![
            Case::running("2 × 13.92125 + 1, 2 × 15.8305 + 2", running),
            Case::hand("press-fit", "2 × 5 + 1, 2 × 2 + 3", hand),
            Case::hand("no-press-fit", "M_N = 2 M_C", AllContactMoments { mc1_int: 0.0, mc3_int: 0.0, ..hand }),
            Case::hand("unloaded", "M_N = |M_C_int|", AllContactMoments { mc1: 0.0, mc3: 0.0, ..hand }),
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
            Kink::<Self>::new(
                convention,
                "M_{C1} = 0",
                |i| i.mc1 == 0.0,
                AllContactMoments { mc1: 0.0, ..AT },
                AllContactMoments { mc1: 1.0, ..ZERO },
            ),
            Kink::<Self>::new(
                convention,
                "M_{C3} = 0",
                |i| i.mc3 == 0.0,
                AllContactMoments { mc3: 0.0, ..AT },
                AllContactMoments { mc3: 1.0, ..ZERO },
            ),
            Kink::<Self>::new(
                convention,
                r"M_{C1}^{\mathrm{int}} = 0",
                |i| i.mc1_int == 0.0,
                AllContactMoments { mc1_int: 0.0, ..AT },
                AllContactMoments { mc1_int: 1.0, ..ZERO },
            ),
            Kink::<Self>::new(
                convention,
                r"M_{C3}^{\mathrm{int}} = 0",
                |i| i.mc3_int == 0.0,
                AllContactMoments { mc3_int: 0.0, ..AT },
                AllContactMoments { mc3_int: 1.0, ..ZERO },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("reversing any moment does not change them", |i| {
            let out = Self::eval(i);
            let reversed = Self::eval(&AllContactMoments { mc1: -i.mc1, mc3_int: -i.mc3_int, ..*i });
            law::equal_all([(out.mn1, reversed.mn1), (out.mn3, reversed.mn3)])
        })]
    }
}
