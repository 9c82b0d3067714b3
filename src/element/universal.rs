//! UNIVERSAL as an element: one residual, the cosine between e1a and e3b, on which spins alone work.

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::products::cross_gradient;
use crate::fields;
use crate::formula::{Component, Document, Finite, Formula, Jacobian, Spec};
use crate::quantity::{E1A, E3B, G_ROT_TA, G_ROT_TB, LAMBDA_ROT, MOMENT_A, MOMENT_B};
use crate::scalar::Scalar;
use crate::ujoint::CrossAxes;
use nalgebra::Vector3;

fields! {
    /// The derivatives of the residual by the spins of both nodes; translations do not change it.
    pub struct UniversalRow<T> { g_rot_ta: Vector3<T> = G_ROT_TA, g_rot_tb: Vector3<T> = G_ROT_TB }
}

/// The row of UNIVERSAL: e1a × e3b by the spin of a, its opposite by that of b.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new(
        "universal.rows",
        "Row of UNIVERSAL",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; this is the derivative of its residual"),
    )
    .equation(r"\mathbf{g}_{\mathrm{rot},\theta a} = \mathbf{e}_{1a}\times\mathbf{e}_{3b},\quad \mathbf{g}_{\mathrm{rot},\theta b} = \mathbf{e}_{3b}\times\mathbf{e}_{1a}")
    .eta(1.0, 0.0)
    .finite(Finite::Below);
    type Inputs<T: Component> = CrossAxes<T>;
    type Outputs<T: Component> = UniversalRow<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossAxes<D>) -> UniversalRow<D> {
        let across = i.e1a.cross(&i.e3b);
        UniversalRow { g_rot_ta: across, g_rot_tb: -across }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossAxes<D>) -> Jacobian<Self, D> {
        let row = |k: usize| {
            let [e1a, e3b] = cross_gradient(&i.e1a, &i.e3b, k);
            CrossAxes { e1a, e3b }
        };
        let across = Vector3::from_fn(|k, _| row(k));
        UniversalRow {
            g_rot_ta: across,
            g_rot_tb: across.map(|CrossAxes { e1a, e3b }| CrossAxes { e1a: -e1a, e3b: -e3b }),
        }
    }
}

fields! {
    /// The axes of the cross, and the multiplier.
    pub struct UniversalLoads<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B, lambda_rot: T = LAMBDA_ROT }
}
fields! {
    /// What UNIVERSAL exerts on its nodes.
    pub struct UniversalMoments<T> { ma: Vector3<T> = MOMENT_A, mb: Vector3<T> = MOMENT_B }
}

/// What UNIVERSAL exerts on its nodes, Rowsᵀ λ: λ e1a × e3b on a, its opposite on b.
#[derive(Clone, Copy, Debug)]
pub struct Moments;

impl Formula for Moments {
    const SPEC: Spec = Spec::new(
        "universal.nodal_moments",
        "Nodal moments of UNIVERSAL",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; these do the work of its multiplier"),
    )
    .equation(r"\mathbf{m}_a = \lambda_{\mathrm{rot}}\,\mathbf{e}_{1a}\times\mathbf{e}_{3b},\quad \mathbf{m}_b = -\mathbf{m}_a")
    .eta(1.5, 1.5)
    .finite(Finite::Below);
    type Inputs<T: Component> = UniversalLoads<T>;
    type Outputs<T: Component> = UniversalMoments<T>;

    #[inline]
    fn eval<D: Scalar>(i: &UniversalLoads<D>) -> UniversalMoments<D> {
        let ma = i.e1a.cross(&i.e3b) * i.lambda_rot;
        UniversalMoments { ma, mb: -ma }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &UniversalLoads<D>) -> Jacobian<Self, D> {
        let across = i.e1a.cross(&i.e3b);
        let row = |k: usize, factor: D, sign: D| {
            let [e1a, e3b] = cross_gradient(&i.e1a, &i.e3b, k);
            UniversalLoads { e1a: e1a * factor, e3b: e3b * factor, lambda_rot: across[k] * sign }
        };
        let rows = |sign: D| Vector3::from_fn(|k, _| row(k, i.lambda_rot * sign, sign));
        UniversalMoments { ma: rows(D::one()), mb: rows(-D::one()) }
    }
}
