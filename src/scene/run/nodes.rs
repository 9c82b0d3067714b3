//! Where the nodes are.

use super::shared;
use crate::scene::kind::Origin;
use crate::scene::model::{Axes, Frame, Motion, Orientation, Scene, exactly, global, turned};
use crate::scene::plan::Plan;
use crate::scene::step::Number;
use nalgebra::Vector3;

/// Where the nodes are now, and where they were.
#[derive(Debug)]
pub(super) struct Nodes<T> {
    initial: Vec<[f64; 3]>,
    pub(super) positions: Vec<Vector3<T>>,
    /// Positions in the last state, if anything asks for increments.
    pub(super) before: Vec<Vector3<T>>,
    /// The triad of every node, if an element reads one.
    triad_of: Vec<u32>,
    /// The global triad and the orientations of the scene, which nodes share; then those of the nodes that turn.
    triads: Vec<Axes<T>>,
    /// The nodes that turn in some state, in order, and the triads they turn from.
    turning: Vec<(u32, u32)>,
}

impl<T: Number> Nodes<T> {
    pub(super) fn new(scene: &Scene, plan: &Plan) -> Self {
        let passes = || plan.groups.iter().flat_map(|group| [&group.recipe.start, &group.recipe.state]);
        let reads = |is: fn(Origin) -> bool| passes().any(|pass| pass.reads.iter().any(|&(origin, _)| is(origin)));
        let positions: Vec<_> = scene.nodes.values().map(|node| exactly(node.at)).collect();
        let moves = reads(|origin| matches!(origin, Origin::Increment(_))) || !plan.contacts.is_empty();
        let mut nodes = Self {
            initial: scene.nodes.values().map(|node| node.at).collect(),
            before: if moves { positions.clone() } else { Vec::new() },
            positions,
            triad_of: Vec::new(),
            triads: std::iter::once(global()).chain(scene.orientations.iter().map(Orientation::axes)).collect(),
            turning: Vec::new(),
        };
        if reads(|origin| matches!(origin, Origin::Axis(..))) {
            nodes.share_triads(scene);
        }
        nodes
    }

    /// Every node has the triad of its orientation; those that turn in some state, one of their own.
    fn share_triads(&mut self, scene: &Scene) {
        let shared = |orientation: Option<u32>| orientation.map_or(0, |index| index + 1);
        self.triad_of = scene.nodes.values().map(|node| shared(node.orientation)).collect();
        let mut turns = vec![false; scene.nodes.len()];
        scene.frames.iter().flat_map(|frame| &frame.turns).for_each(|turn| turns[turn.node as usize] = true);
        let mut own = (0..).skip(self.triads.len());
        for (node, triad) in (0..).zip(&mut self.triad_of).filter(|(node, _)| turns[*node as usize]) {
            self.turning.push((node, *triad));
            self.triads.push(self.triads[*triad as usize]);
            *triad = own.next().unwrap_or(*triad);
        }
    }

    /// The current triad of a node.
    pub(super) fn triad(&self, node: usize) -> &Axes<T> {
        &self.triads[self.triad_of[node] as usize]
    }

    /// The number of the triad of all these nodes, if it is one.
    pub(super) fn common_triad(&self, mut nodes: impl Iterator<Item = usize>) -> Option<u32> {
        let first = self.triad_of[nodes.next()?];
        nodes.all(|node| self.triad_of[node] == first).then_some(first)
    }

    /// A current triad by its number.
    pub(super) fn shared_triad(&self, number: u32) -> &Axes<T> {
        &self.triads[number as usize]
    }

    /// Moves and turns them.
    pub(super) fn advance(&mut self, frame: &Frame) {
        if !self.before.is_empty() {
            self.before.copy_from_slice(&self.positions);
        }
        let initial = &self.initial;
        shared(&mut self.positions, |first, positions| {
            for motion in among(&frame.moves, first, positions.len()) {
                let node = motion.node as usize;
                positions[node - first] = exactly::<T>(initial[node]) + exactly(motion.by);
            }
        });
        let turning = &self.turning;
        let common = self.triads.len() - turning.len();
        let (common, own) = self.triads.split_at_mut(common);
        shared(own, |first, triads| {
            let turning = &turning[first..first + triads.len()];
            let (Some((from, _)), Some((to, _))) = (turning.first(), turning.last()) else { return };
            let mut triads = turning.iter().zip(triads);
            for motion in among(&frame.turns, *from as usize, (to - from) as usize + 1) {
                if let Some(((_, of), triad)) = triads.find(|((node, _), _)| *node == motion.node) {
                    *triad = turned(&common[*of as usize], motion.by);
                }
            }
        });
    }

    /// Bytes that last from state to state.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.initial)
            + size_of_val(&*self.positions)
            + size_of_val(&*self.before)
            + size_of_val(&*self.triad_of)
            + size_of_val(&*self.triads)
            + size_of_val(&*self.turning)
    }
}

/// The motions of this many nodes, of which each has one at most.
fn among(motions: &[Motion], first: usize, count: usize) -> &[Motion] {
    let from = motions.partition_point(|motion| (motion.node as usize) < first);
    let some = &motions[from..motions.len().min(from + count)];
    &some[..some.partition_point(|motion| (motion.node as usize) < first + count)]
}
