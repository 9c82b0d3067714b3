//! The position of m along the line of a SLIDER, in space and in the plane: the shares of nodes 1 and n in the force on m, and
//! the gradients of numbers that are linear in the multipliers.

#![expect(clippy::inline_always, reason = "the compiler shares what rows, forces and stiffness have of the line")]

use crate::connector::slider::{Span, Station};
use crate::number::scalar::Scalar;
use nalgebra::SVector;

/// ξ or 1 − ξ, with a sign: the value, and the derivative with respect to ξ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight<D> {
    pub(super) value: D,
    pub(super) slope: f64,
}

/// The position of m along the line, in 2 or 3 dimensions.
pub(super) struct Along<D, const N: usize> {
    /// ξ, 1 − ξ.
    pub(super) share: D,
    pub(super) rest: D,
    /// ∂ξ with respect to the positions of nodes 1, n and m.
    by_nodes: [SVector<D, N>; 3],
}

impl<D: Scalar, const N: usize> Along<D, N> {
    #[inline(always)]
    pub(super) fn new(x1: &SVector<D, N>, xn: &SVector<D, N>, xm: &SVector<D, N>) -> Self {
        let span = Span::new(x1, xn);
        let station = Station::new(&span, x1, xn, xm);
        let [share, rest] = station.shares();
        Self { share, rest, by_nodes: station.gradients(&span) }
    }

    /// ξ times a sign.
    #[inline(always)]
    pub(super) fn share(&self, sign: f64) -> Weight<D> {
        Weight { value: self.share * sign, slope: sign }
    }

    /// 1 − ξ times a sign.
    #[inline(always)]
    pub(super) fn rest(&self, sign: f64) -> Weight<D> {
        Weight { value: self.rest * sign, slope: -sign }
    }

    /// The weights of the force on m in the forces on nodes 1 and n.
    #[inline(always)]
    pub(super) fn lever(&self) -> [Weight<D>; 2] {
        [self.rest(-1.0), self.share(-1.0)]
    }

    /// The gradient of a weighted number with respect to the positions of nodes 1, n and m, from its gradient with respect to d.
    #[inline(always)]
    pub(super) fn gradient(&self, weight: Weight<D>, number: D, by_d: &SVector<D, N>) -> [SVector<D, N>; 3] {
        self.moved_and_turned(weight.slope, number, by_d * weight.value)
    }

    /// A gradient from the derivative with respect to ξ, a number times a sign, and the derivative with respect to d.
    #[inline(always)]
    pub(super) fn moved_and_turned(&self, sign: f64, number: D, by_d: SVector<D, N>) -> [SVector<D, N>; 3] {
        // The sign comes last, so that results that differ only in the sign share the products.
        let [x1, xn, xm] = self.by_nodes.map(|by| by * number * D::from(sign));
        [x1 - by_d, xn + by_d, xm]
    }
}

/// The gradient of a number that depends on d alone.
#[inline(always)]
pub(super) fn turned<D: Scalar, const N: usize>(by_d: &SVector<D, N>) -> [SVector<D, N>; 3] {
    [-by_d, *by_d, SVector::from_element(D::zero())]
}

/// A gradient with respect to the positions of nodes 1, n and m, and to the multipliers.
pub(super) type LoadsGradient<D, const N: usize, const M: usize> = ([SVector<D, N>; 3], [D; M]);

/// A number that is linear in the multipliers, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Loaded<D, const N: usize, const M: usize> {
    value: D,
    by_d: SVector<D, N>,
    by_multipliers: [D; M],
}

impl<D: Scalar, const N: usize, const M: usize> Loaded<D, N, M> {
    /// The sum of numbers times multipliers, from the numbers and their gradients with respect to d.
    #[inline(always)]
    pub(super) fn new(multipliers: [D; M], numbers: [D; M], by_d: [SVector<D, N>; M]) -> Self {
        let (mut value, mut turned) = (numbers[0] * multipliers[0], by_d[0] * multipliers[0]);
        for m in 1..M {
            value += numbers[m] * multipliers[m];
            turned += by_d[m] * multipliers[m];
        }
        Self { value, by_d: turned, by_multipliers: numbers }
    }

    /// The gradient of the number itself.
    #[inline(always)]
    pub(super) fn turned(&self) -> LoadsGradient<D, N, M> {
        (turned(&self.by_d), self.by_multipliers)
    }

    /// The gradient of the weighted number.
    #[inline(always)]
    pub(super) fn weighted(&self, along: &Along<D, N>, weight: Weight<D>) -> LoadsGradient<D, N, M> {
        let by_multipliers = self.by_multipliers.map(|by| by * weight.value);
        (along.gradient(weight, self.value, &self.by_d), by_multipliers)
    }
}
