//! The forces of the contact on the slave point and on the segment.

#[cfg(feature = "verify")]
mod proof;

use super::Spot;
use crate::contact::slide_line::{LinearPoint, LocalBasis, ParabolicPoint, check_distinct, check_tangent};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    AREA, LINE_FORCE_1, LINE_FORCE_2, LINE_FORCE_3, LINE_FORCE_S, S11, S12, SEGMENT_G, X1, X2, X3,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Source, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

const OURS: Source =
    Document::SLIDE_LINE.ours("Element output", "the section names pressure and shear stress, and prints no forces");

fields! {
    /// A point on a straight segment, and the loads there.
    pub struct LinearLoads<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, g: T = SEGMENT_G, area: T = AREA, s11: T = S11, s12: T = S12,
    }
}
fields! {
    /// A point on a parabolic segment, and the loads there.
    pub struct ParabolicLoads<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, g: T = SEGMENT_G,
        area: T = AREA, s11: T = S11, s12: T = S12,
    }
}
fields! {
    /// The forces of the contact on the slave point and on two nodes.
    pub struct LinearForces<T> {
        fs: Vector2<T> = LINE_FORCE_S, f1: Vector2<T> = LINE_FORCE_1, f2: Vector2<T> = LINE_FORCE_2,
    }
}
fields! {
    /// The forces of the contact on the slave point and on three nodes.
    pub struct ParabolicForces<T> {
        fs: Vector2<T> = LINE_FORCE_S, f1: Vector2<T> = LINE_FORCE_1, f2: Vector2<T> = LINE_FORCE_2,
        f3: Vector2<T> = LINE_FORCE_3,
    }
}

/// The force on the slave point, A (S11 n − S12 t), and those on the nodes, −Nᵢ times that.
fn acting<D: Scalar, const N: usize>(spot: &Spot<D, N>, [area, s11, s12]: [D; 3]) -> (Vector2<D>, [Vector2<D>; N]) {
    let fs = spot.n * (area * s11) - spot.t * (area * s12);
    (fs, spot.weights.map(|weight| fs * -weight))
}

/// The forces of contact on a straight segment: pressure along n and shear against t, times the area, distributed by the weights.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    pub(super) fn at<D: Scalar>(spot: &Spot<D, 2>, loads: [D; 3]) -> LinearForces<D> {
        let (fs, [f1, f2]) = acting(spot, loads);
        LinearForces { fs, f1, f2 }
    }
}

impl Formula for Linear {
    const SPEC: Spec = Spec::new("slide_line.nodal_forces_linear", "Nodal forces of contact on a straight segment", OURS)
        .equation(r"\mathbf{f}_s = A\,(S_{11}\,\mathbf{n} - S_{12}\,\mathbf{t}),\quad \mathbf{f}_1 = -\tfrac12(1-g)\,\mathbf{f}_s,\quad \mathbf{f}_2 = -\tfrac12(1+g)\,\mathbf{f}_s")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &LinearPoint::SPEC)])
        // The largest η that `audit --attack` found is 1.93 for the value, and 2.67 is possible to first order.
        .eta_of_value(3.0)
        .scale(1e120)
        .finite(Finite::Between);
    type Inputs<T: Component> = LinearLoads<T>;
    type Outputs<T: Component> = LinearForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearLoads<D>) -> LinearForces<D> {
        Self::at(&Spot::linear([i.x1, i.x2], i.g), [i.area, i.s11, i.s12])
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearLoads<D>) -> Result<(), Error> {
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}

/// The forces of contact on a parabolic segment, as on a straight one.
#[derive(Clone, Copy, Debug)]
pub struct Parabolic;

impl Parabolic {
    fn at<D: Scalar>(spot: &Spot<D, 3>, loads: [D; 3]) -> ParabolicForces<D> {
        let (fs, [f1, f2, f3]) = acting(spot, loads);
        ParabolicForces { fs, f1, f2, f3 }
    }
}

impl Formula for Parabolic {
    const SPEC: Spec = Spec::new("slide_line.nodal_forces_parabolic", "Nodal forces of contact on a parabolic segment", OURS)
        .equation(r"\mathbf{f}_s = A\,(S_{11}\,\mathbf{n} - S_{12}\,\mathbf{t}),\quad \mathbf{f}_1 = -\tfrac12 g(g-1)\,\mathbf{f}_s,\quad \mathbf{f}_2 = -(1-g^2)\,\mathbf{f}_s,\quad \mathbf{f}_3 = -\tfrac12 g(g+1)\,\mathbf{f}_s")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &ParabolicPoint::SPEC)])
        // The largest η that `audit --attack` found is 1.92 for the value, and 4.37 is possible to first order.
        .eta_of_value(2.0)
        .normwise_of_value(4.5)
        .apart(1e-9)
        .scale(1e150)
        .finite(Finite::Between);
    type Inputs<T: Component> = ParabolicLoads<T>;
    type Outputs<T: Component> = ParabolicForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicLoads<D>) -> ParabolicForces<D> {
        Self::at(&Spot::parabolic([i.x1, i.x2, i.x3], i.g), [i.area, i.s11, i.s12])
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicLoads<D>) -> Result<(), Error> {
        check_tangent([i.x1, i.x2, i.x3], i.g)
    }
}
