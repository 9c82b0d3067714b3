//! Evaluation of a plan, state after state.
//!
//! Elements are evaluated in blocks; each block has its own registers, and elements are independent of each other, so the results
//! do not depend on the number of threads. The data that persist from state to state are those that the plan keeps per element,
//! the results of the last state, and the initial position and triad of each node; displacements are read from the frame. For a
//! history in columns, one state is in memory.

mod blocks;
mod contact;
mod cross;
mod gather;
mod group;
mod nodes;
mod problem;
mod share;
mod states;
mod warning;
mod way;

pub(super) use gather::{Gather, array_name};
pub use problem::{Culprit, Problem, Problems, Stopped, Unreadable};
pub use warning::Warning;

use super::model::{Frame, Scene};
use super::plan::{Group, Plan};
use crate::contact::isl;
use crate::element::table::{Failure, Number};
use crate::formula::error::Error;
use arrayvec::ArrayVec;
use contact::{Astray, ContactRun, Increment};
use cross::Crosses;
use group::{GroupState, Inputs};
use indexmap::IndexMap;
use nodes::NodeStates;
use states::States;
use std::borrow::Cow;

/// The maximum number of problems or warnings that are listed.
const LISTED: usize = 100;

/// A scene being evaluated in `T`: `f64`, or [`Octuple`](crate::Octuple) for the exact results.
#[derive(Debug)]
pub struct Run<'s, T> {
    scene: &'s Scene,
    plan: &'s Plan<'s>,
    /// The number of states so far, and the remaining ones.
    states: usize,
    frames: States<'s>,
    nodes: NodeStates<'s, T>,
    groups: Vec<GroupState<T>>,
    crosses: Vec<Crosses>,
    /// The group, and the index in it, of every element with requested outputs.
    places: Vec<Option<[u32; 2]>>,
    contacts: Vec<ContactRun<'s, T>>,
    warnings: Vec<Warning>,
}

impl<'s, T: Number> Run<'s, T> {
    /// Evaluates the initial configuration.
    ///
    /// # Errors
    /// A formula that is undefined there, or an array of the history that cannot be read.
    pub fn new(plan: &'s Plan<'s>) -> Result<Self, Stopped> {
        let scene = plan.scene;
        let frames = States::new(scene)?;
        let mut places = vec![None; scene.elements.len()];
        for (group, index) in plan.groups.iter().zip(0..) {
            for (&element, place) in group.elements.iter().zip(0..) {
                places[element as usize] = Some([index, place]);
            }
        }
        let nodes = NodeStates::new(plan);
        let groups = plan.groups.iter().map(|group| GroupState::new(scene, group, &nodes)).collect();
        let crosses = plan.groups.iter().map(|group| Crosses::new(scene, group, &nodes)).collect();
        let contacts = plan.contacts.iter().map(ContactRun::new).collect();
        let warnings = Vec::new();
        let mut run = Self { scene, plan, states: 0, frames, nodes, groups, crosses, places, contacts, warnings };
        let problems = run.evaluate(None, |_| true);
        if problems.is_empty() { Ok(run) } else { Err(Problems(problems).into()) }
    }

    /// Advances to the next state; `false` if there is none.
    ///
    /// # Errors
    /// A formula that is undefined there, a result that a double cannot represent, or an array of the history that cannot be
    /// read.
    pub fn advance(&mut self) -> Result<bool, Stopped> {
        let Some(mut frame) = self.frames.advance()? else { return Ok(false) };
        let mut problems = self.turn(&frame);
        self.nodes.advance(&mut frame);
        problems.extend(self.evaluate(Some(&frame), |_| true));
        problems.extend(self.slide(&frame));
        problems.truncate(LISTED);
        self.frames.reuse(frame);
        self.states += 1;
        if problems.is_empty() { Ok(true) } else { Err(Problems(problems).into()) }
    }

    /// Turns the nodes by large angles in parts, so that angles are followed. What turns along no known axis is warned of.
    fn turn(&mut self, frame: &Frame) -> Vec<Problem> {
        let Some((way, unknown)) = self.nodes.way(frame) else { return Vec::new() };
        let (state, scene) = (self.states, self.scene);
        let warning = |(node, angle)| Warning::UnknownWay { state, node: scene.nodes.name(node).to_string(), angle };
        warn(&mut self.warnings, unknown.into_iter().map(warning));
        if way.parts == 1 {
            return Vec::new();
        }
        let mut between: Cow<'s, Frame> = Cow::Owned(way.between());
        for part in 1..way.parts {
            way.turn(part, between.to_mut());
            self.nodes.advance(&mut between);
            let problems = self.evaluate(Some(&between), Group::follows);
            if !problems.is_empty() {
                return problems;
            }
        }
        Vec::new()
    }

