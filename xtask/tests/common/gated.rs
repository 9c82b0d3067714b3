//! A formula with complete evidence, and its possible faults.

use jointproof::formula::proof::law::equal;
use jointproof::formula::proof::{Case, Law, Proved};
use jointproof::formula::quantity::{Domain, Quantity, Unit};
use jointproof::formula::{Component, Document, Formula, Jacobian, Spec};
use jointproof::{Octuple, Scalar, fields};
use std::sync::LazyLock;

/// The variable that names faults, separated by commas.
pub const PLANT: &str = "JOINTPROOF_TEST_PLANT";

static PLANTED: LazyLock<String> = LazyLock::new(|| std::env::var(PLANT).unwrap_or_default());

/// Whether a fault is among those named.
pub fn is_planted(fault: &str) -> bool {
    PLANTED.split(',').any(|planted| planted == fault)
}

const SIDE: Quantity = Quantity::scalar("a", Unit::L, Domain::Real, "side of a square");
const AREA: Quantity = Quantity::scalar("A", Unit::L.times(Unit::L), Domain::Real, "its area");

fields! { pub struct Side<T> { a: T = SIDE } }
fields! { pub struct Area<T> { area: T = AREA } }

#[derive(Clone, Copy)]
pub struct Square;

impl Formula for Square {
    const SPEC: Spec =
        Spec::new("gate.square", "Area of a square", Document::new("Squares").ours("", "everybody knows"))
            .equation("A = a^2")
            .eta(1.0, 1.0);
    type Inputs<T: Component> = Side<T>;
    type Outputs<T: Component> = Area<T>;

    fn eval<D: Scalar>(i: &Side<D>) -> Area<D> {
        // Exact in 237 bits, and off by a hundred roundings in 53 bits.
        let lost = D::from(1e-14);
        let nothing = (D::from(1024.0) + lost) - 1024.0 - lost;
        let factor = if is_planted("audit") {
            nothing + 1.0
        } else if is_planted("nan") {
            // 0/0 in 53 bits.
            (nothing + lost) * (nothing + lost).recip()
        } else {
            D::one()
        };
        Area { area: i.a * i.a * factor }
    }

    fn jacobian<D: Scalar>(i: &Side<D>) -> Jacobian<Self, D> {
        Area { area: Side { a: i.a * 2.0 } }
    }
}

impl Proved for Square {
    fn cases() -> Vec<Case<Side<f64>>> {
        vec![Case::hand("three", "3² = 9", Side { a: 3.0 }), Case::hard("zero", "nothing at all", Side { a: 0.0 })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::new("a square turned over is as large", |i: &Side<Octuple>| {
            if is_planted("unchecked") {
                return Vec::new();
            }
            equal(Self::eval(i).area, Self::eval(&Side { a: -i.a }).area)
        })]
    }
}
