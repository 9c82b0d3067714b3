//! TRANSLATOR as an element: rows, forces and stiffness of SLOT and of ALIGN, five residuals on twelve degrees of freedom.

#[cfg(feature = "verify")]
mod proof;

use super::NodalForces;
use super::align::{self, AlignLoads, AlignRows, AlignStiffness};
use super::join::JoinStiffness;
use super::slot::{self, SlotLoads, SlotPlaces, SlotRows};
use super::universal::UniversalMoments;
use crate::connector::cardan::Triads;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    E1A, E1B, E2A, E2B, E3A, E3B, F2, F3, GY_TA, GY_UA, GY_UB, GZ_TA, GZ_UA, GZ_UB, K_TA_TA, K_TB_TB, K_UA_TA,
    LAMBDA_R1, LAMBDA_R2, LAMBDA_R3, UR1_TB, UR2_TB, UR3_TB, XA, XB,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Source, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// What all of them are derived from.
const OURS: Source =
    Document::TRANSLATOR.ours("Description", "the page names SLOT and ALIGN; these are made of theirs");

fields! {
    /// Where both nodes are, and how they are turned.
    pub struct TranslatorPlaces<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
    }
}
fields! {
    /// The derivatives of the five residuals by translations and spins that are not zero everywhere; those of the last
    /// three by the spin of a are the opposite of those by the spin of b.
    pub struct TranslatorRows<T> {
        gy_ua: Vector3<T> = GY_UA, gy_ta: Vector3<T> = GY_TA, gy_ub: Vector3<T> = GY_UB,
        gz_ua: Vector3<T> = GZ_UA, gz_ta: Vector3<T> = GZ_TA, gz_ub: Vector3<T> = GZ_UB,
        ur1_tb: Vector3<T> = UR1_TB, ur2_tb: Vector3<T> = UR2_TB, ur3_tb: Vector3<T> = UR3_TB,
    }
}

impl<T: Component> TranslatorRows<T> {
    #[inline]
    const fn of(slot: SlotRows<T>, align: AlignRows<T>) -> Self {
        let SlotRows { gy_ua, gy_ta, gy_ub, gz_ua, gz_ta, gz_ub } = slot;
        let AlignRows { ur1_tb, ur2_tb, ur3_tb } = align;
        Self { gy_ua, gy_ta, gy_ub, gz_ua, gz_ta, gz_ub, ur1_tb, ur2_tb, ur3_tb }
    }
}

impl<T: Component> TranslatorPlaces<T> {
    #[inline]
    const fn slot(&self) -> SlotPlaces<T> {
        let Self { e2a, e3a, xa, xb, .. } = *self;
        SlotPlaces { e2a, e3a, xa, xb }
    }

    /// The triads.
    #[inline]
    pub fn triads(&self) -> Triads<T> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, .. } = self;
        Triads::by_components([e1a, e2a, e3a], [e1b, e2b, e3b])
    }

    /// From both triads and places.
    #[inline]
    pub const fn new(triads: &Triads<T>, [xa, xb]: [Vector3<T>; 2]) -> Self {
        let Triads { e1a, e2a, e3a, e1b, e2b, e3b } = *triads;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb }
    }
}

/// The rows of TRANSLATOR: SLOT's two and ALIGN's three.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new("translator.rows", "Rows of TRANSLATOR", OURS)
        .equation(r"\begin{aligned} \mathbf{g}_{y,ua} &= -\mathbf{e}_{2a}, & \mathbf{g}_{y,\theta a} &= \mathbf{e}_{2a}\times(\mathbf{x}_b-\mathbf{x}_a), & \mathbf{g}_{y,ub} &= \mathbf{e}_{2a},\\ \mathbf{g}_{z,ua} &= -\mathbf{e}_{3a}, & \mathbf{g}_{z,\theta a} &= \mathbf{e}_{3a}\times(\mathbf{x}_b-\mathbf{x}_a), & \mathbf{g}_{z,ub} &= \mathbf{e}_{3a},\\ \mathbf{u}_{r1,\theta b} &= \mathbf{e}_{3b}\times\mathbf{u}_1, & \mathbf{u}_{r2,\theta b} &= \frac{\mathbf{e}_{3b}\times\mathbf{e}_{1a}}{\sqrt{1-(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})^2}}, & \mathbf{u}_{r3,\theta b} &= \mathbf{u}_3\times\mathbf{e}_{1a} \end{aligned}")
        .given(&[Given::new(r"\mathbf{u}_1,\ \mathbf{u}_3", &align::Rows::SPEC)])
        // An entry is a sum of terms that may cancel, and what inputs do to them with them; then their roundings remain: in the
        // rows at 45 000 random points up to 48. Normwise it is 7.
        .eta_of_value(8.0)
        .normwise_of_value(4.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = TranslatorPlaces<T>;
    type Outputs<T: Component> = TranslatorRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TranslatorPlaces<D>) -> TranslatorRows<D> {
        TranslatorRows::of(slot::Rows::eval(&i.slot()), align::Rows::eval(&i.triads()))
    }

    #[inline]
    fn validate<D: Scalar>(i: &TranslatorPlaces<D>) -> Result<(), Error> {
        align::Rows::validate(&i.triads())
    }
}

impl<D: Scalar> TranslatorPlaces<D> {
    // The gradients of k-th components, as SLOT and ALIGN have them.
}

fields! {
    /// Where both nodes are, how they are turned, and the five multipliers.
    pub struct TranslatorLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB, f2: T = F2, f3: T = F3,
        lambda_r1: T = LAMBDA_R1, lambda_r2: T = LAMBDA_R2, lambda_r3: T = LAMBDA_R3,
    }
}

