//! A scene as it was read and checked.

mod frame;
mod named;
mod orientation;

pub(super) use frame::{Changes, Frame};
pub(super) use named::Named;
pub(super) use orientation::{Axes, Orientation, exactly, global, turned};

use super::kind::{Dimension, Kind};
use crate::isl::{IslElement, Surface};

/// A model over a history of states, and what is wanted of it; made by [`Scene::parse`].
#[derive(Clone, Debug)]
pub struct Scene {
    pub(in crate::scene) title: String,
    pub(in crate::scene) dimension: Dimension,
    pub(in crate::scene) orientations: Named<Orientation>,
    pub(in crate::scene) nodes: Named<SceneNode>,
    /// Slide lines, of axisymmetric scenes only.
    pub(in crate::scene) lines: Named<SceneLine>,
    pub(in crate::scene) elements: Named<SceneElement>,
    pub(in crate::scene) frames: Vec<Frame>,
}

impl Scene {
    /// The title; empty if there is none.
    pub fn title(&self) -> &str {
        &self.title
    }
    /// The space it lives in.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }
    /// The number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes.len()
    }
    /// The names of the elements, in the order of the file.
    pub fn elements(&self) -> impl ExactSizeIterator<Item = &str> {
        self.elements.names()
    }
    /// The kind of an element.
    pub fn kind(&self, element: &str) -> Option<&'static Kind> {
        self.elements.number_of(element).map(|number| self.elements[number].kind)
    }
    /// The times of the states, in order.
    pub fn times(&self) -> impl ExactSizeIterator<Item = f64> {
        self.frames.iter().map(|frame| frame.time)
    }
}

/// A node where it is initially.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneNode {
    pub(super) at: [f64; 3],
    /// The global axes if `None`.
    pub(super) orientation: Option<u32>,
}

/// A slide line, and how often its torque is wanted.
#[derive(Clone, Debug)]
pub(super) struct SceneLine {
    pub(super) surface: Surface,
    /// In every how many states; never where it is 0.
    pub(super) torque_frequency: u32,
}

/// An element with what it was given.
#[derive(Clone, Debug)]
pub(super) struct SceneElement {
    pub(super) kind: &'static Kind,
    pub(super) nodes: Box<[u32]>,
    pub(super) sliding: Option<Sliding>,
    /// In the order of [`Kind::parameters`]; `None` where the scene gives none.
    pub(super) parameters: Box<[Option<f64>]>,
    /// A bit per output of the kind.
    pub(super) outputs: u64,
}

/// An element on its slide line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Sliding {
    /// The line, by its place in the scene.
    pub(super) line: u32,
    /// Its nodes are numbered by their place in the scene; its own number says nothing.
    pub(super) element: IslElement,
}
