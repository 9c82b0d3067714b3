//! The derivative of the normal force of the contact with respect to the nodes, with its magnitude held constant: λ ∂²E11.
//!
//! With aᵢ = (1, −Nᵢ) and bᵢ = (0, Nᵢ′/|X′|) for the slave point and the nodes, t·δ = Σ aᵢ t·δxᵢ is the relative motion along the
//! line and Σ bᵢ n·δxᵢ the rotation of its material. The closest point moves along the line by
//! δs = (Σ aᵢ t·δxᵢ + E11 Σ bᵢ n·δxᵢ)/(1 − κ E11), from which δ²E11 follows: the blocks
//! −(aᵢ bⱼ t⊗n + bᵢ aⱼ n⊗t + κ aᵢ aⱼ t⊗t + E11 bᵢ bⱼ n⊗n)/(1 − κ E11), a symmetric matrix. It is infinite if the slave point is
//! at the centre of curvature, and beyond that the point is not the closest one.

#[cfg(feature = "verify")]
mod proof;

use super::Spot;
use crate::contact::slide_line::{LinearPoint, LocalBasis, ParabolicPoint, check_distinct, check_tangent};
use crate::fields;
use crate::formula::error::{Error, Name};
use crate::formula::quantity::{
    CONTACT_LAMBDA, LINE_K_U1_U1, LINE_K_U1_U2, LINE_K_U1_U3, LINE_K_U2_U2, LINE_K_U2_U3, LINE_K_U3_U3, LINE_K_US_U1,
    LINE_K_US_U2, LINE_K_US_U3, LINE_K_US_US, SEGMENT_G, SEPARATION, X1, X2, X3,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Source, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix2, Matrix6, SMatrix, Vector2};

const OURS: Source = Document::SLIDE_LINE
    .ours("Element output", "the section names the separation; it is the derivative of the force along its normal");

fields! {
    /// The closest point of a straight segment, the separation, and the contact force along the normal.
    pub struct LinearTouch<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, g: T = SEGMENT_G, separation: T = SEPARATION,
        lambda: T = CONTACT_LAMBDA,
    }
}
fields! {
    /// The closest point of a parabolic segment, the separation, and the contact force along the normal.
    pub struct ParabolicTouch<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, g: T = SEGMENT_G,
        separation: T = SEPARATION, lambda: T = CONTACT_LAMBDA,
    }
}
fields! {
    /// The distinct blocks on a straight segment; [`matrix`](LinearStiffness::matrix) assembles them.
    pub struct LinearStiffness<T> {
        k_us_u1: Matrix2<T> = LINE_K_US_U1, k_u1_u1: Matrix2<T> = LINE_K_U1_U1, k_u1_u2: Matrix2<T> = LINE_K_U1_U2,
        k_u2_u2: Matrix2<T> = LINE_K_U2_U2,
    }
}
fields! {
    /// The blocks on a parabolic segment; [`matrix`](ParabolicStiffness::matrix) assembles them.
    pub struct ParabolicStiffness<T> {
        k_us_us: Matrix2<T> = LINE_K_US_US, k_us_u1: Matrix2<T> = LINE_K_US_U1, k_us_u2: Matrix2<T> = LINE_K_US_U2,
        k_us_u3: Matrix2<T> = LINE_K_US_U3, k_u1_u1: Matrix2<T> = LINE_K_U1_U1, k_u1_u2: Matrix2<T> = LINE_K_U1_U2,
        k_u1_u3: Matrix2<T> = LINE_K_U1_U3, k_u2_u2: Matrix2<T> = LINE_K_U2_U2, k_u2_u3: Matrix2<T> = LINE_K_U2_U3,
        k_u3_u3: Matrix2<T> = LINE_K_U3_U3,
    }
}

/// v ⊗ w times a.
fn outer<D: Scalar>(v: &Vector2<D>, w: &Vector2<D>, a: D) -> Matrix2<D> {
    Matrix2::from_fn(|i, j| v[i] * w[j] * a)
}

/// The geometric stiffness of contact on a straight segment, λ ∂²E11.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    /// With b₂ = −b₁ = 1/ℓ and κ = 0. N₁ P − N₂ Q is ½ (P − Q) − ½ g (P + Q), and P − Q does not depend on the direction: it is
    /// λ/ℓ times the rotation by 90° to the right.
    fn at<D: Scalar>(spot: &Spot<D, 2>, i: &LinearTouch<D>) -> LinearStiffness<D> {
        let Spot { t, n, weights: [n1, n2], rates: [_, per_length], .. } = *spot;
        let (half, per) = (D::from(0.5), i.lambda * per_length);
        let (p, q, r) = (outer(&t, &n, per), outer(&n, &t, per), outer(&n, &n, per * per_length * i.separation));
        let both = p + q;
        let mut k_u1_u2 = r - both * (i.g * half);
        k_u1_u2.m12 += per * half;
        k_u1_u2.m21 -= per * half;
        LinearStiffness { k_us_u1: p, k_u1_u1: both * -n1 - r, k_u1_u2, k_u2_u2: both * n2 - r }
    }
}

