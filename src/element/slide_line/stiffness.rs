//! How the normal force of the contact changes with the nodes, while its size is held: λ ∂²E11.
//!
//! With aᵢ = (1, −Nᵢ) and bᵢ = (0, Nᵢ′/|X′|) for the slave point and the nodes, t·δ = Σ aᵢ t·δxᵢ is the relative motion along the
//! line and Σ bᵢ n·δxᵢ the turn of its material. The closest point moves along the line by
//! δs = (Σ aᵢ t·δxᵢ + E11 Σ bᵢ n·δxᵢ)/(1 − κ E11), and δ²E11 has all there is from that: the blocks
//! −(aᵢ bⱼ t⊗n + bᵢ aⱼ n⊗t + κ aᵢ aⱼ t⊗t + E11 bᵢ bⱼ n⊗n)/(1 − κ E11), a symmetric matrix. It is infinite where the slave point
//! is on the centre of curvature, and beyond that the place is not the closest one.

#[cfg(feature = "verify")]
mod proof;

use super::{Place, Spot};
use crate::contact::slide_line::{LinearPoint, LocalBasis, ParabolicPoint, check_distinct, check_tangent};
use crate::fields;
use crate::formula::error::{Error, Name};
use crate::formula::quantity::{
    CONTACT_LAMBDA, LINE_K_U1_U1, LINE_K_U1_U2, LINE_K_U1_U3, LINE_K_U2_U2, LINE_K_U2_U3, LINE_K_U3_U3, LINE_K_US_U1,
    LINE_K_US_U2, LINE_K_US_U3, LINE_K_US_US, SEGMENT_G, SEPARATION, X1, X2, X3,
};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Source, Spec, ValueAndJacobian};
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
fn outer<D: Scalar>(v: &Vector2<D>, w: &Vector2<D>, a: D) -> Matrix2<D> {
    Matrix2::from_fn(|i, j| v[i] * w[j] * a)
}

/// The geometric stiffness of contact on a straight segment, λ ∂²E11.
#[derive(Clone, Copy, Debug)]
pub struct Linear;

