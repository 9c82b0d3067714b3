//! The line from node 1 to node n, and the position of node m along it, measured from the nearer end.

use crate::number::binade::Binade;
use crate::number::scalar::{Scalar, abs};
use nalgebra::SVector;

/// d = xn − x1 in units of a power of two, and its square.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span<D, const N: usize> {
    pub(crate) d: SVector<D, N>,
    pub(crate) square: D,
    pub(crate) binade: Binade<D>,
}

impl<D: Scalar, const N: usize> Span<D, N> {
    #[inline]
    pub(crate) fn new(x1: &SVector<D, N>, xn: &SVector<D, N>) -> Self {
        Self::along(xn - x1)
    }

    /// The line with this d.
    #[inline]
    pub(crate) fn along(d: SVector<D, N>) -> Self {
        let binade = Binade::of(d.iter().copied());
        let d = d * binade.per_unit;
        Self { d, square: d.dot(&d), binade }
    }

    /// The factor by which v·d, with v in the units of the nodes, becomes the fraction of the line covered by v: (xn − x1)·v over
    /// the square of the length.
    #[inline]
    pub(crate) fn factor(&self) -> D {
        self.binade.per_unit / self.square
    }
}

/// The position of m: m − end = τ (xn − x1) + a vector normal to the line, where "end" is the nearer of nodes 1 and n.
///
/// With ξ = (xm − x1)·d/d·d, τ is ξ if the end is node 1 and ξ − 1 if it is node n. Measured from the far end, the position of m
/// would have the rounding errors of much larger distances.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Station<D, const N: usize> {
    nearer_to_n: bool,
    /// m − end.
    pub(crate) offset: SVector<D, N>,
    tau: D,
}

impl<D: Scalar, const N: usize> Station<D, N> {
    #[inline]
    pub(crate) fn new(span: &Span<D, N>, x1: &SVector<D, N>, xn: &SVector<D, N>, xm: &SVector<D, N>) -> Self {
        let (from_1, from_n) = (xm - x1, xm - xn);
        let (ahead_of_1, ahead_of_n) = (from_1.dot(&span.d), from_n.dot(&span.d));
        let nearer_to_n = abs(ahead_of_n) < abs(ahead_of_1);
        let (offset, ahead) = if nearer_to_n { (from_n, ahead_of_n) } else { (from_1, ahead_of_1) };
        Self { nearer_to_n, offset, tau: ahead * span.factor() }
    }

    /// ξ and 1 − ξ, both without loss of accuracy.
    #[inline]
    pub(crate) fn shares(&self) -> [D; 2] {
        let tau = self.tau;
        if self.nearer_to_n { [tau + 1.0, -tau] } else { [tau, -tau + 1.0] }
    }

    /// (1 − ξ) u1 + ξ un.
    #[inline]
    pub(crate) fn blend(&self, u1: &SVector<D, N>, un: &SVector<D, N>) -> SVector<D, N> {
        let end = if self.nearer_to_n { un } else { u1 };
        end + (un - u1) * self.tau
    }

    /// The gradients of ξ with respect to x1, xn and xm.
    ///
    /// With the part f of m − x1 normal to the line: ∂ξ/∂xm = d/d·d, ∂ξ/∂xn = (f − ξ d)/d·d, ∂ξ/∂x1 = −(f + (1 − ξ) d)/d·d.
    #[inline]
    pub(crate) fn gradients(&self, span: &Span<D, N>) -> [SVector<D, N>; 3] {
        let factor = span.factor();
        let [by_x1, by_xn] = self.unscaled_gradients(span);
        [by_x1 * -factor, by_xn * factor, span.d * factor]
    }

    /// f + (1 − ξ) d and f − ξ d, in units of the line's size.
    #[inline]
    pub(crate) fn unscaled_gradients(&self, span: &Span<D, N>) -> [SVector<D, N>; 2] {
        let [share, rest] = self.shares();
        let aside = self.offset * span.binade.per_unit - span.d * self.tau;
        [aside + span.d * rest, aside - span.d * share]
    }
}
