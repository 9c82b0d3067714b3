//! What the contact exerts on the slave point and on the segment.

#[cfg(feature = "verify")]
mod proof;

use super::{Number, Place, Spot, times};
use crate::element::chain::{Term, gradients};
use crate::error::Error;
use crate::fields;
use crate::formula::{Component, Document, Formula, Given, Jacobian, Source, Spec};
use crate::quantity::{AREA, LINE_FORCE_1, LINE_FORCE_2, LINE_FORCE_3, LINE_FORCE_S, S11, S12, SEGMENT_G, X1, X2, X3};
use crate::scalar::Scalar;
use crate::slide_line::{LinearPoint, LocalBasis, ParabolicPoint, check_distinct, check_tangent};
use nalgebra::Vector2;

const OURS: Source =
    Document::SLIDE_LINE.ours("Element output", "the section names pressure and shear stress, and prints no forces");

fields! {
    /// A place on a straight segment, and what acts there.
    pub struct LinearLoads<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, g: T = SEGMENT_G, area: T = AREA, s11: T = S11, s12: T = S12,
    }
}
fields! {
    /// A place on a parabolic segment, and what acts there.
    pub struct ParabolicLoads<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, g: T = SEGMENT_G,
        area: T = AREA, s11: T = S11, s12: T = S12,
    }
}
fields! {
    /// What the contact exerts on the slave point and on two nodes.
    pub struct LinearForces<T> {
        fs: Vector2<T> = LINE_FORCE_S, f1: Vector2<T> = LINE_FORCE_1, f2: Vector2<T> = LINE_FORCE_2,
    }
}
fields! {
    /// What the contact exerts on the slave point and on three nodes.
    pub struct ParabolicForces<T> {
        fs: Vector2<T> = LINE_FORCE_S, f1: Vector2<T> = LINE_FORCE_1, f2: Vector2<T> = LINE_FORCE_2,
        f3: Vector2<T> = LINE_FORCE_3,
    }
}

/// On the slave point A (S11 n − S12 t), on the nodes −Nᵢ times that.
fn acting<T: Number + nalgebra::Scalar, const N: usize>(
    spot: &Spot<T, N>,
    [area, s11, s12]: [T; 3],
) -> (Vector2<T>, [Vector2<T>; N]) {
    let across = times(spot.n, area * s11);
    let fs = across.zip_map(&times(spot.t, area * s12), |normal, shear| normal + -shear);
    (fs, spot.weights.map(|weight| times(fs, -weight)))
}

/// Area and stresses, which follow the first inputs.
fn loads<D: Scalar, const K: usize>(loads: [D; 3]) -> [Term<D, K>; 3] {
    [0, 1, 2].map(|k| Term::variable(loads[k], K - 3 + k))
}

/// What contact on a straight segment exerts: pressure along n and shear against t, times the area, shared out by the weights.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    pub(super) fn at<T: Number + nalgebra::Scalar>(spot: &Spot<T, 2>, loads: [T; 3]) -> LinearForces<T> {
        let (fs, [f1, f2]) = acting(spot, loads);
        LinearForces { fs, f1, f2 }
    }
}

impl Formula for Linear {
    const SPEC: Spec = Spec::new("slide_line.nodal_forces_linear", "Nodal forces of contact on a straight segment", OURS)
        .equation(r"\mathbf{f}_s = A\,(S_{11}\,\mathbf{n} - S_{12}\,\mathbf{t}),\quad \mathbf{f}_1 = -\tfrac12(1-g)\,\mathbf{f}_s,\quad \mathbf{f}_2 = -\tfrac12(1+g)\,\mathbf{f}_s")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &LinearPoint::SPEC)])
        .eta(2.0, 4.0)
        .scale(1e120);
    type Inputs<T: Component> = LinearLoads<T>;
    type Outputs<T: Component> = LinearForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearLoads<D>) -> LinearForces<D> {
        Self::at(&Place::linear([i.x1, i.x2], i.g).spot, [i.area, i.s11, i.s12])
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearLoads<D>) -> Jacobian<Self, D> {
        gradients(&Self::at(&Place::linear([i.x1, i.x2], i.g).varied::<8>(), loads([i.area, i.s11, i.s12])))
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearLoads<D>) -> Result<(), Error> {
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}

/// What contact on a parabolic segment exerts, as on a straight one.
#[derive(Clone, Copy, Debug)]
pub struct Parabolic;

impl Parabolic {
    fn at<T: Number + nalgebra::Scalar>(spot: &Spot<T, 3>, loads: [T; 3]) -> ParabolicForces<T> {
        let (fs, [f1, f2, f3]) = acting(spot, loads);
        ParabolicForces { fs, f1, f2, f3 }
    }
}

impl Formula for Parabolic {
    const SPEC: Spec = Spec::new("slide_line.nodal_forces_parabolic", "Nodal forces of contact on a parabolic segment", OURS)
        .equation(r"\mathbf{f}_s = A\,(S_{11}\,\mathbf{n} - S_{12}\,\mathbf{t}),\quad \mathbf{f}_1 = -\tfrac12 g(g-1)\,\mathbf{f}_s,\quad \mathbf{f}_2 = -(1-g^2)\,\mathbf{f}_s,\quad \mathbf{f}_3 = -\tfrac12 g(g+1)\,\mathbf{f}_s")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &ParabolicPoint::SPEC)])
        .eta(2.0, 8.0)
        .scale(1e5);
    type Inputs<T: Component> = ParabolicLoads<T>;
    type Outputs<T: Component> = ParabolicForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicLoads<D>) -> ParabolicForces<D> {
        Self::at(&Place::parabolic([i.x1, i.x2, i.x3], i.g).spot, [i.area, i.s11, i.s12])
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicLoads<D>) -> Jacobian<Self, D> {
        gradients(&Self::at(&Place::parabolic([i.x1, i.x2, i.x3], i.g).varied::<10>(), loads([i.area, i.s11, i.s12])))
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicLoads<D>) -> Result<(), Error> {
        check_tangent([i.x1, i.x2, i.x3], i.g)
    }
}
