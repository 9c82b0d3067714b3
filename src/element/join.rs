//! JOIN as an element: three residuals, each the distance of b from its place along one axis of a.

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::products::{
    Sparse, column, cross_gradient, double_cross, double_cross_gradient, matrix, skew, skew_gradient, symmetric,
    symmetric_gradient,
};
use crate::fields;
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec, along};
use crate::quantity::{
    E1A, E2A, E3A, F2, F3, FORCE_A, FORCE_B, G1_TA, G1_UA, G1_UB, G2_TA, G2_UA, G2_UB, G3_TA, G3_UA, G3_UB, JOIN_F1,
    K_TA_TA, K_UA_TA, MOMENT_A, S_TA_TA, XA, XB,
};
use crate::scalar::Scalar;
use crate::slot::Positions;
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
    .finite(Finite::Below);
    type Inputs<T: Component> = Positions<T>;
    type Outputs<T: Component> = JoinRows<T>;

    #[inline(always)]
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
        JoinRows::gradients(i, |gradient| gradient)
    }
}

impl<I: Component> JoinRows<I> {
    /// The gradients, as they are written where there are more inputs.
    #[inline(always)]
    pub(super) fn gradients<D: Scalar>(i: &Positions<D>, written: impl Fn(Positions<D>) -> I) -> Self {
        let zero = Positions::filled(D::zero());
        let with = |axis: usize, e: Vector3<D>| match axis {
            0 => Positions { e1a: e, ..zero },
            1 => Positions { e2a: e, ..zero },
            _ => Positions { e3a: e, ..zero },
        };
        let of_axis = |axis: usize, sign: D| column(|k| written(with(axis, along(k, sign))));
        let d = i.xb - i.xa;
        let moment = |axis: usize, e: &Vector3<D>| {
            column(|k| {
                let [by_e, by_d] = cross_gradient(e, &d, k);
                written(Positions { xa: by_d.negative(), xb: by_d.dense(), ..with(axis, by_e.dense()) })
            })
        };
        let one = D::one();
        JoinRows {
            g1_ua: of_axis(0, -one),
            g1_ta: moment(0, &i.e1a),
            g1_ub: of_axis(0, one),
            g2_ua: of_axis(1, -one),
            g2_ta: moment(1, &i.e2a),
            g2_ub: of_axis(1, one),
            g3_ua: of_axis(2, -one),
            g3_ta: moment(2, &i.e3a),
            g3_ub: of_axis(2, one),
        }
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

impl<D: Scalar> JoinLoads<D> {
    /// The force on b.
    #[inline(always)]
    pub(super) fn force(&self) -> Vector3<D> {
        self.e1a * self.f1 + self.e2a * self.f2 + self.e3a * self.f3
    }

    /// From a to b.
    #[inline(always)]
    pub(super) fn arm(&self) -> Vector3<D> {
        self.xb - self.xa
    }

    /// The gradient of something by what it is made of, the force on b and the vector from a to b, by the inputs.
    #[inline(always)]
    pub(super) fn gradient(&self, by_force: &Sparse<D>, by_arm: &Sparse<D>) -> Self {
        Self {
            e1a: by_force.times(self.f1),
            e2a: by_force.times(self.f2),
            e3a: by_force.times(self.f3),
            xa: by_arm.negative(),
            xb: by_arm.dense(),
            f1: by_force.dot(&self.e1a),
            f2: by_force.dot(&self.e2a),
            f3: by_force.dot(&self.e3a),
        }
    }

    /// The gradient of an entry of f × I.
    #[inline(always)]
    pub(super) fn of_force(&self, row: usize, column: usize) -> Self {
        self.gradient(&skew_gradient(row, column), &Sparse::none())
    }

    /// The gradient of an entry of f ⊗ d − (f·d) I.
    #[inline(always)]
    pub(super) fn of_turn(&self, row: usize, column: usize) -> Self {
        let [by_force, by_arm] = double_cross_gradient(&self.force(), &self.arm(), row, column);
        self.gradient(&by_force, &by_arm)
    }

    /// The same, of its symmetric part.
    #[inline(always)]
    pub(super) fn of_symmetric_turn(&self, row: usize, column: usize) -> Self {
        let [by_force, by_arm] = symmetric_gradient(&self.force(), &self.arm(), row, column);
        self.gradient(&by_force, &by_arm)
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
    .finite(Finite::Below);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinForces<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinForces<D> {
        let f = i.force();
        JoinForces { fa: -f, ma: f.cross(&i.arm()), fb: f }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        let (f, d) = (i.force(), i.arm());
        let (none, one) = (Vector3::from_element(D::zero()), D::one());
        let force = |sign: D| {
            column(|k| JoinLoads {
                e1a: along(k, i.f1 * sign),
                e2a: along(k, i.f2 * sign),
                e3a: along(k, i.f3 * sign),
                xa: none,
                xb: none,
                f1: i.e1a[k] * sign,
                f2: i.e2a[k] * sign,
                f3: i.e3a[k] * sign,
            })
        };
        let moment = |k: usize| {
            let [by_force, by_arm] = cross_gradient(&f, &d, k);
            i.gradient(&by_force, &by_arm)
        };
        JoinForces { fa: force(-one), ma: column(|k| moment(k)), fb: force(one) }
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
    .finite(Finite::Below);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinStiffness<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinStiffness<D> {
        let f = i.force();
        JoinStiffness { k_ua_ta: skew(&f), k_ta_ta: double_cross(&f, &i.arm()) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        JoinStiffness {
            k_ua_ta: matrix(|row, column| i.of_force(row, column)),
            k_ta_ta: matrix(|row, column| i.of_turn(row, column)),
        }
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
    .finite(Finite::Below);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinSymmetric<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinSymmetric<D> {
        JoinSymmetric { s_ta_ta: symmetric(&GeometricStiffness::eval(i).k_ta_ta) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        JoinSymmetric { s_ta_ta: matrix(|row, column| i.of_symmetric_turn(row, column)) }
    }
}
