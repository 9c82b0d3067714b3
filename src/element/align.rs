//! ALIGN as an element: three residuals, the Cardan angles of b relative to a.
//!
//! They change with the difference of both spins alone: the rows by the spin of a are those by the spin of b with the other
//! sign, and so are the moments. α is the angle of e3b between e2a and e3a, γ that of e1a between e1b and e2b, so that the
//! rows are the derivatives of two such angles and of an arc sine. Where β is ±90° there are none.
//! The geometric stiffness depends on both spins by their difference too: one block, its transpose and their opposites.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::products::{column, double_cross, double_cross_gradient, matrix};
use super::turn::{Curving, Turn};
use super::universal::UniversalMoments;
use crate::element::cardan::{CardanAngles, Triads, arc_sine_slope};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    E1A, E1B, E2A, E2B, E3A, E3B, K_TB_TB, LAMBDA_R1, LAMBDA_R2, LAMBDA_R3, UR1_TB, UR2_TB, UR3_TB,
};
use crate::formula::{
    Component, Document, Fields, Finite, Formula, Given, Jacobian, Source, Spec, ValueAndJacobian, cross_gradient,
};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// What all of them are derived from.
const OURS: Source = Document::TRANSLATOR
    .ours("Description", "the page of ALIGN was not given; these are derivatives of the angles that are held");

fields! {
    /// The derivatives of the three residuals by the spin of b; by that of a they are the opposite.
    pub struct AlignRows<T> {
        ur1_tb: Vector3<T> = UR1_TB, ur2_tb: Vector3<T> = UR2_TB, ur3_tb: Vector3<T> = UR3_TB,
    }
}

/// What the derivatives are made of.
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

    /// Along the line of nodes.
    #[inline(always)]
    fn node_line(&self) -> Vector3<D> {
        self.e3b.cross(&self.e1a)
    }

    /// The derivatives of the three angles by the spin of b.
    #[inline(always)]
    pub(super) fn rows(&self) -> [Vector3<D>; 3] {
        [self.first.row(), self.node_line() * self.slope, -self.third.row()]
    }

    /// The gradient of a number of times the n-th component of the first row.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_ur1(&self, times: D, n: usize) -> Triads<D> {
        of_first(self.first.row_gradient(times, n))
    }

    /// As [`of_ur1`](Self::of_ur1), of the second row.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_ur2(&self, times: D, n: usize) -> Triads<D> {
        let ([by_e3b, by_e1a], slope) = (cross_gradient(&self.e3b, &self.e1a, n), self.slope * times);
        self.by_arms([by_e1a.times(slope), by_e3b.times(slope)], self.by_sine() * (self.node_line()[n] * times))
    }

    /// As [`of_ur1`](Self::of_ur1), of the third row.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_ur3(&self, times: D, n: usize) -> Triads<D> {
        of_third(self.third.row_gradient(-times, n))
    }

    /// How each row changes with the spin of b.
    #[inline(always)]
    fn curvatures(&self) -> [Matrix3<D>; 3] {
        let n = self.node_line();
        let second = double_cross(&self.e3b, &self.e1a) * self.slope + n * n.transpose() * self.by_sine();
        [self.first.curvature(), second, self.third.curvature().transpose()]
    }

    /// The gradient of a number of times an entry of the second of [`curvatures`](Self::curvatures).
    #[inline(always)]
    fn second_curvature_gradient(&self, times: D, r: usize, c: usize) -> Triads<D> {
        let Self { e1a, e3b, sine, slope, square, .. } = self;
        let (n, by_n) = (self.node_line(), |k: usize| cross_gradient(e3b, e1a, k));
        let ([b_r, a_r], [b_c, a_c]) = (by_n(r), by_n(c));
        let ([by_b, by_a], sign) = double_cross_gradient(e3b, e1a, r, c);
        let by_sine = self.by_sine();
        let again = *slope * *square * (*sine * *sine * *square * 3.0 + 1.0) * times;
        let (slope, by_sine) = (sign.of(*slope * times), by_sine * times);
        let (times_r, times_c) = (n[r] * by_sine, n[c] * by_sine);
        let by_both = [
            by_a.added_to(&a_r.added_to(&a_c.times(times_r), times_c), slope),
            by_b.added_to(&b_r.added_to(&b_c.times(times_r), times_c), slope),
        ];
        self.by_arms(by_both, double_cross(e3b, e1a)[(r, c)] * by_sine + n[r] * n[c] * again)
    }

    /// The derivative of the slope by sin β.
    #[inline(always)]
    fn by_sine(&self) -> D {
        self.sine * self.slope * self.square
    }

    /// A gradient by e1a, e3b and sin β.
    #[inline(always)]
    fn by_arms(&self, [by_a, by_b]: [Vector3<D>; 2], by_sine: D) -> Triads<D> {
        let zero = Triads::filled(D::zero());
        Triads { e1a: by_a + self.e3b * by_sine, e3b: by_b + self.e1a * by_sine, ..zero }
    }
}

