//! Contact along a slide line as an element: a slave point, and the two or three nodes of the segment that it touches.
//!
//! | | |
//! |---|---|
//! | unknowns | the translations of the slave point and of the nodes of the segment, in the plane (r, z) |
//! | place | the closest point of the segment, g, which [`closest_*`](crate::slide_line) finds |
//! | rows | of the separation E11: n and −Nᵢ n; of the slip: t and −Nᵢ t |
//! | zero position | E11 = 0: the slave point on the segment |
//! | signs | as of [`isl`](crate::isl): S11 pushes the slave point along n, S12 along −t, which is against positive slip |
//!
//! The separation has no first derivative by g: at the closest point it is stationary. So its row is exact, although g is held. The
//! row of the slip is the velocity relative to the material at the place g, which is held, too. It is not the derivative
//! of the way of the closest point along the line, which ends at g but begins elsewhere; a consistent tangent needs both.
//!
//! Forces are those of the whole circumference. Those on the slave point and on the segment add up to nothing, along the axis
//! and along the radius: the nodes of a segment are rings, and what a ring takes up in its hoop is not the contact's.

pub mod forces;
pub mod friction;
pub mod response;
pub mod rows;
pub mod stiffness;

use super::chain::Term;
use crate::scalar::Scalar;
use crate::slide_line::{Sides, length_and_tangent, shape};
use nalgebra::{SVector, Vector2};
use std::ops::{Add, Mul, Neg};

/// What products and sums are made of: numbers, or numbers with their derivatives.
trait Number: Copy + Add<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {}
impl<T: Copy + Add<Output = T> + Mul<Output = T> + Neg<Output = T>> Number for T {}

/// A place on a segment of N nodes.
#[derive(Clone, Copy, Debug)]
struct Spot<T, const N: usize> {
    t: Vector2<T>,
    n: Vector2<T>,
    /// Nᵢ.
    weights: [T; N],
    /// Nᵢ′/|X′|: by the length of the line.
    rates: [T; N],
    /// The curvature n·X″/|X′|².
    curvature: T,
}

/// A place on a segment, and what its derivatives need beside it.
struct Place<D, const N: usize> {
    spot: Spot<D, N>,
    /// |X′|.
    speed: D,
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
        Self { spot, speed: length * 0.5, spreads: [zero; 2], bend: zero, stretch: zero }
    }
}

impl<D: Scalar> Place<D, 3> {
    fn parabolic(nodes: [Vector2<D>; 3], g: D) -> Self {
        let sides = Sides::new(nodes);
        let (speed, t) = length_and_tangent(sides.rate(g));
        let per_speed = speed.recip();
        let bend = sides.turn(speed) * per_speed;
        let spot = Spot {
            t,
            n: Vector2::new(-t.y, t.x),
            weights: shape::parabolic(g),
            rates: shape::parabolic_rates(g).map(|rate| rate * per_speed),
            curvature: bend * per_speed,
        };
        // Nᵢ″ X′ − Nᵢ′ X″ does not depend on g.
        let spreads = [sides.after, -sides.chord, sides.before].map(|side| t.dot(&(side * per_speed)) * per_speed);
        Self { spot, speed, spreads, bend, stretch: t.dot(&sides.second_derivative()) * per_speed }
    }
}

impl<D: Scalar, const N: usize> Place<D, N> {
    /// With derivatives by the nodes and by g, which are the first of K numbers.
    ///
    /// The tangent turns by δφ = Σ (Nᵢ′/|X′|) n·δxᵢ + κ |X′| δg, and |X′| changes by the part Σ (Nᵢ′/|X′|) t·δxᵢ + (t·X″/|X′|) δg.
    fn varied<const K: usize>(&self) -> Spot<Term<D, K>, N> {
        let Self { spot: Spot { t, n, weights, rates, curvature }, speed, spreads, bend, stretch } = *self;
        let slope = |by_node: &dyn Fn(usize) -> Vector2<D>, by_g: D| {
            SVector::<D, K>::from_fn(|k, _| match k / 2 {
                node if node < N => by_node(node)[k % 2],
                _ if k == 2 * N => by_g,
                _ => D::zero(),
            })
        };
        let none = Vector2::from_element(D::zero());
        let turned = slope(&|i| n * rates[i], bend);
        let weight = |i: usize| Term::new(weights[i], slope(&|_| none, rates[i] * speed));
        let rate = |i: usize| Term::new(rates[i], slope(&|j| t * -(rates[i] * rates[j]), spreads[i]));
        let (per_speed, twice) = (speed.recip(), curvature * 2.0);
        let bent = slope(&|i| n * (spreads[i] * per_speed) - t * (twice * rates[i]), -(curvature * stretch * 3.0));
        Spot {
            t: Vector2::from_fn(|k, _| Term::new(t[k], turned * n[k])),
            n: Vector2::from_fn(|k, _| Term::new(n[k], -(turned * t[k]))),
            weights: std::array::from_fn(weight),
            rates: std::array::from_fn(rate),
            curvature: Term::new(curvature, bent),
        }
    }
}

/// a times a vector.
fn times<T: Number + nalgebra::Scalar>(v: Vector2<T>, a: T) -> Vector2<T> {
    v.map(|x| x * a)
}
