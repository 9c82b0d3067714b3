//! Evaluating a plan, state after state.
//!
//! Elements are taken in blocks; each block has its own registers, and no element sees another, so the results do not
//! depend on how many threads there are. What lasts from state to state is what the plan keeps per element, the
//! results of the last state, and initial position and triad per node; displacements are read where the frame holds them.
//! Of a history in columns, one state is in memory.

mod blocks;
mod contact;
mod gather;
mod group;
mod nodes;
mod prefetch;
mod problem;
mod share;
mod states;

pub(super) use gather::{Gather, array_name};
pub use problem::{Culprit, Problem, Problems, Stopped, Unreadable};

use super::evaluate::{Failure, Number};
use super::model::{Frame, Scene};
use super::plan::Plan;
use crate::isl;
use arrayvec::ArrayVec;
use contact::{ContactRun, Increment};
use group::{GroupState, Inputs};
use indexmap::IndexMap;
use nodes::NodeStates;
use states::States;

/// Problems that are listed.
const LISTED: usize = 100;

/// A scene that is being evaluated in `T`: `f64`, or [`Octuple`](crate::Octuple) for the exact results.
#[derive(Debug)]
pub struct Run<'s, T> {
    scene: &'s Scene,
    plan: &'s Plan<'s>,
    /// How many states there were, and those to come.
    states: usize,
    frames: States<'s>,
    nodes: NodeStates<'s, T>,
    groups: Vec<GroupState<T>>,
    /// Group, and place in it, of every element of which something is wanted.
    places: Vec<Option<[u32; 2]>>,
    contacts: Vec<ContactRun<'s, T>>,
}

impl<'s, T: Number> Run<'s, T> {
    /// The initial configuration.
    ///
    /// # Errors
    /// A formula that is undefined there, and an array of the history that cannot be read.
    pub fn new(plan: &'s Plan<'s>) -> Result<Self, Stopped> {
        let scene = plan.scene;
        let frames = States::new(&scene.history)?;
        let mut places = vec![None; scene.elements.len()];
        for (group, index) in plan.groups.iter().zip(0..) {
            for (&element, place) in group.elements.iter().zip(0..) {
                places[element as usize] = Some([index, place]);
            }
        }
        let nodes = NodeStates::new(plan);
        let groups = plan.groups.iter().map(|group| GroupState::new(scene, group, &nodes)).collect();
        let contacts = plan.contacts.iter().map(ContactRun::new).collect();
        let mut run = Self { scene, plan, states: 0, frames, nodes, groups, places, contacts };
        let problems = run.evaluate(None);
        if problems.is_empty() { Ok(run) } else { Err(Problems(problems).into()) }
    }

    /// The next state; `false` if there is none.
    ///
    /// # Errors
    /// A formula that is undefined there, a result that no double can hold, and an array of the history that cannot be read.
    pub fn advance(&mut self) -> Result<bool, Stopped> {
        let Some(mut frame) = self.frames.advance()? else { return Ok(false) };
        self.nodes.advance(&mut frame);
        let mut problems = self.evaluate(Some(&frame));
        problems.extend(self.slide(&frame));
        problems.truncate(LISTED);
        self.frames.reuse(frame);
        self.states += 1;
        if problems.is_empty() { Ok(true) } else { Err(Problems(problems).into()) }
    }

    /// Evaluates every element in a frame, or without one in the initial configuration.
    fn evaluate(&mut self, frame: Option<&Frame>) -> Vec<Problem> {
        let mut problems = Vec::new();
        for (group, state) in self.plan.groups.iter().zip(&mut self.groups) {
            let failures = state.evaluate(&Inputs { group, nodes: &self.nodes, frame });
            problems.extend(failures.into_iter().take(LISTED).map(|Failure { element, formula, error }| {
                let culprit = Culprit::Element(self.scene.elements.name(group.elements[element]).to_string());
                let message = error.to_string();
                Problem { culprit, state: frame.map(|_| self.states), formula, error, message }
            }));
        }
        problems.truncate(LISTED);
        problems
    }