impl Linear {
    /// With b₂ = −b₁ = 1/ℓ and κ = 0. N₁ P − N₂ Q is ½ (P − Q) − ½ g (P + Q), and P − Q has no direction: λ/ℓ times what turns
    /// to the right.
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
        .eta(4.0, 6.0)
        .by_vectors(4.0, 6.0)
        .scale(1e80)
        .finite(Finite::Between);
    type Inputs<T: Component> = LinearTouch<T>;
    type Outputs<T: Component> = LinearStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearTouch<D>) -> LinearStiffness<D> {
        Self::at(&Place::linear([i.x1, i.x2], i.g).spot, i)
    }

    /// Every block is made of t⊗n + n⊗t, which turns with the tangent by 2 (n⊗n − t⊗t) δφ, and of n⊗n, which turns by −(t⊗n + n⊗t) δφ.
    /// The length changes by δℓ/ℓ = t·(δx₂ − δx₁)/ℓ.
    #[inline]
    fn jacobian<D: Scalar>(i: &LinearTouch<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &LinearTouch<D>) -> ValueAndJacobian<Self, D> {
        let spot = Place::linear([i.x1, i.x2], i.g).spot;
        let Spot { t, n, weights: [n1, n2], rates: [_, per_length], .. } = spot;
        let (half, per, bend) = (D::from(0.5), i.lambda * per_length, i.lambda * per_length * per_length);
        let entry = |turned: D, stretched: D, [g, separation, lambda]: [D; 3]| {
            let x2 = (n * turned + t * stretched) * per_length;
            LinearTouch { x1: -x2, x2, g, separation, lambda }
        };
        let (cos, sin) = ((t.x - t.y) * (t.x + t.y), t.x * t.y * 2.0);
        let (both, turn) = (Matrix2::new(-sin, cos, cos, sin), Matrix2::new(-cos, -sin, -sin, cos));
        let across = Matrix2::new(n.x * n.x, n.x * n.y, n.x * n.y, n.y * n.y);
        let block = |weight: D, weight_rate: D, sign: D, skew: D| {
            let skew = Matrix2::new(D::zero(), skew, -skew, D::zero());
            Matrix2::from_fn(|row, column| {
                let at = (row, column);
                let (shear, across) = (both[at] * weight + skew[at], across[at] * sign);
                let by_separation = across * bend;
                let turned = turn[at] * weight * per * 2.0 - both[at] * sign * bend * i.separation;
                let stretched = -(shear * per + by_separation * i.separation * 2.0);
                let by_lambda = (shear + across * (i.separation * per_length)) * per_length;
                entry(turned, stretched, [both[at] * weight_rate * per, by_separation, by_lambda])
            })
        };
        let of_slave = |row: usize, column: usize| {
            let (shear, zero) = (t[row] * n[column], D::zero());
            entry(turn[(row, column)] * per, -(shear * per), [zero, zero, shear * per_length])
        };
        let by = LinearStiffness {
            k_us_u1: Matrix2::from_fn(of_slave),
            k_u1_u1: block(-n1, half, -D::one(), D::zero()),
            k_u1_u2: block(-(i.g * half), -half, D::one(), half),
            k_u2_u2: block(n2, half, -D::one(), D::zero()),
        };
        (Self::at(&spot, i), by)
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

/// What there is of every block.
trait Blocks<D: Scalar> {
    type Entry: Component;

    fn block(&self, degrees: [Degree; 2]) -> Matrix2<Self::Entry>;

    /// All that differ.
    #[inline(always)]
    fn all(&self) -> ParabolicStiffness<Self::Entry> {
        let [s, a, b, c] = [None, Some(0), Some(1), Some(2)];
        ParabolicStiffness {
            k_us_us: self.inlined_or_called([s, s]),
            k_us_u1: self.inlined_or_called([s, a]),
            k_us_u2: self.inlined_or_called([s, b]),
            k_us_u3: self.inlined_or_called([s, c]),
            k_u1_u1: self.inlined_or_called([a, a]),
            k_u1_u2: self.inlined_or_called([a, b]),
            k_u1_u3: self.inlined_or_called([a, c]),
            k_u2_u2: self.inlined_or_called([b, b]),
            k_u2_u3: self.inlined_or_called([b, c]),
            k_u3_u3: self.inlined_or_called([c, c]),
        }
    }

    /// Where several rows are computed at once, what is called is not compiled for vectors; one row alone is faster with calls.
    #[inline(always)]
    fn inlined_or_called(&self, degrees: [Degree; 2]) -> Matrix2<Self::Entry> {
        if D::has_extremes() { self.called(degrees) } else { self.block(degrees) }
    }

    #[inline]
    fn called(&self, degrees: [Degree; 2]) -> Matrix2<Self::Entry> {
        self.block(degrees)
    }
}

/// The blocks, where `by` is λ/(1 − κ E11).
struct Values<'p, D> {
    spot: &'p Spot<D, 3>,
    separation: D,
    by: D,
}

impl<D: Scalar> Blocks<D> for Values<'_, D> {
    type Entry = D;

    #[inline(always)]
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

/// What the motion of the slave point or of a node does.
struct Motion<D> {
    /// aᵢ and bᵢ.
    held: [D; 2],
    /// Their derivatives by g.
    by_g: [D; 2],
    /// How far the closest point moves along the line, (aᵢ t + E11 bᵢ n)/(1 − κ E11).
    moved: Vector2<D>,
    /// How far the line turns there, (bᵢ n + κ aᵢ t)/(1 − κ E11).
    turned: Vector2<D>,
}

impl<D: Scalar> Motion<D> {
    #[inline(always)]
    fn new(place: &Place<D, 3>, separation: D, per: D, degree: Degree) -> Self {
        let (one, zero) = (D::one(), D::zero());
        let [a, b] = degree.map_or([one, zero], |i| [-place.spot.weights[i], place.spot.rates[i]]);
        let by_g = degree.map_or([zero; 2], |i| [-place.weight_rates[i], place.spreads[i]]);
        let Spot { t, n, curvature, .. } = place.spot;
        let moved = (t * a + n * (separation * b)) * per;
        Self { held: [a, b], by_g, moved, turned: (n * b + t * (curvature * a)) * per }
    }
}

