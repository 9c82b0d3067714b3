//! The triads of the nodes of connectors. A node of the scene has one; connectors that have others there get a node with it.

use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The triads of nodes, all by their indices.
#[derive(Default)]
pub(super) struct Ends {
    /// Those that orientations give to nodes, the first to each.
    given: HashMap<usize, usize>,
    /// Those that nodes b have from their nodes a, the first of each.
    inherited: HashMap<usize, usize>,
    /// The nodes of connectors, and the triads that they have there, by connector and end.
    of: Vec<[Option<(usize, usize)>; 2]>,
}

impl Ends {
    /// A connector has a triad at one of its ends, which is this node.
    pub(super) fn give(&mut self, connector: usize, end: usize, node: usize, triad: usize) {
        self.given.entry(node).or_insert(triad);
        self.put(connector, end, node, triad);
    }

    /// The same for a node b that has the triad of a at the start, since it has no orientation.
    pub(super) fn inherit(&mut self, connector: usize, end: usize, node: usize, triad: usize) {
        self.inherited.entry(node).or_insert(triad);
        self.put(connector, end, node, triad);
    }

    fn put(&mut self, connector: usize, end: usize, node: usize, triad: usize) {
        self.of.resize(self.of.len().max(connector + 1), [None; 2]);
        self.of[connector][end] = Some((node, triad));
    }

    /// The triad that the scene gives to a node; a node b without any has that of its node a.
    pub(super) fn triad(&self, node: usize) -> Option<usize> {
        self.given.get(&node).copied()
    }

    /// The triad of a connector at one of its ends, if its node has another.
    pub(super) fn other(&self, connector: usize, end: usize) -> Option<usize> {
        let (node, triad) = (*self.of.get(connector)?)[end]?;
        self.is_other(node, triad).then_some(triad)
    }

    fn is_other(&self, node: usize, triad: usize) -> bool {
        let own = self.given.get(&node).or_else(|| self.inherited.get(&node));
        own.is_none_or(|own| *own != triad)
    }

    /// The other triads at each node, in order.
    pub(super) fn others(&self) -> BTreeMap<usize, BTreeSet<usize>> {
        let mut others: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        for &(node, triad) in self.of.iter().flatten().flatten() {
            if self.is_other(node, triad) {
                others.entry(node).or_default().insert(triad);
            }
        }
        others
    }
}
