//! UNIVERSAL as an element: one residual, the cosine between e1a and e3b, which depends on spins only.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::products::double_cross;
use crate::fields;
use crate::formula::quantity::{
    E1A, E3B, G_ROT_TA, G_ROT_TB, K_TA_TA, K_TA_TB, K_TB_TB, LAMBDA_ROT, MOMENT_A, MOMENT_B,
};
use crate::formula::{Component, Document, Finite, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

fields! {
    /// The axes of the cross.
    pub struct CrossAxes<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B }
}
fields! {
    /// The derivatives of the residual with respect to the spins of both nodes; it does not depend on translations.
    pub struct UniversalRow<T> { g_rot_ta: Vector3<T> = G_ROT_TA, g_rot_tb: Vector3<T> = G_ROT_TB }
}

/// The row of UNIVERSAL: e1a × e3b with respect to the spin of a, its opposite with respect to that of b.
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
    .eta_of_value(1.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = CrossAxes<T>;
    type Outputs<T: Component> = UniversalRow<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossAxes<D>) -> UniversalRow<D> {
        let across = i.e1a.cross(&i.e3b);
        UniversalRow { g_rot_ta: across, g_rot_tb: -across }
    }
}

fields! {
    /// The axes of the cross, and the multiplier.
    pub struct UniversalLoads<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B, lambda_rot: T = LAMBDA_ROT }
}
fields! {
    /// The moments of UNIVERSAL on its nodes.
    pub struct UniversalMoments<T> { ma: Vector3<T> = MOMENT_A, mb: Vector3<T> = MOMENT_B }
}

/// The moments of UNIVERSAL on its nodes, Rowsᵀ λ: λ e1a × e3b on a, its opposite on b.
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
    .eta_of_value(1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = UniversalLoads<T>;
    type Outputs<T: Component> = UniversalMoments<T>;

    #[inline]
    fn eval<D: Scalar>(i: &UniversalLoads<D>) -> UniversalMoments<D> {
        let ma = i.e1a.cross(&i.e3b) * i.lambda_rot;
        UniversalMoments { ma, mb: -ma }
    }
}

fields! {
    /// The derivatives of UNIVERSAL's moments with respect to the spins, with the multiplier held.
    ///
    /// The derivative of the moment on b with respect to the spin of a is the transpose of that of the moment on a with respect
    /// to the spin of b.
    pub struct UniversalStiffness<T> {
        k_ta_ta: Matrix3<T> = K_TA_TA, k_ta_tb: Matrix3<T> = K_TA_TB, k_tb_tb: Matrix3<T> = K_TB_TB,
    }
}

/// The geometric stiffness of UNIVERSAL, λ ∂²g with respect to spins, without symmetrisation: unsymmetric.
///
/// One matrix, λ (e1a ⊗ e3b − (e1a·e3b) I), appears in all blocks: unchanged, transposed, or with the opposite sign.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl<D: Scalar> UniversalLoads<D> {
    #[inline(always)]
    fn block(&self) -> Matrix3<D> {
        double_cross(&self.e1a, &self.e3b) * self.lambda_rot
    }
}

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new(
        "universal.geometric_stiffness",
        "Geometric stiffness of UNIVERSAL",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; it is the derivative of its nodal moments"),
    )
    .equation(r"\mathbf{K}_{\theta a,\theta a} = \lambda_{\mathrm{rot}}(\mathbf{e}_{1a}\otimes\mathbf{e}_{3b} - (\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})\,\mathbf{I}),\quad \mathbf{K}_{\theta b,\theta b} = \lambda_{\mathrm{rot}}(\mathbf{e}_{3b}\otimes\mathbf{e}_{1a} - (\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})\,\mathbf{I}),\quad \mathbf{K}_{\theta a,\theta b} = -\mathbf{K}_{\theta b,\theta b}")
    .eta_of_value(1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = UniversalLoads<T>;
    type Outputs<T: Component> = UniversalStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &UniversalLoads<D>) -> UniversalStiffness<D> {
        let block = i.block();
        let transposed = block.transpose();
        UniversalStiffness { k_ta_ta: block, k_ta_tb: -transposed, k_tb_tb: transposed }
    }
}
