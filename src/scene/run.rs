//! Evaluating a plan, state after state.
//!
//! Elements are taken in blocks; each block has its own registers, and no element sees another, so the results do not
//! depend on how many threads there are. What lasts from state to state is what the plan keeps per element, the
//! results of the last state, and initial position and triad per node; displacements are read where the frame holds them.

mod blocks;
pub(super) mod nodes;
mod state;

use super::contact::{Contact, Motion};
use super::model::{Frame, Scene};
use super::plan::Plan;
use super::step::{Failure, Number};
use crate::error::Error;
use arrayvec::ArrayVec;
use nodes::Nodes;
use rayon::prelude::*;
use state::{Inputs, State};

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
    /// The same in words, with nodes called as the scene calls them.
    pub message: String,
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { element, state, formula, message, .. } = self;
        match state {
            Some(state) => write!(f, "element {element:?}, frames[{state}], {formula}: {message}"),
            None => write!(f, "element {element:?}, initial configuration, {formula}: {message}"),
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
    nodes: Nodes<'s, T>,
    groups: Vec<State<T>>,
    /// Group, and place in it, of every element; `u32::MAX` for those of which nothing is wanted.
    places: Vec<[u32; 2]>,
    contacts: Vec<Contact<'s, T>>,
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
        let contacts = plan.contacts.iter().filter_map(|contact| Contact::new(scene, contact)).collect();
        let mut run = Self { scene, plan, state: 0, nodes, groups, places, contacts };
        let problems = run.evaluate(None);
        if problems.is_empty() { Ok(run) } else { Err(Problems(problems)) }
    }

    /// The next state; `false` if there is none.
    ///
    /// # Errors
    /// A formula that is undefined there, or a result that no double can hold.
    pub fn advance(&mut self) -> Result<bool, Problems> {
        let Some(frame) = self.scene.frames.get(self.state) else {
            return Ok(false);
        };
        self.nodes.advance(frame);
        let mut problems = self.evaluate(Some(frame));
        problems.extend(self.slide(frame));
        problems.truncate(LISTED);
        self.state += 1;
        if problems.is_empty() { Ok(true) } else { Err(Problems(problems)) }
    }

    /// Evaluates every element in a frame, or without one in the initial configuration.
    fn evaluate(&mut self, frame: Option<&Frame>) -> Vec<Problem> {
        let mut problems = Vec::new();
        for (group, state) in self.plan.groups.iter().zip(&mut self.groups) {
            let pass = if frame.is_some() { &group.recipe.state } else { &group.recipe.start };
            let loads = frame.map_or(&[][..], |frame| &frame.loads[..]);
            let failures = state.evaluate(pass, &Inputs { group, nodes: &self.nodes, loads });
            problems.extend(failures.into_iter().take(LISTED).map(|Failure { element, formula, error }| {
                let name = self.scene.elements.get_index(group.elements[element] as usize);
                let element = name.map_or_else(String::new, |(name, _)| name.to_string());
                let message = error.to_string();
                Problem { element, state: frame.map(|_| self.state), formula, error, message }
            }));
        }
        problems.truncate(LISTED);
        problems
    }

    /// The next state of the slide lines.
    fn slide(&mut self, frame: &Frame) -> Vec<Problem> {
        let last = self.state.checked_sub(1).and_then(|last| self.scene.frames.get(last));
        let duration = last.map(|last| frame.time - last.time);
        let motion = Motion { nodes: &self.nodes, duration, pressures: &frame.pressures };
        let mut problems = Vec::new();
        for contact in &mut self.contacts {
            let failures = contact.advance(&motion).err().unwrap_or_default();
            // Slide lines number the nodes by their place in the scene, from 1.
            let node = |number: u32| self.scene.nodes.get_index(number as usize - 1);
            let name = |number: u32| node(number).map_or_else(|| number.to_string(), |(name, _)| format!("{name:?}"));
            let problem = |(formula, error): (_, Error)| {
                let message = error.with_names(name);
                Problem { element: contact.name().into(), state: Some(self.state), formula, error, message }
            };
            problems.extend(failures.into_iter().map(problem));
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
            for &(output, span) in &group.recipe.outputs {
                let components: ArrayVec<T, 3> = state.output(group, place as usize, span).collect();
                visit(name, output, &components);
            }
        }
    }

    /// How many segments and corners of slide lines were looked at so far, and by which formula.
    pub fn looked_at(&self) -> impl Iterator<Item = (&'static str, usize)> {
        self.contacts.iter().map(Contact::looked_at)
    }

    /// Bytes that last from state to state: of elements, and of nodes.
    pub fn bytes(&self) -> [usize; 2] {
        let evaluated: usize = self.groups.iter().map(State::bytes).sum();
        let sliding: usize = self.contacts.iter().map(Contact::bytes).sum();
        [evaluated + sliding + size_of_val(&*self.places), self.nodes.bytes()]
    }
}

/// How many of so many items make a task: as many as are worth a thread at least, and few enough for every thread to get
/// several.
fn task(items: usize, least: usize) -> usize {
    items.div_ceil(8 * rayon::current_num_threads()).max(least)
}

/// Does a job for all items, on all cores if they are many; `job` is told where its share begins.
fn shared<T: Send>(items: &mut [T], job: impl Fn(usize, &mut [T]) + Sync) {
    let share = task(items.len(), 4096);
    if items.len() <= share {
        job(0, items);
    } else {
        items.par_chunks_mut(share).enumerate().for_each(|(index, items)| job(index * share, items));
    }
}
