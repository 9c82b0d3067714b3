//! Where the nodes are.

use crate::scene::model::{Axes, Frame, Orientation, Scene, exactly, global, turned};
use crate::scene::plan::Plan;
use crate::scene::step::Number;
use nalgebra::Vector3;

/// Where the nodes are now.
#[derive(Debug)]
pub(super) struct Nodes<T> {
    pub(super) positions: Vec<Vector3<T>>,
    /// A triad per orientation, the global one first.
    orientations: Vec<Axes<T>>,
    /// Current triads, of all nodes if any element reads one.
    pub(super) triads: Vec<Axes<T>>,
}

impl<T: Number> Nodes<T> {
    pub(super) fn new(scene: &Scene, plan: &Plan) -> Self {
        let mut orientations = vec![global()];
        orientations.extend(scene.orientations.iter().map(Orientation::axes));
        let turning = plan.groups.iter().any(|group| !group.recipe.axes.is_empty());
        let triad = |orientation: Option<u32>| orientations[orientation.map_or(0, |index| index as usize + 1)];
        let triads =
            if turning { scene.nodes.values().map(|node| triad(node.orientation)).collect() } else { Vec::new() };
        let positions = scene.nodes.values().map(|node| exactly(node.at)).collect();
        Self { positions, orientations, triads }
    }

    pub(super) fn apply(&mut self, scene: &Scene, frame: &Frame) {
        for motion in &frame.motions {
            let (index, Some((_, node))) = (motion.node as usize, scene.nodes.get_index(motion.node as usize)) else {
                continue;
            };
            if let Some(u) = motion.u {
                self.positions[index] = exactly::<T>(node.at) + exactly(u);
            }
            if let (Some(ur), Some(triad)) = (motion.ur, self.triads.get_mut(index)) {
                *triad = turned(&self.orientations[node.orientation.map_or(0, |index| index as usize + 1)], ur);
            }
        }
    }
}
