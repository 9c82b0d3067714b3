//! ALIGN as an element: three residuals, the Cardan angles of b relative to a.
//!
//! They depend only on the difference of both spins: the rows for the spin of a are the opposites of those for the spin of b, and
//! so are the moments. α is the angle of e3b between e2a and e3a, γ that of e1a between e1b and e2b, so that the rows are the
//! derivatives of two such angles and of an arc sine. At β = ±90° they do not exist. The geometric stiffness, too, depends on the
//! difference of both spins: it consists of one block, its transpose and their opposites.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::cross::UniversalMoments;
use super::products::double_cross;
use super::turn::Turn;
use crate::element::cardan::{CardanAngles, Triads, arc_sine_slope};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    E1A, E1B, E2A, E2B, E3A, E3B, K_TB_TB, LAMBDA_R1, LAMBDA_R2, LAMBDA_R3, UR1_TB, UR2_TB, UR3_TB,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Source, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// The source of these formulas.
const OURS: Source = Document::TRANSLATOR
    .ours("Description", "the page of ALIGN was not given; these are derivatives of the angles that are held");

fields! {
    /// The derivatives of the three residuals with respect to the spin of b; those with respect to the spin of a are the
    /// opposite.
    pub struct AlignRows<T> {
        ur1_tb: Vector3<T> = UR1_TB, ur2_tb: Vector3<T> = UR2_TB, ur3_tb: Vector3<T> = UR3_TB,
    }
}

/// The quantities from which the derivatives are formed.
pub(super) struct Turns<D> {
    e1a: Vector3<D>,
    e3b: Vector3<D>,
    /// α, of e3b.
    first: Turn<D>,
    /// γ, of e1a.
    third: Turn<D>,
    /// sin β, 1/√(1 − sin² β) and its square.
    sine: D,
    slope: D,
    square: D,
}

impl<D: Scalar> Turns<D> {
    #[inline(always)]
    pub(super) fn new(i: &Triads<D>) -> Self {
        let [slope, square] = arc_sine_slope(&i.e1a, &i.e3b);
        Self {
            e1a: i.e1a,
            e3b: i.e3b,
            first: Turn::new(&i.e3b, &i.e2a, &i.e3a),
            third: Turn::new(&i.e1a, &i.e2b, &i.e1b),
            sine: i.e1a.dot(&i.e3b),
            slope,
            square,
        }
    }

    /// A vector along the line of nodes.
    #[inline(always)]
    fn node_line(&self) -> Vector3<D> {
        self.e3b.cross(&self.e1a)
    }

    /// The derivatives of the three angles with respect to the spin of b.
    #[inline(always)]
    pub(super) fn rows(&self) -> [Vector3<D>; 3] {
        [self.first.row(), self.node_line() * self.slope, -self.third.row()]
    }

    /// The derivative of each row with respect to the spin of b.
    #[inline(always)]
    fn curvatures(&self) -> [Matrix3<D>; 3] {
        let n = self.node_line();
        let second = double_cross(&self.e3b, &self.e1a) * self.slope + n * n.transpose() * self.by_sine();
        [self.first.curvature(), second, self.third.curvature().transpose()]
    }

    /// The derivative of the slope with respect to sin β.
    #[inline(always)]
    fn by_sine(&self) -> D {
        self.sine * self.slope * self.square
    }
}

/// Rejects triads without Cardan angles, and β = ±90°, where the angles have no derivative.
#[inline]
fn check<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
    CardanAngles::validate(i)?;
    let [slope, _] = arc_sine_slope(&i.e1a, &i.e3b);
    if slope > 0.0 {
        return Ok(());
    }
    Err(Error::GimbalLock { angle: "beta", sine: "e1a·e3b", cosine: "√(1 − (e1a·e3b)²)" })
}

