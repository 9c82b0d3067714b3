//! UJOINT as an element: the rows and forces of JOIN and of UNIVERSAL, four residuals on twelve degrees of freedom.

#[cfg(feature = "verify")]
mod proof;

use super::NodalForces;
use super::join::{self, JoinForces, JoinLoads, JoinRows, JoinStiffness};
use super::universal::{self, UniversalLoads, UniversalRow, UniversalStiffness};
use crate::connector::slot::Positions;
use crate::connector::ujoint::CrossAxes;
use crate::fields;
use crate::formula::quantity::{
    E1A, E2A, E3A, E3B, F2, F3, G_ROT_TA, G_ROT_TB, G1_TA, G1_UA, G1_UB, G2_TA, G2_UA, G2_UB, G3_TA, G3_UA, G3_UB,
    JOIN_F1, K_TA_TA, K_TA_TB, K_TB_TB, K_UA_TA, LAMBDA_ROT, XA, XB,
};
use crate::formula::{Component, Document, Finite, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

fields! {
    /// Where the nodes are, and how they are turned.
    pub struct JointPlaces<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
    }
}
fields! {
    /// The derivatives of the four residuals by translations and spins that are not zero everywhere.
    pub struct JointRows<T> {
        g1_ua: Vector3<T> = G1_UA, g1_ta: Vector3<T> = G1_TA, g1_ub: Vector3<T> = G1_UB,
        g2_ua: Vector3<T> = G2_UA, g2_ta: Vector3<T> = G2_TA, g2_ub: Vector3<T> = G2_UB,
        g3_ua: Vector3<T> = G3_UA, g3_ta: Vector3<T> = G3_TA, g3_ub: Vector3<T> = G3_UB,
        g_rot_ta: Vector3<T> = G_ROT_TA, g_rot_tb: Vector3<T> = G_ROT_TB,
    }
}

impl<T: Component> JointPlaces<T> {
    #[inline]
    const fn positions(&self) -> Positions<T> {
        let Self { e1a, e2a, e3a, xa, xb, .. } = *self;
        Positions { e1a, e2a, e3a, xa, xb }
    }
    #[inline]
    const fn axes(&self) -> CrossAxes<T> {
        let Self { e1a, e3b, .. } = *self;
        CrossAxes { e1a, e3b }
    }
}

impl<T: Component> JointRows<T> {
    #[inline]
    fn of(join: JoinRows<T>, universal: UniversalRow<T>) -> Self {
        let JoinRows { g1_ua, g1_ta, g1_ub, g2_ua, g2_ta, g2_ub, g3_ua, g3_ta, g3_ub } = join;
        let UniversalRow { g_rot_ta, g_rot_tb } = universal;
        Self { g1_ua, g1_ta, g1_ub, g2_ua, g2_ta, g2_ub, g3_ua, g3_ta, g3_ub, g_rot_ta, g_rot_tb }
    }
}

/// The rows of UJOINT: JOIN's three and UNIVERSAL's one.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new(
        "ujoint.rows",
        "Rows of UJOINT",
        Document::UJOINT.ours("Description", "the page names the residuals; these are their derivatives"),
    )
    .equation(r"\mathbf{g}_{i,ua} = -\mathbf{e}_{ia},\quad \mathbf{g}_{i,\theta a} = \mathbf{e}_{ia}\times(\mathbf{x}_b-\mathbf{x}_a),\quad \mathbf{g}_{i,ub} = \mathbf{e}_{ia}\quad (i = 1, 2, 3),\quad \mathbf{g}_{\mathrm{rot},\theta a} = \mathbf{e}_{1a}\times\mathbf{e}_{3b},\quad \mathbf{g}_{\mathrm{rot},\theta b} = \mathbf{e}_{3b}\times\mathbf{e}_{1a}")
    .eta_of_value(1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = JointPlaces<T>;
    type Outputs<T: Component> = JointRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JointPlaces<D>) -> JointRows<D> {
        JointRows::of(join::Rows::eval(&i.positions()), universal::Rows::eval(&i.axes()))
    }
}

impl<D: Scalar> JointPlaces<D> {
    // The gradients of k-th components, as JOIN and UNIVERSAL have them.
}