    /// What was ambiguous so far: at most a hundred warnings.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Evaluates the elements of these groups in a frame, or in the initial configuration if there is none.
    fn evaluate(&mut self, frame: Option<&Frame>, wanted: impl Fn(&Group) -> bool) -> Vec<Problem> {
        let mut problems = Vec::new();
        let (scene, state) = (self.scene, frame.map(|_| self.states));
        let groups = self.plan.groups.iter().zip(&mut self.groups).zip(&mut self.crosses);
        for ((group, evaluated), crosses) in groups.filter(|((group, _), _)| wanted(group)) {
            let parallel = crosses.advance(scene, group, &self.nodes).into_iter();
            let warning = |element: usize| {
                let [a, b] = [0, 1].map(|end| name_of_end(scene, group.elements[element], end));
                let element = scene.elements.name(group.elements[element]).to_string();
                Warning::ParallelArms { state: self.states, element, nodes: [a, b] }
            };
            warn(&mut self.warnings, parallel.map(warning));
            let failures = evaluated.evaluate(&Inputs { group, nodes: &self.nodes, frame });
            problems.extend(failures.into_iter().take(LISTED).map(|Failure { element, formula, error }| {
                let element = group.elements[element];
                let culprit = Culprit::Element(scene.elements.name(element).to_string());
                let message = match error {
                    Error::IllConditioned { .. } | Error::GimbalLock { .. } => {
                        let [a, b] = [0, 1].map(|end| name_of_end(scene, element, end));
                        format!("node {b:?} against node {a:?}: {error}")
                    }
                    _ => error.to_string(),
                };
                Problem { culprit, state, formula, error, message }
            }));
        }
        problems.truncate(LISTED);
        problems
    }

    /// Advances the slide lines to the next state.
    fn slide(&mut self, frame: &Frame) -> Vec<Problem> {
        let history = &self.scene.history;
        // Where a step ends and the next begins there are two states at one time, and no velocities between them.
        let duration =
            self.states.checked_sub(1).map(|last| frame.time - history.time(last)).filter(|time| *time > 0.0);
        let is_last = self.states + 1 == history.len();
        let increment = Increment { nodes: &self.nodes, duration, pressures: &frame.pressures, is_last };
        let (scene, state) = (self.scene, self.states);
        let mut problems = Vec::new();
        for contact in &mut self.contacts {
            match contact.advance(&increment) {
                Ok(astray) => warn(
                    &mut self.warnings,
                    astray.into_iter().map(|Astray { node, overclosure, segment }| {
                        let [slide_line, node] = [contact.name().to_owned(), scene.nodes.name(node).to_string()];
                        Warning::WrongSide { state, slide_line, node, overclosure, segment }
                    }),
                ),
                Err(failures) => problems.extend(
                    failures.into_iter().take(LISTED).map(|failure| problem_of(scene, state, contact.name(), failure)),
                ),
            }
        }
        problems
    }

    /// Results of the current state: the components of each output of the first elements in the order of the file; then the
    /// torque of every slide line for which it is requested.
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

    /// The number of evaluations of each formula so far, in the order of evaluation. For the search on a slide line it is the
    /// number of segments and corners examined.
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

    /// The number of bytes that persist from state to state: for elements, and for nodes including the data read of a history in
    /// columns.
    pub fn bytes(&self) -> [usize; 2] {
        let evaluated: usize = self.groups.iter().map(GroupState::bytes).sum();
        let crossed: usize = self.crosses.iter().map(Crosses::bytes).sum();
        let sliding: usize = self.contacts.iter().map(ContactRun::bytes).sum();
        [evaluated + crossed + sliding + size_of_val(&*self.places), self.nodes.bytes() + self.frames.bytes()]
    }
}

/// Adds warnings as long as there is room.
fn warn(warnings: &mut Vec<Warning>, more: impl Iterator<Item = Warning>) {
    let room = LISTED.saturating_sub(warnings.len());
    warnings.extend(more.take(room));
}

/// The name of a node of an element, by its index in the element's list.
fn name_of_end(scene: &Scene, element: u32, end: usize) -> String {
    let (thing, member) = scene.elements.locate(element);
    scene.nodes.name(scene.elements.things()[thing].nodes[end].number(member)).to_string()
}

