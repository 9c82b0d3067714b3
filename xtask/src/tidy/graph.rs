//! Directed graphs: which nodes are on cycles, and the shortest cycles.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// For every node, the nodes it uses.
#[derive(Debug, Clone)]
pub(super) struct Graph<N> {
    uses: BTreeMap<N, BTreeSet<N>>,
}

/// Nodes that all depend on one another, directly or indirectly.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Tangle<N> {
    /// The nodes.
    pub(super) nodes: BTreeSet<N>,
    /// The shortest cycle through each use among them, the shortest first. The last node uses the first.
    pub(super) circles: Vec<Vec<N>>,
}

impl<N: Copy + Ord> Graph<N> {
    /// The graph of these uses. A node that uses itself is no cycle.
    pub(super) fn new(edges: impl IntoIterator<Item = (N, N)>) -> Self {
        let mut uses = BTreeMap::<N, BTreeSet<N>>::new();
        for (from, to) in edges.into_iter().filter(|(from, to)| from != to) {
            uses.entry(from).or_default().insert(to);
        }
        Self { uses }
    }

    /// Repeatedly removes nodes that use nothing or are used by nothing. Without cycles nothing is left.
    fn core(&self) -> Self {
        let mut uses = self.uses.clone();
        loop {
            let before = uses.len();
            let used: BTreeSet<N> = uses.values().flatten().copied().collect();
            uses.retain(|node, _| used.contains(node));
            let using: BTreeSet<N> = uses.keys().copied().collect();
            for next in uses.values_mut() {
                next.retain(|node| using.contains(node));
            }
            uses.retain(|_, next| !next.is_empty());
            if uses.len() == before {
                return Self { uses };
            }
        }
    }

    /// Every set of mutually dependent nodes, the smallest first.
    pub(super) fn tangles(&self) -> Vec<Tangle<N>> {
        let core = self.core();
        let mut tangles: Vec<Tangle<N>> = Vec::new();
        for (&from, next) in &core.uses {
            for circle in next.iter().filter_map(|&to| core.circle(from, to)) {
                match tangles.iter_mut().find(|tangle| tangle.nodes.contains(&from)) {
                    Some(tangle) => tangle.circles.push(circle),
                    None => tangles.push(Tangle { nodes: core.around(from), circles: vec![circle] }),
                }
            }
        }
        for tangle in &mut tangles {
            tangle.circles.sort_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
            tangle.circles.dedup();
        }
        tangles.sort_by_key(|tangle| tangle.nodes.len());
        tangles
    }

    /// The shortest cycle through the use of `to` by `from`, starting at its least node.
    fn circle(&self, from: N, to: N) -> Option<Vec<N>> {
        let mut back = self.path(to, from)?;
        let (least, _) = back.iter().enumerate().min_by_key(|(_, node)| **node)?;
        back.rotate_left(least);
        Some(back)
    }

    /// The nodes that can be reached from `node` and from which it can be reached.
    fn around(&self, node: N) -> BTreeSet<N> {
        self.uses
            .keys()
            .copied()
            .filter(|&other| self.path(node, other).is_some() && self.path(other, node).is_some())
            .collect()
    }

    /// The shortest path, including both ends.
    fn path(&self, from: N, to: N) -> Option<Vec<N>> {
        let mut came_from = BTreeMap::from([(from, from)]);
        let mut open = VecDeque::from([from]);
        while let Some(node) = open.pop_front() {
            if node == to {
                let back = std::iter::successors(Some(to), |node| {
                    came_from.get(node).copied().filter(|before| before != node)
                });
                let mut path: Vec<N> = back.collect();
                path.reverse();
                return Some(path);
            }
            for &next in self.uses.get(&node).into_iter().flatten() {
                came_from.entry(next).or_insert_with(|| {
                    open.push_back(next);
                    node
                });
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_graph_in_layers_has_no_tangle() {
        assert_eq!(Graph::new([(1, 2), (1, 3), (2, 4), (3, 4), (4, 4)]).tangles(), []);
    }

    #[test]
    fn circles_come_shortest_first_and_once_each() {
        let tangles = Graph::new([(3, 1), (1, 2), (2, 3), (2, 1), (5, 1), (8, 7), (7, 8)]).tangles();
        let circles: Vec<_> = tangles.iter().map(|tangle| tangle.circles.clone()).collect();
        assert_eq!(circles, [vec![vec![7, 8]], vec![vec![1, 2], vec![1, 2, 3]]]);
        assert_eq!(tangles[1].nodes, BTreeSet::from([1, 2, 3]));
        let chained = Graph::new([(1, 2), (2, 1), (2, 3), (3, 4), (4, 3)]).tangles();
        let nodes: Vec<_> = chained.into_iter().map(|tangle| tangle.nodes).collect();
        assert_eq!(nodes, [BTreeSet::from([1, 2]), BTreeSet::from([3, 4])]);
    }
}