/// The derivatives of the blocks.
struct Derivatives<'p, D> {
    i: &'p ParabolicTouch<D>,
    place: &'p Place<D, 3>,
    /// 1/(1 − κ E11).
    per: D,
    /// The change of κ with g, for that of the length.
    stretch: D,
    /// Nᵢ′ t, Nᵢ′ n and the derivatives of Nᵢ′ by g, along n, over |X′|.
    along: [Vector2<D>; 3],
    across: [Vector2<D>; 3],
    bent: [Vector2<D>; 3],
    motions: [Motion<D>; 4],
}

impl<'p, D: Scalar> Derivatives<'p, D> {
    #[inline(always)]
    fn new(i: &'p ParabolicTouch<D>, place: &'p Place<D, 3>, per: D) -> Self {
        let (Spot { t, n, curvature, rates, .. }, per_speed) = (place.spot, place.speed.recip());
        let motion = |degree| Motion::new(place, i.separation, per, degree);
        Self {
            i,
            place,
            per,
            stretch: curvature * place.stretch * 3.0,
            along: rates.map(|rate| t * rate),
            across: rates.map(|rate| n * rate),
            bent: place.spreads.map(|spread| n * (spread * per_speed)),
            motions: [motion(None), motion(Some(0)), motion(Some(1)), motion(Some(2))],
        }
    }
}

impl<D: Scalar> Blocks<D> for Derivatives<'_, D> {
    type Entry = ParabolicTouch<D>;

    #[inline(always)]
    fn block(&self, degrees: [Degree; 2]) -> Matrix2<ParabolicTouch<D>> {
        let Self { i, place, per, stretch, along, across, bent, motions } = self;
        let Spot { t, n, curvature, .. } = place.spot;
        let form =
            |[a, b]: [D; 2], [c, d]: [D; 2]| Matrix2::new(curvature * a * c, a * d, b * c, i.separation * b * d) * *per;
        let turning = |m: Matrix2<D>| {
            let (shear, difference) = (m.m12 + m.m21, m.m11 - m.m22);
            Matrix2::new(-shear, difference, difference, shear)
        };
        let stretching = |m: Matrix2<D>| Matrix2::new(D::zero(), m.m12, m.m21, m.m22 * 2.0);
        // In the plane, from the basis of t and n; with the sign that all blocks have.
        let in_plane = |m: Matrix2<D>| {
            let [u, v] = [t * m.m11 + n * m.m21, t * m.m12 + n * m.m22];
            Matrix2::from_fn(|row, column| -(u[row] * t[column] + v[row] * n[column]))
        };
        let [first, second] = degrees.map(|degree| &motions[degree.map_or(0, |node| node + 1)]);
        let held = form(first.held, second.held);
        let by_curvature = outer(&first.moved, &second.moved, -i.lambda);
        let by_g = form(first.by_g, second.held) + form(first.held, second.by_g);
        let by_g = in_plane(by_g * i.lambda) - by_curvature * *stretch;
        let stretched = -in_plane(stretching(held) * i.lambda) - by_curvature * (curvature * 2.0);
        let (turned, by_lambda) = (in_plane(turning(held) * i.lambda), in_plane(held));
        let by_separation = outer(&first.turned, &second.turned, -i.lambda);
        let entry = |row: usize, column: usize| {
            let at = (row, column);
            let of_node = |k: usize| across[k] * turned[at] + along[k] * stretched[at] + bent[k] * by_curvature[at];
            let (g, separation, lambda) = (place.bend * turned[at] + by_g[at], by_separation[at], by_lambda[at]);
            ParabolicTouch { x1: of_node(0), x2: of_node(1), x3: of_node(2), g, separation, lambda }
        };
        Matrix2::new(entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1))
    }
}

