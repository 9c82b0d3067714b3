//! Through a wall of two layers in contact, the resistances of layers and contact add up.

use crate::gap::Heat;
use crate::quantity::{H, IN_SERIES, KA, KB, LA, LB, T1, T2};
use jointproof::formula::proof::{Case, Law, Proved, law};
use jointproof::formula::{Component, Finite, Formula, Jacobian, Spec};
use jointproof::{Scalar, fields};

fields! { pub struct Wall<T> { t1: T = T1, t2: T = T2, la: T = LA, ka: T = KA, lb: T = LB, kb: T = KB, h: T = H } }

#[derive(Clone, Copy)]
pub struct Flux;

impl Formula for Flux {
    const SPEC: Spec = Spec::new("wall.flux", "Heat flux through a wall", IN_SERIES)
        .equation(r"q = \frac{T_1 - T_2}{L_a/k_a + L_b/k_b + 1/h}")
        .eta(4.0, 8.0)
        .finite(Finite::Between);
    type Inputs<T: Component> = Wall<T>;
    type Outputs<T: Component> = Heat<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Wall<D>) -> Heat<D> {
        Heat { q: (i.t1 - i.t2) / (i.la / i.ka + i.lb / i.kb + i.h.recip()) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Wall<D>) -> Jacobian<Self, D> {
        let dt = i.t1 - i.t2;
        let [ra, rb, rc] = [i.ka, i.kb, i.h].map(|conducts| conducts.recip());
        let u = (i.la * ra + i.lb * rb + rc).recip();
        let [a, b, c] = [ra, rb, rc].map(|r| r * u);
        let (la, lb, h) = (-dt * u * a, -dt * u * b, dt * c * c);
        Heat { q: Wall { t1: u, t2: -u, la, ka: dt * a * a * i.la, lb, kb: dt * b * b * i.lb, h } }
    }
}

impl Proved for Flux {
    fn cases() -> Vec<Case<Wall<f64>>> {
        let hand = Wall { t1: 400.0, t2: 300.0, la: 2.0, ka: 4.0, lb: 1.0, kb: 4.0, h: 4.0 };
        vec![
            Case::hand("three-resistances", "100 / (1/2 + 1/4 + 1/4) = 100", hand),
            Case::hard("insulated", "a contact that hardly conducts", Wall { h: 1e-200, ..hand }),
            Case::hard("as-warm", "one ulp between the temperatures", Wall { t2: 400.0_f64.next_down(), ..hand }),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("the order of the layers does not matter", |i| {
            law::equal(Self::eval(i).q, Self::eval(&Wall { la: i.lb, ka: i.kb, lb: i.la, kb: i.ka, ..*i }).q)
        })]
    }
}
