//! The places of a curve that may be the closest one.

use super::expansion::Expansion;
use super::roots;
use super::view::View;
use crate::scalar::{Leaf, Scalar, constant, leaf};
use crate::slide_line::shape::Shape;
use arrayvec::ArrayVec;

/// The places of a curve where the distance has a minimum, in order; the ends among them.
pub(super) struct Candidates<L> {
    pub(super) expansion: Expansion<L>,
    /// The coordinate, and whether it is between the ends.
    pub(super) places: ArrayVec<(L, bool), 7>,
}

impl<L: Leaf> Candidates<L> {
    /// Between two coordinates.
    ///
    /// Whether the distance falls at the ends is told by the full equation, and the search is held to it. So either an
    /// end counts or, between ends towards which it rises, a root is found, however near to an end.
    pub(super) fn new<D: Scalar<Leaf = L>, S: Shape<N>, const N: usize>(view: &View<D, S, N>, ends: [L; 2]) -> Self {
        let expansion = view.expansion();
        let [low, high] = ends.map(|u| leaf(view.at(constant(u)).residual()));
        let mut places = ArrayVec::new();
        if low <= 0.0 {
            places.push((ends[0], false));
        }
        let roots = roots::falling(&expansion.residual(), ends, [low, high]);
        places.extend(roots.into_iter().map(|u| (u, true)));
        // Also where nothing was found because a number overflowed: the result then says so.
        if high >= 0.0 || places.is_empty() {
            places.push((ends[1], false));
        }
        Self { expansion, places }
    }

    /// The nearest; of two that are equally near, the one of smaller coordinate.
    pub(super) fn nearest(&self) -> (L, bool) {
        let nearer = |best: (L, bool), next: (L, bool)| {
            if self.expansion.compare(next.0, best.0).is_lt() { next } else { best }
        };
        self.places.iter().copied().reduce(nearer).expect("where nothing else is, an end is")
    }
}