/// A gradient of something of the first angle.
#[inline(always)]
fn of_first<D: Scalar>([e3b, e2a, e3a]: [Vector3<D>; 3]) -> Triads<D> {
    Triads { e2a, e3a, e3b, ..Triads::filled(D::zero()) }
}

/// A gradient of something of the third angle.
#[inline(always)]
fn of_third<D: Scalar>([e1a, e2b, e1b]: [Vector3<D>; 3]) -> Triads<D> {
    Triads { e1a, e1b, e2b, ..Triads::filled(D::zero()) }
}

/// Rejects what has no angles, and β = ±90°, where they have no derivative.
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
/// On orthonormal triads a turn of b about e1a changes α alone, one about the line of nodes β, one about e3b γ.
#[derive(Clone, Copy, Debug)]
pub struct Rows;

impl Formula for Rows {
    const SPEC: Spec = Spec::new("align.rows", "Rows of ALIGN", OURS)
        .equation(r"\begin{aligned} S_1 &= \mathbf{e}_{2a}\cdot\mathbf{e}_{3b}, & C_1 &= \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}, & \mathbf{u}_1 &= \frac{S_1\,\mathbf{e}_{3a} - C_1\,\mathbf{e}_{2a}}{S_1^2+C_1^2}, & \mathbf{u}_{r1,\theta b} &= \mathbf{e}_{3b}\times\mathbf{u}_1,\\ S_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{2b}, & C_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{1b}, & \mathbf{u}_3 &= \frac{S_3\,\mathbf{e}_{1b} - C_3\,\mathbf{e}_{2b}}{S_3^2+C_3^2}, & \mathbf{u}_{r3,\theta b} &= \mathbf{u}_3\times\mathbf{e}_{1a} \end{aligned},\quad \mathbf{u}_{r2,\theta b} = \frac{\mathbf{e}_{3b}\times\mathbf{e}_{1a}}{\sqrt{1-(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b})^2}}")
        // An entry is a sum of terms that may cancel, and what inputs do to them with them; then their roundings remain: in the
        // rows at 45 000 random points up to 66. By vectors it is 7.
        .eta(8.0, 48.0)
        .by_vectors(4.0, 8.0)
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
    fn jacobian<D: Scalar>(i: &Triads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &Triads<D>) -> ValueAndJacobian<Self, D> {
        let turns = Turns::new(i);
        let [ur1_tb, ur2_tb, ur3_tb] = turns.rows();
        let one = D::one();
        let gradients = AlignRows {
            ur1_tb: column!(turns.of_ur1, one),
            ur2_tb: column!(turns.of_ur2, one),
            ur3_tb: column!(turns.of_ur3, one),
        };
        (AlignRows { ur1_tb, ur2_tb, ur3_tb }, gradients)
    }

    #[inline]
    fn validate<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
        check(i)
    }
}

fields! {
    /// How both nodes are turned, and the three multipliers.
    pub struct AlignLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        lambda_r1: T = LAMBDA_R1, lambda_r2: T = LAMBDA_R2, lambda_r3: T = LAMBDA_R3,
    }
}

impl<T: Component> AlignLoads<T> {
    /// From both triads and the multipliers.
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

impl<D: Scalar> AlignLoads<D> {
    /// The gradient of a sum of one number of each angle, times its multiplier: from these gradients by the triads.
    #[inline(always)]
    fn gradient([first, second, third]: [Triads<D>; 3], numbers: [D; 3]) -> Self {
        let by_triads = Triads {
            e1a: second.e1a + third.e1a,
            e2a: first.e2a,
            e3a: first.e3a,
            e1b: third.e1b,
            e2b: third.e2b,
            e3b: first.e3b + second.e3b,
        };
        Self::new(&by_triads, numbers)
    }