fields! {
    /// Where the nodes are, how they are turned, and the four multipliers.
    pub struct JointLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB, f1: T = JOIN_F1, f2: T = F2, f3: T = F3, lambda_rot: T = LAMBDA_ROT,
    }
}

impl<T: Component> JointLoads<T> {
    #[inline]
    const fn of_join(&self) -> JoinLoads<T> {
        let Self { e1a, e2a, e3a, xa, xb, f1, f2, f3, .. } = *self;
        JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 }
    }
    #[inline]
    const fn of_universal(&self) -> UniversalLoads<T> {
        let Self { e1a, e3b, lambda_rot, .. } = *self;
        UniversalLoads { e1a, e3b, lambda_rot }
    }
}

impl<D: Scalar> JointLoads<D> {
    // The gradients of components and entries, as JOIN and UNIVERSAL have them.
}

/// What UJOINT exerts on its nodes, Rowsᵀ λ: the forces of JOIN and the moments of both.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new(
        "ujoint.nodal_forces",
        "Nodal forces of UJOINT",
        Document::UJOINT.ours("Description", "the page names the residuals; these do the work of their multipliers"),
    )
    .equation(r"\mathbf{f}_b = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{f}_a = -\mathbf{f}_b,\quad \mathbf{m}_a = \mathbf{f}_b\times(\mathbf{x}_b-\mathbf{x}_a) + \lambda_{\mathrm{rot}}\,\mathbf{e}_{1a}\times\mathbf{e}_{3b},\quad \mathbf{m}_b = \lambda_{\mathrm{rot}}\,\mathbf{e}_{3b}\times\mathbf{e}_{1a}")
    .eta_of_value(1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = JointLoads<T>;
    type Outputs<T: Component> = NodalForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JointLoads<D>) -> NodalForces<D> {
        let JoinForces { fa, ma, fb } = join::Forces::eval(&i.of_join());
        let moments = universal::Moments::eval(&i.of_universal());
        NodalForces { fa, ma: ma + moments.ma, fb, mb: moments.mb }
    }
}

fields! {
    /// How what UJOINT exerts on its nodes changes with their spins, the multipliers held: the blocks that differ.
    ///
    /// [`matrix`](JointStiffness::matrix) has them all in their places.
    pub struct JointStiffness<T> {
        k_ua_ta: Matrix3<T> = K_UA_TA, k_ta_ta: Matrix3<T> = K_TA_TA, k_ta_tb: Matrix3<T> = K_TA_TB,
        k_tb_tb: Matrix3<T> = K_TB_TB,
    }
}

/// The geometric stiffness of UJOINT, Σ λ ∂²g by translations and spins, as it is: unsymmetric in the spins.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new(
        "ujoint.geometric_stiffness",
        "Geometric stiffness of UJOINT",
        Document::UJOINT.ours("Description", "the page names the residuals; it is the derivative of their nodal forces"),
    )
    .equation(r"\mathbf{f} = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{d} = \mathbf{x}_b-\mathbf{x}_a,\quad \mathbf{K}_{ua,\theta a} = \mathbf{f}\times\mathbf{I},\quad \mathbf{K}_{\theta a,\theta a} = \mathbf{f}\otimes\mathbf{d} - (\mathbf{f}\cdot\mathbf{d})\,\mathbf{I} + \lambda_{\mathrm{rot}}(\mathbf{e}_{1a}\otimes\mathbf{e}_{3b} - (\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})\,\mathbf{I}),\quad \mathbf{K}_{\theta b,\theta b} = \lambda_{\mathrm{rot}}(\mathbf{e}_{3b}\otimes\mathbf{e}_{1a} - (\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})\,\mathbf{I}),\quad \mathbf{K}_{\theta a,\theta b} = -\mathbf{K}_{\theta b,\theta b}")
    .eta_of_value(1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = JointLoads<T>;
    type Outputs<T: Component> = JointStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JointLoads<D>) -> JointStiffness<D> {
        let JoinStiffness { k_ua_ta, k_ta_ta } = join::GeometricStiffness::eval(&i.of_join());
        let turned = universal::GeometricStiffness::eval(&i.of_universal());
        let UniversalStiffness { k_ta_tb, k_tb_tb, .. } = turned;
        JointStiffness { k_ua_ta, k_ta_ta: k_ta_ta + turned.k_ta_ta, k_ta_tb, k_tb_tb }
    }
}