impl Formula for Parabolic {
    const SPEC: Spec = Spec::new("slide_line.geometric_stiffness_parabolic", "Geometric stiffness of contact on a parabolic segment", OURS)
        .equation(r"\begin{aligned} \mathbf{K}_{us,us} &= -c\kappa\,\mathbf{t}\otimes\mathbf{t},\quad \mathbf{K}_{us,u1} = -c\,(\mathbf{t}\otimes\mathbf{b}_1 + \kappa\,\mathbf{t}\otimes\mathbf{a}_1),\quad \mathbf{K}_{us,u2} = -c\,(\mathbf{t}\otimes\mathbf{b}_2 + \kappa\,\mathbf{t}\otimes\mathbf{a}_2),\quad \mathbf{K}_{us,u3} = -c\,(\mathbf{t}\otimes\mathbf{b}_3 + \kappa\,\mathbf{t}\otimes\mathbf{a}_3), \\ \mathbf{K}_{u1,u1} &= -c\,(\mathbf{a}_1\otimes\mathbf{b}_1 + \mathbf{b}_1\otimes\mathbf{a}_1 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_1 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_1),\quad \mathbf{K}_{u1,u2} = -c\,(\mathbf{a}_1\otimes\mathbf{b}_2 + \mathbf{b}_1\otimes\mathbf{a}_2 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_2 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_2), \\ \mathbf{K}_{u1,u3} &= -c\,(\mathbf{a}_1\otimes\mathbf{b}_3 + \mathbf{b}_1\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_1\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_1\otimes\mathbf{b}_3),\quad \mathbf{K}_{u2,u2} = -c\,(\mathbf{a}_2\otimes\mathbf{b}_2 + \mathbf{b}_2\otimes\mathbf{a}_2 + \kappa\,\mathbf{a}_2\otimes\mathbf{a}_2 + E_{11}\,\mathbf{b}_2\otimes\mathbf{b}_2), \\ \mathbf{K}_{u2,u3} &= -c\,(\mathbf{a}_2\otimes\mathbf{b}_3 + \mathbf{b}_2\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_2\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_2\otimes\mathbf{b}_3),\quad \mathbf{K}_{u3,u3} = -c\,(\mathbf{a}_3\otimes\mathbf{b}_3 + \mathbf{b}_3\otimes\mathbf{a}_3 + \kappa\,\mathbf{a}_3\otimes\mathbf{a}_3 + E_{11}\,\mathbf{b}_3\otimes\mathbf{b}_3), \\ c &= \frac{\lambda}{1-\kappa E_{11}},\quad \kappa = \frac{\mathbf{n}\cdot(\mathbf{x}_1-2\,\mathbf{x}_2+\mathbf{x}_3)}{\lvert\mathbf{X}'\rvert^2},\quad \mathbf{a}_1 = -\tfrac12 g(g-1)\,\mathbf{t},\quad \mathbf{a}_2 = -(1-g^2)\,\mathbf{t},\quad \mathbf{a}_3 = -\tfrac12 g(g+1)\,\mathbf{t}, \\ \mathbf{b}_1 &= \frac{g-\tfrac12}{\lvert\mathbf{X}'\rvert}\,\mathbf{n},\quad \mathbf{b}_2 = -\frac{2g}{\lvert\mathbf{X}'\rvert}\,\mathbf{n},\quad \mathbf{b}_3 = \frac{g+\tfrac12}{\lvert\mathbf{X}'\rvert}\,\mathbf{n} \end{aligned}")
        .given(&[Given::new(r"\mathbf{t},\ \mathbf{n}", &LocalBasis::SPEC), Given::new(r"\mathbf{X}'", &ParabolicPoint::SPEC)])
        // Third derivatives of a closest point: terms of either sign cancel.
        .eta(24.0, 512.0)
        .by_vectors(6.0, 256.0)
        .scale(1e3);
    type Inputs<T: Component> = ParabolicTouch<T>;
    type Outputs<T: Component> = ParabolicStiffness<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicTouch<D>) -> ParabolicStiffness<D> {
        let spot = Place::parabolic([i.x1, i.x2, i.x3], i.g).spot;
        let by = i.lambda * i.per_reach(&spot);
        Values { spot: &spot, separation: i.separation, by }.all()
    }

    /// By E11 and by κ a block changes by the products of how far the line turns there and how far the point moves, times −λ:
    /// quotients that would cancel otherwise. By the length, bᵢ changes as 1/ℓ does, and κ as 1/ℓ².
    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicTouch<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &ParabolicTouch<D>) -> ValueAndJacobian<Self, D> {
        let place = Place::parabolic([i.x1, i.x2, i.x3], i.g);
        let per = i.per_reach(&place.spot);
        let value = Values { spot: &place.spot, separation: i.separation, by: i.lambda * per };
        (value.all(), Derivatives::new(i, &place, per).all())
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
