//! JOIN as an element: three residuals, each the distance of b from its place along one axis of a.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]
#![expect(clippy::unused_self, reason = "all gradients are asked for by methods alike")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::lever::Lever;
use super::products::{column, double_cross, matrix, skew, symmetric, symmetric_matrix};
use crate::connector::slot::Positions;
use crate::fields;
use crate::formula::quantity::{
    E1A, E2A, E3A, F2, F3, FORCE_A, FORCE_B, G1_TA, G1_UA, G1_UB, G2_TA, G2_UA, G2_UB, G3_TA, G3_UA, G3_UB, JOIN_F1,
    K_TA_TA, K_UA_TA, MOMENT_A, S_TA_TA, XA, XB,
};
use crate::formula::{Component, Document, Few, Fields, Finite, Formula, Jacobian, Sign, Spec, along, cross_gradient};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

fields! {
    /// The derivatives of the three residuals by the translations of both nodes and the spin of a; that of b turns nothing.
    pub struct JoinRows<T> {
        g1_ua: Vector3<T> = G1_UA, g1_ta: Vector3<T> = G1_TA, g1_ub: Vector3<T> = G1_UB,
        g2_ua: Vector3<T> = G2_UA, g2_ta: Vector3<T> = G2_TA, g2_ub: Vector3<T> = G2_UB,
        g3_ua: Vector3<T> = G3_UA, g3_ta: Vector3<T> = G3_TA, g3_ub: Vector3<T> = G3_UB,
    }
}

/// The rows of JOIN: −e_ia by the translation of a, e_ia × (xb − xa) by its spin, e_ia by the translation of b.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new(
        "join.rows",
        "Rows of JOIN",
        Document::UJOINT.ours("Description", "the page of JOIN was not given; these are the derivatives of its residuals"),
    )
    .equation(r"\mathbf{g}_{i,ua} = -\mathbf{e}_{ia},\quad \mathbf{g}_{i,\theta a} = \mathbf{e}_{ia}\times(\mathbf{x}_b-\mathbf{x}_a),\quad \mathbf{g}_{i,ub} = \mathbf{e}_{ia}\quad (i = 1, 2, 3)")
    .eta(1.5, 1.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Positions<T>;
    type Outputs<T: Component> = JoinRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Positions<D>) -> JoinRows<D> {
        let d = i.xb - i.xa;
        JoinRows {
            g1_ua: -i.e1a,
            g1_ta: i.e1a.cross(&d),
            g1_ub: i.e1a,
            g2_ua: -i.e2a,
            g2_ta: i.e2a.cross(&d),
            g2_ub: i.e2a,
            g3_ua: -i.e3a,
            g3_ta: i.e3a.cross(&d),
            g3_ub: i.e3a,
        }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Positions<D>) -> Jacobian<Self, D> {
        let one = D::one();
        JoinRows {
            g1_ua: column!(i.of_axis, 0, -one),
            g1_ta: column!(i.of_moment, 0),
            g1_ub: column!(i.of_axis, 0, one),
            g2_ua: column!(i.of_axis, 1, -one),
            g2_ta: column!(i.of_moment, 1),
            g2_ub: column!(i.of_axis, 1, one),
            g3_ua: column!(i.of_axis, 2, -one),
            g3_ta: column!(i.of_moment, 2),
            g3_ub: column!(i.of_axis, 2, one),
        }
    }
}

impl<D: Scalar> Positions<D> {
    #[inline(always)]
    fn axis(&self, n: usize) -> Vector3<D> {
        match n {
            0 => self.e1a,
            1 => self.e2a,
            _ => self.e3a,
        }
    }

    /// A gradient by the n-th axis alone.
    #[inline(always)]
    fn by_axis(n: usize, by_axis: Vector3<D>) -> Self {
        let zero = Self::filled(D::zero());
        match n {
            0 => Self { e1a: by_axis, ..zero },
            1 => Self { e2a: by_axis, ..zero },
            _ => Self { e3a: by_axis, ..zero },
        }
    }

    /// The gradient of the k-th component of the n-th axis, times a sign.
    #[inline(always)]
    pub(super) fn of_axis(&self, n: usize, sign: D, k: usize) -> Self {
        Self::by_axis(n, along(k, sign))
    }

    /// The gradient of the k-th component of the n-th axis × (xb − xa).
    #[inline(always)]
    pub(super) fn of_moment(&self, n: usize, k: usize) -> Self {
        let [by_axis, by_arm] = cross_gradient(&self.axis(n), &(self.xb - self.xa), k);
        Self { xa: by_arm.times(-D::one()), xb: by_arm.vector(), ..Self::by_axis(n, by_axis.vector()) }
    }
}

fields! {
    /// Where the nodes are, how node a is turned, and the multipliers, which are the forces along its triad.
    pub struct JoinLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, xa: Vector3<T> = XA, xb: Vector3<T> = XB,
        f1: T = JOIN_F1, f2: T = F2, f3: T = F3,
    }
}
fields! {
    /// What JOIN exerts on its nodes; on b no moment.
    pub struct JoinForces<T> { fa: Vector3<T> = FORCE_A, ma: Vector3<T> = MOMENT_A, fb: Vector3<T> = FORCE_B }
}

