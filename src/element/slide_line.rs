//! Contact along a slide line as an element: a slave point, and the two or three nodes of the segment that it touches.
//!
//! | | |
//! |---|---|
//! | unknowns | the translations of the slave point and of the nodes of the segment, in the plane (r, z) |
//! | place | the closest point of the segment, g, which [`closest_*`](crate::contact::slide_line) finds |
//! | rows | of the separation E11: n and −Nᵢ n; of the slip: t and −Nᵢ t |
//! | zero position | E11 = 0: the slave point on the segment |
//! | signs | as of [`isl`](crate::contact::isl): S11 pushes the slave point along n, S12 along −t, which is against positive slip |
//!
//! The separation has no first derivative by g: at the closest point it is stationary. So its row is exact, although g is held. The
//! row of the slip is the velocity relative to the material at the place g, which is held, too. It is not the derivative
//! of the way of the closest point along the line, which ends at g but begins elsewhere; a consistent tangent needs both.
//!
//! Forces are those of the whole circumference. Those on the slave point and on the segment add up to nothing, along the axis
//! and along the radius: the nodes of a segment are rings, and what a ring takes up in its hoop is not the contact's.

#![expect(clippy::inline_always, reason = "a call would write the results to memory, and wait for them there")]

pub mod forces;
pub mod friction;
pub mod response;
pub mod rows;
pub mod stiffness;

use crate::contact::slide_line::{LinearPlace, ParabolicPlace, Sides, length_and_tangent, shape};
use crate::number::scalar::{Scalar, abs, choice};
use nalgebra::Vector2;

/// A place on a segment of N nodes.
#[derive(Clone, Copy, Debug)]
struct Spot<D, const N: usize> {
    t: Vector2<D>,
    n: Vector2<D>,
    /// Nᵢ.
    weights: [D; N],
    /// Nᵢ′/|X′|: by the length of the line.
    rates: [D; N],
    /// The curvature n·X″/|X′|².
    curvature: D,
}

/// A place on a segment, and what its derivatives need beside it.
struct Place<D, const N: usize> {
    spot: Spot<D, N>,
    /// |X′|.
    speed: D,
    /// Nᵢ′.
    weight_rates: [D; N],
    /// The derivatives of the rates by g, (Nᵢ″ X′ − Nᵢ′ X″)·t/|X′|².
    spreads: [D; N],
    /// n·X″/|X′|, by which the tangent turns with g.
    bend: D,
    /// t·X″/|X′|.
    stretch: D,
}

impl<D: Scalar> Place<D, 2> {
    fn linear([x1, x2]: [Vector2<D>; 2], g: D) -> Self {
        let (length, t) = length_and_tangent(x2 - x1);
        let (zero, per_length) = (D::zero(), length.recip());
        let (weights, rates) = (shape::linear(g), [-per_length, per_length]);
        let spot = Spot { t, n: Vector2::new(-t.y, t.x), weights, rates, curvature: zero };
        let weight_rates = [D::from(-0.5), D::from(0.5)];
        Self { spot, speed: length * 0.5, weight_rates, spreads: [zero; 2], bend: zero, stretch: zero }
    }
}

impl<D: Scalar> Place<D, 3> {
    #[inline(always)]
    fn parabolic(nodes: [Vector2<D>; 3], g: D) -> Self {
        let sides = Sides::new(nodes);
        let (speed, t) = length_and_tangent(sides.rate(g));
        let per_speed = speed.recip();
        let bend = sides.turn(speed) * per_speed;
        let weight_rates = shape::parabolic_rates(g);
        let spot = Spot {
            t,
            n: Vector2::new(-t.y, t.x),
            weights: shape::parabolic(g),
            rates: weight_rates.map(|rate| rate * per_speed),
            curvature: bend * per_speed,
        };
        // Nᵢ″ X′ − Nᵢ′ X″ does not depend on g.
        let spreads = [sides.after, -sides.chord, sides.before].map(|side| t.dot(&(side * per_speed)) * per_speed);
        Self { spot, speed, weight_rates, spreads, bend, stretch: t.dot(&sides.second_derivative()) * per_speed }
    }
}

impl<D: Scalar, const N: usize> Place<D, N> {
    /// The derivatives of −Nᵢ (x n + y t), where `by_g` is that of Nᵢ t. `part` has those of a component of which there is a share,
    /// and what it changes by with g.
    #[inline(always)]
    fn of_node<G>(
        &self,
        i: usize,
        by_g: &[Vector2<D>; N],
        [x, y]: [D; 2],
        part: impl Fn(usize, D, D) -> G,
    ) -> Vector2<G> {
        let (share, by_g) = (-self.spot.weights[i], by_g[i]);
        Vector2::new(part(0, share, by_g.y * x - by_g.x * y), part(1, share, -(by_g.x * x + by_g.y * y)))
    }
}

impl<D: Scalar> Place<D, 2> {
    /// The derivatives of Nᵢ t by g.
    #[inline(always)]
    fn by_g(&self) -> [Vector2<D>; 2] {
        self.weight_rates.map(|rate| self.spot.t * rate)
    }

    /// The derivatives of a number that changes by `turned` times the turn of the tangent with the nodes, Σ (Nᵢ′/|X′|) n·δxᵢ, and
    /// by `g` times δg.
    #[inline(always)]
    fn by(&self, turned: D, g: D) -> LinearPlace<D> {
        let x2 = self.spot.n * self.spot.rates[1] * turned;
        LinearPlace { x1: -x2, x2, g }
    }
}

impl<D: Scalar> Place<D, 3> {
    /// The derivatives of Nᵢ t by g, Nᵢ′ t + Nᵢ t′, where t′ is κ |X′| n.
    ///
    /// N₁ and N₃ are ½ g (g ∓ 1): with e = g n·t′, which is −½ n·chord/|X′|, theirs are g (t + ½ e n) ∓ ½ (t + e n). Where the
    /// midside node is far from a short chord, e n takes away nearly all of t, and what is left is ½ t (t·chord) + g X″, by |X′|.
    #[inline(always)]
    fn by_g(&self, nodes: [Vector2<D>; 3], g: D) -> [Vector2<D>; 3] {
        let Spot { t, n, weights, .. } = self.spot;
        let (sides, per_speed) = (Sides::new(nodes), self.speed.recip());
        let (chord, curved) = (sides.chord * D::from(0.5), sides.second_derivative() * g);
        let size = |v: Vector2<D>| abs(v.x) + abs(v.y);
        let [x, y, e] = choice::<D, 3>(|| {
            let is_far = size(curved) > size(chord) * 4.0;
            let e = if is_far { -n.dot(&chord) * per_speed } else { self.bend * g };
            let rest = if is_far { (t * t.dot(&chord) + curved) * per_speed } else { t + n * e };
            [rest.x, rest.y, e]
        });
        let (half, both) = (Vector2::new(x, y) * D::from(0.5), (t + n * (e * 0.5)) * g);
        [both - half, n * (weights[1] * self.bend) - t * (g * 2.0), both + half]
    }

    /// As of a straight segment.
    #[inline(always)]
    fn by(&self, turned: D, g: D) -> ParabolicPlace<D> {
        let of = |i: usize| self.spot.n * self.spot.rates[i] * turned;
        ParabolicPlace { x1: of(0), x2: of(1), x3: of(2), g }
    }
}
