//! The triads in which connectors measure: that of the first node is required; the second node has the same unless another is
//! given.

use crate::scene::json::Reader;
use crate::scene::kind::{Kind, Origin};
use crate::scene::model::{Members, Named, SceneNode};
use std::collections::HashMap;

/// Orientations that nodes without one inherit from the first node of their connector, by the index of a node or a set of nodes
/// in the scene.
#[derive(Default)]
pub(super) struct Inherited {
    of: HashMap<usize, u32>,
}

impl Inherited {
    /// Reports faults in the triads of a connector at a position in the text, and records which orientation its second node
    /// inherits from the first.
    pub(super) fn check(
        &mut self,
        reader: &mut Reader,
        place: usize,
        kind: &Kind,
        ends: &[Option<Members>],
        nodes: &Named<Option<SceneNode>>,
    ) {
        let [Some(a), second, ..] = ends.iter().map(|end| end.map(|members| members.number(0))).collect::<Vec<_>>()[..]
        else {
            return;
        };
        let Some(first) = nodes[a].filter(|_| kind.reads_triad(0)) else { return };
        let Some(orientation) = first.orientation else {
            let found = format!("node a, {:?}, without an orientation", nodes.name(a));
            reader.fault(place, found, "a node a with an \"orientation\", in whose axes the connector measures");
            return;
        };
        let Some(b) = second.filter(|_| kind.reads_triad(1)) else { return };
        if nodes[b].is_none_or(|node| node.orientation.is_some()) {
            return;
        }
        if *self.of.entry(nodes.locate(b).0).or_insert(orientation) != orientation {
            let found = format!(
                "node b, {:?}, without an orientation, and two connectors that differ in theirs",
                nodes.name(b)
            );
            reader.fault(place, found, "a node b with an \"orientation\" of its own");
        }
    }

    /// Sets the inherited orientations of the nodes.
    pub(super) fn give(&self, place: usize, node: SceneNode) -> SceneNode {
        SceneNode { orientation: node.orientation.or_else(|| self.of.get(&place).copied()), ..node }
    }
}

impl Kind {
    /// Whether it measures in the triad of a node, given by its index.
    pub(in crate::scene) fn reads_triad(&self, node: usize) -> bool {
        self.origins().any(|origin| matches!(origin, Origin::Axis(of, _) if of == node))
    }
}
