//! An element, or a set of elements of one kind, as it was given.

use super::named::Members;
use crate::scene::kind::Kind;
use arrayvec::ArrayVec;

/// An element with what it was given, or a set of them.
#[derive(Clone, Debug)]
pub(in crate::scene) struct SceneElement {
    pub(in crate::scene) kind: &'static Kind,
    /// The nodes of each role: one for all members, or as many as there are members.
    pub(in crate::scene) nodes: ArrayVec<Members, 3>,
    /// The line that it slides on, by its place in the scene.
    pub(in crate::scene) line: Option<u32>,
    /// In the order of [`Kind::parameters`].
    pub(in crate::scene) parameters: Box<[Parameter]>,
    /// A bit per output of the kind.
    pub(in crate::scene) outputs: u64,
}

/// What a scene gives for a parameter.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::scene) enum Parameter {
    Absent,
    /// For every member.
    One(f64),
    /// For each.
    Each(Box<[f64]>),
}

impl Parameter {
    /// The number of a member of the set, if there is one.
    #[inline]
    pub(in crate::scene) fn of(&self, member: u32) -> Option<f64> {
        match self {
            Self::Absent => None,
            Self::One(number) => Some(*number),
            Self::Each(numbers) => Some(numbers[member as usize]),
        }
    }
}

impl SceneElement {
    /// How many of a set nodes stand for; `None` of what is no set.
    pub(in crate::scene) fn count(nodes: &[Members]) -> Option<u32> {
        nodes.iter().find_map(Members::count)
    }

    /// The nodes of a member of the set.
    pub(in crate::scene) fn nodes_of(&self, member: u32) -> ArrayVec<u32, 3> {
        self.nodes.iter().map(|nodes| nodes.number(member)).collect()
    }
}
