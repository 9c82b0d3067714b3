//! Across the gap between two surfaces, heat takes two ways: through the gas, and through the spots that touch.

use crate::quantity::{A, C, G, KG, P, Q, T1, T2, TWO_WAYS};
use jointproof::formula::proof::{Case, Law, Proved, law};
use jointproof::formula::{Component, Finite, Formula, Jacobian, Spec};
use jointproof::{Scalar, fields};

fields! { pub struct Gap<T> { t1: T = T1, t2: T = T2, c: T = C, g: T = G, kg: T = KG, p: T = P, a: T = A } }
fields! { pub struct Heat<T> { q: T = Q } }

#[derive(Clone, Copy)]
pub struct Flux;

impl Formula for Flux {
    const SPEC: Spec = Spec::new("gap.flux", "Heat flux across a gap", TWO_WAYS)
        .equation(r"q = \left(\frac{k_g}{c + g} + a p\right)(T_1 - T_2)")
        .eta(4.0, 4.0)
        .finite(Finite::Between);
    type Inputs<T: Component> = Gap<T>;
    type Outputs<T: Component> = Heat<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Gap<D>) -> Heat<D> {
        Heat { q: (i.kg / (i.c + i.g) + i.a * i.p) * (i.t1 - i.t2) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Gap<D>) -> Jacobian<Self, D> {
        let (dt, per_length) = (i.t1 - i.t2, (i.c + i.g).recip());
        let (gas, h) = (i.kg * per_length, i.kg * per_length + i.a * i.p);
        let wider = -gas * per_length * dt;
        Heat { q: Gap { t1: h, t2: -h, c: wider, g: wider, kg: per_length * dt, p: i.a * dt, a: i.p * dt } }
    }
}

impl Proved for Flux {
    fn cases() -> Vec<Case<Gap<f64>>> {
        let hand = Gap { t1: 400.0, t2: 300.0, c: 1.5, g: 0.5, kg: 4.0, p: 3.0, a: 0.5 };
        vec![
            Case::hand("both-ways", "(4/2 + 0.5·3) · 100 = 350", hand),
            Case::limit("open", "without pressure the gas alone: 4/2 · 100", Gap { p: 0.0, ..hand }),
            Case::hard("closed", "no clearance", Gap { c: 0.0, ..hand }),
            Case::hard("as-warm", "one ulp between the temperatures", Gap { t2: 400.0_f64.next_down(), ..hand }),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("exchanging the temperatures turns the flux round", |i| {
            law::equal(Self::eval(i).q, -Self::eval(&Gap { t1: i.t2, t2: i.t1, ..*i }).q)
        })]
    }
}
