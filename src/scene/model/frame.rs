//! The history of a scene.

use super::named::Members;
use std::ops::Range;
use std::sync::Arc;

/// A state: what changes from the state before. What is not mentioned stays.
#[derive(Clone, Debug, Default)]
pub(in crate::scene) struct Frame {
    pub(in crate::scene) time: f64,
    /// Displacements of nodes from their initial positions.
    pub(in crate::scene) moves: Changes<[f64; 3]>,
    /// Rotation vectors of nodes from their initial orientations.
    pub(in crate::scene) turns: Changes<[f64; 3]>,
    /// Loads of elements, in the order of [`Kind::loads`].
    pub(in crate::scene) loads: Vec<Changes<f64>>,
    /// Pressures of hard contact of nodes on slide lines.
    pub(in crate::scene) pressures: Changes<f64>,
}

/// New values of some nodes or elements: which they are, each once and in their order, and beside it their values.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Changes<V> {
    /// States that change the same share it.
    pub(in crate::scene) of: Arc<[u32]>,
    pub(in crate::scene) to: Vec<V>,
}

impl<V> Default for Changes<V> {
    fn default() -> Self {
        Self { of: Arc::default(), to: Vec::new() }
    }
}

impl<V: Copy> Changes<V> {
    /// The changes at these places.
    pub(in crate::scene) fn iter(&self, places: Range<usize>) -> impl Iterator<Item = (u32, V)> {
        self.of[places.clone()].iter().copied().zip(self.to[places].iter().copied())
    }

    /// The first place, from this one on, whose node or element is this one or a later one.
    pub(in crate::scene) fn place(&self, from: usize, of: u32) -> usize {
        from + self.of[from..].partition_point(|&other| other < of)
    }

    /// The value of one.
    pub(in crate::scene) fn get(&self, of: u32) -> Option<V> {
        let place = self.place(0, of);
        (self.of.get(place) == Some(&of)).then(|| self.to[place])
    }
}

/// Changes in any order.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Unsorted<V> {
    of: Vec<u32>,
    to: Vec<V>,
}

impl<V> Default for Unsorted<V> {
    fn default() -> Self {
        Self { of: Vec::new(), to: Vec::new() }
    }
}

impl<V: Copy> Unsorted<V> {
    /// Adds nodes or elements with the new value of all.
    pub(in crate::scene) fn push_all(&mut self, of: Members, to: V) {
        self.of.extend(of.numbers());
        self.to.resize(self.of.len(), to);
    }

    /// By the node or element that changes.
    pub(in crate::scene) fn sorted(self) -> Changes<V> {
        let Self { mut of, mut to } = self;
        if !of.is_sorted() {
            let mut changes: Vec<_> = of.into_iter().zip(to).collect();
            changes.sort_unstable_by_key(|&(of, _)| of);
            (of, to) = changes.into_iter().unzip();
        }
        Changes { of: of.into(), to }
    }
}
