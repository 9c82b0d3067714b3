//! A scene after reading and checking.

mod element;
mod frame;
mod history;
mod named;
mod orientation;

pub(super) use element::{Parameter, SceneElement};
pub(super) use frame::{Changes, Frame, Quantity, Unsorted};
pub(super) use history::{Components, History, HistoryColumn, HistoryColumns, HistoryTables, OpenColumn, Places};
pub(super) use named::{Members, Name, Named};
pub(super) use orientation::{Axes, Orientation, exactly, global, turned};

use super::angles::AngleUnit;
use super::kind::{Dimension, Kind};
use crate::contact::isl::Surface;
use crate::formula::quantity::Domain;

/// A model over a history of states, with the requested outputs; created by [`Scene::parse`].
#[derive(Clone, Debug)]
pub struct Scene {
    pub(in crate::scene) title: String,
    pub(in crate::scene) dimension: Dimension,
    /// The unit of the angles in the file; here they are in radians.
    pub(in crate::scene) angles: AngleUnit,
    pub(in crate::scene) orientations: Named<Orientation>,
    pub(in crate::scene) nodes: Named<SceneNode>,
    /// The initial position of every node, by its number.
    pub(in crate::scene) at: Vec<[f64; 3]>,
    /// Slide lines, of axisymmetric scenes only.
    pub(in crate::scene) lines: Named<SceneLine>,
    pub(in crate::scene) elements: Named<SceneElement>,
    pub(in crate::scene) history: History,
}

impl Scene {
    /// The title; empty if there is none.
    pub fn title(&self) -> &str {
        &self.title
    }
    /// The dimension of the scene.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }
    /// The number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes.len()
    }
    /// The names of the elements and sets of elements, in the order of the file.
    pub fn elements(&self) -> impl ExactSizeIterator<Item = &str> {
        self.elements.names()
    }
    /// The number of elements, including those of sets.
    pub fn size(&self) -> usize {
        self.elements.len()
    }
    /// The kind of an element or a set of them.
    pub fn kind(&self, element: &str) -> Option<&'static Kind> {
        let members = self.elements.members(element)?;
        Some(self.elements[members.number(0)].kind)
    }
    /// What is ambiguous, in words: angles that look like degrees, unless the file says their unit; rows of tables about what is
    /// not in the scene.
    pub fn warnings(&self) -> Vec<String> {
        let turn = std::f64::consts::TAU;
        let mut warnings = match &self.history {
            History::Tables(tables) => tables.warnings.clone(),
            _ => Vec::new(),
        };
        if self.angles != AngleUnit::Unsaid {
            return warnings;
        }
        for (name, SceneElement { kind, parameters, .. }) in self.elements.names().zip(self.elements.things()) {
            let angles =
                kind.parameters().zip(&**parameters).filter(|((name, _), _)| kind.domain(name) == Domain::Angle);
            for ((parameter, _), given) in angles {
                let numbers = match given {
                    Parameter::Absent => &[],
                    Parameter::One(number) => std::slice::from_ref(number),
                    Parameter::Each(numbers) => &**numbers,
                };
                if let Some(number) = numbers.iter().find(|number| number.is_finite() && number.abs() > turn) {
                    warnings.push(format!(
                        "elements.{name}.{parameter} is {number}, more than a full turn: angles are in radians, and {number}° would be {:.6}; say \"angles\": \"degrees\" or \"radians\"",
                        number.to_radians()
                    ));
                }
            }
        }
        warnings
    }
    /// The times of the states, in order.
    pub fn times(&self) -> impl ExactSizeIterator<Item = f64> {
        (0..self.history.len()).map(|state| self.history.time(state))
    }
}

/// A node, or a set of nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneNode {
    /// The global axes if `None`.
    pub(super) orientation: Option<u32>,
    /// The node with which it moves and rotates, if it is at another one.
    pub(super) with: Option<u32>,
}

/// What is wrong with a motion of a node that moves with another, and what is allowed.
pub(super) fn moves_with(node: Name<'_>, with: Name<'_>) -> [String; 2] {
    [format!("node {node:?}, which moves with {with:?}"), format!("{with:?}, with which it moves")]
}

/// A slide line, and how often its torque is output.
#[derive(Clone, Debug)]
pub(super) struct SceneLine {
    pub(super) surface: Surface,
    /// The interval in states at which the torque is output; never if it is 0.
    pub(super) torque_frequency: u32,
}
