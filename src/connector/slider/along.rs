//! Where m is along the line of a SLIDER, in space and in the plane: what nodes 1 and n take of the force on it, and the gradients of
//! numbers that are linear in the multipliers.

#![expect(clippy::inline_always, reason = "the compiler shares what rows, forces and stiffness have of the line")]

use crate::connector::slider::{Span, Station};
use crate::number::scalar::Scalar;
use nalgebra::SVector;

/// ξ or 1 − ξ, with a sign: the value, and the derivative by ξ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight<D> {
    pub(super) value: D,
    pub(super) slope: f64,
}

/// Where m is along the line, in as many dimensions as the model has.
pub(super) struct Along<D, const N: usize> {
    /// ξ, 1 − ξ.
    pub(super) share: D,
    pub(super) rest: D,
    /// ∂ξ by the positions of nodes 1, n and m.
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

    /// What nodes 1 and n take of the force on m.
    #[inline(always)]
    pub(super) fn lever(&self) -> [Weight<D>; 2] {
        [self.rest(-1.0), self.share(-1.0)]
    }

    /// The gradient of a weighted number by the positions of nodes 1, n and m, from that of the number by d.
    #[inline(always)]
    pub(super) fn gradient(&self, weight: Weight<D>, number: D, by_d: &SVector<D, N>) -> [SVector<D, N>; 3] {
        self.moved_and_turned(weight.slope, number, by_d * weight.value)
    }

    /// The gradient of something whose derivative by ξ is a number times a sign, and that by d is given.
    #[inline(always)]
    pub(super) fn moved_and_turned(&self, sign: f64, number: D, by_d: SVector<D, N>) -> [SVector<D, N>; 3] {
        // The sign comes last: so the products are the same for all that differs by it.
        let [x1, xn, xm] = self.by_nodes.map(|by| by * number * D::from(sign));
        [x1 - by_d, xn + by_d, xm]
    }
}

/// The gradient of something that changes with d alone.
#[inline(always)]
pub(super) fn turned<D: Scalar, const N: usize>(by_d: &SVector<D, N>) -> [SVector<D, N>; 3] {
    [-by_d, *by_d, SVector::from_element(D::zero())]
}

/// A gradient by the positions of nodes 1, n and m, and by the multipliers.
pub(super) type LoadsGradient<D, const N: usize, const M: usize> = ([SVector<D, N>; 3], [D; M]);

/// A number that is linear in the multipliers, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Loaded<D, const N: usize, const M: usize> {
    value: D,
    by_d: SVector<D, N>,
    by_multipliers: [D; M],
}

impl<D: Scalar, const N: usize, const M: usize> Loaded<D, N, M> {
    /// The sum of numbers with their multipliers, from the numbers and their gradients by d.
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
