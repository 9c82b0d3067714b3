//! The curves of a slide line, defined by the weights of the nodes in their points.
//!
//! A point is X(u) = Σ Nᵢ(u) xᵢ with weights that add up to 1; their derivatives add up to 0. Points and derivatives are
//! evaluated from differences of nodes, relative to the node with the largest weight: then a common offset of all nodes costs no
//! digits, and the rounding error of no node counts for much more than its weight.

use super::basis::length_and_tangent;
use crate::Scalar;
use crate::number::scalar::{abs, choice};
use nalgebra::Vector2;

/// A curve through N nodes, with a parameter f (the smoothing fraction; unused by segments).
///
/// At a smoothed corner all derivatives contain f as a factor. It is omitted from them here, and returned by `factor`.
pub(super) trait Shape<const N: usize> {
    /// The coordinates of the ends.
    const ENDS: [f64; 2];

    /// N(u).
    fn weights<D: Scalar>(f: D, u: D) -> [D; N];

    /// N′(u)/factor.
    fn rates<D: Scalar>(f: D, u: D) -> [D; N];

    /// N″(u)/factor.
    fn second_derivatives<D: Scalar>(f: D, u: D) -> [D; N];

    /// N‴/factor.
    fn third_derivatives<D: Scalar>(_: D) -> [D; N] {
        [D::zero(); N]
    }

    /// Two vectors with the product Y′ × Y″, if the curve is quadratic: then it is the same everywhere.
    fn turning<D: Scalar>(_: &[Vector2<D>; N]) -> Option<[Vector2<D>; 2]> {
        None
    }

    /// The factor omitted from the derivatives.
    fn factor<D: Scalar>(_: D) -> D {
        D::one()
    }

    /// The weights of the point closest to xs on the tangent at an end.
    ///
    /// Each is a sum of differences from xs: computed as the weights of the end plus a step along the tangent they would be
    /// differences, and the smaller ones inaccurate.
    fn on_end_tangent<D: Scalar>(xs: Vector2<D>, nodes: &[Vector2<D>; N], f: D, u: D) -> [D; N];
}

/// The differences of the nodes of a parabola, from which its derivatives are formed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sides<D> {
    /// x2 − x1.
    pub(crate) before: Vector2<D>,
    /// x3 − x2.
    pub(crate) after: Vector2<D>,
    /// x3 − x1.
    pub(crate) chord: Vector2<D>,
}

impl<D: Scalar> Sides<D> {
    #[inline]
    pub(crate) fn new([x1, x2, x3]: [Vector2<D>; 3]) -> Self {
        Self { before: x2 - x1, after: x3 - x2, chord: x3 - x1 }
    }

    /// X′ = ½ chord + g (after − before) = (½−g) before + (½+g) after.
    ///
    /// The first form is used near the midside node, the second elsewhere: then no node enters with much more than its own
    /// weight, and its rounding error is harmless where it hardly matters.
    #[inline]
    pub(crate) fn rate(&self, g: D) -> Vector2<D> {
        let rate = || {
            if g < 0.25 && g > -0.25 {
                self.chord * D::from(0.5) + self.second_derivative() * g
            } else {
                self.before * (-g + 0.5) + self.after * (g + 0.5)
            }
        };
        choice::<D, 2>(|| rate().into()).into()
    }

    /// X″.
    #[inline]
    pub(crate) fn second_derivative(&self) -> Vector2<D> {
        self.after - self.before
    }

    /// The side before the midside node, and the one after it or, if that is shorter, the chord: their product is the same.
    #[inline]
    fn shorter(&self) -> [Vector2<D>; 2] {
        let size = |v: Vector2<D>| abs(v.x) + abs(v.y);
        let other =
            choice::<D, 2>(|| (if size(self.chord) < size(self.after) { self.chord } else { self.after }).into());
        [self.before, other.into()]
    }

    /// n·X″ = before × after / |X′|.
    #[inline]
    pub(crate) fn turn(&self, speed: D) -> D {
        let [before, other] = self.shorter();
        (before / speed).perp(&other)
    }
}