/// The rows of ALIGN.
///
/// On orthonormal triads a rotation of b about e1a changes only α, one about the line of nodes only β, one about e3b only γ.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new("align.rows", "Rows of ALIGN", OURS)
        .equation(r"\begin{aligned} S_1 &= \mathbf{e}_{2a}\cdot\mathbf{e}_{3b}, & C_1 &= \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}, & \mathbf{u}_1 &= \frac{S_1\,\mathbf{e}_{3a} - C_1\,\mathbf{e}_{2a}}{S_1^2+C_1^2}, & \mathbf{u}_{r1,\theta b} &= \mathbf{e}_{3b}\times\mathbf{u}_1,\\ S_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{2b}, & C_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{1b}, & \mathbf{u}_3 &= \frac{S_3\,\mathbf{e}_{1b} - C_3\,\mathbf{e}_{2b}}{S_3^2+C_3^2}, & \mathbf{u}_{r3,\theta b} &= \mathbf{u}_3\times\mathbf{e}_{1a} \end{aligned},\quad \mathbf{u}_{r2,\theta b} = \frac{\mathbf{e}_{3b}\times\mathbf{e}_{1a}}{\sqrt{1-(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})^2}}")
        // An entry is a sum of terms that may cancel, and so may their sensitivities to the inputs; then their rounding errors
        // remain: in the rows up to 66 at 45 000 random points.
        // The largest η that `audit --attack` found is 2.93 for the value, and 5.48 is possible to first order.
        .eta_of_value(8.0)
        .normwise_of_value(6.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = Triads<T>;
    type Outputs<T: Component> = AlignRows<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Triads<D>) -> AlignRows<D> {
        let [ur1_tb, ur2_tb, ur3_tb] = Turns::new(i).rows();
        AlignRows { ur1_tb, ur2_tb, ur3_tb }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
        check(i)
    }
}

fields! {
    /// The triads of both nodes, and the three multipliers.
    pub struct AlignLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        lambda_r1: T = LAMBDA_R1, lambda_r2: T = LAMBDA_R2, lambda_r3: T = LAMBDA_R3,
    }
}

impl<T: Component> AlignLoads<T> {
    /// Combines both triads with the multipliers.
    #[inline]
    pub const fn new(triads: &Triads<T>, [lambda_r1, lambda_r2, lambda_r3]: [T; 3]) -> Self {
        let Triads { e1a, e2a, e3a, e1b, e2b, e3b } = *triads;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, lambda_r1, lambda_r2, lambda_r3 }
    }

    /// The triads.
    #[inline]
    pub fn triads(&self) -> Triads<T> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, .. } = self;
        Triads::by_components([e1a, e2a, e3a], [e1b, e2b, e3b])
    }

    /// The multipliers.
    #[inline]
    pub const fn multipliers(&self) -> [T; 3] {
        [self.lambda_r1, self.lambda_r2, self.lambda_r3]
    }
}

/// The moments of ALIGN on its nodes, Rowsᵀ λ: a moment on b, its opposite on a.
#[derive(Clone, Copy, Debug)]
pub struct Moments;

impl Formula for Moments {
    const SPEC: Spec = Spec::new("align.nodal_moments", "Nodal moments of ALIGN", OURS)
        .equation(r"\mathbf{m}_b = \lambda_{r1}\,\mathbf{u}_{r1,\theta b} + \lambda_{r2}\,\mathbf{u}_{r2,\theta b} + \lambda_{r3}\,\mathbf{u}_{r3,\theta b},\quad \mathbf{m}_a = -\mathbf{m}_b")
        .given(&[Given::new(
            r"\mathbf{u}_{r1,\theta b},\ \mathbf{u}_{r2,\theta b},\ \mathbf{u}_{r3,\theta b}",
            &Rows::SPEC,
        )])
        // An entry is a sum of terms that may cancel, and so may their sensitivities to the inputs; then their rounding errors
        // remain. Of the rows the worst at 20 000 random points is 46.
        // The largest η that `audit --attack` found is 2.24 for the value, and 4.76 is possible to first order.
        .eta_of_value(6.0)
        .normwise_of_value(6.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = AlignLoads<T>;
    type Outputs<T: Component> = UniversalMoments<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AlignLoads<D>) -> UniversalMoments<D> {
        let ([first, second, third], [l1, l2, l3]) = (Turns::new(&i.triads()).rows(), i.multipliers());
        let mb = first * l1 + second * l2 + third * l3;
        UniversalMoments { ma: -mb, mb }
    }

