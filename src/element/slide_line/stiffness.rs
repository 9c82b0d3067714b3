//! How the normal force of the contact changes with the nodes, while its size is held: λ ∂²E11.
//!
//! With aᵢ = (1, −Nᵢ) and bᵢ = (0, Nᵢ′/|X′|) for the slave point and the nodes, t·δ = Σ aᵢ t·δxᵢ is the relative motion along the
//! line and Σ bᵢ n·δxᵢ the turn of its material. The closest point moves along the line by
//! δs = (Σ aᵢ t·δxᵢ + E11 Σ bᵢ n·δxᵢ)/(1 − κ E11), and δ²E11 has all there is from that: the blocks
//! −(aᵢ bⱼ t⊗n + bᵢ aⱼ n⊗t + κ aᵢ aⱼ t⊗t + E11 bᵢ bⱼ n⊗n)/(1 − κ E11), a symmetric matrix. It is infinite where the slave point
//! is on the centre of curvature, and beyond that the place is not the closest one.

#[cfg(feature = "verify")]
mod proof;

use super::{Number, Place, Spot};
use crate::element::chain::{Term, gradients};
use crate::error::{Error, Name};
use crate::fields;
use crate::formula::{Component, Document, Formula, Given, Jacobian, Source, Spec};
use crate::quantity::{
    CONTACT_LAMBDA, LINE_K_U1_U1, LINE_K_U1_U2, LINE_K_U1_U3, LINE_K_U2_U2, LINE_K_U2_U3, LINE_K_U3_U3, LINE_K_US_U1,
    LINE_K_US_U2, LINE_K_US_U3, LINE_K_US_US, SEGMENT_G, SEPARATION, X1, X2, X3,
};
use crate::scalar::Scalar;
use crate::slide_line::{LinearPoint, LocalBasis, ParabolicPoint, check_distinct, check_tangent};
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
    /// The blocks on a straight segment that differ; [`matrix`](LinearStiffness::matrix) has them all in their places.
    pub struct LinearStiffness<T> {
        k_us_u1: Matrix2<T> = LINE_K_US_U1, k_u1_u1: Matrix2<T> = LINE_K_U1_U1, k_u1_u2: Matrix2<T> = LINE_K_U1_U2,
        k_u2_u2: Matrix2<T> = LINE_K_U2_U2,
    }
}
fields! {
    /// The blocks on a parabolic segment; [`matrix`](ParabolicStiffness::matrix) has them in their places.
    pub struct ParabolicStiffness<T> {
        k_us_us: Matrix2<T> = LINE_K_US_US, k_us_u1: Matrix2<T> = LINE_K_US_U1, k_us_u2: Matrix2<T> = LINE_K_US_U2,
        k_us_u3: Matrix2<T> = LINE_K_US_U3, k_u1_u1: Matrix2<T> = LINE_K_U1_U1, k_u1_u2: Matrix2<T> = LINE_K_U1_U2,
        k_u1_u3: Matrix2<T> = LINE_K_U1_U3, k_u2_u2: Matrix2<T> = LINE_K_U2_U2, k_u2_u3: Matrix2<T> = LINE_K_U2_U3,
        k_u3_u3: Matrix2<T> = LINE_K_U3_U3,
    }
}

/// v ⊗ w times a.
fn outer<T: Number + nalgebra::Scalar>(v: &Vector2<T>, w: &Vector2<T>, a: T) -> Matrix2<T> {
    Matrix2::from_fn(|i, j| v[i] * w[j] * a)
}

/// A matrix and others.
fn sum<T: Number + nalgebra::Scalar, const M: usize>(first: Matrix2<T>, rest: [Matrix2<T>; M]) -> Matrix2<T> {
    rest.into_iter().fold(first, |sum, m| sum.zip_map(&m, |x, y| x + y))
}

