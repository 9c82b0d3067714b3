//! Elements block by block; while one block is evaluated, the next is prefetched into the cache.

use super::nodes::NodeStates;
use crate::element::table::{Column, LANES, Number};
use crate::number::prefetch::{LINE, prefetch};
use crate::scene::plan::Group;

/// One of the nodes of each element of a block.
#[derive(Debug)]
pub(super) struct End {
    /// The indices of the nodes.
    pub(super) places: Column<u32>,
    /// The numbers of their triads.
    pub(super) triads: Column<u32>,
    /// The triad shared by all of them, if any.
    pub(super) triad: Option<u32>,
}

/// The remaining blocks of a task: the persistent registers of their elements, and their nodes.
pub(super) struct Blocks<'b, T> {
    pub(super) group: &'b Group,
    pub(super) nodes: &'b NodeStates<'b, T>,
    pub(super) lasting: &'b mut [Column<T>],
    pub(super) ends: &'b [End],
}

impl<'b, T> Iterator for Blocks<'b, T> {
    type Item = (&'b mut [Column<T>], &'b [End]);

    fn next(&mut self) -> Option<Self::Item> {
        let (lasting, later) = std::mem::take(&mut self.lasting).split_at_mut_checked(self.group.recipe.lasting)?;
        self.lasting = later;
        Some((lasting, self.ends.split_off(..self.group.kind.nodes.len())?))
    }
}

impl<T: Number> Blocks<'_, T> {
    /// Prefetches one of `parts` parts of the next block. Prefetching everything at once would take longer than the memory needs.
    pub(super) fn prefetch(&self, part: usize, parts: usize) {
        let share = |of: usize| of * part / parts..of * (part + 1) / parts;
        let columns = self.group.recipe.lasting.min(self.lasting.len());
        for column in &self.lasting[share(columns)] {
            for lane in (0..LANES).step_by((LINE / size_of::<T>()).max(1)) {
                prefetch(&column[lane]);
            }
        }
        let prefetch = self.nodes.prefetch();
        for end in self.ends.iter().take(self.group.kind.nodes.len()) {
            for &place in &end.places[share(LANES)] {
                prefetch(place);
            }
        }
    }
}
