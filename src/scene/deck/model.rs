//! What a deck says, before it is a scene: numbers and names are those of the deck.

use super::field::Label;
use super::motion::{Motion, System};
use super::source::Place;
use indexmap::IndexMap;
use std::collections::HashMap;

/// The index of an instance; 0 is the assembly, or a deck without parts. The complement of each is that of the grounds of its
/// connectors, which have the numbers of their connectors.
pub(super) type Scope = u32;

/// A node or an element: its scope and its number.
pub(super) type Numbered = (Scope, u32);

/// A name in a scope.
pub(super) type Named = (Scope, String);

/// A value and its place.
pub(super) type At<T> = (T, Place);

#[derive(Default)]
pub(super) struct Model {
    pub(super) title: String,
    /// The instances as they are written; the first is the assembly, without a name.
    pub(super) scopes: Vec<String>,
    pub(super) scope_of: HashMap<String, Scope>,
    pub(super) nodes: IndexMap<Numbered, Node>,
    pub(super) elements: IndexMap<Numbered, Element>,
    /// Where elements of other types are first, by type.
    pub(super) others: IndexMap<String, Place>,
    pub(super) node_sets: HashMap<Named, Vec<Item>>,
    pub(super) element_sets: HashMap<Named, Vec<Item>>,
    pub(super) orientations: IndexMap<Named, Orientation>,
    pub(super) sections: Vec<Section>,
    pub(super) behaviors: IndexMap<String, Behavior>,
    pub(super) sliders: Vec<[Reference; 3]>,
    pub(super) lines: Vec<SlideLine>,
    pub(super) interfaces: Vec<Interface>,
    pub(super) requests: Vec<Request>,
    /// How often torques are printed.
    pub(super) torque_frequency: Option<At<u32>>,
}

#[derive(Clone, Copy)]
pub(super) struct Node {
    pub(super) at: [f64; 3],
    pub(super) place: Place,
}

/// The types of elements that a scene can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    Connector,
    PlaneConnector,
    Linear,
    Parabolic,
}

impl Type {
    pub(super) const ALL: [(&str, Self); 4] = [
        ("CONN3D2", Self::Connector),
        ("CONN2D2", Self::PlaneConnector),
        ("ISL21A", Self::Linear),
        ("ISL22A", Self::Parabolic),
    ];

    pub(super) fn nodes(self) -> usize {
        if self == Self::Parabolic { 3 } else { 2 }
    }

    pub(super) fn slides(self) -> bool {
        matches!(self, Self::Linear | Self::Parabolic)
    }
}

#[derive(Clone)]
pub(super) struct Element {
    pub(super) of: Type,
    pub(super) nodes: arrayvec::ArrayVec<At<Numbered>, 3>,
    pub(super) place: Place,
}

/// A member of a set, or several.
#[derive(Clone)]
pub(super) struct Item {
    pub(super) scope: Scope,
    pub(super) of: Members,
    pub(super) place: Place,
}

#[derive(Clone)]
pub(super) enum Members {
    One(u32),
    /// First, last and increment.
    Range(u32, u32, u32),
    Set(String),
}

/// A node, or a set of nodes.
#[derive(Clone)]
pub(super) struct Reference {
    pub(super) scope: Scope,
    pub(super) of: Members,
    pub(super) shown: String,
    pub(super) place: Place,
}

/// A system of axes.
pub(super) struct Orientation {
    pub(super) shown: String,
    /// That of its points, if it has any.
    pub(super) place: Place,
    pub(super) system: System,
    /// `None` if it is described in another way, which connectors do not have.
    pub(super) points: Option<Points>,
    /// The axis from 0, and the angle in degrees.
    pub(super) turn: Option<(usize, f64)>,
    pub(super) motion: Option<Motion>,
}

/// The points a, b and the origin.
pub(super) enum Points {
    Coordinates([[f64; 3]; 3]),
    /// The origin is that of the global axes without a third node.
    Nodes([At<Numbered>; 2], Option<At<Numbered>>),
}

/// *CONNECTOR SECTION.
pub(super) struct Section {
    pub(super) scope: Scope,
    pub(super) elements: At<Label>,
    pub(super) place: Place,
    /// The types of connection.
    pub(super) kinds: Vec<At<String>>,
    /// The orientations of both nodes.
    pub(super) orientations: [Option<At<Label>>; 2],
    pub(super) behavior: Option<At<Label>>,
}

/// *CONNECTOR BEHAVIOR.
#[derive(Default)]
pub(super) struct Behavior {
    /// The last is that to which *FRICTION belongs.
    pub(super) frictions: Vec<Friction>,
    pub(super) stops: Vec<Stop>,
    /// Components and their references.
    pub(super) reference: Vec<(u8, At<f64>)>,
    /// What of it the scene does not have.
    pub(super) others: Vec<At<&'static str>>,
}

impl Behavior {
    pub(super) fn predefined(&self) -> Option<&Friction> {
        self.frictions.iter().find(|friction| friction.predefined)
    }
}

/// *CONNECTOR STOP.
pub(super) struct Stop {
    pub(super) component: u8,
    /// Lower and upper.
    pub(super) limits: [Option<At<f64>>; 2],
    pub(super) place: Place,
}

/// *CONNECTOR FRICTION.
pub(super) struct Friction {
    pub(super) place: Place,
    /// Whether it is predefined, and its parameters, in order.
    pub(super) predefined: bool,
    pub(super) parameters: Vec<At<Option<f64>>>,
    pub(super) stick: Option<At<f64>>,
    pub(super) mu: Option<At<f64>>,
}

/// *SLIDE LINE.
pub(super) struct SlideLine {
    pub(super) scope: Scope,
    pub(super) elements: At<Label>,
    pub(super) place: Place,
    pub(super) parabolic: bool,
    pub(super) nodes: Vec<At<Numbered>>,
    pub(super) smooth: Option<At<f64>>,
    pub(super) extension: Option<At<f64>>,
}

/// *INTERFACE.
pub(super) struct Interface {
    pub(super) scope: Scope,
    pub(super) elements: At<Label>,
    /// The keys and numbers of the pressure law.
    pub(super) pressure: Vec<(&'static str, At<f64>)>,
    pub(super) friction: Option<Place>,
}

/// *ELEMENT OUTPUT and the like.
pub(super) struct Request {
    /// The elements; all of them if none are named.
    pub(super) of: Option<(Scope, Label)>,
    /// Names of outputs; `None` stands for all.
    pub(super) names: Option<Vec<At<String>>>,
    pub(super) place: Place,
}

impl Model {
    /// A number as the scene names it.
    pub(super) fn shown(&self, (scope, number): Numbered) -> String {
        match self.scopes.get(scope as usize) {
            None => format!("ground of {}", self.shown((!scope, number))),
            Some(of) if of.is_empty() => number.to_string(),
            Some(of) => format!("{of}.{number}"),
        }
    }

    /// Gives connectors to ground a node there: at the start it is at their other node (Connector elements, connection to ground).
    pub(super) fn add_grounds(&mut self) {
        for (&(scope, number), element) in &self.elements {
            let ground = (!scope, number);
            let Some(&(_, place)) = element.nodes.iter().find(|(node, _)| *node == ground) else { continue };
            let other = element.nodes.iter().find(|(node, _)| *node != ground);
            let at = other.and_then(|(node, _)| self.nodes.get(node)).map_or([0.0; 3], |node| node.at);
            self.nodes.insert(ground, Node { at, place });
        }
    }
}
