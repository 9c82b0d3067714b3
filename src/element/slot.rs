//! SLOT as an element: two residuals, the distances of b from the slot along two axes of a.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

#[cfg(feature = "verify")]
mod proof;

use super::join::{JoinForces, JoinStiffness};
use super::products::{double_cross, skew};
use crate::fields;
use crate::formula::quantity::{E2A, E3A, F2, F3, GY_TA, GY_UA, GY_UB, GZ_TA, GZ_UA, GZ_UB, XA, XB};
use crate::formula::{Component, Document, Finite, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// Where the nodes are, and the axes across the slot.
    pub struct SlotPlaces<T> {
        e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, xa: Vector3<T> = XA, xb: Vector3<T> = XB,
    }
}
fields! {
    /// The derivatives of both residuals by the translations of both nodes and the spin of a; that of b turns nothing.
    pub struct SlotRows<T> {
        gy_ua: Vector3<T> = GY_UA, gy_ta: Vector3<T> = GY_TA, gy_ub: Vector3<T> = GY_UB,
        gz_ua: Vector3<T> = GZ_UA, gz_ta: Vector3<T> = GZ_TA, gz_ub: Vector3<T> = GZ_UB,
    }
}

/// The rows of SLOT: the second and the third of JOIN.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new(
        "slot.rows",
        "Rows of SLOT",
        Document::SLOT.ours("Description", "the page prints the residuals; these are their derivatives"),
    )
    .equation(r"\begin{aligned} \mathbf{g}_{y,ua} &= -\mathbf{e}_{2a}, & \mathbf{g}_{y,\theta a} &= \mathbf{e}_{2a}\times(\mathbf{x}_b-\mathbf{x}_a), & \mathbf{g}_{y,ub} &= \mathbf{e}_{2a},\\ \mathbf{g}_{z,ua} &= -\mathbf{e}_{3a}, & \mathbf{g}_{z,\theta a} &= \mathbf{e}_{3a}\times(\mathbf{x}_b-\mathbf{x}_a), & \mathbf{g}_{z,ub} &= \mathbf{e}_{3a} \end{aligned}")
    .eta_of_value(1.5)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = SlotPlaces<T>;
    type Outputs<T: Component> = SlotRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotPlaces<D>) -> SlotRows<D> {
        let d = i.xb - i.xa;
        SlotRows {
            gy_ua: -i.e2a,
            gy_ta: i.e2a.cross(&d),
            gy_ub: i.e2a,
            gz_ua: -i.e3a,
            gz_ta: i.e3a.cross(&d),
            gz_ub: i.e3a,
        }
    }
}

fields! {
    /// Where the nodes are, the axes across the slot, and the multipliers, which are the forces along them.
    pub struct SlotLoads<T> {
        e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, xa: Vector3<T> = XA, xb: Vector3<T> = XB, f2: T = F2, f3: T = F3,
    }
}

impl<D: Scalar> SlotLoads<D> {
    #[inline(always)]
    fn force(&self) -> Vector3<D> {
        self.e2a * self.f2 + self.e3a * self.f3
    }

    #[inline(always)]
    fn arm(&self) -> Vector3<D> {
        self.xb - self.xa
    }
}

/// What SLOT exerts on its nodes, Rowsᵀ λ: on b the documented force f2 e2a + f3 e3a, on a its opposite and its moment.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new(
        "slot.nodal_forces",
        "Nodal forces of SLOT",
        Document::SLOT.ours("Description", "the page prints the force on b; on a is what balances it"),
    )
    .equation(r"\mathbf{f}_b = f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{f}_a = -\mathbf{f}_b,\quad \mathbf{m}_a = \mathbf{f}_b\times(\mathbf{x}_b-\mathbf{x}_a)")
    .eta_of_value(1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = SlotLoads<T>;
    type Outputs<T: Component> = JoinForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotLoads<D>) -> JoinForces<D> {
        let f = i.force();
        JoinForces { fa: -f, ma: f.cross(&i.arm()), fb: f }
    }
}

/// The geometric stiffness of SLOT, Σ λ ∂²g by translations and spins, as it is: unsymmetric in the spins.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new(
        "slot.geometric_stiffness",
        "Geometric stiffness of SLOT",
        Document::SLOT.ours("Description", "the page prints the residuals; it is the derivative of their nodal forces"),
    )
    .equation(r"\mathbf{f} = f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{d} = \mathbf{x}_b-\mathbf{x}_a,\quad \mathbf{K}_{ua,\theta a} = \mathbf{f}\times\mathbf{I},\quad \mathbf{K}_{\theta a,\theta a} = \mathbf{f}\otimes\mathbf{d} - (\mathbf{f}\cdot\mathbf{d})\,\mathbf{I}")
    .eta_of_value(1.5)
    .scale(1e120)
    .finite(Finite::Below);
    type Inputs<T: Component> = SlotLoads<T>;
    type Outputs<T: Component> = JoinStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotLoads<D>) -> JoinStiffness<D> {
        let f = i.force();
        JoinStiffness { k_ua_ta: skew(&f), k_ta_ta: double_cross(&f, &i.arm()) }
    }
}