impl<T: Component> TranslatorLoads<T> {
    /// From what SLOT and ALIGN see of it.
    #[inline]
    pub const fn new(slot: &SlotLoads<T>, align: &AlignLoads<T>) -> Self {
        let SlotLoads { xa, xb, f2, f3, .. } = *slot;
        let AlignLoads { e1a, e2a, e3a, e1b, e2b, e3b, lambda_r1, lambda_r2, lambda_r3 } = *align;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb, f2, f3, lambda_r1, lambda_r2, lambda_r3 }
    }

    /// What SLOT sees of it.
    #[inline]
    pub const fn slot(&self) -> SlotLoads<T> {
        let Self { e2a, e3a, xa, xb, f2, f3, .. } = *self;
        SlotLoads { e2a, e3a, xa, xb, f2, f3 }
    }

    /// What ALIGN sees of it.
    #[inline]
    pub fn align(&self) -> AlignLoads<T> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, .. } = self;
        let triads = Triads::by_components([e1a, e2a, e3a], [e1b, e2b, e3b]);
        AlignLoads::new(&triads, [self.lambda_r1, self.lambda_r2, self.lambda_r3])
    }
}

impl<D: Scalar> TranslatorLoads<D> {
    // The gradients of k-th components, as SLOT and ALIGN have them.
}

/// What TRANSLATOR exerts on its nodes, Rowsᵀ λ: the forces of SLOT and the moments of both.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

impl Formula for Forces {
    const SPEC: Spec = Spec::new("translator.nodal_forces", "Nodal forces of TRANSLATOR", OURS)
        .equation(r"\mathbf{f}_b = f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{f}_a = -\mathbf{f}_b,\quad \mathbf{m}_b = \lambda_{r1}\,\mathbf{u}_{r1,\theta b} + \lambda_{r2}\,\mathbf{u}_{r2,\theta b} + \lambda_{r3}\,\mathbf{u}_{r3,\theta b},\quad \mathbf{m}_a = \mathbf{f}_b\times(\mathbf{x}_b-\mathbf{x}_a) - \mathbf{m}_b")
        .given(&[Given::new(
            r"\mathbf{u}_{r1,\theta b},\ \mathbf{u}_{r2,\theta b},\ \mathbf{u}_{r3,\theta b}",
            &align::Rows::SPEC,
        )])
        // An entry is a sum of terms that may cancel, and what inputs do to them with them; then their roundings remain. Of the
        // rows at 20 000 random points the worst is 46.
        .eta_of_value(6.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = TranslatorLoads<T>;
    type Outputs<T: Component> = NodalForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TranslatorLoads<D>) -> NodalForces<D> {
        let forces = slot::Forces::eval(&i.slot());
        let UniversalMoments { ma, mb } = align::Moments::eval(&i.align());
        NodalForces { fa: forces.fa, ma: forces.ma + ma, fb: forces.fb, mb }
    }

    #[inline]
    fn validate<D: Scalar>(i: &TranslatorLoads<D>) -> Result<(), Error> {
        align::Moments::validate(&i.align())
    }
}

fields! {
    /// How what TRANSLATOR exerts on its nodes changes with their spins, the multipliers held: the blocks from which all
    /// are made.
    ///
    /// [`matrix`](TranslatorStiffness::matrix) has them in their places.
    pub struct TranslatorStiffness<T> {
        k_ua_ta: Matrix3<T> = K_UA_TA, k_ta_ta: Matrix3<T> = K_TA_TA, k_tb_tb: Matrix3<T> = K_TB_TB,
    }
}

/// The geometric stiffness of TRANSLATOR, Σ λ ∂²g by translations and spins, as it is: unsymmetric in the spins.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new("translator.geometric_stiffness", "Geometric stiffness of TRANSLATOR", OURS)
        .equation(r"\mathbf{f} = f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a},\quad \mathbf{d} = \mathbf{x}_b-\mathbf{x}_a,\quad \mathbf{K}_{ua,\theta a} = \mathbf{f}\times\mathbf{I},\quad \mathbf{K}_{\theta a,\theta a} = \mathbf{f}\otimes\mathbf{d} - (\mathbf{f}\cdot\mathbf{d})\,\mathbf{I} + \mathbf{K}_{\theta b,\theta b} + \mathbf{m}_b\times\mathbf{I}")
        .given(&[
            Given::new(r"\mathbf{K}_{\theta b,\theta b}", &align::GeometricStiffness::SPEC),
            Given::new(r"\mathbf{m}_b", &align::Moments::SPEC),
        ])
        .eta_of_value(12.0)
        .normwise_of_value(3.0)
        .scale(1e250);
    type Inputs<T: Component> = TranslatorLoads<T>;
    type Outputs<T: Component> = TranslatorStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TranslatorLoads<D>) -> TranslatorStiffness<D> {
        let JoinStiffness { k_ua_ta, k_ta_ta } = slot::GeometricStiffness::eval(&i.slot());
        let AlignStiffness { k_tb_tb } = align::GeometricStiffness::eval(&i.align());
        TranslatorStiffness { k_ua_ta, k_ta_ta: k_ta_ta + k_tb_tb.transpose(), k_tb_tb }
    }

    #[inline]
    fn validate<D: Scalar>(i: &TranslatorLoads<D>) -> Result<(), Error> {
        align::GeometricStiffness::validate(&i.align())
    }
}
