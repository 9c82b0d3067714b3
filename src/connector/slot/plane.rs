//! SLOT in the plane as an element: one residual, and a single spin per node.
//!
//! The order of the six degrees of freedom is u_a, θ_a, u_b, θ_b. A spin is positive from the first axis to the second: δe = δθ s
//! × e, where s × e is e rotated by 90° to the left. Rotations in the plane commute, so that the geometric stiffness is
//! symmetric.

#[cfg(feature = "verify")]
mod proof;

use crate::fields;
use crate::formula::quantity::{
    E2A_PLANE, F2, FORCE_A_PLANE, FORCE_B_PLANE, GY_TA_PLANE, GY_UA_PLANE, GY_UB_PLANE, K_TA_TA_PLANE, K_UA_TA_PLANE,
    MOMENT_A_PLANE, XA_PLANE, XB_PLANE,
};
use crate::formula::{Component, Document, Finite, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix6, Vector2, Vector6};

fields! {
    /// The positions of both nodes, and the axis normal to the slot.
    pub struct PlanePlaces<T> {
        e2a: Vector2<T> = E2A_PLANE, xa: Vector2<T> = XA_PLANE, xb: Vector2<T> = XB_PLANE,
    }
}
fields! {
    /// The derivatives of the residual with respect to the translations of both nodes and the spin of a; the spin of b has no
    /// effect.
    pub struct PlaneRow<T> {
        gy_ua: Vector2<T> = GY_UA_PLANE, gy_ta: T = GY_TA_PLANE, gy_ub: Vector2<T> = GY_UB_PLANE,
    }
}

/// v rotated by 90° to the left.
#[inline]
fn left<D: Scalar>(v: &Vector2<D>) -> Vector2<D> {
    Vector2::new(-v.y, v.x)
}

/// The row of SLOT in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new(
        "slot.rows_2d",
        "Row of SLOT in the plane",
        Document::SLOT.ours("Description", "the page prints the residual; this is its derivative"),
    )
    .equation(r"\mathbf{g}_{y,ua} = -\mathbf{e}_{2a},\quad g_{y,\theta a} = (\mathbf{s}\times\mathbf{e}_{2a})\cdot(\mathbf{x}_b-\mathbf{x}_a),\quad \mathbf{g}_{y,ub} = \mathbf{e}_{2a}")
    .eta_of_value(1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = PlanePlaces<T>;
    type Outputs<T: Component> = PlaneRow<T>;

    #[inline]
    fn eval<D: Scalar>(i: &PlanePlaces<D>) -> PlaneRow<D> {
        PlaneRow { gy_ua: -i.e2a, gy_ta: i.e2a.perp(&(i.xb - i.xa)), gy_ub: i.e2a }
    }
}

fields! {
    /// The positions of both nodes, the axis normal to the slot, and the multiplier, which is the force along this axis.
    pub struct PlaneLoads<T> {
        e2a: Vector2<T> = E2A_PLANE, xa: Vector2<T> = XA_PLANE, xb: Vector2<T> = XB_PLANE, f2: T = F2,
    }
}
fields! {
    /// The forces of SLOT on its nodes in the plane; there is no moment on b.
    pub struct PlaneForces<T> {
        fa: Vector2<T> = FORCE_A_PLANE, ma: T = MOMENT_A_PLANE, fb: Vector2<T> = FORCE_B_PLANE,
    }
}

impl<D: Scalar> PlaneLoads<D> {
    /// The force on b.
    #[inline]
    fn force(&self) -> Vector2<D> {
        self.e2a * self.f2
    }
}

/// The forces of SLOT on its nodes in the plane, the multiplier times the row: the documented force f2 e2a on b, its opposite and
/// its moment on a.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new(
        "slot.nodal_forces_2d",
        "Nodal forces of SLOT in the plane",
        Document::SLOT.ours("Description", "the page prints the force on b; on a is what balances it"),
    )
    .equation(r"\mathbf{f}_b = f_2\,\mathbf{e}_{2a},\quad \mathbf{f}_a = -\mathbf{f}_b,\quad m_a = (\mathbf{s}\times\mathbf{f}_b)\cdot(\mathbf{x}_b-\mathbf{x}_a)")
    .eta_of_value(1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = PlaneLoads<T>;
    type Outputs<T: Component> = PlaneForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &PlaneLoads<D>) -> PlaneForces<D> {
        let f = i.force();
        PlaneForces { fa: -f, ma: f.perp(&(i.xb - i.xa)), fb: f }
    }
}

fields! {
    /// The derivatives of SLOT's nodal forces in the plane with respect to the spin of a, with the multiplier held.
    pub struct PlaneStiffness<T> { k_ua_ta: Vector2<T> = K_UA_TA_PLANE, k_ta_ta: T = K_TA_TA_PLANE }
}

/// The geometric stiffness of SLOT in the plane, λ ∂²g with respect to translations and spins: symmetric.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new(
        "slot.geometric_stiffness_2d",
        "Geometric stiffness of SLOT in the plane",
        Document::SLOT.ours("Description", "the page prints the residual; it is the derivative of its nodal forces"),
    )
    .equation(r"\mathbf{f} = f_2\,\mathbf{e}_{2a},\quad \mathbf{k}_{ua,\theta a} = -\mathbf{s}\times\mathbf{f},\quad k_{\theta a,\theta a} = -\mathbf{f}\cdot(\mathbf{x}_b-\mathbf{x}_a)")
    .eta_of_value(1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = PlaneLoads<T>;
    type Outputs<T: Component> = PlaneStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &PlaneLoads<D>) -> PlaneStiffness<D> {
        let f = i.force();
        PlaneStiffness { k_ua_ta: -left(&f), k_ta_ta: -f.dot(&(i.xb - i.xa)) }
    }
}

impl<D: Scalar> PlaneRow<D> {
    /// The row over the six degrees of freedom.
    pub fn vector(&self) -> Vector6<D> {
        Vector6::new(self.gy_ua.x, self.gy_ua.y, self.gy_ta, self.gy_ub.x, self.gy_ub.y, D::zero())
    }
}

impl<D: Scalar> PlaneForces<D> {
    /// The forces over the six degrees of freedom.
    pub fn vector(&self) -> Vector6<D> {
        Vector6::new(self.fa.x, self.fa.y, self.ma, self.fb.x, self.fb.y, D::zero())
    }
}

impl<D: Scalar> PlaneStiffness<D> {
    /// The assembled matrix.
    ///
    /// ```
    /// use jointproof::connector::slot::plane::{GeometricStiffness, PlaneLoads};
    /// use jointproof::formula::value;
    /// use nalgebra::Vector2;
    /// let loads = PlaneLoads { e2a: Vector2::y(), xa: Vector2::zeros(), xb: Vector2::new(3.0, 4.0), f2: 2.0 };
    /// let k = value::<GeometricStiffness>(&loads)?.matrix();
    /// assert_eq!((k[(0, 2)], k[(3, 2)], k[(2, 2)]), (2.0, -2.0, -8.0)); // fa and fb by θ_a, m_a by θ_a
    /// assert_eq!(k, k.transpose());
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn matrix(&self) -> Matrix6<D> {
        let mut all = Matrix6::zeros();
        for (k, &force) in self.k_ua_ta.iter().enumerate() {
            for (node, entry) in [(0, force), (3, -force)] {
                all[(node + k, 2)] = entry;
                all[(2, node + k)] = entry;
            }
        }
        all[(2, 2)] = self.k_ta_ta;
        all
    }
}
