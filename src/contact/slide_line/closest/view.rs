//! A curve relative to the slave point, in a unit of length near its own size.

use super::expansion::Expansion;
use crate::contact::slide_line::shape::{Shape, combination, gap};
use crate::number::binade::Binade;
use crate::number::scalar::{Scalar, choice, leaf};
use nalgebra::Vector2;
use std::marker::PhantomData;

/// A curve relative to the slave point, in a unit of length near its own size.
///
/// X(u) = X(0) + c Y(u), where the factor c does not affect the foot.
#[derive(Clone, Copy, Debug)]
pub(super) struct View<D, S, const N: usize> {
    pub(super) xs: Vector2<D>,
    pub(super) nodes: [Vector2<D>; N],
    pub(super) f: D,
    pub(super) binade: Binade<D>,
    shape: PhantomData<S>,
}

impl<D: Scalar, S: Shape<N>, const N: usize> View<D, S, N> {
    pub(super) fn new(xs: Vector2<D>, nodes: [Vector2<D>; N], f: D) -> Self {
        let sides = nodes.iter().map(|x| x - nodes[N / 2]);
        Self { xs, nodes, f, binade: Binade::of(sides.flat_map(|side| [side.x, side.y])), shape: PhantomData }
    }

    pub(super) fn in_unit(&self, v: Vector2<D>) -> Vector2<D> {
        v * self.binade.per_unit
    }

    pub(super) fn combination(&self, weights: [D; N]) -> Vector2<D> {
        self.in_unit(combination(&self.nodes, weights))
    }

    pub(super) fn gap(&self, weights: [D; N]) -> Vector2<D> {
        self.in_unit(gap(self.xs, &self.nodes, weights))
    }

    pub(super) fn at(&self, u: D) -> CurveAt<D> {
        CurveAt {
            gap: self.gap(S::weights(self.f, u)),
            rate: self.combination(S::rates(self.f, u)),
            second: self.combination(S::second_derivatives(self.f, u)),
            factor: S::factor(self.f),
        }
    }

    /// Converts a derivative with respect to a position back to the model's unit of length.
    pub(super) fn per_unit(&self, gradient: Vector2<D>) -> Vector2<D> {
        self.in_unit(gradient)
    }

    /// The expansion for the search of the foot.
    pub(super) fn expansion(&self) -> Expansion<D::Leaf> {
        let zero = D::zero();
        let CurveAt { gap, rate, second, factor } = self.at(zero);
        let third = self.combination(S::third_derivatives(self.f));
        let leaves = |v: Vector2<D>, factor: f64| v.map(|x| leaf(x * factor));
        let sixth = |v: Vector2<D>| v.map(|x| leaf(x / 6.0));
        Expansion {
            gap: leaves(gap, 1.0),
            factor: leaf(factor),
            y: [leaves(rate, 1.0), leaves(second, 0.5), sixth(third)],
        }
    }
}

/// The curve at one of its points.
#[derive(Clone, Copy, Debug)]
pub(super) struct CurveAt<D> {
    /// xs − X.
    pub(super) gap: Vector2<D>,
    /// Y′, along the tangent.
    pub(super) rate: Vector2<D>,
    /// Y″.
    pub(super) second: Vector2<D>,
    /// c.
    pub(super) factor: D,
}

impl<D: Scalar> CurveAt<D> {
    /// (xs − X)·Y′: 0 at a foot, positive where the distance decreases.
    pub(super) fn residual(&self) -> D {
        self.gap.dot(&self.rate)
    }

    /// Its derivative: negative at a minimum of the distance, 0 at a centre of curvature.
    pub(super) fn slope(&self) -> D {
        self.gap.dot(&self.second) - self.factor * self.rate.dot(&self.rate)
    }

    /// Newton's step for the residual; 0 at a centre of curvature.
    pub(super) fn newton_step(&self) -> D::Leaf {
        let slope = leaf(self.slope());
        let [step] = choice(|| [if slope == 0.0 { slope } else { -leaf(self.residual()) / slope }]);
        step
    }
}
