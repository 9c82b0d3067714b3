//! Evaluating a plan, state after state.
//!
//! Elements are taken in blocks; each block has its own registers, and no element sees another, so the results do not
//! depend on how many threads there are. What lasts from state to state is what the plan keeps per element, the
//! results of the last state, and position and triad per node.

mod nodes;
mod state;

use super::contact::{Contact, Motion};
use super::model::{Frame, Scene};
use super::plan::{Group, Plan};
use super::recipe::Span;
use super::step::{Failure, Number};
use crate::error::Error;
use nalgebra::Vector3;
use nodes::Nodes;
use state::State;

/// A formula that rejected its inputs during a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The element.
    pub element: String,
    /// The state, counted from 0; `None` for the initial configuration.
    pub state: Option<usize>,
    /// The formula.
    pub formula: &'static str,
    /// What it says.
    pub error: Error,
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { element, state, formula, error } = self;
        match state {
            Some(state) => write!(f, "element {element:?}, frames[{state}], {formula}: {error}"),
            None => write!(f, "element {element:?}, initial configuration, {formula}: {error}"),
        }
    }
}

/// Problems of a state; a hundred at most.
#[derive(Clone, Debug, PartialEq)]
pub struct Problems(pub Vec<Problem>);

impl std::fmt::Display for Problems {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let lines: Vec<_> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for Problems {}

/// Problems that are listed.
const LISTED: usize = 100;

/// A scene that is being evaluated in `T`.
#[derive(Debug)]
pub struct Run<'s, T> {
    scene: &'s Scene,
    plan: &'s Plan,
    state: usize,
    nodes: Nodes<T>,
    groups: Vec<State<T>>,
    /// Group, and place in it, of every element; `u32::MAX` for those of which nothing is wanted.
    places: Vec<[u32; 2]>,
    contacts: Vec<Contact<'s, T>>,
    /// Where the nodes were, if a slide line asks.
    before: Vec<Vector3<T>>,
}

impl<'s, T: Number> Run<'s, T> {
    /// The initial configuration.
    ///
    /// # Errors
    /// A formula that is undefined there.
    pub fn new(scene: &'s Scene, plan: &'s Plan) -> Result<Self, Problems> {
        let mut places = vec![[u32::MAX; 2]; scene.elements.len()];
        for (group, index) in plan.groups.iter().zip(0..) {
            for (&element, place) in group.elements.iter().zip(0..) {
                places[element as usize] = [index, place];
            }
        }
        let nodes = Nodes::new(scene, plan);
        let groups = plan.groups.iter().map(|group| State::new(scene, group, &nodes)).collect();
        let contacts: Vec<_> = plan.contacts.iter().filter_map(|contact| Contact::new(scene, contact)).collect();
        let before = if contacts.is_empty() { Vec::new() } else { nodes.positions.clone() };
        let mut run = Self { scene, plan, state: 0, nodes, groups, places, contacts, before };
        run.start()?;
        Ok(run)
    }

    fn start(&mut self) -> Result<(), Problems> {
        let mut problems = Vec::new();
        for (group, state) in self.plan.groups.iter().zip(&mut self.groups) {
            let recipe = &group.recipe;
            let (scene, nodes) = (self.scene, &self.nodes);
            let failures = state.blocks(group, nodes, &recipe.start, |kept, lanes, lane, _| {
                for (from, to) in recipe.initial.iter().chain(&recipe.fallbacks) {
                    lanes.take(lane, from.at, &mut kept[range(*to)]);
                }
            });
            problems.extend(failures.into_iter().map(|failure| problem(scene, group, None, failure)));
        }
        problems.truncate(LISTED);
        if problems.is_empty() { Ok(()) } else { Err(Problems(problems)) }
    }

