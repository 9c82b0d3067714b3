//! A formula whose derivative has a wrong sign.

use jointproof::formula::proof::{Case, Proved};
use jointproof::formula::quantity::{Domain, Quantity, Unit};
use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
use jointproof::{Scalar, fields};

const SIDE: Quantity = Quantity::scalar("a", Unit::L, Domain::Real, "side of a square");
const AREA: Quantity = Quantity::scalar("A", Unit::L.times(Unit::L), Domain::Real, "its area");

fields! { pub struct Side<T> { a: T = SIDE } }
fields! { pub struct Area<T> { area: T = AREA } }

#[derive(Clone, Copy)]
pub struct Square;

impl Formula for Square {
    const SPEC: Spec =
        Spec::new("broken.square", "Area of a square", Document::new("Squares").ours("", "everybody knows"))
            .equation("A = a^2")
            .eta(1.0, 1.0);
    type Inputs<T: Component> = Side<T>;
    type Outputs<T: Component> = Area<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Side<D>) -> Area<D> {
        Area { area: i.a * i.a }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Side<D>) -> Jacobian<Self, D> {
        Area { area: Side { a: i.a * -2.0 } }
    }
}

impl Proved for Square {
    fn cases() -> Vec<Case<Side<f64>>> {
        vec![Case::hand("three", "3² = 9", Side { a: 3.0 })]
    }
}