    /// −1 times a gradient.
    #[inline(always)]
    fn opposite(&self) -> Self {
        let Triads { e1a, e2a, e3a, e1b, e2b, e3b } = self.triads();
        let triads = Triads { e1a: -e1a, e2a: -e2a, e3a: -e3a, e1b: -e1b, e2b: -e2b, e3b: -e3b };
        Self::new(&triads, self.multipliers().map(|x| -x))
    }
}

/// The rows with their multipliers.
pub(super) struct Loaded<D> {
    multipliers: [D; 3],
    turns: Turns<D>,
    rows: [Vector3<D>; 3],
}

impl<D: Scalar> Loaded<D> {
    #[inline(always)]
    pub(super) fn new(loads: &AlignLoads<D>) -> Self {
        let (turns, multipliers) = (Turns::new(&loads.triads()), loads.multipliers());
        Self { multipliers, rows: turns.rows(), turns }
    }

    /// On b.
    #[inline(always)]
    pub(super) fn moment(&self) -> Vector3<D> {
        let ([first, second, third], [l1, l2, l3]) = (self.rows, self.multipliers);
        first * l1 + second * l2 + third * l3
    }

    /// The gradient of the n-th component of the moment on b.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_mb(&self, n: usize) -> AlignLoads<D> {
        let (turns, [first, second, third], [l1, l2, l3]) = (&self.turns, self.rows, self.multipliers);
        let gradients = [turns.of_ur1(l1, n), turns.of_ur2(l2, n), turns.of_ur3(l3, n)];
        AlignLoads::gradient(gradients, [first[n], second[n], third[n]])
    }

    /// The gradient of the n-th component of the moment on a.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_ma(&self, n: usize) -> AlignLoads<D> {
        self.of_mb(n).opposite()
    }
}

/// What ALIGN exerts on its nodes, Rowsᵀ λ: a moment on b, its opposite on a.
#[derive(Clone, Copy, Debug)]
pub struct Moments;

impl Formula for Moments {
    const SPEC: Spec = Spec::new("align.nodal_moments", "Nodal moments of ALIGN", OURS)
        .equation(r"\mathbf{m}_b = \lambda_{r1}\,\mathbf{u}_{r1,\theta b} + \lambda_{r2}\,\mathbf{u}_{r2,\theta b} + \lambda_{r3}\,\mathbf{u}_{r3,\theta b},\quad \mathbf{m}_a = -\mathbf{m}_b")
        .given(&[Given::new(
            r"\mathbf{u}_{r1,\theta b},\ \mathbf{u}_{r2,\theta b},\ \mathbf{u}_{r3,\theta b}",
            &Rows::SPEC,
        )])
        // An entry is a sum of terms that may cancel, and what inputs do to them with them; then their roundings remain. Of the
        // rows at 20 000 random points the worst is 46.
        .eta(6.0, 48.0)
        .scale(1e250)
        .finite(Finite::Between);
    type Inputs<T: Component> = AlignLoads<T>;
    type Outputs<T: Component> = UniversalMoments<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AlignLoads<D>) -> UniversalMoments<D> {
        let mb = Loaded::new(i).moment();
        UniversalMoments { ma: -mb, mb }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &AlignLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &AlignLoads<D>) -> ValueAndJacobian<Self, D> {
        let loaded = Loaded::new(i);
        let mb = loaded.moment();
        (UniversalMoments { ma: -mb, mb }, UniversalMoments { ma: column!(loaded.of_ma), mb: column!(loaded.of_mb) })
    }

    #[inline]
    fn validate<D: Scalar>(i: &AlignLoads<D>) -> Result<(), Error> {
        check(&i.triads())
    }
}

fields! {
    /// How the moments of ALIGN change with the spins, the multipliers held: the block from which all four are made.
    ///
    /// [`matrix`](AlignStiffness::matrix) has them in their places.
    pub struct AlignStiffness<T> { k_tb_tb: Matrix3<T> = K_TB_TB }
}

/// The changes of the rows with the spin of b, with their multipliers.
pub(super) struct Curved<D> {
    multipliers: [D; 3],
    turns: Turns<D>,
    entries: [Matrix3<D>; 3],
    first: Curving<D>,
    third: Curving<D>,
}

impl<D: Scalar> Curved<D> {
    #[inline(always)]
    pub(super) fn new(loads: &AlignLoads<D>) -> Self {
        let (turns, multipliers @ [l1, _, l3]) = (Turns::new(&loads.triads()), loads.multipliers());
        let (first, third) = (turns.first.curving(l1), turns.third.curving(l3));
        Self { multipliers, entries: turns.curvatures(), first, third, turns }
    }