/// Weights of x1, x2 on a straight segment.
#[inline]
pub(crate) fn linear<D: Scalar>(g: D) -> [D; 2] {
    [(-g + 1.0) * 0.5, (g + 1.0) * 0.5]
}

/// A parabolic segment x1, x2, x3 with midside node x2, and −1 ≤ g ≤ 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parabola;

impl Shape<3> for Parabola {
    const ENDS: [f64; 2] = [-1.0, 1.0];

    #[inline]
    fn weights<D: Scalar>(_: D, g: D) -> [D; 3] {
        parabolic(g)
    }
    #[inline]
    fn rates<D: Scalar>(_: D, g: D) -> [D; 3] {
        parabolic_rates(g)
    }
    #[inline]
    fn second_derivatives<D: Scalar>(_: D, _: D) -> [D; 3] {
        [1.0, -2.0, 1.0].map(D::from)
    }
    #[inline]
    fn turning<D: Scalar>(nodes: &[Vector2<D>; 3]) -> Option<[Vector2<D>; 2]> {
        Some(Sides::new(*nodes).shorter())
    }
    fn on_end_tangent<D: Scalar>(xs: Vector2<D>, nodes: &[Vector2<D>; 3], _: D, g: D) -> [D; 3] {
        let square = |x: D| x * x * 0.5;
        on_tangent(xs, nodes, g, [square(-g + 1.0), square(g), square(g + 1.0)])
    }
}

/// The weights of the point closest to xs on the tangent of a parabola at g; given ½(1−g)², ½g² and ½(1+g)².
///
/// A point Σ wᵢ xᵢ of the tangent has the weights w = N + τ N′. With τ = (xs − X)·X′/|X′|² every weight is
/// wⱼ = Σᵢ (Nᵢ Nⱼ′ − Nᵢ′ Nⱼ) (xs − xᵢ)·X′/|X′|², and these Wronskians are the three squares, with signs. Whatever numbers
/// stand in place of the (xs − xᵢ)·X′/|X′|², the point is on the tangent once the weights are divided by their sum.
fn on_tangent<D: Scalar>(xs: Vector2<D>, nodes: &[Vector2<D>; 3], g: D, [left, middle, right]: [D; 3]) -> [D; 3] {
    let (length, along) = length_and_tangent(Sides::new(*nodes).rate(g));
    let [d1, d2, d3] = nodes.map(|x| (xs - x).dot(&along) / length);
    [middle * d3 - left * d2, left * d1 - right * d3, right * d2 - middle * d1]
}

/// Weights of x1, x2, x3 on a parabola.
#[inline]
pub(crate) fn parabolic<D: Scalar>(g: D) -> [D; 3] {
    let half = g * 0.5;
    [half * (g - 1.0), (-g + 1.0) * (g + 1.0), half * (g + 1.0)]
}

/// Their derivatives.
#[inline]
pub(crate) fn parabolic_rates<D: Scalar>(g: D) -> [D; 3] {
    [g - 0.5, g * -2.0, g + 0.5]
}

/// The smoothed corner x2 between straight segments, with 0 ≤ t ≤ 1 and s = 1 − t.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinearCorner;

impl Shape<3> for LinearCorner {
    const ENDS: [f64; 2] = [0.0, 1.0];

    #[inline]
    fn weights<D: Scalar>(f: D, t: D) -> [D; 3] {
        let s = -t + 1.0;
        let (first, last) = (f * s * s, f * t * t);
        [first, -(first + last) + 1.0, last]
    }
    #[inline]
    fn rates<D: Scalar>(_: D, t: D) -> [D; 3] {
        let s = -t + 1.0;
        [s * -2.0, (s - t) * 2.0, t * 2.0]
    }
    #[inline]
    fn second_derivatives<D: Scalar>(_: D, _: D) -> [D; 3] {
        [2.0, -4.0, 2.0].map(D::from)
    }
    #[inline]
    fn turning<D: Scalar>(nodes: &[Vector2<D>; 3]) -> Option<[Vector2<D>; 2]> {
        let [side, other] = Sides::new(*nodes).shorter();
        Some([side * D::from(4.0), other])
    }
    /// The tangents are the straight segments, for every f.
    fn on_end_tangent<D: Scalar>(xs: Vector2<D>, [x1, x2, x3]: &[Vector2<D>; 3], _: D, t: D) -> [D; 3] {
        let zero = D::zero();
        let weights = |far: &Vector2<D>| {
            let (length, along) = length_and_tangent(far - x2);
            [(xs - x2).dot(&along) / length, (far - xs).dot(&along) / length]
        };
        if t < 0.5 {
            let [n1, n2] = weights(x1);
            [n1, n2, zero]
        } else {
            let [n3, n2] = weights(x3);
            [zero, n2, n3]
        }
    }
    #[inline]
    fn factor<D: Scalar>(f: D) -> D {
        f
    }
}