    #[inline]
    fn validate<D: Scalar>(i: &AlignLoads<D>) -> Result<(), Error> {
        check(&i.triads())
    }
}

fields! {
    /// The derivatives of ALIGN's moments with respect to the spins, with the multipliers held: the block from which all four are
    /// formed.
    ///
    /// [`matrix`](AlignStiffness::matrix) assembles them.
    pub struct AlignStiffness<T> { k_tb_tb: Matrix3<T> = K_TB_TB }
}

/// The geometric stiffness of ALIGN, Σ λ ∂²g with respect to spins, without symmetrisation: unsymmetric.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new("align.geometric_stiffness", "Geometric stiffness of ALIGN", OURS)
        .equation(r"\begin{aligned} S_1 &= \mathbf{e}_{2a}\cdot\mathbf{e}_{3b}, & C_1 &= \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}, & \mathbf{u}_1 &= \frac{S_1\,\mathbf{e}_{3a} - C_1\,\mathbf{e}_{2a}}{S_1^2+C_1^2}, & \mathbf{h}_1 &= \mathbf{e}_{3b}\times\frac{C_1\,\mathbf{e}_{3a} + S_1\,\mathbf{e}_{2a}}{S_1^2+C_1^2},\\ S_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{2b}, & C_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{1b}, & \mathbf{u}_3 &= \frac{S_3\,\mathbf{e}_{1b} - C_3\,\mathbf{e}_{2b}}{S_3^2+C_3^2}, & \mathbf{h}_3 &= \mathbf{e}_{1a}\times\frac{C_3\,\mathbf{e}_{1b} + S_3\,\mathbf{e}_{2b}}{S_3^2+C_3^2} \end{aligned},\quad s = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b},\quad \begin{aligned} \mathbf{K}_{\theta b,\theta b} &= \lambda_{r1}(\mathbf{e}_{3b}\otimes\mathbf{u}_1 - \mathbf{h}_1\otimes\mathbf{u}_{r1,\theta b} - \mathbf{u}_{r1,\theta b}\otimes\mathbf{h}_1) + \frac{\lambda_{r2}}{\sqrt{1-s^2}}(\mathbf{e}_{3b}\otimes\mathbf{e}_{1a} - s\,\mathbf{I} + s\,\mathbf{u}_{r2,\theta b}\otimes\mathbf{u}_{r2,\theta b}) + \lambda_{r3}(\mathbf{u}_3\otimes\mathbf{e}_{1a} + \mathbf{h}_3\otimes\mathbf{u}_{r3,\theta b} + \mathbf{u}_{r3,\theta b}\otimes\mathbf{h}_3) \end{aligned}")
        .given(&[Given::new(
            r"\mathbf{u}_{r1,\theta b},\ \mathbf{u}_{r2,\theta b},\ \mathbf{u}_{r3,\theta b}",
            &Rows::SPEC,
        )])
        // As for the rows.
        // The largest η that `audit --attack` found is 1.77 for the value, and 5.21 is possible to first order.
        .eta_of_value(12.0)
        .normwise_of_value(6.0)
        .scale(1e250);
    type Inputs<T: Component> = AlignLoads<T>;
    type Outputs<T: Component> = AlignStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AlignLoads<D>) -> AlignStiffness<D> {
        let ([first, second, third], [l1, l2, l3]) = (Turns::new(&i.triads()).curvatures(), i.multipliers());
        AlignStiffness { k_tb_tb: first * l1 + second * l2 + third * l3 }
    }

    #[inline]
    fn validate<D: Scalar>(i: &AlignLoads<D>) -> Result<(), Error> {
        check(&i.triads())
    }
}
