//! The rows of separation and slip.

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::Spot;
use crate::contact::slide_line::{
    LinearPlace, LinearPoint, LocalBasis, ParabolicPlace, ParabolicPoint, check_distinct, check_tangent,
};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{E11_U1, E11_U2, E11_U3, E11_US, E12_U1, E12_U2, E12_U3, E12_US};
use crate::formula::{Component, Document, Finite, Formula, Given, Source, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

const OURS: Source =
    Document::SLIDE_LINE.ours("Element output", "the section names separation and slip; these are their variations");

fields! {
    /// The variations of separation and slip with respect to the translations of the slave point and of two nodes.
    pub struct LinearRows<T> {
        e11_us: Vector2<T> = E11_US, e11_u1: Vector2<T> = E11_U1, e11_u2: Vector2<T> = E11_U2,
        e12_us: Vector2<T> = E12_US, e12_u1: Vector2<T> = E12_U1, e12_u2: Vector2<T> = E12_U2,
    }
}
fields! {
    /// The variations of separation and slip with respect to the translations of the slave point and of three nodes.
    pub struct ParabolicRows<T> {
        e11_us: Vector2<T> = E11_US, e11_u1: Vector2<T> = E11_U1, e11_u2: Vector2<T> = E11_U2,
        e11_u3: Vector2<T> = E11_U3, e12_us: Vector2<T> = E12_US, e12_u1: Vector2<T> = E12_U1,
        e12_u2: Vector2<T> = E12_U2, e12_u3: Vector2<T> = E12_U3,
    }
}

/// The rows of the nodes of a segment: −Nᵢ times a vector.
fn of_nodes<D: Scalar, const N: usize>(spot: &Spot<D, N>, v: Vector2<D>) -> [Vector2<D>; N] {
    spot.weights.map(|weight| v * -weight)
}

/// The rows of separation and slip on a straight segment.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    fn at<D: Scalar>(spot: &Spot<D, 2>) -> LinearRows<D> {
        let ([e11_u1, e11_u2], [e12_u1, e12_u2]) = (of_nodes(spot, spot.n), of_nodes(spot, spot.t));
        LinearRows { e11_us: spot.n, e11_u1, e11_u2, e12_us: spot.t, e12_u1, e12_u2 }
    }
}

impl Formula for Linear {
    const SPEC: Spec = Spec::new("slide_line.rows_linear", "Rows of contact on a straight segment", OURS)
        .equation(r"\begin{aligned} \mathbf{e}_{11,us} &= \mathbf{n}, & \mathbf{e}_{11,u1} &= -N_1\,\mathbf{n}, & \mathbf{e}_{11,u2} &= -N_2\,\mathbf{n}, \\ \mathbf{e}_{12,us} &= \mathbf{t}, & \mathbf{e}_{12,u1} &= -N_1\,\mathbf{t}, & \mathbf{e}_{12,u2} &= -N_2\,\mathbf{t}, \\ N_1 &= \tfrac12(1-g), & N_2 &= \tfrac12(1+g) \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &LinearPoint::SPEC)])
        .eta_of_value(4.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = LinearPlace<T>;
    type Outputs<T: Component> = LinearRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearPlace<D>) -> LinearRows<D> {
        Self::at(&Spot::linear([i.x1, i.x2], i.g))
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearPlace<D>) -> Result<(), Error> {
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}

/// The rows of separation and slip on a parabolic segment.
#[derive(Clone, Copy, Debug)]
pub struct Parabolic;

impl Parabolic {
    fn at<D: Scalar>(spot: &Spot<D, 3>) -> ParabolicRows<D> {
        let ([e11_u1, e11_u2, e11_u3], [e12_u1, e12_u2, e12_u3]) = (of_nodes(spot, spot.n), of_nodes(spot, spot.t));
        ParabolicRows { e11_us: spot.n, e11_u1, e11_u2, e11_u3, e12_us: spot.t, e12_u1, e12_u2, e12_u3 }
    }
}

impl Formula for Parabolic {
    const SPEC: Spec = Spec::new("slide_line.rows_parabolic", "Rows of contact on a parabolic segment", OURS)
        .equation(r"\begin{aligned} \mathbf{e}_{11,us} &= \mathbf{n}, & \mathbf{e}_{11,u1} &= -N_1\,\mathbf{n}, & \mathbf{e}_{11,u2} &= -N_2\,\mathbf{n}, & \mathbf{e}_{11,u3} &= -N_3\,\mathbf{n}, \\ \mathbf{e}_{12,us} &= \mathbf{t}, & \mathbf{e}_{12,u1} &= -N_1\,\mathbf{t}, & \mathbf{e}_{12,u2} &= -N_2\,\mathbf{t}, & \mathbf{e}_{12,u3} &= -N_3\,\mathbf{t}, \\ N_1 &= \tfrac12 g(g-1), & N_2 &= 1-g^2, & N_3 &= \tfrac12 g(g+1) \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &ParabolicPoint::SPEC)])
        .eta_of_value(3.0)
        .normwise_of_value(4.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = ParabolicPlace<T>;
    type Outputs<T: Component> = ParabolicRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicPlace<D>) -> ParabolicRows<D> {
        Self::at(&Spot::parabolic([i.x1, i.x2, i.x3], i.g))
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicPlace<D>) -> Result<(), Error> {
        check_tangent([i.x1, i.x2, i.x3], i.g)
    }
}
