//! UNIVERSAL as an element: one residual, the cosine between e1a and e3b, on which spins alone work.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::products::{
    column, double_cross, double_cross_gradient, matrix, symmetric, symmetric_gradient, symmetric_matrix,
};
use crate::connector::ujoint::CrossAxes;
use crate::fields;
use crate::formula::quantity::{
    E1A, E3B, G_ROT_TA, G_ROT_TB, K_TA_TA, K_TA_TB, K_TB_TB, LAMBDA_ROT, MOMENT_A, MOMENT_B, S_TA_TA, S_TB_TB,
};
use crate::formula::{Component, Document, Few, Finite, Formula, Jacobian, Sign, Spec, cross_gradient};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

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
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = CrossAxes<T>;
    type Outputs<T: Component> = UniversalRow<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossAxes<D>) -> UniversalRow<D> {
        let across = i.e1a.cross(&i.e3b);
        UniversalRow { g_rot_ta: across, g_rot_tb: -across }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &CrossAxes<D>) -> Jacobian<Self, D> {
        UniversalRow { g_rot_ta: column!(i.of_cross, D::one()), g_rot_tb: column!(i.of_cross, -D::one()) }
    }
}

impl<D: Scalar> CrossAxes<D> {
    /// The gradient of the k-th component of e1a × e3b, times a sign.
    #[inline(always)]
    pub(super) fn of_cross(&self, sign: D, k: usize) -> Self {
        let [by_e1a, by_e3b] = cross_gradient(&self.e1a, &self.e3b, k);
        Self { e1a: by_e1a.times(sign), e3b: by_e3b.times(sign) }
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
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = UniversalLoads<T>;
    type Outputs<T: Component> = UniversalMoments<T>;

    #[inline]
    fn eval<D: Scalar>(i: &UniversalLoads<D>) -> UniversalMoments<D> {
        let ma = i.e1a.cross(&i.e3b) * i.lambda_rot;
        UniversalMoments { ma, mb: -ma }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &UniversalLoads<D>) -> Jacobian<Self, D> {
        UniversalMoments { ma: column!(i.of_ma), mb: column!(i.of_mb) }
    }
}

fields! {
    /// How what UNIVERSAL exerts on its nodes changes with their spins, the multiplier held.
    ///
    /// The moment on b changes with the spin of a by the transpose of what that on a does with the spin of b.
    pub struct UniversalStiffness<T> {
        k_ta_ta: Matrix3<T> = K_TA_TA, k_ta_tb: Matrix3<T> = K_TA_TB, k_tb_tb: Matrix3<T> = K_TB_TB,
    }
}

/// The geometric stiffness of UNIVERSAL, λ ∂²g by spins, as it is: unsymmetric.
///
/// One matrix, λ (e1a ⊗ e3b − (e1a·e3b) I), is in all blocks: as it stands, transposed, and with the other sign.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl<D: Scalar> UniversalLoads<D> {
    #[inline(always)]
    fn block(&self) -> Matrix3<D> {
        double_cross(&self.e1a, &self.e3b) * self.lambda_rot
    }

    /// The gradient of something times λ, by e1a, e3b and λ: of what is so with this sign.
    #[inline(always)]
    fn gradient(&self, [by_e1a, by_e3b]: [Few<D>; 2], something: D, sign: Sign) -> Self {
        let by = |few: Few<D>| few.signed(sign, self.lambda_rot);
        Self { e1a: by(by_e1a), e3b: by(by_e3b), lambda_rot: sign.of(something) }
    }

    #[inline(always)]
    fn of_moment(&self, k: usize, sign: Sign) -> Self {
        self.gradient(cross_gradient(&self.e1a, &self.e3b, k), self.e1a.cross(&self.e3b)[k], sign)
    }

    #[inline(always)]
    fn of_block(&self, row: usize, column: usize, sign: Sign) -> Self {
        let (by_axes, own) = double_cross_gradient(&self.e1a, &self.e3b, row, column);
        let entry = double_cross(&self.e1a, &self.e3b)[(row, column)];
        self.gradient(by_axes, own.of(entry), own.of(sign))
    }

    /// The gradient of the k-th component of the moment on a.
    #[inline(always)]
    pub(super) fn of_ma(&self, k: usize) -> Self {
        self.of_moment(k, Sign::Plus)
    }

    /// The gradient of the k-th component of the moment on b.
    #[inline(always)]
    pub(super) fn of_mb(&self, k: usize) -> Self {
        self.of_moment(k, Sign::Minus)
    }

    /// The gradient of an entry of the block of a.
    #[inline(always)]
    pub(super) fn of_k_ta_ta(&self, row: usize, column: usize) -> Self {
        self.of_block(row, column, Sign::Plus)
    }

    /// The gradient of an entry of the block of a and b.
    #[inline(always)]
    pub(super) fn of_k_ta_tb(&self, row: usize, column: usize) -> Self {
        self.of_block(column, row, Sign::Minus)
    }

    /// The gradient of an entry of the block of b.
    #[inline(always)]
    pub(super) fn of_k_tb_tb(&self, row: usize, column: usize) -> Self {
        self.of_block(column, row, Sign::Plus)
    }

    /// The gradient of an entry of the symmetric part of either.
    #[inline(always)]
    pub(super) fn of_symmetric(&self, row: usize, column: usize) -> Self {
        let (by_axes, sign) = symmetric_gradient(&self.e1a, &self.e3b, row, column);
        let entry = symmetric(&double_cross(&self.e1a, &self.e3b))[(row, column)];
        self.gradient(by_axes, sign.of(entry), sign)
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
    .eta(1.5, 1.5)
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

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &UniversalLoads<D>) -> Jacobian<Self, D> {
        UniversalStiffness {
            k_ta_ta: matrix!(i.of_k_ta_ta),
            k_ta_tb: matrix!(i.of_k_ta_tb),
            k_tb_tb: matrix!(i.of_k_tb_tb),
        }
    }
}

fields! {
    /// The blocks of the geometric stiffness that are not symmetric, made so.
    pub struct UniversalSymmetric<T> { s_ta_ta: Matrix3<T> = S_TA_TA, s_tb_tb: Matrix3<T> = S_TB_TB }
}

/// The symmetric part of the geometric stiffness of UNIVERSAL; the other blocks are those of [`GeometricStiffness`].
#[derive(Clone, Copy, Debug)]
pub struct SymmetricStiffness;

impl Formula for SymmetricStiffness {
    const SPEC: Spec = Spec::new(
        "universal.symmetric_stiffness",
        "Symmetric part of the geometric stiffness of UNIVERSAL",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; for programs that solve symmetric equations"),
    )
    .equation(r"\mathbf{S}_{\theta a,\theta a} = \lambda_{\mathrm{rot}}(\tfrac12(\mathbf{e}_{1a}\otimes\mathbf{e}_{3b} + \mathbf{e}_{3b}\otimes\mathbf{e}_{1a}) - (\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})\,\mathbf{I}),\quad \mathbf{S}_{\theta b,\theta b} = \mathbf{S}_{\theta a,\theta a}")
    .eta(1.5, 1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = UniversalLoads<T>;
    type Outputs<T: Component> = UniversalSymmetric<T>;

    #[inline]
    fn eval<D: Scalar>(i: &UniversalLoads<D>) -> UniversalSymmetric<D> {
        let block = symmetric(&i.block());
        UniversalSymmetric { s_ta_ta: block, s_tb_tb: block }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &UniversalLoads<D>) -> Jacobian<Self, D> {
        let block = symmetric_matrix!(i.of_symmetric);
        UniversalSymmetric { s_ta_ta: block, s_tb_tb: block }
    }
}
