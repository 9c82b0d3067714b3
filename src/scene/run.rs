//! Evaluating a plan, state after state.
//!
//! Elements are taken in blocks; each block has its own registers, and no element sees another, so the results do not
//! depend on how many threads there are. What lasts from state to state is what the plan keeps per element, the
//! results of the last state, and position and triad per node.

use super::model::{Axes, Frame, Orientation, Scene, exactly, global, turned};
use super::plan::{Group, Plan};
use super::recipe::{Planned, Recipe, Span};
use super::step::{Failure, Lanes, Number};
use crate::error::Error;
use nalgebra::Vector3;
use rayon::prelude::*;

/// Elements evaluated together: few enough for the registers to stay in the first-level cache.
const BLOCK: usize = 32;

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
}

/// Where the nodes are now.
#[derive(Debug)]
struct Nodes<T> {
    positions: Vec<Vector3<T>>,
    /// A triad per orientation, the global one first.
    orientations: Vec<Axes<T>>,
    /// Current triads, of all nodes if any element reads one.
    triads: Vec<Axes<T>>,
}

/// What a group of elements keeps, and its results, element by element.
#[derive(Debug)]
struct State<T> {
    kept: Vec<T>,
    results: Vec<T>,
    width: usize,
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
        let mut run = Self { scene, plan, state: 0, nodes, groups, places };
        run.start()?;
        Ok(run)
    }

    fn start(&mut self) -> Result<(), Problems> {
        let mut problems = Vec::new();
        for (group, state) in self.plan.groups.iter().zip(&mut self.groups) {
            let recipe = &group.recipe;
            let (scene, nodes) = (self.scene, &self.nodes);
            let failures = state.blocks(scene, group, nodes, &recipe.start, |kept, registers, _| {
                for (from, to) in recipe.initial.iter().chain(&recipe.fallbacks) {
                    kept[range(*to)].copy_from_slice(&registers[range(*from)]);
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
            let failures = state.blocks(scene, group, nodes, &recipe.steps, |kept, registers, results| {
                for (from, to) in &recipe.before {
                    kept[range(*to)].copy_from_slice(&registers[range(*from)]);
                }
                let mut at = 0;
                for (_, span) in &recipe.outputs {
                    results[at..at + span.len].copy_from_slice(&registers[range(*span)]);
                    at += span.len;
                }
            });
            problems.extend(failures.into_iter().map(|failure| problem(scene, group, Some(self.state), failure)));
        }
        self.state += 1;
        problems.truncate(LISTED);
        if problems.is_empty() { Ok(true) } else { Err(Problems(problems)) }
    }

    /// Results of the current state: for the first elements in the order of the file, output by output, the components.
    pub fn for_each_result<'r>(&'r self, elements: usize, mut visit: impl FnMut(&'s str, &'static str, &'r [T])) {
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

    /// Bytes that last from state to state: of elements, and of nodes.
    pub fn bytes(&self) -> [usize; 2] {
        let numbers: usize = self.groups.iter().map(|state| state.kept.capacity() + state.results.capacity()).sum();
        let elements = numbers * size_of::<T>() + self.places.len() * size_of::<[u32; 2]>();
        let nodes = size_of_val(&*self.nodes.positions) + size_of_val(&*self.nodes.triads);
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

impl<T: Number> Nodes<T> {
    fn new(scene: &Scene, plan: &Plan) -> Self {
        let mut orientations = vec![global()];
        orientations.extend(scene.orientations.iter().map(Orientation::axes));
        let turning = plan.groups.iter().any(|group| !group.recipe.axes.is_empty());
        let triad = |orientation: Option<u32>| orientations[orientation.map_or(0, |index| index as usize + 1)];
        let triads =
            if turning { scene.nodes.values().map(|node| triad(node.orientation)).collect() } else { Vec::new() };
        let positions = scene.nodes.values().map(|node| exactly(node.at)).collect();
        Self { positions, orientations, triads }
    }

    fn apply(&mut self, scene: &Scene, frame: &Frame) {
        for motion in &frame.motions {
            let (index, Some((_, node))) = (motion.node as usize, scene.nodes.get_index(motion.node as usize)) else {
                continue;
            };
            if let Some(u) = motion.u {
                self.positions[index] = exactly::<T>(node.at) + exactly(u);
            }
            if let (Some(ur), Some(triad)) = (motion.ur, self.triads.get_mut(index)) {
                *triad = turned(&self.orientations[node.orientation.map_or(0, |index| index as usize + 1)], ur);
            }
        }
    }
}

impl<T: Number> State<T> {
    fn new(scene: &Scene, group: &Group, nodes: &Nodes<T>) -> Self {
        let Recipe { kept, parameters, increments, outputs, .. } = &group.recipe;
        let width = outputs.iter().map(|(_, span)| span.len).sum();
        let mut state = Self {
            kept: vec![T::zero(); kept * group.elements.len()],
            results: vec![T::zero(); width * group.elements.len()],
            width,
        };
        for (kept, &element) in state.kept.chunks_exact_mut((*kept).max(1)).zip(&group.elements) {
            let Some((_, element)) = scene.elements.get_index(element as usize) else { continue };
            for (index, span) in parameters {
                let fallback = element.kind.parameters().nth(*index).and_then(|(_, fallback)| fallback.number());
                kept[span.at] = T::exactly(element.parameters[*index].or(fallback).unwrap_or(0.0));
            }
            for (node, _, before) in increments {
                let position = nodes.positions[element.nodes[*node] as usize];
                kept[range(*before)].copy_from_slice(&position.as_slice()[..before.len]);
            }
        }
        state
    }

    /// Runs steps for all elements; `finish` sees what is kept, the registers and the results of each.
    fn blocks(
        &mut self,
        scene: &Scene,
        group: &Group,
        nodes: &Nodes<T>,
        steps: &[Planned],
        finish: impl Fn(&mut [T], &[T], &mut [T]) + Sync,
    ) -> Vec<Failure> {
        let Recipe { stride, kept, .. } = group.recipe;
        if group.elements.is_empty() || (steps.is_empty() && group.recipe.outputs.is_empty()) {
            return Vec::new();
        }
        // A group that keeps nothing still needs its blocks.
        let mut nothing = vec![T::zero(); if kept == 0 { group.elements.len() } else { 0 }];
        let all_kept = if kept == 0 { &mut nothing } else { &mut self.kept };
        let width = self.width;
        let blocks = all_kept
            .par_chunks_mut(BLOCK * kept.max(1))
            .zip(self.results.par_chunks_mut(BLOCK * width))
            .zip(group.elements.par_chunks(BLOCK))
            .enumerate();
        let scratch = || (vec![T::zero(); BLOCK * stride], Vec::new());
        let block = |(registers, failures): &mut (Vec<T>, Vec<Failure>),
                     (index, ((all_kept, results), elements)): Block<'_, T>| {
            let registers = &mut registers[..elements.len() * stride];
            let lanes = registers.chunks_exact_mut(stride).zip(all_kept.chunks_exact_mut(kept.max(1)));
            for ((registers, all_kept), &element) in lanes.zip(elements) {
                registers[..kept].copy_from_slice(&all_kept[..kept]);
                gather(scene, &group.recipe, nodes, element, registers, &mut all_kept[..kept]);
            }
            for planned in steps {
                T::run(planned.step, &planned.wiring, &mut Lanes { registers, stride }, failures);
            }
            let lanes = registers.chunks_exact(stride).zip(all_kept.chunks_exact_mut(kept.max(1)));
            for ((registers, all_kept), results) in lanes.zip(results.chunks_exact_mut(width)) {
                finish(&mut all_kept[..kept], registers, results);
            }
            let found: Vec<Failure> =
                failures.drain(..).map(|f| Failure { lane: f.lane + index * BLOCK, ..f }).collect();
            found
        };
        blocks.map_init(scratch, block).flatten_iter().collect()
    }
}

type Block<'b, T> = (usize, ((&'b mut [T], &'b mut [T]), &'b [u32]));

/// Reads what an element needs of its nodes.
fn gather<T: Number>(
    scene: &Scene,
    recipe: &Recipe,
    nodes: &Nodes<T>,
    element: u32,
    registers: &mut [T],
    kept: &mut [T],
) {
    let Some((_, element)) = scene.elements.get_index(element as usize) else { return };
    let position = |node: usize| &nodes.positions[element.nodes[node] as usize];
    for &(node, span) in &recipe.positions {
        registers[range(span)].copy_from_slice(&position(node).as_slice()[..span.len]);
    }
    for &(node, axis, span) in &recipe.axes {
        let axes = &nodes.triads[element.nodes[node] as usize];
        registers[range(span)].copy_from_slice(&axes[axis].as_slice()[..span.len]);
    }
    for &(node, span, before) in &recipe.increments {
        let position = position(node);
        for k in 0..span.len {
            registers[span.at + k] = position[k] - kept[before.at + k];
            kept[before.at + k] = position[k];
        }
    }
}