    #[inline(always)]
    pub(super) fn stiffness(&self) -> Matrix3<D> {
        let ([first, second, third], [l1, l2, l3]) = (self.entries, self.multipliers);
        first * l1 + second * l2 + third * l3
    }

    /// The gradient of an entry of the stiffness.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_k_tb_tb(&self, r: usize, c: usize) -> AlignLoads<D> {
        let [first, second, third] = &self.entries;
        let second_gradient = self.turns.second_curvature_gradient(self.multipliers[1], r, c);
        let gradients = [of_first(self.first.gradient(r, c)), second_gradient, of_third(self.third.gradient(c, r))];
        AlignLoads::gradient(gradients, [first[(r, c)], second[(r, c)], third[(r, c)]])
    }
}

/// The geometric stiffness of ALIGN, Σ λ ∂²g by spins, as it is: unsymmetric.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness;

impl Formula for GeometricStiffness {
    const SPEC: Spec = Spec::new("align.geometric_stiffness", "Geometric stiffness of ALIGN", OURS)
        .equation(r"\begin{aligned} S_1 &= \mathbf{e}_{2a}\cdot\mathbf{e}_{3b}, & C_1 &= \mathbf{e}_{3a}\cdot\mathbf{e}_{3b}, & \mathbf{u}_1 &= \frac{S_1\,\mathbf{e}_{3a} - C_1\,\mathbf{e}_{2a}}{S_1^2+C_1^2}, & \mathbf{h}_1 &= \mathbf{e}_{3b}\times\frac{C_1\,\mathbf{e}_{3a} + S_1\,\mathbf{e}_{2a}}{S_1^2+C_1^2},\\ S_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{2b}, & C_3 &= \mathbf{e}_{1a}\cdot\mathbf{e}_{1b}, & \mathbf{u}_3 &= \frac{S_3\,\mathbf{e}_{1b} - C_3\,\mathbf{e}_{2b}}{S_3^2+C_3^2}, & \mathbf{h}_3 &= \mathbf{e}_{1a}\times\frac{C_3\,\mathbf{e}_{1b} + S_3\,\mathbf{e}_{2b}}{S_3^2+C_3^2} \end{aligned},\quad s = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b},\quad \begin{aligned} \mathbf{K}_{\theta b,\theta b} &= \lambda_{r1}(\mathbf{e}_{3b}\otimes\mathbf{u}_1 - \mathbf{h}_1\otimes\mathbf{u}_{r1,\theta b} - \mathbf{u}_{r1,\theta b}\otimes\mathbf{h}_1) + \frac{\lambda_{r2}}{\sqrt{1-s^2}}(\mathbf{e}_{3b}\otimes\mathbf{e}_{1a} - s\,\mathbf{I} + s\,\mathbf{u}_{r2,\theta b}\otimes\mathbf{u}_{r2,\theta b}) + \lambda_{r3}(\mathbf{u}_3\otimes\mathbf{e}_{1a} + \mathbf{h}_3\otimes\mathbf{u}_{r3,\theta b} + \mathbf{u}_{r3,\theta b}\otimes\mathbf{h}_3) \end{aligned}")
        .given(&[Given::new(
            r"\mathbf{u}_{r1,\theta b},\ \mathbf{u}_{r2,\theta b},\ \mathbf{u}_{r3,\theta b}",
            &Rows::SPEC,
        )])
        // As of the rows.
        .eta(12.0, 48.0)
        .by_vectors(3.0, 24.0)
        .scale(1e250);
    type Inputs<T: Component> = AlignLoads<T>;
    type Outputs<T: Component> = AlignStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AlignLoads<D>) -> AlignStiffness<D> {
        let ([first, second, third], [l1, l2, l3]) = (Turns::new(&i.triads()).curvatures(), i.multipliers());
        AlignStiffness { k_tb_tb: first * l1 + second * l2 + third * l3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &AlignLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &AlignLoads<D>) -> ValueAndJacobian<Self, D> {
        let curved = Curved::new(i);
        (AlignStiffness { k_tb_tb: curved.stiffness() }, AlignStiffness { k_tb_tb: matrix!(curved.of_k_tb_tb) })
    }

    #[inline]
    fn validate<D: Scalar>(i: &AlignLoads<D>) -> Result<(), Error> {
        check(&i.triads())
    }
}
