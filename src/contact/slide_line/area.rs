//! Contact area of the nodes of axisymmetric elements, around the whole circumference.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::basis::length_and_tangent;
use super::check_radii;
use super::points::ParabolicPoint;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{A1, A2, A3, X1, X2, X3};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Source, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, pi};
use nalgebra::Vector2;

const SOURCE: Source = Document::SLIDE_LINE.ours(
    "Defining slide line elements (slave surface)",
    "the section says current length times width; the shares of the nodes are ours",
);

fields! {
    /// The two nodes of an ISL21A element.
    pub struct LinearNodes<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2 }
}
fields! {
    /// Contact areas of two nodes.
    pub struct TwoAreas<T> { a1: T = A1, a2: T = A2 }
}

/// Contact areas of ISL21A: Aᵢ = π ℓ rᵢ, half the length times the circumference at the node.
#[derive(Clone, Copy, Debug)]
pub struct ContactAreaLinear;

impl Formula for ContactAreaLinear {
    const SPEC: Spec = Spec::new("slide_line.contact_area_linear", "Contact areas of ISL21A", SOURCE)
        .equation(r"A_i = 2\pi r_i\,\tfrac{\ell}{2},\quad r_i = x_{i,1}\quad (i = 1, 2),\quad \ell = \lvert\mathbf{x}_2-\mathbf{x}_1\rvert")
        .eta(3.0, 4.5)
        // Beyond, a slope underflows whose product with a radius does not.
        .scale(1e120)
        .finite(Finite::Below)
        .not_objective();
    type Inputs<T: Component> = LinearNodes<T>;
    type Outputs<T: Component> = TwoAreas<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearNodes<D>) -> TwoAreas<D> {
        let (length, _) = length_and_tangent(i.x2 - i.x1);
        let band = pi::<D>() * length;
        TwoAreas { a1: band * i.x1.x, a2: band * i.x2.x }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &LinearNodes<D>) -> Jacobian<Self, D> {
        let (length, t) = length_and_tangent(i.x2 - i.x1);
        let band = pi::<D>() * length;
        let radius = Vector2::new(band, D::zero());
        let [s1, s2] = [i.x1.x, i.x2.x].map(|r| t * (pi::<D>() * r));
        TwoAreas { a1: LinearNodes { x1: radius - s1, x2: s1 }, a2: LinearNodes { x1: -s2, x2: radius + s2 } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearNodes<D>) -> Result<(), Error> {
        check_radii([("x1", i.x1), ("x2", i.x2)])
    }
}

fields! {
    /// The three nodes of an ISL22A element; the second is the midside node.
    pub struct ParabolicNodes<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3 }
}
fields! {
    /// Contact areas of three nodes.
    pub struct ThreeAreas<T> { a1: T = A1, a2: T = A2, a3: T = A3 }
}

/// Contact areas of ISL22A: Aᵢ = 2π rᵢ wᵢ |X′(gᵢ)|, with w = 1/3, 4/3, 1/3 at g = −1, 0, 1 (Simpson's rule).
#[derive(Clone, Copy, Debug)]
pub struct ContactAreaParabolic;

/// The lengths whose products with π rᵢ/3 are the areas, and their directions: those of 6X′(−1)/3, 4·2X′(0), 6X′(1)/3.
#[inline]
fn lengths<D: Scalar>(i: &ParabolicNodes<D>) -> [(D, Vector2<D>); 3] {
    let (before, after) = (i.x2 - i.x1, i.x3 - i.x2);
    let three = D::from(3.0);
    [before * three - after, i.x3 - i.x1, after * three - before].map(length_and_tangent)
}

impl ContactAreaParabolic {
    /// The areas from these lengths.
    #[inline]
    fn of<D: Scalar>(i: &ParabolicNodes<D>, [first, middle, last]: [D; 3]) -> ThreeAreas<D> {
        let third = pi::<D>() / 3.0;
        ThreeAreas { a1: third * i.x1.x * first, a2: third * 4.0 * i.x2.x * middle, a3: third * i.x3.x * last }
    }
}

impl Formula for ContactAreaParabolic {
    const SPEC: Spec = Spec::new("slide_line.contact_area_parabolic", "Contact areas of ISL22A", SOURCE)
        .equation(r"A_i = 2\pi r_i\,w_i\,\lvert\mathbf{X}'(g_i)\rvert,\quad r_i = x_{i,1}\quad (i = 1, 2, 3),\quad (w_1, w_2, w_3) = (\tfrac13, \tfrac43, \tfrac13),\quad (g_1, g_2, g_3) = (-1, 0, 1)")
.given(&[Given::new(r"\mathbf{X}'(g)", &ParabolicPoint::SPEC)])
        // The largest η that `audit --attack` found is 2.11 for the value, and 3.22 is possible to first order; for the Jacobian 4.1 and 7.
        .eta(3.5, 7.0)
        .apart(1e-9)
        .scale(1e250)
        .finite(Finite::Below)
        .not_objective();
    type Inputs<T: Component> = ParabolicNodes<T>;
    type Outputs<T: Component> = ThreeAreas<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicNodes<D>) -> ThreeAreas<D> {
        Self::of(i, lengths(i).map(|(length, _)| length))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicNodes<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ParabolicNodes<D>) -> ValueAndJacobian<Self, D> {
        let [(first, t1), (middle, t2), (last, t3)] = lengths(i);
        let third = pi::<D>() / 3.0;
        let radius = |x| Vector2::new(third * x, D::zero());
        let scaled = |t: Vector2<D>, factor: f64| t * D::from(factor);
        let (s1, s2, s3) = (t1 * (third * i.x1.x), t2 * (third * 4.0 * i.x2.x), t3 * (third * i.x3.x));
        let by = ThreeAreas {
            a1: ParabolicNodes { x1: radius(first) - scaled(s1, 3.0), x2: scaled(s1, 4.0), x3: -s1 },
            a2: ParabolicNodes { x1: -s2, x2: radius(middle * 4.0), x3: s2 },
            a3: ParabolicNodes { x1: s3, x2: scaled(s3, -4.0), x3: radius(last) + scaled(s3, 3.0) },
        };
        (Self::of(i, [first, middle, last]), by)
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicNodes<D>) -> Result<(), Error> {
        check_radii([("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])
    }
}
