//! Where node m is along the line, told from the end that is nearer to it.

use crate::scalar::{Scalar, abs};
use nalgebra::SVector;

/// The place of m: m − end = τ (xn − x1) + something across the line, where "end" is the nearer of nodes 1 and n.
///
/// With ξ = (xm − x1)·n/l, τ is ξ if the end is node 1 and ξ − 1 if it is node n. Told from the far end, the position of m would
/// carry the rounding errors of distances that are much larger than those which matter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Station<D, const N: usize> {
    nearer_to_n: bool,
    /// m − end.
    pub(super) offset: SVector<D, N>,
    tau: D,
}

impl<D: Scalar, const N: usize> Station<D, N> {
    /// The station of m, for a vector s·n with any s > 0 or < 0 and the number s·l.
    #[inline]
    pub(super) fn new([x1, xn, xm]: [&SVector<D, N>; 3], along: &SVector<D, N>, length: D) -> Self {
        let (from_1, from_n) = (xm - x1, xm - xn);
        let (ahead_of_1, ahead_of_n) = (from_1.dot(along), from_n.dot(along));
        let nearer_to_n = abs(ahead_of_n) < abs(ahead_of_1);
        let (offset, ahead) = if nearer_to_n { (from_n, ahead_of_n) } else { (from_1, ahead_of_1) };
        Self { nearer_to_n, offset, tau: ahead / length }
    }

    /// ξ and 1 − ξ, both without loss.
    #[inline]
    pub(super) fn shares(&self) -> [D; 2] {
        let tau = self.tau;
        if self.nearer_to_n { [tau + 1.0, -tau] } else { [tau, -tau + 1.0] }
    }

    /// (1 − ξ) u1 + ξ un.
    #[inline]
    pub(super) fn blend(&self, u1: &SVector<D, N>, un: &SVector<D, N>) -> SVector<D, N> {
        let end = if self.nearer_to_n { un } else { u1 };
        end + (un - u1) * self.tau
    }

    /// The part of m − x1 across the line, for d = xn − x1.
    #[inline]
    pub(super) fn aside(&self, d: &SVector<D, N>) -> SVector<D, N> {
        self.offset - d * self.tau
    }
}