impl<D: Scalar> Lever<D> for JoinLoads<D> {
    #[inline(always)]
    fn force(&self) -> Vector3<D> {
        self.e1a * self.f1 + self.e2a * self.f2 + self.e3a * self.f3
    }

    #[inline(always)]
    fn arm(&self) -> Vector3<D> {
        self.xb - self.xa
    }

    #[inline(always)]
    fn gradient(&self, ([by_force, by_arm], sign): ([Few<D>; 2], Sign)) -> Self {
        Self {
            e1a: by_force.signed(sign, self.f1),
            e2a: by_force.signed(sign, self.f2),
            e3a: by_force.signed(sign, self.f3),
            xa: by_arm.signed(-sign, D::one()),
            xb: by_arm.signed(sign, D::one()),
            f1: sign.of(by_force.dot(&self.e1a)),
            f2: sign.of(by_force.dot(&self.e2a)),
            f3: sign.of(by_force.dot(&self.e3a)),
        }
    }
}

/// What JOIN exerts on its nodes, Rowsᵀ λ: on b the force f1 e1a + f2 e2a + f3 e3a, on a its opposite and its moment.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new(
        "join.nodal_forces",
        "Nodal forces of JOIN",
        Document::UJOINT.ours("Description", "the page of JOIN was not given; these do the work of its multipliers"),
    )
    .equation(r"\mathbf{f}_b = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{f}_a = -\mathbf{f}_b,\quad \mathbf{m}_a = \mathbf{f}_b\times(\mathbf{x}_b-\mathbf{x}_a)")
    .eta(1.5, 1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinForces<D> {
        let f = i.force();
        JoinForces { fa: -f, ma: f.cross(&i.arm()), fb: f }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        JoinForces { fa: column!(i.of_fa), ma: column!(i.of_ma), fb: column!(i.of_fb) }
    }
}

fields! {
    /// How what JOIN exerts on a changes with the spin of a, the multipliers held.
    ///
    /// The force on b changes by the opposite of that on a, and the other blocks follow from symmetry; all else is zero.
    pub struct JoinStiffness<T> { k_ua_ta: Matrix3<T> = K_UA_TA, k_ta_ta: Matrix3<T> = K_TA_TA }
}

/// The geometric stiffness of JOIN, Σ λ ∂²g by translations and spins, as it is: unsymmetric in the spins.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new(
        "join.geometric_stiffness",
        "Geometric stiffness of JOIN",
        Document::UJOINT.ours("Description", "the page of JOIN was not given; it is the derivative of its nodal forces"),
    )
    .equation(r"\mathbf{f} = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{d} = \mathbf{x}_b-\mathbf{x}_a,\quad \mathbf{K}_{ua,\theta a} = \mathbf{f}\times\mathbf{I},\quad \mathbf{K}_{\theta a,\theta a} = \mathbf{f}\otimes\mathbf{d} - (\mathbf{f}\cdot\mathbf{d})\,\mathbf{I}")
    .eta(1.5, 1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinStiffness<D> {
        let f = i.force();
        JoinStiffness { k_ua_ta: skew(&f), k_ta_ta: double_cross(&f, &i.arm()) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        // These two by components: copied whole they go through memory, and results are stored 15 times more.
        let i = &JoinLoads { e1a: i.e1a.xyz(), e2a: i.e2a.xyz(), ..*i };
        JoinStiffness { k_ua_ta: matrix!(i.of_k_ua_ta), k_ta_ta: matrix!(i.of_k_ta_ta) }
    }
}

fields! {
    /// The block of the geometric stiffness that is not symmetric, made so.
    pub struct JoinSymmetric<T> { s_ta_ta: Matrix3<T> = S_TA_TA }
}

/// The symmetric part of the geometric stiffness of JOIN; the other blocks are those of [`GeometricStiffness`].
#[derive(Clone, Copy, Debug)]
pub struct SymmetricStiffness;

impl Formula for SymmetricStiffness {
    const SPEC: Spec = Spec::new(
        "join.symmetric_stiffness",
        "Symmetric part of the geometric stiffness of JOIN",
        Document::UJOINT.ours("Description", "the page of JOIN was not given; for programs that solve symmetric equations"),
    )
    .equation(r"\mathbf{f} = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{d} = \mathbf{x}_b-\mathbf{x}_a,\quad \mathbf{S}_{\theta a,\theta a} = \tfrac12(\mathbf{f}\otimes\mathbf{d} + \mathbf{d}\otimes\mathbf{f}) - (\mathbf{f}\cdot\mathbf{d})\,\mathbf{I}")
    .eta(1.5, 1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinSymmetric<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinSymmetric<D> {
        JoinSymmetric { s_ta_ta: symmetric(&GeometricStiffness::eval(i).k_ta_ta) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        // By components, as for the geometric stiffness: copied whole it goes through memory.
        let i = &JoinLoads { e2a: i.e2a.xyz(), ..*i };
        JoinSymmetric { s_ta_ta: symmetric_matrix!(i.of_s_ta_ta) }
    }
}
