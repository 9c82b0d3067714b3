//! The interpolation of a slide line between its nodes.

/// The interpolation of a slide line between its nodes (TYPE).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight, from node to node.
    Linear,
    /// Parabolic, over three nodes each.
    Parabolic,
}

impl Interpolation {
    /// The number of nodes from the beginning of a segment to that of the next.
    pub(super) const fn stride(self) -> usize {
        match self {
            Self::Linear => 1,
            Self::Parabolic => 2,
        }
    }

    pub(super) const fn allows(self, count: usize) -> bool {
        match self {
            Self::Linear => count >= 2,
            Self::Parabolic => count >= 3 && !count.is_multiple_of(2),
        }
    }

    pub(super) const fn allowed(self) -> &'static str {
        match self {
            Self::Linear => "at least 2 nodes in a linear slide line",
            Self::Parabolic => "an odd number of nodes, at least 3, in a parabolic slide line",
        }
    }
}
