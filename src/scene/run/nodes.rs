//! The positions of the nodes.

use super::share::shared;
use super::way::Way;
use crate::element::table::Number;
use crate::number::prefetch::prefetch;
use crate::scene::kind::Origin;
use crate::scene::model::{Axes, Changes, Frame, Orientation, Scene, exactly, global, turned};
use crate::scene::plan::{Group, Plan};
use nalgebra::Vector3;
use std::borrow::Cow;

/// The current and previous positions of the nodes. Nodes that never move come first, then those that do.
#[derive(Debug)]
pub(super) struct NodeStates<'s, T> {
    /// The index here of each node of the scene.
    places: Vec<u32>,
    initial: Vec<[f64; 3]>,
    /// The nodes that move in any state, by their numbers in the scene.
    moving: Vec<u32>,
    /// Their displacements: those of a frame of the scene, if it contains all of them.
    displacements: Cow<'s, [[f64; 3]]>,
    /// Displacements in the last state, if increments are needed.
    before: Option<Cow<'s, [[f64; 3]]>>,
    /// The triad of every node of the scene, if an element reads one.
    triad_of: Vec<u32>,
    /// The global triad and the orientations of the scene, which nodes share; then those of the nodes that rotate.
    triads: Vec<Axes<T>>,
    /// The nodes that rotate in any state, by their numbers in the scene, and the triads from which they rotate; one with which
    /// others rotate is there for each of them, too.
    turning: Vec<(u32, u32)>,
    /// Their rotation vectors in the last state, if angles are followed.
    rotations: Option<Vec<[f64; 3]>>,
}

impl<'s, T: Number> NodeStates<'s, T> {
    pub(super) fn new(plan: &Plan<'s>) -> Self {
        let scene = plan.scene;
        let passes = || plan.groups.iter().flat_map(|group| [&group.recipe.start, &group.recipe.state]);
        let reads = |is: fn(Origin) -> bool| passes().any(|pass| pass.reads.iter().any(|&(origin, _)| is(origin)));
        let increments = reads(|origin| matches!(origin, Origin::Increment(_))) || !plan.contacts.is_empty();
        let is_moved = changed(scene, |frame| &frame.moves);
        let own = (0..scene.nodes.next_number()).filter(|&node| scene.nodes[node].with.is_none());
        let (moving, fixed): (Vec<_>, Vec<_>) = own.partition(|&node| is_moved[node as usize]);
        let mut places = vec![0; scene.nodes.len()];
        for (&node, place) in fixed.iter().chain(&moving).zip(0..) {
            places[node as usize] = place;
        }
        for node in 0..scene.nodes.next_number() {
            if let Some(with) = scene.nodes[node].with {
                places[node as usize] = places[with as usize];
            }
        }
        let displacements: Cow<'s, [_]> = Cow::Owned(vec![[0.0; 3]; moving.len()]);
        let mut nodes = Self {
            places,
            initial: fixed.iter().chain(&moving).map(|&node| scene.at[node as usize]).collect(),
            moving,
            before: increments.then(|| displacements.clone()),
            displacements,
            triad_of: Vec::new(),
            triads: std::iter::once(global())
                .chain(scene.orientations.things().iter().map(Orientation::axes))
                .collect(),
            turning: Vec::new(),
            rotations: None,
        };
        if reads(|origin| matches!(origin, Origin::Axis(..))) {
            nodes.share_triads(scene);
        }
        if plan.groups.iter().any(Group::follows) {
            nodes.rotations = Some(vec![[0.0; 3]; nodes.turning.len()]);
        }
        nodes
    }

    /// Every node has the triad of its orientation; those that rotate in any state have a triad of their own.
    fn share_triads(&mut self, scene: &Scene) {
        let nodes =
            || scene.nodes.iter().flat_map(|(_, members, node)| members.numbers().map(move |number| (number, node)));
        self.triad_of = nodes().map(|(_, node)| node.orientation.map_or(0, |index| index + 1)).collect();
        let is_turned = changed(scene, |frame| &frame.turns);
        let turning = nodes().map(|(number, node)| (node.with.unwrap_or(number), number));
        let mut turning: Vec<_> = turning.filter(|&(with, _)| is_turned[with as usize]).collect();
        turning.sort_unstable();
        let first = u32::try_from(self.triads.len()).expect("orientations and nodes together are numbered in 32 bits");
        for ((with, node), own) in turning.into_iter().zip(first..) {
            let triad = &mut self.triad_of[node as usize];
            self.turning.push((with, *triad));
            self.triads.push(self.triads[*triad as usize]);
            *triad = own;
        }
    }

    /// The index here of a node of the scene.
    pub(super) fn place(&self, node: u32) -> u32 {
        self.places[node as usize]
    }

    /// The number of nodes that never move.
    #[inline]
    fn fixed(&self) -> usize {
        self.initial.len() - self.moving.len()
    }

    /// The position of a node, by its index here.
    #[inline]
    pub(super) fn positions(&self) -> impl Fn(u32) -> Vector3<T> {
        let (initial, displacements, fixed) = (&*self.initial, &*self.displacements, self.fixed());
        move |place| {
            let (place, at) = (place as usize, exactly(initial[place as usize]));
            if place < fixed { at } else { at + exactly(displacements[place - fixed]) }
        }
    }

    /// The displacement of a node since the last state.
    #[inline]
    pub(super) fn increments(&self) -> impl Fn(u32) -> Vector3<T> {
        let before = self.before.as_deref().expect("what asks for increments had them kept");
        let now = &*self.displacements;
        let fixed = self.fixed();
        move |place| {
            let Some(moving) = (place as usize).checked_sub(fixed) else { return exactly([0.0; 3]) };
            exactly::<T>(now[moving]) - exactly(before[moving])
        }
    }

