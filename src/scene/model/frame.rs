//! The history of a scene.

use std::ops::Range;

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

impl Frame {
    /// Sorts every list of changes by the node or element that changes.
    pub(in crate::scene) fn sorted(mut self) -> Self {
        self.moves.sort();
        self.turns.sort();
        self.loads.iter_mut().for_each(Changes::sort);
        self.pressures.sort();
        self
    }
}

/// New values of some nodes or elements: which they are, each once and in their order, and beside it their values.
#[derive(Clone, Debug, Default)]
pub(in crate::scene) struct Changes<V> {
    pub(in crate::scene) of: Vec<u32>,
    pub(in crate::scene) to: Vec<V>,
}

impl<V: Copy> Changes<V> {
    /// Adds a node or element with its new value.
    pub(in crate::scene) fn push(&mut self, of: u32, to: V) {
        self.of.push(of);
        self.to.push(to);
    }

    fn sort(&mut self) {
        if !self.of.is_sorted() {
            let mut changes: Vec<_> = self.iter(0..self.of.len()).collect();
            changes.sort_unstable_by_key(|&(of, _)| of);
            (self.of, self.to) = changes.into_iter().unzip();
        }
    }

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