/// The geometric stiffness of contact on a straight segment, λ ∂²E11.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    /// With b₂ = −b₁ = 1/ℓ and κ = 0. N₁ P − N₂ Q is ½ (P − Q) − ½ g (P + Q), and P − Q has no direction: λ/ℓ times what turns
    /// to the right.
    fn at<T: Number + nalgebra::Scalar>(
        spot: &Spot<T, 2>,
        [half, half_g]: [T; 2],
        separation: T,
        lambda: T,
    ) -> LinearStiffness<T> {
        let Spot { t, n, weights: [n1, n2], rates: [_, per_length], .. } = *spot;
        let per = lambda * per_length;
        let (p, q, r) = (outer(&t, &n, per), outer(&n, &t, per), outer(&n, &n, -(per * per_length * separation)));
        let (both, part) = (sum(p, [q]), |m: Matrix2<T>, a: T| m.map(|entry| entry * a));
        let mut k_u1_u2 = sum(r.map(|entry| -entry), [part(both, -half_g)]);
        k_u1_u2.m12 = k_u1_u2.m12 + per * half;
        k_u1_u2.m21 = k_u1_u2.m21 + -(per * half);
        LinearStiffness { k_us_u1: p, k_u1_u1: sum(r, [part(both, -n1)]), k_u1_u2, k_u2_u2: sum(r, [part(both, n2)]) }
    }
}

impl Formula for Linear {
    const SPEC: Spec = Spec::new("slide_line.geometric_stiffness_linear", "Geometric stiffness of contact on a straight segment", OURS)
        .equation(r"\begin{aligned} \mathbf{P} &= \frac{\lambda}{\ell}\,\mathbf{t}\otimes\mathbf{n},\quad \mathbf{Q} = \frac{\lambda}{\ell}\,\mathbf{n}\otimes\mathbf{t},\quad \mathbf{R} = \frac{\lambda E_{11}}{\ell^2}\,\mathbf{n}\otimes\mathbf{n}, \\ \mathbf{K}_{us,u1} &= \mathbf{P},\quad \mathbf{K}_{u1,u1} = -N_1(\mathbf{P}+\mathbf{Q}) - \mathbf{R},\quad \mathbf{K}_{u1,u2} = N_1\,\mathbf{P} - N_2\,\mathbf{Q} + \mathbf{R},\quad \mathbf{K}_{u2,u2} = N_2(\mathbf{P}+\mathbf{Q}) - \mathbf{R}, \\ N_1 &= \tfrac12(1-g),\quad N_2 = \tfrac12(1+g),\quad \ell = \lvert\mathbf{x}_2-\mathbf{x}_1\rvert \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &LinearPoint::SPEC)])
        .eta(4.0, 6.0)
        .scale(1e50);
    type Inputs<T: Component> = LinearTouch<T>;
    type Outputs<T: Component> = LinearStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearTouch<D>) -> LinearStiffness<D> {
        let halves = [D::from(0.5), i.g * 0.5];
        Self::at(&Place::linear([i.x1, i.x2], i.g).spot, halves, i.separation, i.lambda)
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearTouch<D>) -> Jacobian<Self, D> {
        let spot = Place::linear([i.x1, i.x2], i.g).varied::<7>();
        let half = Term::constant(D::from(0.5));
        let halves = [half, Term::variable(i.g, 4) * half];
        gradients(&Self::at(&spot, halves, Term::variable(i.separation, 5), Term::variable(i.lambda, 6)))
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearTouch<D>) -> Result<(), Error> {
        check_distinct([("x1", i.x1), ("x2", i.x2)])
    }
}

/// At the centre of curvature and beyond it another place is closer.
#[cold]
fn beyond_centre<D: Scalar>(separation: D) -> Error {
    Error::OutOfRange {
        name: Name { field: "separation", component: None },
        value: separation.re(),
        allowed: "a separation on this side of the centre of curvature".into(),
    }
}

/// The slave point (none), or a node.
type Degree = Option<usize>;

/// The geometric stiffness of contact on a parabolic segment, λ ∂²E11.
#[derive(Clone, Copy, Debug)]
pub struct Parabolic;

