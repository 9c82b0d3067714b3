//! TRANSLATOR as an element: rows, forces and stiffness of SLOT and of ALIGN, five residuals on twelve degrees of freedom.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]
#![expect(clippy::unused_self, reason = "all gradients are asked for by methods alike")]

#[cfg(feature = "verify")]
mod proof;

use super::NodalForces;
use super::align::{self, AlignLoads, AlignRows, AlignStiffness, Curved, Loaded, Turns};
use super::join::JoinStiffness;
use super::lever::Lever;
use super::products::{column, matrix};
use super::slot::{self, SlotLoads, SlotPlaces, SlotRows};
use super::universal::UniversalMoments;
use crate::element::cardan::Triads;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    E1A, E1B, E2A, E2B, E3A, E3B, F2, F3, GY_TA, GY_UA, GY_UB, GZ_TA, GZ_UA, GZ_UB, K_TA_TA, K_TB_TB, K_UA_TA,
    LAMBDA_R1, LAMBDA_R2, LAMBDA_R3, UR1_TB, UR2_TB, UR3_TB, XA, XB,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Given, Jacobian, Source, Spec, ValueAndJacobian};
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
        // rows at 45 000 random points up to 48. By vectors it is 7.
        .eta(8.0, 48.0)
        .by_vectors(4.0, 8.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = TranslatorPlaces<T>;
    type Outputs<T: Component> = TranslatorRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &TranslatorPlaces<D>) -> TranslatorRows<D> {
        TranslatorRows::of(slot::Rows::eval(&i.slot()), align::Rows::eval(&i.triads()))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &TranslatorPlaces<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &TranslatorPlaces<D>) -> ValueAndJacobian<Self, D> {
        let turns = Turns::new(&i.triads());
        let one = D::one();
        let gradients = TranslatorRows {
            gy_ua: column!(i.of_y, -one),
            gy_ta: column!(i.of_moment_of_y),
            gy_ub: column!(i.of_y, one),
            gz_ua: column!(i.of_z, -one),
            gz_ta: column!(i.of_moment_of_z),
            gz_ub: column!(i.of_z, one),
            ur1_tb: column!(i.of_ur1, &turns),
            ur2_tb: column!(i.of_ur2, &turns),
            ur3_tb: column!(i.of_ur3, &turns),
        };
        let [ur1_tb, ur2_tb, ur3_tb] = turns.rows();
        (TranslatorRows::of(slot::Rows::eval(&i.slot()), AlignRows { ur1_tb, ur2_tb, ur3_tb }), gradients)
    }

    #[inline]
    fn validate<D: Scalar>(i: &TranslatorPlaces<D>) -> Result<(), Error> {
        align::Rows::validate(&i.triads())
    }
}

impl<D: Scalar> TranslatorPlaces<D> {
    #[inline(always)]
    fn by_slot(SlotPlaces { e2a, e3a, xa, xb }: SlotPlaces<D>) -> Self {
        Self { e2a, e3a, xa, xb, ..Self::filled(D::zero()) }
    }
    #[inline(always)]
    fn by_triads(triads: &Triads<D>) -> Self {
        Self::new(triads, [Vector3::from_element(D::zero()); 2])
    }