    /// Prefetches the data for the position of a node.
    #[inline]
    pub(super) fn prefetch(&self) -> impl Fn(u32) {
        let (initial, displacements, fixed) = (&*self.initial, &*self.displacements, self.fixed());
        move |place| {
            prefetch(&initial[place as usize]);
            if let Some(moving) = (place as usize).checked_sub(fixed) {
                prefetch(&displacements[moving]);
            }
        }
    }

    /// The number of the triad of a node of the scene; the global one if no element reads any.
    pub(super) fn triad_of(&self, node: u32) -> u32 {
        self.triad_of.get(node as usize).copied().unwrap_or_default()
    }

    /// A current triad by its number.
    #[inline]
    pub(super) fn triad(&self, number: u32) -> &Axes<T> {
        &self.triads[number as usize]
    }

    /// Moves and rotates the nodes. If an owned frame contains all displacements, they are swapped with the old ones.
    pub(super) fn advance(&mut self, frame: &mut Cow<'s, Frame>) {
        if let Some(before) = &mut self.before {
            before.clone_from(&self.displacements);
        }
        if frame.moves.of.len() == self.moving.len() {
            match frame {
                Cow::Borrowed(frame) => self.displacements = Cow::Borrowed(&frame.moves.to),
                Cow::Owned(frame) => std::mem::swap(self.displacements.to_mut(), &mut frame.moves.to),
            }
        } else if !frame.moves.of.is_empty() {
            self.move_some(frame);
        }
        if !frame.turns.of.is_empty() {
            self.turn_some(frame);
        }
    }

    /// The way of the rotations to a frame, and the nodes for which it is not known; `None` if nothing needs it.
    pub(super) fn way<'f>(&self, frame: &'f Frame) -> Option<(Way<'f>, Vec<(u32, f64)>)> {
        let rotations = self.rotations.as_ref().filter(|_| !frame.turns.of.is_empty())?;
        let before = |&node: &u32| {
            self.turning.binary_search_by_key(&node, |&(node, _)| node).map_or([0.0; 3], |k| rotations[k])
        };
        Some(Way::new(frame.turns.of.iter().map(before).collect(), frame))
    }

    fn move_some(&mut self, frame: &Frame) {
        let (moving, places, fixed) = (&self.moving, &self.places, self.fixed());
        shared(self.displacements.to_mut(), |first, displacements| {
            for (node, by) in among(&frame.moves, &moving[first..first + displacements.len()], |&node| node) {
                displacements[places[node as usize] as usize - fixed - first] = by;
            }
        });
    }

    fn turn_some(&mut self, frame: &Frame) {
        let turning = &self.turning;
        if let Some(rotations) = &mut self.rotations {
            for_each_turn(&frame.turns, turning, |index, by| rotations[index] = by);
        }
        let common = self.triads.len() - turning.len();
        let (common, own) = self.triads.split_at_mut(common);
        shared(own, |first, triads| {
            let turning = &turning[first..first + triads.len()];
            for_each_turn(&frame.turns, turning, |index, by| {
                triads[index] = turned(&common[turning[index].1 as usize], by);
            });
        });
    }

    /// The number of bytes that persist from state to state.
    pub(super) fn bytes(&self) -> usize {
        let owned = |displacements: &Cow<'_, [[f64; 3]]>| match displacements {
            Cow::Borrowed(_) => 0,
            Cow::Owned(own) => size_of_val(&**own),
        };
        size_of_val(&*self.places)
            + size_of_val(&*self.initial)
            + size_of_val(&*self.moving)
            + owned(&self.displacements)
            + self.before.as_ref().map_or(0, owned)
            + size_of_val(&*self.triad_of)
            + size_of_val(&*self.triads)
            + size_of_val(&*self.turning)
            + self.rotations.as_ref().map_or(0, |rotations| size_of_val(&**rotations))
    }
}

/// Whether some frame changes each node of the scene.
fn changed(scene: &Scene, changes: impl Fn(&Frame) -> &Changes<[f64; 3]>) -> Vec<bool> {
    let mut is_changed = vec![false; scene.nodes.len()];
    let all = scene.history.mentions().iter().flat_map(|frame| &*changes(frame).of);
    all.for_each(|&node| is_changed[node as usize] = true);
    is_changed
}

/// The rotation vectors of those among the turning nodes that a frame turns, with their indices.
fn for_each_turn(turns: &Changes<[f64; 3]>, turning: &[(u32, u32)], mut turn: impl FnMut(usize, [f64; 3])) {
    let mut turns = among(turns, turning, |&(node, _)| node).peekable();
    for (index, &(node, _)) in turning.iter().enumerate() {
        while turns.next_if(|&(before, _)| before < node).is_some() {}
        if let Some(&(_, by)) = turns.peek().filter(|&&(of, _)| of == node) {
            turn(index, by);
        }
    }
}

/// The changes of these nodes, which are sorted.
fn among<N, V: Copy>(changes: &Changes<V>, nodes: &[N], number: impl Fn(&N) -> u32) -> impl Iterator<Item = (u32, V)> {
    let places = match (nodes.first(), nodes.last()) {
        (Some(first), Some(last)) => {
            let from = changes.place(0, number(first));
            from..changes.place(from, number(last) + 1)
        }
        _ => 0..0,
    };
    changes.iter(places)
}