/// A block, where `by` is λ/(1 − κ E11).
fn block<T: Number + nalgebra::Scalar>(spot: &Spot<T, 3>, separation: T, by: T, [i, j]: [Degree; 2]) -> Matrix2<T> {
    let Spot { t, n, weights, rates, curvature } = *spot;
    let motion = |i: Degree, x: T| i.map_or(x, |i| -(x * weights[i]));
    let bend = outer(&t, &t, motion(i, motion(j, -(by * curvature))));
    let shear = j.map(|j| outer(&t, &n, motion(i, -(by * rates[j]))));
    let back = i.map(|i| outer(&n, &t, motion(j, -(by * rates[i]))));
    let turn = i.zip(j).map(|(i, j)| outer(&n, &n, -(by * separation * rates[i] * rates[j])));
    [shear, back, turn].into_iter().flatten().fold(bend, |all, m| sum(all, [m]))
}

/// All that differ.
fn blocks<T: Component>(block: impl Fn([Degree; 2]) -> Matrix2<T>) -> ParabolicStiffness<T> {
    let [s, a, b, c] = [None, Some(0), Some(1), Some(2)];
    ParabolicStiffness {
        k_us_us: block([s, s]),
        k_us_u1: block([s, a]),
        k_us_u2: block([s, b]),
        k_us_u3: block([s, c]),
        k_u1_u1: block([a, a]),
        k_u1_u2: block([a, b]),
        k_u1_u3: block([a, c]),
        k_u2_u2: block([b, b]),
        k_u2_u3: block([b, c]),
        k_u3_u3: block([c, c]),
    }
}

/// How far the closest point moves along the line, (aᵢ t + E11 bᵢ n)/(1 − κ E11), and how far the line turns there,
/// (bᵢ n + κ aᵢ t)/(1 − κ E11), where the slave point or a node moves.
fn carried<D: Scalar>(spot: &Spot<D, 3>, separation: D, per: D, i: Degree) -> [Vector2<D>; 2] {
    let Spot { t, n, weights, rates, curvature } = *spot;
    let (a, b) = i.map_or((D::one(), D::zero()), |i| (-weights[i], rates[i]));
    [(t * a + n * (separation * b)) * per, (n * b + t * (curvature * a)) * per]
}

