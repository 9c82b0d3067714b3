//! The orientations of nodes, as triads of the scene.

use super::field::Label;
use super::log::Log;
use super::model::{Model, Named, Numbered, Orientation, Points};
use super::motion::{System, angle, axes};
use super::sets::candidates;
use super::source::Place;
use crate::scene::json::some_of;
use std::collections::HashMap;

/// An orientation of the scene: two axes in space, or an angle in the plane.
pub(super) struct Triad {
    pub(super) name: String,
    pub(super) place: Place,
    pub(super) axes: Result<[[f64; 3]; 2], f64>,
}

#[derive(Default)]
pub(super) struct Triads {
    pub(super) list: Vec<Triad>,
    /// Those of orientations, and of the nodes on which their axes depend.
    known: HashMap<(Named, Option<usize>), Option<usize>>,
    global: Option<usize>,
}

/// The name of an orientation in a scope, and where it is named.
type Wanted<'l> = (u32, &'l Label, Place);

impl Triads {
    /// The global axes.
    pub(super) fn global(&mut self, place: Place) -> usize {
        *self.global.get_or_insert_with(|| {
            self.list.push(Triad { name: "global axes".into(), place, axes: Ok([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]) });
            self.list.len() - 1
        })
    }

    /// The triad of this name at a node.
    pub(super) fn find(
        &mut self,
        model: &Model,
        node: usize,
        (scope, label, place): Wanted,
        is_plane: bool,
        log: &mut Log,
    ) -> Option<usize> {
        let named = candidates(model, scope, &label.key).into_iter().find(|name| model.orientations.contains_key(name));
        let Some(named) = named else {
            let names = some_of(model.orientations.values().map(|orientation| &orientation.shown));
            let allowed =
                if names.is_empty() { "no orientation, there are none".into() } else { format!("one of {names}") };
            log.fault(place, format!("no orientation {:?}", label.shown), allowed);
            return None;
        };
        let orientation = &model.orientations[&named];
        let of_node = matches!(orientation.system, System::Cylindrical | System::Spherical).then_some(node);
        let key = (named, of_node);
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let triad = triad(model, key.0.0, orientation, (node, of_node.is_some()), is_plane, log);
        let index = triad.map(|triad| {
            self.list.push(triad);
            self.list.len() - 1
        });
        self.known.insert(key, index);
        index
    }
}

/// The triad of an orientation at a node, which its name mentions if its axes depend on it.
fn triad(
    model: &Model,
    scope: u32,
    orientation: &Orientation,
    (node, depends): (usize, bool),
    is_plane: bool,
    log: &mut Log,
) -> Option<Triad> {
    let Orientation { shown, place, system, points, turn, motion } = orientation;
    let mut at = |&(node, place): &(Numbered, Place)| {
        let known = model.nodes.get(&node).map(|node| node.at);
        if known.is_none() {
            log.fault(place, format!("no node {}", model.shown(node)), "the number of a node");
        }
        known
    };
    let (points, motion) = match points {
        None => {
            let found =
                format!("orientation {shown:?}, by nodes of each element, a distribution, a program or several angles");
            log.fault(*place, found, "points a and b, the origin, and one angle, for connectors");
            return None;
        }
        Some(Points::Coordinates(points)) => (*points, motion.as_ref()),
        // The nodes are where the instance is.
        Some(Points::Nodes([a, b], origin)) => ([at(a)?, at(b)?, origin.as_ref().map_or(Some([0.0; 3]), at)?], None),
    };
    let (number, node) = model.nodes.get_index(node)?;
    let axes = axes(points, *system, node.at, *turn, motion);
    let axes = if is_plane {
        let angle = angle(axes);
        if angle.is_none() {
            log.fault(*place, "axes that are not in the plane", "points in the plane, b to the left of the first axis");
        }
        Err(angle?)
    } else {
        Ok(axes)
    };
    let of = &model.scopes[scope as usize];
    let name = if of.is_empty() { shown.clone() } else { format!("{of}.{shown}") };
    let name = if depends { format!("{name} at {}", model.shown(*number)) } else { name };
    Some(Triad { name, place: *place, axes })
}
