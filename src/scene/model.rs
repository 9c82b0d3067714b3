//! A scene as it was read and checked.

use super::contact::Line;
use super::kind::{Dimension, Kind};
use super::step::Number;
use crate::scalar::norm_and_direction;
use indexmap::IndexMap;
use nalgebra::Vector3;
use std::ops::Range;

/// A model over a history of states, and what is wanted of it; made by [`Scene::parse`].
#[derive(Clone, Debug)]
pub struct Scene {
    pub(super) title: String,
    pub(super) dimension: Dimension,
    pub(super) orientations: Vec<Orientation>,
    pub(super) nodes: IndexMap<Box<str>, Node>,
    /// Of axisymmetric scenes only.
    pub(super) lines: IndexMap<Box<str>, Line>,
    pub(super) elements: IndexMap<Box<str>, Element>,
    pub(super) frames: Vec<Frame>,
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
        self.elements.keys().map(|name| &**name)
    }
    /// The times of the states, in order.
    pub fn times(&self) -> impl ExactSizeIterator<Item = f64> {
        self.frames.iter().map(|frame| frame.time)
    }
}

/// How a triad stands, as the scene says it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Orientation {
    /// The first axis, and a vector in the plane of the first two.
    Axes([f64; 3], [f64; 3]),
    /// Axis times angle.
    Rotation([f64; 3]),
    /// Real part first; need not be of length 1.
    Quaternion([f64; 4]),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) at: [f64; 3],
    /// The global axes if `None`.
    pub(super) orientation: Option<u32>,
}

#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) kind: &'static Kind,
    pub(super) nodes: Box<[u32]>,
    /// The slide line of an element that slides.
    pub(super) line: Option<u32>,
    /// In the order of [`Kind::parameters`]; `None` where the scene gives none.
    pub(super) parameters: Box<[Option<f64>]>,
    /// A bit per output of the kind.
    pub(super) outputs: u64,
}

/// A state: what changes from the state before. What is not mentioned stays.
#[derive(Clone, Debug, Default)]
pub(super) struct Frame {
    pub(super) time: f64,
    /// Displacements of nodes from their initial positions.
    pub(super) moves: Changes<[f64; 3]>,
    /// Rotation vectors of nodes from their initial orientations.
    pub(super) turns: Changes<[f64; 3]>,
    /// Loads of elements, in the order of [`Kind::loads`].
    pub(super) loads: Vec<Changes<f64>>,
    /// Pressures of hard contact of nodes on slide lines.
    pub(super) pressures: Changes<f64>,
}

impl Frame {
    /// Brings into order what stands in another order than what it refers to.
    pub(super) fn sorted(mut self) -> Self {
        self.moves.sort();
        self.turns.sort();
        self.loads.iter_mut().for_each(Changes::sort);
        self.pressures.sort();
        self
    }
}

/// New values of some nodes or elements: which they are, each once and in their order, and beside it their values.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes<V> {
    pub(super) of: Vec<u32>,
    pub(super) to: Vec<V>,
}

impl<V: Copy> Changes<V> {
    /// Another, if there is one.
    pub(super) fn extend(&mut self, of: u32, to: Option<V>) {
        self.of.extend(to.map(|_| of));
        self.to.extend(to);
    }

    fn sort(&mut self) {
        if !self.of.is_sorted() {
            let mut changes: Vec<_> = self.iter(0..self.of.len()).collect();
            changes.sort_unstable_by_key(|&(of, _)| of);
            (self.of, self.to) = changes.into_iter().unzip();
        }
    }

    /// Those from this place on and before another.
    pub(super) fn iter(&self, places: Range<usize>) -> impl Iterator<Item = (u32, V)> {
        self.of[places.clone()].iter().copied().zip(self.to[places].iter().copied())
    }

    /// The place of the first, from this place on, that does not come before a node or element.
    pub(super) fn place(&self, from: usize, of: u32) -> usize {
        from + self.of[from..].partition_point(|&other| other < of)
    }

    /// The value of one.
    pub(super) fn get(&self, of: u32) -> Option<V> {
        self.of.binary_search(&of).ok().map(|place| self.to[place])
    }
}

/// The vectors of a triad.
pub(super) type Axes<T> = [Vector3<T>; 3];

/// A vector of exact doubles.
pub(super) fn exactly<T: Number>(v: [f64; 3]) -> Vector3<T> {
    Vector3::from(v.map(T::exactly))
}

fn unit<T: Number>(v: Vector3<T>) -> Vector3<T> {
    Vector3::from(norm_and_direction(<[T; 3]>::from(v)).1)
}

pub(super) fn global<T: Number>() -> Axes<T> {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(exactly)
}

impl Orientation {
    pub(super) fn axes<T: Number>(&self) -> Axes<T> {
        match *self {
            Self::Axes(first, second) => {
                let e1 = unit(exactly(first));
                let e3 = unit(e1.cross(&exactly(second)));
                [e1, e3.cross(&e1), e3]
            }
            Self::Rotation(rotation) => turned(&global(), rotation),
            Self::Quaternion(q) => {
                let [w, x, y, z] = norm_and_direction(q.map(T::exactly)).1;
                let v = Vector3::new(x, y, z);
                global().map(|e: Vector3<T>| {
                    let t = v.cross(&e) * (T::one() * 2.0);
                    e + t * w + v.cross(&t)
                })
            }
        }
    }
}

/// A triad turned by a rotation vector (Rodrigues' formula, with 1 − cos θ as 2 sin² θ/2).
pub(super) fn turned<T: Number>(axes: &Axes<T>, rotation: [f64; 3]) -> Axes<T> {
    if rotation == [0.0; 3] {
        return *axes;
    }
    let (angle, axis) = norm_and_direction(rotation.map(T::exactly));
    let axis = Vector3::from(axis);
    let (sine, half) = (angle.sin(), (angle * 0.5).sin());
    let versine = half * half * 2.0;
    axes.map(|e| {
        let across = axis.cross(&e);
        e + across * sine + axis.cross(&across) * versine
    })
}
