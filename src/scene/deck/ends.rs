//! The triads of the nodes of connectors. A node of the scene has one; connectors that have others there get a node with it.

use std::collections::{BTreeMap, HashMap};

/// The triads of nodes, all by their indices.
#[derive(Default)]
pub(super) struct Ends {
    /// Those that orientations give to nodes, the first to each.
    given: HashMap<usize, usize>,
    /// Those that nodes b have from their nodes a, the first of each.
    inherited: HashMap<usize, usize>,
    /// Those that connectors have at their nodes, by connector and end.
    of: HashMap<(usize, usize), (usize, usize)>,
}

impl Ends {
    /// A connector has a triad at one of its ends, which is this node.
    pub(super) fn give(&mut self, connector: usize, end: usize, node: usize, triad: usize) {
        self.given.entry(node).or_insert(triad);
        self.of.insert((connector, end), (node, triad));
    }

    /// The same for a node b that has the triad of a at the start, since it has no orientation.
    pub(super) fn inherit(&mut self, connector: usize, end: usize, node: usize, triad: usize) {
        self.inherited.entry(node).or_insert(triad);
        self.of.insert((connector, end), (node, triad));
    }

    /// The triad that the scene gives to a node; a node b without any has that of its node a.
    pub(super) fn triad(&self, node: usize) -> Option<usize> {
        self.given.get(&node).copied()
    }

    /// The triad of a connector at one of its ends, if its node has another.
    pub(super) fn other(&self, connector: usize, end: usize) -> Option<usize> {
        let &(node, triad) = self.of.get(&(connector, end))?;
        let own = self.given.get(&node).or_else(|| self.inherited.get(&node));
        own.is_none_or(|own| *own != triad).then_some(triad)
    }

    /// The other triads at each node, in order.
    pub(super) fn others(&self) -> BTreeMap<usize, Vec<usize>> {
        let mut others: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (&(connector, end), &(node, _)) in &self.of {
            others.entry(node).or_default().extend(self.other(connector, end));
        }
        for triads in others.values_mut() {
            triads.sort_unstable();
            triads.dedup();
        }
        others
    }
}
