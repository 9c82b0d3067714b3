//! The arms of crosses, which must not become parallel.

use super::nodes::NodeStates;
use crate::element::cardan::MOST_CONDITION;
use crate::element::table::Number;
use crate::scene::model::Scene;
use crate::scene::plan::Group;

/// The sine of the angle between the arms below which they count as parallel: there the angles have the condition number from
/// which a start is refused.
const PARALLEL: f64 = 2.0 / MOST_CONDITION;

/// For every element of a group with a cross: where the arm e3b points, seen along the arm e1a, as components along e2a and e3a.
/// Their length is the sine of the angle between the arms.
#[derive(Debug, Default)]
pub(super) struct Crosses {
    seen: Vec<[f64; 2]>,
    /// Whether the element has been warned of.
    told: Vec<bool>,
}

impl Crosses {
    /// At the start.
    pub(super) fn new<T: Number>(scene: &Scene, group: &Group, nodes: &NodeStates<'_, T>) -> Self {
        if !(group.follows() && group.kind.has_cross()) {
            return Self::default();
        }
        let seen: Vec<_> = group.elements.iter().map(|&element| seen(scene, element, nodes)).collect();
        Self { told: vec![false; seen.len()], seen }
    }

    /// The elements, by their indices in the group, whose arms have become parallel on the way from the last places of the nodes
    /// to these; each is told once.
    pub(super) fn advance<T: Number>(&mut self, scene: &Scene, group: &Group, nodes: &NodeStates<'_, T>) -> Vec<usize> {
        let mut parallel = Vec::new();
        for (index, ((before, told), &element)) in
            self.seen.iter_mut().zip(&mut self.told).zip(&group.elements).enumerate()
        {
            let now = seen(scene, element, nodes);
            let from = std::mem::replace(before, now);
            if !*told && distance_from_origin(from, now) < PARALLEL {
                *told = true;
                parallel.push(index);
            }
        }
        parallel
    }

    /// The number of bytes that persist from state to state.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.seen) + size_of_val(&*self.told)
    }
}

/// The components of e3b along e2a and e3a.
fn seen<T: Number>(scene: &Scene, element: u32, nodes: &NodeStates<'_, T>) -> [f64; 2] {
    let (thing, member) = scene.elements.locate(element);
    let ends = &scene.elements.things()[thing].nodes;
    let [a, b] = [0, 1].map(|end| nodes.triad(nodes.triad_of(ends[end].number(member))));
    [a[1], a[2]].map(|axis| axis.dot(&b[2]).rounded())
}

/// The distance of the origin from the line between two points.
fn distance_from_origin(from: [f64; 2], to: [f64; 2]) -> f64 {
    let [p, q] = [from, to].map(nalgebra::Vector2::from);
    let way = q - p;
    let share =
        if way == nalgebra::Vector2::zeros() { 0.0 } else { (-p.dot(&way) / way.norm_squared()).clamp(0.0, 1.0) };
    (p + way * share).norm()
}

#[cfg(test)]
mod tests {
    use super::distance_from_origin;

    #[test]
    fn the_origin_is_as_far_as_the_nearest_point_between() {
        for (from, to, distance) in [
            ([0.5, 0.0], [0.5, 0.0], 0.5),
            ([0.5, 0.0], [1.0, 0.0], 0.5),
            ([0.5, 0.25], [-0.5, 0.25], 0.25),
            ([0.5, 0.0], [-0.25, 0.0], 0.0),
            ([0.0, 1.0], [1.0, 0.0], 0.5_f64.sqrt()),
        ] {
            assert!((distance_from_origin(from, to) - distance).abs() < 1e-15, "{from:?} {to:?}");
        }
    }
}
