//! Elements block by block, the next one on its way from memory while one is evaluated.

use super::nodes::Nodes;
use crate::scene::plan::Group;
use crate::scene::step::{Column, LANES, Number};

/// One of the nodes of each element of a block.
#[derive(Debug)]
pub(super) struct End {
    /// Where the nodes are found.
    pub(super) places: Column<u32>,
    /// The triad that all of them share, if they do.
    pub(super) triad: Option<u32>,
}

/// The blocks of a task that are still to come: what their elements keep, and their nodes.
pub(super) struct Blocks<'b, T> {
    pub(super) group: &'b Group,
    pub(super) nodes: &'b Nodes<'b, T>,
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
    /// Has one of so many parts of the next block fetched. All at once would take longer than the memory needs for it.
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

/// Bytes that are fetched together.
const LINE: usize = 64;

/// Has a value fetched that will be needed soon, if the processor can be told.
#[inline]
pub(super) fn prefetch<V>(value: &V) {
    #[cfg(target_arch = "x86_64")]
    safe_arch::prefetch_t0(value);
    #[cfg(not(target_arch = "x86_64"))]
    let _ = value;
}
