//! Evidence for the formulas of the parent module.

use super::{KeptAxis, KeptAxis2d, KeptNodes, KeptNodes2d, LineNodes, LineNodes2d, PivotAxes, PivotAxis2d};
use crate::connector::slider::hard::{change_of_pivot, changes_of_pivots};
use crate::formula::Fields;
use crate::formula::proof::{Kink, Proved};
use nalgebra::{Vector2, Vector3};

impl Proved for KeptAxis {
    fn kinks() -> Vec<Kink<Self>> {
        changes_of_pivots::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptNodes {
                x1: Vector3::zeros(),
                xn,
                xm: Vector3::new(0.5, 1.0, 0.75),
                dxm: Vector3::new(0.25, -0.5, 0.125),
            },
            |dxn| KeptNodes { xn: dxn, ..KeptNodes::filled(0.0) },
        )
    }
}

impl Proved for KeptAxis2d {
    fn kinks() -> Vec<Kink<Self>> {
        change_of_pivot::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptNodes2d { x1: Vector2::zeros(), xn, xm: Vector2::new(0.5, 1.0), dxm: Vector2::new(0.25, -0.5) },
            |dxn| KeptNodes2d { xn: dxn, ..KeptNodes2d::filled(0.0) },
        )
    }
}

impl Proved for PivotAxes {
    fn kinks() -> Vec<Kink<Self>> {
        changes_of_pivots::<Self>(
            |i| i.xn - i.x1,
            |xn| LineNodes { x1: Vector3::zeros(), xn },
            |dxn| LineNodes { xn: dxn, ..LineNodes::filled(0.0) },
        )
    }
}

impl Proved for PivotAxis2d {
    fn kinks() -> Vec<Kink<Self>> {
        change_of_pivot::<Self>(
            |i| i.xn - i.x1,
            |xn| LineNodes2d { x1: Vector2::zeros(), xn },
            |dxn| LineNodes2d { xn: dxn, ..LineNodes2d::filled(0.0) },
        )
    }
}
