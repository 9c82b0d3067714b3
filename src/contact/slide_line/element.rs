//! Contact along a slide line as an element: slave nodes, each with the two or three nodes of the segment that it touches.
//!
//! | | |
//! |---|---|
//! | unknowns | the translations of the slave nodes and of the nodes of their segments, in the plane (r, z) |
//! | position | the closest point of the segment, g, which [`closest_*`](crate::contact::slide_line) finds |
//! | work | of the pressure on the separation E11: n on the slave point, −Nᵢ n on the nodes; of the shear on the slip: t and −Nᵢ t |
//! | zero position | E11 = 0: the slave point on the segment |
//! | signs | those of [`isl`](crate::contact::isl): S11 pushes the slave point along n, S12 along −t, which is against positive slip |
//!
//! At the closest point the separation is stationary with respect to g, so its variation is exact although g is held constant. The
//! shear works on the velocity relative to the material at the point g, which is held constant, too. It is not the derivative of
//! the distance that the closest point travels along the line, which ends at g but begins elsewhere; a consistent tangent needs
//! both.
//!
//! Forces are those of the whole circumference. Those on the slave point and on the segment add up to zero, both axially and
//! radially: the nodes of a segment are rings, and the hoop forces in a ring are not part of the contact.

#![expect(clippy::inline_always, reason = "a call would write the results to memory, and wait for them there")]

mod chain;
pub mod fields;
pub mod forces;
mod ring;
mod segment;

pub use fields::{
    ExponentialLaw, Isl21aNodes, Isl21aState, Isl22aNodes, Isl22aState, IslContact, LinearLaw, PressureLaw,
};
pub use ring::{Isl, Isl21aElement, Isl22aElement};
pub use segment::{Curved, Straight};

use crate::contact::slide_line::{Sides, left, length_and_tangent, shape};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

/// A point on a segment of N nodes.
#[derive(Clone, Copy, Debug)]
struct Spot<D, const N: usize> {
    t: Vector2<D>,
    n: Vector2<D>,
    /// Nᵢ.
    weights: [D; N],
}

impl<D: Scalar, const N: usize> Spot<D, N> {
    #[inline(always)]
    fn new(along: Vector2<D>, weights: [D; N]) -> Self {
        let (_, t) = length_and_tangent(along);
        Self { t, n: left(t), weights }
    }
}

impl<D: Scalar> Spot<D, 2> {
    fn linear([x1, x2]: [Vector2<D>; 2], g: D) -> Self {
        Self::new(x2 - x1, shape::linear(g))
    }
}

impl<D: Scalar> Spot<D, 3> {
    #[inline(always)]
    fn parabolic(nodes: [Vector2<D>; 3], g: D) -> Self {
        Self::new(Sides::new(nodes).rate(g), shape::parabolic(g))
    }
}
