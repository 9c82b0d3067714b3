//! The elements of a group: their persistent registers, and the evaluation of their formulas, block by block.

use super::blocks::{Blocks, End};
use super::nodes::NodeStates;
use super::share::task;
use crate::element::table::{Column, Failure, LANES, Lanes, Number, Span};
use crate::scene::kind::Origin;
use crate::scene::model::{Changes, Frame, Scene};
use crate::scene::plan::{Group, Parameter, Pass};
use arrayvec::ArrayVec;
use rayon::prelude::*;
use std::collections::HashSet;
use std::ops::Range;

/// The values that the elements of a group keep from state to state, including their results.
#[derive(Debug)]
pub(super) struct GroupState<T> {
    /// Block by block, one column per persistent register.
    lasting: Vec<Column<T>>,
    /// Memory for the other registers of a block.
    passing: Vec<Column<T>>,
    /// Block by block, node by node.
    ends: Vec<End>,
    /// The number of evaluations of the initial configuration, and of states.
    starts: usize,
    states: usize,
}

impl<T: Number> GroupState<T> {
    /// The elements with their parameters, and zeros otherwise.
    pub(super) fn new(scene: &Scene, group: &Group, nodes: &NodeStates<'_, T>) -> Self {
        let recipe = &group.recipe;
        // The zeros are written explicitly: the pages of a zeroed `vec!` would be mapped one by one in the first state.
        let zeros = |columns: usize| -> Vec<_> { std::iter::repeat_n([T::zero(); LANES], columns).collect() };
        let mut lasting = zeros(group.elements.len().div_ceil(LANES) * recipe.lasting);
        let mut ends = Vec::new();
        for (block, lasting) in group.elements.chunks(LANES).zip(lasting.chunks_exact_mut(recipe.lasting)) {
            let located = block.iter().map(|&element| scene.elements.locate(element));
            let given: ArrayVec<_, LANES> =
                located.map(|(thing, member)| (&scene.elements.things()[thing], member)).collect();
            for (lane, &(element, member)) in given.iter().enumerate() {
                for &Parameter { index, fallback, register } in &recipe.parameters {
                    let number = element.parameters[index].of(member).or(fallback);
                    let number = number.expect("elements of a group have the same numbers given");
                    lasting[register][lane] = T::exactly(number);
                }
            }
            ends.extend((0..group.kind.nodes.len()).map(|node| {
                let (mut places, mut triads) = ([0; LANES], [0; LANES]);
                for (lane, &(element, member)) in given.iter().enumerate() {
                    let number = element.nodes[node].number(member);
                    (places[lane], triads[lane]) = (nodes.place(number), nodes.triad_of(number));
                }
                let is_common = triads[..block.len()].iter().all(|&triad| triad == triads[0]);
                End { places, triads, triad: is_common.then_some(triads[0]) }
            }));
        }
        Self { lasting, passing: zeros(recipe.passing), ends, starts: 0, states: 0 }
    }

    /// Evaluates the formulas of a pass for every element.
    pub(super) fn evaluate(&mut self, inputs: &Inputs<'_, T>) -> Vec<Failure> {
        let Group { kind, elements, recipe } = inputs.group;
        let pass = if inputs.frame.is_some() { &recipe.state } else { &recipe.start };
        let times = if inputs.frame.is_some() { &mut self.states } else { &mut self.starts };
        *times += 1;
        let blocks = task(elements.len().div_ceil(LANES), T::BLOCKS);
        if elements.len() <= blocks * LANES {
            return inputs.evaluate(pass, 0, &mut self.lasting, &mut self.passing, &self.ends);
        }
        let ends = self.ends.par_chunks(blocks * kind.nodes.len());
        let tasks = self.lasting.par_chunks_mut(blocks * recipe.lasting).zip(ends).enumerate();
        let evaluate = |passing: &mut Vec<_>, (task, (lasting, ends)): (usize, (&mut [_], &[_]))| {
            inputs.evaluate(pass, task * blocks * LANES, lasting, passing, ends)
        };
        tasks.map_with(self.passing.clone(), evaluate).flatten_iter().collect()
    }

    /// The number of evaluations of each formula so far.
    pub(super) fn counts(&self, group: &Group) -> impl Iterator<Item = (&'static str, usize)> {
        let elements = group.elements.len();
        let passes = [(&group.recipe.start, self.starts), (&group.recipe.state, self.states)];
        let evaluated = passes.into_iter().filter(|&(_, times)| times > 0);
        evaluated.flat_map(move |(pass, times)| {
            pass.steps.iter().map(move |planned| (planned.step.spec().id, times * elements))
        })
    }

    /// The components of an output of an element.
    pub(super) fn output(&self, group: &Group, element: usize, span: Span) -> impl Iterator<Item = T> {
        let block = &self.lasting[element / LANES * group.recipe.lasting..];
        block[span.range()].iter().map(move |column| column[element % LANES])
    }