impl Formula for Linear {
    const SPEC: Spec = Spec::new("slide_line.geometric_stiffness_linear", "Geometric stiffness of contact on a straight segment", OURS)
        .equation(r"\begin{aligned} \mathbf{P} &= \frac{\lambda}{\ell}\,\mathbf{t}\otimes\mathbf{n},\quad \mathbf{Q} = \frac{\lambda}{\ell}\,\mathbf{n}\otimes\mathbf{t},\quad \mathbf{R} = \frac{\lambda E_{11}}{\ell^2}\,\mathbf{n}\otimes\mathbf{n}, \\ \mathbf{K}_{us,u1} &= \mathbf{P},\quad \mathbf{K}_{u1,u1} = -N_1(\mathbf{P}+\mathbf{Q}) - \mathbf{R},\quad \mathbf{K}_{u1,u2} = N_1\,\mathbf{P} - N_2\,\mathbf{Q} + \mathbf{R},\quad \mathbf{K}_{u2,u2} = N_2(\mathbf{P}+\mathbf{Q}) - \mathbf{R}, \\ N_1 &= \tfrac12(1-g),\quad N_2 = \tfrac12(1+g),\quad \ell = \lvert\mathbf{x}_2-\mathbf{x}_1\rvert \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &LinearPoint::SPEC)])
        .eta_of_value(4.0)
        .normwise_of_value(4.0)
        .scale(1e80)
        .finite(Finite::Between);
    type Inputs<T: Component> = LinearTouch<T>;
    type Outputs<T: Component> = LinearStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearTouch<D>) -> LinearStiffness<D> {
        Self::at(&Spot::linear([i.x1, i.x2], i.g), i)
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearTouch<D>) -> Result<(), Error> {
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}

/// At the centre of curvature and beyond it another point is closer.
#[cold]
fn beyond_centre<D: Scalar>(separation: D) -> Error {
    Error::OutOfRange {
        name: Name { field: "separation", component: None },
        value: separation.re(),
        allowed: "a separation on this side of the centre of curvature".into(),
    }
}

/// The slave point (`None`), or a node.
type Degree = Option<usize>;

/// The geometric stiffness of contact on a parabolic segment, λ ∂²E11.
#[derive(Clone, Copy, Debug)]
pub struct Parabolic;

/// The blocks, where `by` is λ/(1 − κ E11).
struct Values<'p, D> {
    spot: &'p Spot<D, 3>,
    separation: D,
    by: D,
}

impl<D: Scalar> Values<'_, D> {
    /// All distinct blocks.
    fn all(&self) -> ParabolicStiffness<D> {
        let [s, a, b, c] = [None, Some(0), Some(1), Some(2)];
        ParabolicStiffness {
            k_us_us: self.block([s, s]),
            k_us_u1: self.block([s, a]),
            k_us_u2: self.block([s, b]),
            k_us_u3: self.block([s, c]),
            k_u1_u1: self.block([a, a]),
            k_u1_u2: self.block([a, b]),
            k_u1_u3: self.block([a, c]),
            k_u2_u2: self.block([b, b]),
            k_u2_u3: self.block([b, c]),
            k_u3_u3: self.block([c, c]),
        }
    }

    fn block(&self, [i, j]: [Degree; 2]) -> Matrix2<D> {
        let Self { spot: Spot { t, n, weights, rates, curvature }, separation, by } = *self;
        let motion = |i: Degree, x: D| i.map_or(x, |i| -(x * weights[i]));
        let bend = outer(t, t, motion(i, motion(j, -(by * *curvature))));
        let shear = j.map(|j| outer(t, n, motion(i, -(by * rates[j]))));
        let back = i.map(|i| outer(n, t, motion(j, -(by * rates[i]))));
        let turn = i.zip(j).map(|(i, j)| outer(n, n, -(by * separation * rates[i] * rates[j])));
        [shear, back, turn].into_iter().flatten().fold(bend, |all, m| all + m)
    }
}