    // The gradients of k-th components, as SLOT and ALIGN have them.

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_y(&self, sign: D, k: usize) -> Self {
        Self::by_slot(self.slot().of_y(sign, k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_z(&self, sign: D, k: usize) -> Self {
        Self::by_slot(self.slot().of_z(sign, k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_moment_of_y(&self, k: usize) -> Self {
        Self::by_slot(self.slot().of_moment_of_y(k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_moment_of_z(&self, k: usize) -> Self {
        Self::by_slot(self.slot().of_moment_of_z(k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_ur1(&self, turns: &Turns<D>, k: usize) -> Self {
        Self::by_triads(&turns.of_ur1(D::one(), k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_ur2(&self, turns: &Turns<D>, k: usize) -> Self {
        Self::by_triads(&turns.of_ur2(D::one(), k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_ur3(&self, turns: &Turns<D>, k: usize) -> Self {
        Self::by_triads(&turns.of_ur3(D::one(), k))
    }
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
    /// A gradient by the inputs of SLOT.
    #[inline(always)]
    fn by_slot(slot: SlotLoads<D>) -> Self {
        let SlotLoads { e2a, e3a, xa, xb, f2, f3 } = slot;
        Self { e2a, e3a, xa, xb, f2, f3, ..Self::filled(D::zero()) }
    }

    /// A gradient by the inputs of ALIGN.
    #[inline(always)]
    fn by_align(align: AlignLoads<D>) -> Self {
        Self::new(&SlotLoads::filled(D::zero()), &align)
    }

    /// The gradient of a sum of something of SLOT and something of ALIGN.
    #[inline(always)]
    fn by_both(slot: SlotLoads<D>, align: AlignLoads<D>) -> Self {
        let (e2a, e3a) = (slot.e2a + align.e2a, slot.e3a + align.e3a);
        Self { e2a, e3a, ..Self::new(&slot, &align) }
    }

    // The gradients of k-th components, as SLOT and ALIGN have them.

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_fa(&self, k: usize) -> Self {
        Self::by_slot(self.slot().of_fa(k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_fb(&self, k: usize) -> Self {
        Self::by_slot(self.slot().of_fb(k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_ma(&self, loaded: &Loaded<D>, k: usize) -> Self {
        Self::by_both(self.slot().of_ma(k), loaded.of_ma(k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_mb(&self, loaded: &Loaded<D>, k: usize) -> Self {
        Self::by_align(loaded.of_mb(k))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_k_ua_ta(&self, row: usize, column: usize) -> Self {
        Self::by_slot(self.slot().of_k_ua_ta(row, column))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_k_tb_tb(&self, align: &AlignStiffness<AlignLoads<D>>, row: usize, column: usize) -> Self {
        Self::by_align(align.k_tb_tb[(row, column)])
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_k_ta_ta(&self, align: &AlignStiffness<AlignLoads<D>>, row: usize, column: usize) -> Self {
        Self::by_both(self.slot().of_k_ta_ta(row, column), align.k_tb_tb[(column, row)])
    }
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
        .eta(6.0, 48.0)
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
    fn jacobian<D: Scalar>(i: &TranslatorLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &TranslatorLoads<D>) -> ValueAndJacobian<Self, D> {
        let (forces, loaded) = (slot::Forces::eval(&i.slot()), Loaded::new(&i.align()));
        let mb = loaded.moment();
        let value = NodalForces { fa: forces.fa, ma: forces.ma + -mb, fb: forces.fb, mb };
        let gradients = NodalForces {
            fa: column!(i.of_fa),
            ma: column!(i.of_ma, &loaded),
            fb: column!(i.of_fb),
            mb: column!(i.of_mb, &loaded),
        };
        (value, gradients)
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
        .eta(12.0, 48.0)
        .by_vectors(3.0, 24.0)
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
    fn jacobian<D: Scalar>(i: &TranslatorLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &TranslatorLoads<D>) -> ValueAndJacobian<Self, D> {
        let JoinStiffness { k_ua_ta, k_ta_ta } = slot::GeometricStiffness::eval(&i.slot());
        let curved = Curved::new(&i.align());
        let (k_tb_tb, align) = (curved.stiffness(), AlignStiffness { k_tb_tb: matrix!(curved.of_k_tb_tb) });
        (
            TranslatorStiffness { k_ua_ta, k_ta_ta: k_ta_ta + k_tb_tb.transpose(), k_tb_tb },
            TranslatorStiffness {
                k_ua_ta: matrix!(i.of_k_ua_ta),
                k_ta_ta: matrix!(i.of_k_ta_ta, &align),
                k_tb_tb: matrix!(i.of_k_tb_tb, &align),
            },
        )
    }

    #[inline]
    fn validate<D: Scalar>(i: &TranslatorLoads<D>) -> Result<(), Error> {
        align::GeometricStiffness::validate(&i.align())
    }
}