/// The smoothed corner x3 between parabolas, with 0 ≤ t ≤ 1 and s = 1 − t: the cubic Bézier curve, collected by nodes.
///
/// The nodes on either side have the same functions, of s before the corner and of t after it. For 0 < f < ½ none of the weights
/// is a difference of nearly equal terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct ParabolicCorner;

impl ParabolicCorner {
    /// The two terms of ½ ∂²X/∂f² = 2 (s−t) (s² (x1−2x2+x3) − t² (x3−2x4+x5)), given s, t and s − t.
    #[inline]
    pub(super) fn bend_by_fraction<D: Scalar>(
        [x1, x2, x3, x4, x5]: [Vector2<D>; 5],
        [s, t, difference]: [D; 3],
    ) -> [Vector2<D>; 2] {
        let side = |nodes, weight: D| Sides::new(nodes).second_derivative() * (difference * weight * 2.0);
        [side([x1, x2, x3], s * s), side([x3, x4, x5], -(t * t))]
    }

    /// The weights of the nodes beside x3 in ∂X/∂f + ½s Y′ if s ≥ t, and in ∂X/∂f − ½t Y′ otherwise. They vanish at the nearer end.
    #[inline]
    pub(super) fn across_by_fraction<D: Scalar>(f: D, [s, t]: [D; 2]) -> [D; 5] {
        let sides = |near: D, other: D| {
            let (bent, more) = (f * near * near * other * 2.0, f * (-(other * (other + 2.0)) + 1.0));
            [[-bent, bent * 2.0], [-(other * (more * 2.0 + 1.0)), other * (more + 1.0) * 4.0]]
        };
        let zero = D::zero();
        choice(|| {
            let [[n1, n2], [n5, n4]] = sides(s, t);
            let [[m5, m4], [m1, m2]] = sides(t, s);
            if s < t { [m1, m2, zero, m4, m5] } else { [n1, n2, zero, n4, n5] }
        })
    }

    /// The derivatives of weights, rates and second derivatives with respect to f.
    #[inline]
    pub(super) fn by_fraction<D: Scalar>(f: D, t: D) -> [[D; 5]; 3] {
        let s = -t + 1.0;
        let rest = -(f * 4.0) + 1.0;
        let weights = both_sides(s, t, |near, other| {
            let square = near * near;
            [-(square * (rest + f * other * 8.0)), square * (-(f * 2.0) + 1.0 + f * other * 4.0) * 4.0]
        });
        let rates = both_sides(s, t, |near, _| {
            let turn = (-(near * 3.0) + 1.0) * near;
            [turn * 4.0, turn * -8.0]
        });
        let second_derivatives = both_sides(s, t, |near, _| {
            let turn = -(near * 6.0) + 1.0;
            [turn * -4.0, turn * 8.0]
        });
        let middle = f * 4.0 - 3.0 + (-(f * 16.0) + 6.0) * s * t;
        [
            with_middle(weights, middle),
            with_middle(against(rates), (s - t) * -8.0),
            with_middle(second_derivatives, D::from(16.0)),
        ]
    }
}

impl Shape<5> for ParabolicCorner {
    const ENDS: [f64; 2] = [0.0, 1.0];

