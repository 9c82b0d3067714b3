//! An element, or a set of elements of one kind, as given in the file.

use super::named::Members;
use crate::scene::kind::Kind;
use arrayvec::ArrayVec;

/// An element with its given data, or a set of elements.
#[derive(Clone, Debug)]
pub(in crate::scene) struct SceneElement {
    pub(in crate::scene) kind: &'static Kind,
    /// The nodes of each role: one for all members, or one for each member.
    pub(in crate::scene) nodes: ArrayVec<Members, 3>,
    /// The index in the scene of the line on which it slides.
    pub(in crate::scene) line: Option<u32>,
    /// In the order of [`Kind::parameters`].
    pub(in crate::scene) parameters: Box<[Parameter]>,
    /// One bit per output of the kind.
    pub(in crate::scene) outputs: u64,
}

/// What a scene gives for a parameter.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::scene) enum Parameter {
    Absent,
    /// One number for every member.
    One(f64),
    /// One number for each member.
    Each(Box<[f64]>),
}

impl Parameter {
    /// The number for a member of the set, if there is one.
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
    /// The number of elements in the set defined by these nodes; `None` if it is not a set.
    pub(in crate::scene) fn count(nodes: &[Members]) -> Option<u32> {
        nodes.iter().find_map(Members::count)
    }

    /// The nodes of a member of the set.
    pub(in crate::scene) fn nodes_of(&self, member: u32) -> ArrayVec<u32, 3> {
        self.nodes.iter().map(|nodes| nodes.number(member)).collect()
    }
}