    /// Copies the components of an output of these elements, contiguously for each element.
    pub(super) fn copy(&self, group: &Group, elements: Range<usize>, span: Span, to: &mut [f64]) {
        let mut rest = to;
        let mut element = elements.start;
        while element < elements.end {
            let lanes = element % LANES..LANES.min(element % LANES + elements.end - element);
            let block = &self.lasting[element / LANES * group.recipe.lasting..][span.range()];
            let (here, later) = rest.split_at_mut(lanes.len() * span.len);
            for (component, column) in block.iter().enumerate() {
                let numbers = here[component..].iter_mut().step_by(span.len);
                numbers.zip(&column[lanes.clone()]).for_each(|(number, value)| *number = value.rounded());
            }
            (rest, element) = (later, element + lanes.len());
        }
    }

    /// The number of bytes that persist from state to state.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.lasting) + size_of_val(&*self.ends)
    }
}

/// The inputs for the evaluation of a state.
pub(super) struct Inputs<'i, T> {
    pub(super) group: &'i Group,
    pub(super) nodes: &'i NodeStates<'i, T>,
    /// The state; `None` for the initial configuration, without loads.
    pub(super) frame: Option<&'i Frame>,
}

impl<T: Number> Inputs<'_, T> {
    /// Evaluates the elements of a task, block by block; `first` is the index of its first element in the group.
    fn evaluate(
        &self,
        pass: &Pass,
        first: usize,
        lasting: &mut [Column<T>],
        passing: &mut [Column<T>],
        ends: &[End],
    ) -> Vec<Failure> {
        let elements = &self.group.elements[first..];
        let mut failures = Vec::new();
        let mut loads = self.loads_from(elements[0]);
        let mut spread = vec![None; pass.reads.len()];
        let mut blocks = Blocks { group: self.group, nodes: self.nodes, lasting, ends };
        for (first, elements) in (first..).step_by(LANES).zip(elements.chunks(LANES)) {
            let Some((lasting, ends)) = blocks.next() else { break };
            let mut lanes = Lanes { lasting, passing, first, count: elements.len() };
            for &(of, before) in &pass.before {
                lanes.copy(of, before);
            }
            for (register, changes, place) in &mut loads {
                *place = take_over(changes, *place, elements, &mut lanes.lasting[*register]);
            }
            self.read(pass, ends, &mut lanes, &mut spread);
            for (part, planned) in pass.steps.iter().enumerate() {
                blocks.prefetch(part, pass.steps.len());
                T::run(planned.step, &planned.wiring, &mut lanes, &mut failures);
            }
        }
        // What follows from the first failure of an element has the same cause.
        let mut told = HashSet::new();
        failures.retain(|failure| told.insert(failure.element));
        failures
    }

    /// The needed loads: their registers, their changes, and the index of the first change at or after this element.
    fn loads_from(&self, element: u32) -> Vec<(usize, &Changes<f64>, usize)> {
        let changed = self.frame.into_iter().flat_map(|frame| &frame.loads);
        let loads = self.group.recipe.loads.iter().zip(changed);
        loads.filter_map(|(register, changes)| Some(((*register)?, changes, changes.place(0, element)))).collect()
    }

    /// Reads the quantities of their nodes that a block's elements need. A triad shared by all of them is kept after it was
    /// spread.
    fn read(&self, pass: &Pass, ends: &[End], lanes: &mut Lanes<'_, T>, spread: &mut [Option<u32>]) {
        let nodes = self.nodes;
        for (&(origin, span), spread) in pass.reads.iter().zip(spread) {
            match origin {
                Origin::Position(node) => lanes.fill(span, &ends[node].places, nodes.positions()),
                Origin::Increment(node) => lanes.fill(span, &ends[node].places, nodes.increments()),
                Origin::Axis(node, axis) => {
                    let End { triads, triad, .. } = &ends[node];
                    match *triad {
                        None => lanes.fill(span, triads, |triad| nodes.triad(triad)[axis]),
                        Some(triad) if *spread != Some(triad) => lanes.spread(span, nodes.triad(triad)[axis]),
                        Some(_) => {}
                    }
                    *spread = *triad;
                }
                _ => {}
            }
        }
    }
}

/// Applies the changes of these elements, starting at an index of the changes; returns the index after them.
fn take_over<T: Number>(changes: &Changes<f64>, place: usize, elements: &[u32], column: &mut [T]) -> usize {
    let all = place..place + elements.len();
    if changes.of.get(all.clone()) == Some(elements) {
        column.iter_mut().zip(&changes.to[all.clone()]).for_each(|(load, &value)| *load = T::exactly(value));
        return all.end;
    }
    let mut place = place;
    for (&element, load) in elements.iter().zip(column) {
        if changes.of.get(place).is_some_and(|&next| next < element) {
            place = changes.place(place, element);
        }
        if changes.of.get(place) == Some(&element) {
            *load = T::exactly(changes.to[place]);
            place += 1;
        }
    }
    place
}