impl Formula for Parabolic {
    const SPEC: Spec = Spec::new("slide_line.geometric_stiffness_parabolic", "Geometric stiffness of contact on a parabolic segment", OURS)
        .equation(r"\begin{aligned} \mathbf{K}_{us,us} &= -c\kappa\,\mathbf{t}\otimes\mathbf{t},\quad \mathbf{K}_{us,u1} = -c\,(\mathbf{t}\otimes\mathbf{b}_1 + \kappa\,\mathbf{t}\otimes\mathbf{a}_1),\quad \mathbf{K}_{us,u2} = -c\,(\mathbf{t}\otimes\mathbf{b}_2 + \kappa\,\mathbf{t}\otimes\mathbf{a}_2),\quad \mathbf{K}_{us,u3} = -c\,(\mathbf{t}\otimes\mathbf{b}_3 + \kappa\,\mathbf{t}\otimes\mathbf{a}_3), \\ \mathbf{K}_{u1,u1} &= -c\,(\mathbf{a}_1\otimes\mathbf{b}_1 + \mathbf{b}_1\otimes\mathbf{a}_1 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_1 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_1),\quad \mathbf{K}_{u1,u2} = -c\,(\mathbf{a}_1\otimes\mathbf{b}_2 + \mathbf{b}_1\otimes\mathbf{a}_2 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_2 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_2), \\ \mathbf{K}_{u1,u3} &= -c\,(\mathbf{a}_1\otimes\mathbf{b}_3 + \mathbf{b}_1\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_3),\quad \mathbf{K}_{u2,u2} = -c\,(\mathbf{a}_2\otimes\mathbf{b}_2 + \mathbf{b}_2\otimes\mathbf{a}_2 + \kappa\,\mathbf{a}_2\otimes\mathbf{a}_2 + E_{11}\,\mathbf{b}_2\otimes\mathbf{b}_2), \\ \mathbf{K}_{u2,u3} &= -c\,(\mathbf{a}_2\otimes\mathbf{b}_3 + \mathbf{b}_2\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_2\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_2\otimes\mathbf{b}_3),\quad \mathbf{K}_{u3,u3} = -c\,(\mathbf{a}_3\otimes\mathbf{b}_3 + \mathbf{b}_3\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_3\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_3\otimes\mathbf{b}_3), \\ c &= \frac{\lambda}{1-\kappa E_{11}},\quad \kappa = \frac{\mathbf{n}\cdot(\mathbf{x}_1-2\,\mathbf{x}_2+\mathbf{x}_3)}{\lvert\mathbf{X}'\rvert^2},\quad \mathbf{a}_1 = -\tfrac12 g(g-1)\,\mathbf{t},\quad \mathbf{a}_2 = -(1-g^2)\,\mathbf{t},\quad \mathbf{a}_3 = -\tfrac12 g(g+1)\,\mathbf{t}, \\ \mathbf{b}_1 &= \frac{g-\tfrac12}{\lvert\mathbf{X}'\rvert}\,\mathbf{n},\quad \mathbf{b}_2 = -\frac{2g}{\lvert\mathbf{X}'\rvert}\,\mathbf{n},\quad \mathbf{b}_3 = \frac{g+\tfrac12}{\lvert\mathbf{X}'\rvert}\,\mathbf{n} \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &ParabolicPoint::SPEC)])
        // Third derivatives of a closest point: terms of opposite signs cancel.
        .eta_of_value(24.0)
        .normwise_of_value(6.0)
        .scale(1e60);
    type Inputs<T: Component> = ParabolicTouch<T>;
    type Outputs<T: Component> = ParabolicStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicTouch<D>) -> ParabolicStiffness<D> {
        let spot = Spot::parabolic([i.x1, i.x2, i.x3], i.g);
        let by = i.lambda * i.per_reach(&spot);
        Values { spot: &spot, separation: i.separation, by }.all()
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicTouch<D>) -> Result<(), Error> {
        check_tangent([i.x1, i.x2, i.x3], i.g)?;
        let spot = Spot::parabolic([i.x1, i.x2, i.x3], i.g);
        if spot.curvature * i.separation < 1.0 { Ok(()) } else { Err(beyond_centre(i.separation)) }
    }
}

impl<D: Scalar> ParabolicTouch<D> {
    /// 1/(1 − κ E11).
    #[inline]
    fn per_reach(&self, spot: &Spot<D, 3>) -> D {
        (-(spot.curvature * self.separation) + 1.0).recip()
    }
}

/// Inserts a block and, off the diagonal, its transpose in the opposite position.
fn place<D: Scalar, const M: usize>(all: &mut SMatrix<D, M, M>, row: usize, column: usize, block: &Matrix2<D>) {
    all.fixed_view_mut::<2, 2>(2 * column, 2 * row).copy_from(&block.transpose());
    all.fixed_view_mut::<2, 2>(2 * row, 2 * column).copy_from(block);
}

impl<D: Scalar> LinearStiffness<D> {
    /// The assembled matrix for the translations of the slave point and of both nodes.
    pub fn matrix(&self) -> Matrix6<D> {
        let mut all = Matrix6::zeros();
        let Self { k_us_u1, k_u1_u1, k_u1_u2, k_u2_u2 } = self;
        let blocks = [(0, 1, *k_us_u1), (0, 2, -k_us_u1), (1, 1, *k_u1_u1), (1, 2, *k_u1_u2), (2, 2, *k_u2_u2)];
        for (row, column, block) in &blocks {
            place(&mut all, *row, *column, block);
        }
        all
    }
}

impl<D: Scalar> ParabolicStiffness<D> {
    /// The assembled matrix for the translations of the slave point and of the three nodes.
    pub fn matrix(&self) -> SMatrix<D, 8, 8> {
        let mut all = SMatrix::zeros();
        let of_slave = [self.k_us_us, self.k_us_u1, self.k_us_u2, self.k_us_u3];
        let of_nodes = [self.k_u1_u1, self.k_u1_u2, self.k_u1_u3, self.k_u2_u2, self.k_u2_u3, self.k_u3_u3];
        let places = [(1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)];
        for (k, block) in of_slave.iter().enumerate() {
            place(&mut all, 0, k, block);
        }
        for (block, (row, column)) in of_nodes.iter().zip(places) {
            place(&mut all, row, column, block);
        }
        all
    }
}