impl Formula for Parabolic {
    const SPEC: Spec = Spec::new("slide_line.geometric_stiffness_parabolic", "Geometric stiffness of contact on a parabolic segment", OURS)
        .equation(r"\begin{aligned} \mathbf{K}_{us,us} &= -c\kappa\,\mathbf{t}\otimes\mathbf{t},\quad \mathbf{K}_{us,u1} = -c\,(\mathbf{t}\otimes\mathbf{b}_1 + \kappa\,\mathbf{t}\otimes\mathbf{a}_1),\quad \mathbf{K}_{us,u2} = -c\,(\mathbf{t}\otimes\mathbf{b}_2 + \kappa\,\mathbf{t}\otimes\mathbf{a}_2),\quad \mathbf{K}_{us,u3} = -c\,(\mathbf{t}\otimes\mathbf{b}_3 + \kappa\,\mathbf{t}\otimes\mathbf{a}_3), \\ \mathbf{K}_{u1,u1} &= -c\,(\mathbf{a}_1\otimes\mathbf{b}_1 + \mathbf{b}_1\otimes\mathbf{a}_1 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_1 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_1),\quad \mathbf{K}_{u1,u2} = -c\,(\mathbf{a}_1\otimes\mathbf{b}_2 + \mathbf{b}_1\otimes\mathbf{a}_2 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_2 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_2), \\ \mathbf{K}_{u1,u3} &= -c\,(\mathbf{a}_1\otimes\mathbf{b}_3 + \mathbf{b}_1\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_3),\quad \mathbf{K}_{u2,u2} = -c\,(\mathbf{a}_2\otimes\mathbf{b}_2 + \mathbf{b}_2\otimes\mathbf{a}_2 + \kappa\,\mathbf{a}_2\otimes\mathbf{a}_2 + E_{11}\,\mathbf{b}_2\otimes\mathbf{b}_2), \\ \mathbf{K}_{u2,u3} &= -c\,(\mathbf{a}_2\otimes\mathbf{b}_3 + \mathbf{b}_2\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_2\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_2\otimes\mathbf{b}_3),\quad \mathbf{K}_{u3,u3} = -c\,(\mathbf{a}_3\otimes\mathbf{b}_3 + \mathbf{b}_3\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_3\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_3\otimes\mathbf{b}_3), \\ c &= \frac{\lambda}{1-\kappa E_{11}},\quad \kappa = \frac{\mathbf{n}\cdot(\mathbf{x}_1-2\,\mathbf{x}_2+\mathbf{x}_3)}{\lvert\mathbf{X}'\rvert^2},\quad \mathbf{a}_1 = -\tfrac12 g(g-1)\,\mathbf{t},\quad \mathbf{a}_2 = -(1-g^2)\,\mathbf{t},\quad \mathbf{a}_3 = -\tfrac12 g(g+1)\,\mathbf{t}, \\ \mathbf{b}_1 &= \frac{g-\tfrac12}{\lvert\mathbf{X}'\rvert}\,\mathbf{n},\quad \mathbf{b}_2 = -\frac{2g}{\lvert\mathbf{X}'\rvert}\,\mathbf{n},\quad \mathbf{b}_3 = \frac{g+\tfrac12}{\lvert\mathbf{X}'\rvert}\,\mathbf{n} \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &ParabolicPoint::SPEC)])
        // Third derivatives of a closest point: terms of either sign cancel. At 5000 random points it is 14 and 170.
        .eta(24.0, 512.0)
        .scale(1e3);
    type Inputs<T: Component> = ParabolicTouch<T>;
    type Outputs<T: Component> = ParabolicStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicTouch<D>) -> ParabolicStiffness<D> {
        let spot = Place::parabolic([i.x1, i.x2, i.x3], i.g).spot;
        let by = i.lambda * i.per_reach(&spot);
        blocks(|degrees| block(&spot, i.separation, by, degrees))
    }

    /// By E11 and by κ a block changes by the products of what `carried` says, times −λ: quotients that would cancel otherwise.
    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicTouch<D>) -> Jacobian<Self, D> {
        let place = Place::parabolic([i.x1, i.x2, i.x3], i.g);
        let (spot, varied, per) = (place.spot, place.varied::<9>(), i.per_reach(&place.spot));
        let held = Spot { curvature: Term::constant(spot.curvature), ..varied };
        let (separation, by) = (Term::constant(i.separation), Term::variable(i.lambda, 8) * Term::constant(per));
        let by_separation = Term::<D, 9>::variable(i.separation, 7).slope;
        gradients(&blocks(|[a, b]| {
            let ([moved_a, turned_a], [moved_b, turned_b]) =
                (carried(&spot, i.separation, per, a), carried(&spot, i.separation, per, b));
            block(&held, separation, by, [a, b]).map_with_location(|row, column, entry| {
                let (of_turn, of_way) = (turned_a[row] * turned_b[column], moved_a[row] * moved_b[column]);
                let more = by_separation * of_turn + varied.curvature.slope * of_way;
                Term::new(entry.value, entry.slope - more * i.lambda)
            })
        }))
    }

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicTouch<D>) -> Result<(), Error> {
        check_tangent([i.x1, i.x2, i.x3], i.g)?;
        let spot = Place::parabolic([i.x1, i.x2, i.x3], i.g).spot;
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

/// A block in its place and, off the diagonal, its transpose in the other.
fn place<D: Scalar, const M: usize>(all: &mut SMatrix<D, M, M>, row: usize, column: usize, block: &Matrix2<D>) {
    all.fixed_view_mut::<2, 2>(2 * column, 2 * row).copy_from(&block.transpose());
    all.fixed_view_mut::<2, 2>(2 * row, 2 * column).copy_from(block);
}

impl<D: Scalar> LinearStiffness<D> {
    /// All blocks in their places, for the translations of the slave point and of both nodes.
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
    /// All blocks in their places, for the translations of the slave point and of the three nodes.
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