/// The problem of a failure on a slide line, whose nodes and elements have the numbers of the scene.
fn problem_of(scene: &Scene, state: usize, line: &str, failure: isl::Failure) -> Problem {
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

#[cfg(test)]
mod tests {
    use super::blocks::End;
    use super::*;
    use crate::element::table::{Column, LANES};
    use crate::scene::npz::{PIECE, Writer};
    use std::fs::File;

    /// The number of bytes of the elements of a scene's only group.
    fn of_elements(plan: &Plan<'_>) -> usize {
        let [group] = &plan.groups[..] else { unreachable!("the elements are alike") };
        let (elements, blocks) = (group.elements.len(), group.elements.len().div_ceil(LANES));
        let block = group.recipe.lasting * size_of::<Column<f64>>() + group.kind.nodes.len() * size_of::<End>();
        blocks * block + elements * size_of::<Option<[u32; 2]>>()
    }

    const VECTOR: usize = size_of::<[f64; 3]>();
    const TRIAD: usize = 3 * VECTOR;

    #[test]
    fn bytes_are_those_of_all_that_lasts() {
        let scene = Scene::parse(
            r#"{"dimension": "3d", "orientations": {"o": {"rotation": [0, 0, 0]}},
            "nodes": {"a": {"at": [0, 0, 0], "orientation": "o"}, "b": {"at": [1, 0, 0]}, "c": {"at": [2, 0, 0]}},
            "elements": {"e": {"kind": "slot", "nodes": ["a", "b"]}, "f": {"kind": "slot", "nodes": ["a", "c"]}},
            "frames": [{"time": 0, "nodes": {"b": {"u": [1, 0, 0]}, "a": {"ur": [0, 0, 1]}}}], "outputs": ["U1"]}"#,
        );
        let scene = scene.unwrap();
        let plan = Plan::new(&scene);
        let mut run = Run::<f64>::new(&plan).unwrap();
        // Their indices, positions and triad numbers; for the one that moves, its displacement; for the one that rotates, its
        // triad, in addition to the global one and that of the orientation.
        let nodes = 3 * (4 + VECTOR + 4) + (4 + VECTOR) + (8 + TRIAD) + 2 * TRIAD;
        assert_eq!(run.bytes(), [of_elements(&plan), nodes]);
        assert!(run.advance().unwrap());
        // The frame contains the displacements.
        assert_eq!(run.bytes(), [of_elements(&plan), nodes - VECTOR]);
    }

    #[test]
    fn increments_need_the_displacements_before() {
        let scene = Scene::parse(
            r#"{"dimension": "3d", "nodes": {"a": {"at": [0, 0, 0]}, "b": {"at": [1, 0, 0]}, "m": {"at": [0.5, 0, 0]}},
            "elements": {"e": {"kind": "slider", "nodes": ["a", "b", "m"]}},
            "frames": [{"time": 0, "nodes": {"b": {"u": [1, 0, 0]}, "m": {"u": [1, 0, 0]}}}], "outputs": ["DXMI"]}"#,
        );
        let scene = scene.unwrap();
        let plan = Plan::new(&scene);
        let run = Run::<f64>::new(&plan).unwrap();
        let nodes = 3 * (4 + VECTOR) + 2 * (4 + 2 * VECTOR) + TRIAD;
        assert_eq!(run.bytes(), [of_elements(&plan), nodes]);
    }

    /// With more members than are read at once, in the plane, where an array has two components of three.
    #[test]
    fn columns_are_read_piece_by_piece() {
        for count in [3, PIECE + 10] {
            let folder = tempfile::tempdir().unwrap();
            let mut arrays = Writer::new(File::create(folder.path().join("arrays.npz")).unwrap());
            let numbers = |of: fn(f64) -> [f64; 2]| -> Vec<f64> {
                (0..u32::try_from(count).unwrap()).flat_map(|k| of(f64::from(k))).collect()
            };
            arrays.write("b", &[count, 2], &numbers(|k| [k / 4.0, 1.0])).unwrap();
            arrays.write("time", &[1], &[0.5]).unwrap();
            let u = numbers(|k| [k / 8.0, -k]);
            arrays.write("u", &[1, count, 2], &u).unwrap();
            arrays.write("f", &[1, count], &u[..count]).unwrap();
            arrays.finish().unwrap();
            let scene = Scene::parse_in(
                folder.path(),
                r#"{"dimension": "2d", "columns": "arrays.npz", "orientations": {"o": {"angle": 0}},
                "nodes": {"a": {"at": [0, 0], "orientation": "o"}, "b": {"at": "b"}},
                "elements": {"e": {"kind": "slot", "nodes": ["a", "b"]}}, "outputs": ["Y", "U1", "RF"],
                "frames": {"time": "time", "nodes": {"b": {"u": "u"}}, "loads": {"e": {"f2": "f"}}}}"#,
            );
            let scene = scene.unwrap_or_else(|faults| panic!("{faults}"));
            let plan = Plan::new(&scene);
            let mut run = Run::<f64>::new(&plan).unwrap();
            let nodes = (count + 1) * (4 + VECTOR + 4) + count * (4 + VECTOR) + 2 * TRIAD;
            let next_state = count * (VECTOR + size_of::<f64>());
            let pieces = ((2 * count).min(PIECE) + count.min(PIECE)) * size_of::<f64>();
            assert_eq!(run.bytes(), [of_elements(&plan), nodes + next_state + pieces]);
            assert!(run.advance().unwrap());
            assert_eq!(run.bytes(), [of_elements(&plan), nodes + next_state + pieces]);
            let mut found = [Vec::new(), Vec::new(), Vec::new()];
            run.for_each_result(usize::MAX, |_, output, components| {
                let (index, component) = match output {
                    "Y" => (0, 0),
                    "U1" => (1, 0),
                    _ => (2, 1),
                };
                found[index].push(components[component]);
            });
            assert_eq!(found[0], numbers(|k| [1.0 - k, 0.0]).chunks(2).map(|y| y[0]).collect::<Vec<_>>());
            assert_eq!(found[1], u.chunks(2).map(|u| u[0]).collect::<Vec<_>>());
            assert_eq!(found[2], u[..count]);
            assert!(!run.advance().unwrap());
        }
    }
}