    #[inline]
    fn weights<D: Scalar>(f: D, t: D) -> [D; 5] {
        let s = -t + 1.0;
        let rest = -(f * 2.0) + 1.0;
        let sides = both_sides(s, t, |near, other| {
            let square = f * near * near;
            [-(square * (rest + f * other * 4.0)), square * (-f + 1.0 + f * other * 2.0) * 4.0]
        });
        with_middle(sides, rest * (-f + 1.0) + f * (-(f * 4.0) + 3.0) * s * t * 2.0)
    }
    #[inline]
    fn rates<D: Scalar>(f: D, t: D) -> [D; 5] {
        let s = -t + 1.0;
        let sides = both_sides(s, t, |near, _| {
            let turn = f * (-(near * 3.0) + 1.0);
            [near * (turn * 2.0 + 1.0) * 2.0, near * (turn + 1.0) * -8.0]
        });
        with_middle(against(sides), (s - t) * (-(f * 8.0) + 6.0))
    }
    #[inline]
    fn second_derivatives<D: Scalar>(f: D, t: D) -> [D; 5] {
        let s = -t + 1.0;
        let sides = both_sides(s, t, |near, _| {
            let turn = f * (-(near * 6.0) + 1.0);
            [-(turn * 4.0 + 2.0), turn * 8.0 + 8.0]
        });
        with_middle(sides, f * 16.0 - 12.0)
    }
    #[inline]
    fn third_derivatives<D: Scalar>(f: D) -> [D; 5] {
        [-24.0, 48.0, 0.0, -48.0, 24.0].map(|weight| f * weight)
    }
    fn on_end_tangent<D: Scalar>(xs: Vector2<D>, [x1, x2, x3, x4, x5]: &[Vector2<D>; 5], f: D, t: D) -> [D; 5] {
        let (zero, g) = (D::zero(), -(f * 2.0) + 1.0);
        let rest = -f + 1.0;
        let [near, middle, far] = [f * f * 2.0, g * g * 0.5, rest * rest * 2.0];
        if t < 0.5 {
            let [n1, n2, n3] = on_tangent(xs, &[*x1, *x2, *x3], g, [near, middle, far]);
            [n1, n2, n3, zero, zero]
        } else {
            let [n3, n4, n5] = on_tangent(xs, &[*x3, *x4, *x5], -g, [far, middle, near]);
            [zero, zero, n3, n4, n5]
        }
    }
    #[inline]
    fn factor<D: Scalar>(f: D) -> D {
        f
    }
}

/// Far node and midside node before the corner, then those after it.
#[inline]
fn both_sides<D: Scalar>(s: D, t: D, side: impl Fn(D, D) -> [D; 2]) -> [[D; 2]; 2] {
    [side(s, t), side(t, s)]
}

/// After the corner the coordinate runs in the opposite direction.
#[inline]
fn against<D: Scalar>([before, after]: [[D; 2]; 2]) -> [[D; 2]; 2] {
    [before, after.map(|n| -n)]
}

#[inline]
fn with_middle<D: Scalar>([[n1, n2], [n5, n4]]: [[D; 2]; 2], n3: D) -> [D; 5] {
    [n1, n2, n3, n4, n5]
}

/// Σ wᵢ xᵢ for weights that add up to 0.
#[inline]
pub(super) fn combination<D: Scalar, const N: usize>(nodes: &[Vector2<D>; N], weights: [D; N]) -> Vector2<D> {
    weighted(&from_heaviest(nodes, weights), weights)
}

/// The nodes relative to that with the weight of largest magnitude.
#[inline(always)]
#[expect(clippy::inline_always, reason = "a call would need nodes and weights in memory")]
pub(super) fn from_heaviest<D: Scalar, const N: usize>(nodes: &[Vector2<D>; N], weights: [D; N]) -> [Vector2<D>; N] {
    let base = heaviest(nodes, weights.map(abs));
    nodes.map(|x| x - base)
}

/// Σ wᵢ xᵢ. For weights that add up to 0 the nodes may be given relative to one of them.
#[inline(always)]
#[expect(clippy::inline_always, reason = "a call would need nodes and weights in memory")]
pub(super) fn weighted<D: Scalar, const N: usize>(nodes: &[Vector2<D>; N], weights: [D; N]) -> Vector2<D> {
    nodes.iter().zip(weights).fold(Vector2::from_element(D::zero()), |sum, (x, w)| sum + x * w)
}