    /// The next state; `false` if there is none.
    ///
    /// # Errors
    /// A formula that is undefined there, or a result that no double can hold.
    pub fn advance(&mut self) -> Result<bool, Problems> {
        let Some(frame) = self.scene.frames.get(self.state) else {
            return Ok(false);
        };
        self.nodes.apply(self.scene, frame);
        for load in &frame.loads {
            let [group, place] = self.places[load.element as usize];
            let Some((group, state)) = self.plan.groups.get(group as usize).zip(self.groups.get_mut(group as usize))
            else {
                continue;
            };
            if let Some(Some(span)) = group.recipe.loads.get(usize::from(load.index)) {
                state.kept[place as usize * group.recipe.kept + span.at] = T::exactly(load.value);
            }
        }
        let mut problems = Vec::new();
        for (group, state) in self.plan.groups.iter().zip(&mut self.groups) {
            let recipe = &group.recipe;
            let (scene, nodes) = (self.scene, &self.nodes);
            let failures = state.blocks(group, nodes, &recipe.steps, |kept, lanes, lane, results| {
                for (from, to) in &recipe.before {
                    lanes.take(lane, from.at, &mut kept[range(*to)]);
                }
                let mut at = 0;
                for (_, span) in &recipe.outputs {
                    lanes.take(lane, span.at, &mut results[at..at + span.len]);
                    at += span.len;
                }
            });
            problems.extend(failures.into_iter().map(|failure| problem(scene, group, Some(self.state), failure)));
        }
        problems.extend(self.slide(frame));
        self.state += 1;
        problems.truncate(LISTED);
        if problems.is_empty() { Ok(true) } else { Err(Problems(problems)) }
    }

    /// The next state of the slide lines.
    fn slide(&mut self, frame: &Frame) -> Vec<Problem> {
        let last = self.state.checked_sub(1).and_then(|last| self.scene.frames.get(last));
        let duration = last.map(|last| frame.time - last.time);
        let motion = Motion { now: &self.nodes.positions, before: &self.before, duration };
        let mut problems = Vec::new();
        for contact in &mut self.contacts {
            frame.pressures.iter().for_each(|&(node, pressure)| contact.press(node, pressure));
            let failures = contact.advance(&motion).err().unwrap_or_default();
            let problem =
                |(formula, error)| Problem { element: contact.name().into(), state: Some(self.state), formula, error };
            problems.extend(failures.into_iter().map(problem));
        }
        if !self.contacts.is_empty() {
            self.before.copy_from_slice(&self.nodes.positions);
        }
        problems
    }

    /// Results of the current state: for the first elements in the order of the file, output by output, the components;
    /// then for every slide line of which it is wanted the torque.
    pub fn for_each_result(&self, elements: usize, mut visit: impl FnMut(&'s str, &'static str, &[T])) {
        for contact in &self.contacts {
            contact.for_each_result(self.scene, elements, &mut visit);
        }
        for (name, &[group, place]) in self.scene.elements.keys().zip(&self.places).take(elements) {
            let Some((group, state)) = self.plan.groups.get(group as usize).zip(self.groups.get(group as usize)) else {
                continue;
            };
            let mut at = place as usize * state.width;
            for (output, span) in &group.recipe.outputs {
                visit(name, output, &state.results[at..at + span.len]);
                at += span.len;
            }
        }
    }

    /// How many segments and corners of slide lines were looked at so far, and by which formula.
    pub fn looked_at(&self) -> impl Iterator<Item = (&'static str, usize)> {
        self.contacts.iter().map(Contact::looked_at)
    }

    /// Bytes that last from state to state: of elements, and of nodes.
    pub fn bytes(&self) -> [usize; 2] {
        let numbers: usize = self.groups.iter().map(|state| state.kept.capacity() + state.results.capacity()).sum();
        let ends: usize = self.groups.iter().map(|state| state.ends.len() * size_of::<u32>()).sum();
        let sliding: usize = self.contacts.iter().map(Contact::bytes).sum();
        let places = self.places.len() * size_of::<[u32; 2]>();
        let elements = numbers * size_of::<T>() + places + ends + sliding;
        let nodes = size_of_val(&*self.nodes.positions) + size_of_val(&*self.before) + size_of_val(&*self.nodes.triads);
        [elements, nodes]
    }
}

fn range(span: Span) -> std::ops::Range<usize> {
    span.at..span.at + span.len
}

fn problem(scene: &Scene, group: &Group, state: Option<usize>, failure: Failure) -> Problem {
    let Failure { lane, formula, error } = failure;
    let name = group.elements.get(lane).and_then(|&element| scene.elements.get_index(element as usize));
    Problem { element: name.map_or_else(String::new, |(name, _)| name.to_string()), state, formula, error }
}