    /// The next state of the slide lines.
    fn slide(&mut self, frame: &Frame) -> Vec<Problem> {
        let history = &self.scene.history;
        let duration = self.states.checked_sub(1).map(|last| frame.time - history.time(last));
        let is_last = self.states + 1 == history.len();
        let increment = Increment { nodes: &self.nodes, duration, pressures: &frame.pressures, is_last };
        let (scene, state) = (self.scene, self.states);
        let mut problems = Vec::new();
        for contact in &mut self.contacts {
            if let Err(failures) = contact.advance(&increment) {
                problems.extend(
                    failures.into_iter().take(LISTED).map(|failure| slipped(scene, state, contact.name(), failure)),
                );
            }
        }
        problems
    }

    /// Results of the current state: for the first elements in the order of the file, output by output, the components;
    /// then for every slide line of which it is wanted the torque.
    pub fn for_each_result(&self, elements: usize, mut visit: impl FnMut(&str, &'static str, &[T])) {
        let names = &self.scene.elements;
        let mut name = String::new();
        for contact in &self.contacts {
            contact.for_each_result(elements, &mut |element, output, components| {
                name.clear();
                match element {
                    Some(number) => names.name(number).push_to(&mut name),
                    None => name.push_str(contact.name()),
                }
                visit(&name, output, components);
            });
        }
        let places = (0..).zip(&self.places).take(elements);
        for (number, [group, place]) in places.filter_map(|(number, place)| Some((number, place.as_ref()?))) {
            let (group, state) = (&self.plan.groups[*group as usize], &self.groups[*group as usize]);
            name.clear();
            names.name(number).push_to(&mut name);
            for &(output, span) in &group.recipe.outputs {
                let components: ArrayVec<T, 3> = state.output(group, *place as usize, span).collect();
                visit(&name, output, &components);
            }
        }
    }

    /// How often each formula was evaluated so far, in the order of evaluation. Where a slide line is searched, that is how
    /// many of its segments and corners were looked at.
    pub fn counts(&self) -> Vec<(&'static str, usize)> {
        let mut counts: IndexMap<_, usize> = IndexMap::new();
        for (group, state) in self.plan.groups.iter().zip(&self.groups) {
            state.counts(group).for_each(|(formula, times)| *counts.entry(formula).or_default() += times);
        }
        for (formula, times) in self.contacts.iter().flat_map(|contact| contact.tally().iter()) {
            *counts.entry(formula).or_default() += times;
        }
        counts.into_iter().collect()
    }

    /// Bytes that last from state to state: of elements, and of nodes with what is read of a history in columns.
    pub fn bytes(&self) -> [usize; 2] {
        let evaluated: usize = self.groups.iter().map(GroupState::bytes).sum();
        let sliding: usize = self.contacts.iter().map(ContactRun::bytes).sum();
        [evaluated + sliding + size_of_val(&*self.places), self.nodes.bytes() + self.frames.bytes()]
    }
}

/// What went wrong on a slide line, whose nodes and elements have the numbers of the scene's.
fn slipped(scene: &Scene, state: usize, line: &str, failure: isl::Failure) -> Problem {
    let isl::Failure { culprit, formula, error } = failure;
    let slide_line = line.to_owned();
    let culprit = match culprit {
        isl::Culprit::Line => Culprit::SlideLine(slide_line),
        isl::Culprit::Node(node) => Culprit::SlidingNode { slide_line, node: scene.nodes.name(node).to_string() },
        isl::Culprit::Element(element) => {
            Culprit::SlidingElement { slide_line, element: scene.elements.name(element).to_string() }
        }
    };
    let message = error.with_names(|node| format!("{:?}", scene.nodes.name(node)));
    Problem { culprit, state: Some(state), formula, error, message }
}