/// xs − Σ wᵢ xᵢ for weights that add up to 1.
#[inline]
pub(crate) fn gap<D: Scalar, const N: usize>(xs: Vector2<D>, nodes: &[Vector2<D>; N], weights: [D; N]) -> Vector2<D> {
    let base = heaviest(nodes, weights);
    nodes.iter().zip(weights).fold(xs - base, |gap, (x, w)| gap - (x - base) * w)
}

/// The node of the largest weight. Indices are selected instead of nodes, so that no branch is mispredicted.
#[inline]
fn heaviest<D: Scalar, const N: usize>(nodes: &[Vector2<D>; N], weights: [D; N]) -> Vector2<D> {
    let heaviest = || {
        let (mut place, mut most) = (0, weights[0]);
        for (k, &weight) in weights.iter().enumerate().skip(1) {
            let is_more = weight > most;
            place = if is_more { k } else { place };
            most = if is_more { weight } else { most };
        }
        [nodes[place].x, nodes[place].y]
    };
    choice(heaviest).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Inconsistent sides show which of them are used.
    #[test]
    fn a_rate_is_that_of_the_chord_near_the_midside_node_and_of_the_halves_elsewhere() {
        let [before, after, chord] = [[1.0, 0.0], [1.0, 0.0], [4.0, 0.0]].map(Vector2::from);
        let sides = Sides { before, after, chord };
        for g in [0.0, 0.24, -0.24] {
            assert_eq!(sides.rate(g).x, 2.0, "{g}");
        }
        for g in [0.25, -0.25, 0.5, -0.5, 1.0, -1.0] {
            assert_eq!(sides.rate(g).x, 1.0, "{g}");
        }
    }

    #[test]
    fn a_turn_is_measured_with_the_shorter_side() {
        let turn = |after: [f64; 2], chord: [f64; 2]| {
            let [before, after, chord] = [[2.0, 0.0], after, chord].map(Vector2::from);
            Sides { before, after, chord }.turn(2.0)
        };
        assert_eq!((turn([0.0, 4.0], [0.0, 3.0]), turn([0.0, 4.0], [0.0, 5.0])), (3.0, 4.0));
        assert_eq!((turn([0.0, 4.0], [1.0, 3.0]), turn([-3.0, 4.0], [1.0, -5.0])), (4.0, -5.0));
        assert_eq!(turn([-1.0, 4.0], [-3.0, 3.0]), 4.0);
    }

    #[test]
    fn the_heaviest_node_is_the_first_of_the_largest_weight() {
        let nodes = [1.0, 2.0, 3.0].map(|x| Vector2::new(x, -x));
        for (weights, heaviest) in [
            ([0.5, 0.2, 0.3], 1.0),
            ([0.2, 0.5, 0.3], 2.0),
            ([0.2, 0.3, 0.5], 3.0),
            ([0.4, 0.4, 0.2], 1.0),
            ([0.2, 0.4, 0.4], 2.0),
            ([-2.0, -3.0, -1.0], 3.0),
        ] {
            assert_eq!(super::heaviest(&nodes, weights), Vector2::new(heaviest, -heaviest), "{weights:?}");
        }
    }

    /// Nodes far from the origin: the differences are exact, products with whole positions would not be.
    #[test]
    fn sums_are_taken_from_differences() {
        let far = Vector2::new(1e15, -1e15);
        let nodes = [[0.0, 0.0], [1.0, 3.0], [4.0, 2.0]].map(|x| Vector2::from(x) + far);
        let weights = [-0.125, 0.75, 0.375];
        assert_eq!(gap(far + Vector2::new(5.0, 7.0), &nodes, weights), Vector2::new(2.75, 4.0));
        assert_eq!(combination(&nodes, [-0.3, 0.1, 0.2]), Vector2::new(0.1 + 4.0 * 0.2, 0.1 * 3.0 + 0.2 * 2.0));
    }
}
