//! The elements of a group: what they keep, and how their formulas are evaluated, block by block.

use super::nodes::Nodes;
use super::task;
use crate::scene::kind::Origin;
use crate::scene::model::{Load, Scene};
use crate::scene::plan::Group;
use crate::scene::recipe::{Pass, Span};
use crate::scene::step::{Column, Failure, LANES, Lanes, Number, column};
use rayon::prelude::*;

/// What the elements of a group keep from state to state, their results among it.
#[derive(Debug)]
pub(super) struct State<T> {
    /// Block by block, a column per register that lasts.
    lasting: Vec<Column<T>>,
    /// Room for the other registers of a block.
    passing: Vec<Column<T>>,
    /// The nodes of every element, side by side.
    ends: Vec<u32>,
}

impl<T: Number> State<T> {
    /// The elements with their parameters, and zeros.
    pub(super) fn new(scene: &Scene, group: &Group) -> Self {
        let recipe = &group.recipe;
        // Written, where `vec!` would leave it to the first state to have the pages mapped.
        let zeros = |columns: usize| -> Vec<_> { std::iter::repeat_n(column(T::zero()), columns).collect() };
        let mut lasting = zeros(group.elements.len().div_ceil(LANES) * recipe.lasting);
        let mut ends = Vec::with_capacity(group.elements.len() * group.kind.nodes.len());
        for (place, &element) in group.elements.iter().enumerate() {
            let element = &scene.elements[element as usize];
            ends.extend_from_slice(&element.nodes);
            let (block, lane) = (place / LANES * recipe.lasting, place % LANES);
            for &(index, fallback, register) in &recipe.parameters {
                lasting[block + register].as_flattened_mut()[lane] =
                    T::exactly(element.parameters[index].unwrap_or(fallback));
            }
        }
        Self { lasting, passing: zeros(recipe.passing), ends }
    }

    /// Evaluates the formulas of a pass for every element.
    pub(super) fn evaluate(&mut self, pass: &Pass, inputs: &Inputs<'_, T>) -> Vec<Failure> {
        let Group { kind, elements, recipe } = inputs.group;
        let blocks = task(elements.len().div_ceil(LANES), T::BLOCKS);
        if elements.len() <= blocks * LANES {
            return inputs.evaluate(pass, 0, &mut self.lasting, &mut self.passing, &self.ends);
        }
        let ends = self.ends.par_chunks(blocks * LANES * kind.nodes.len());
        let tasks = self.lasting.par_chunks_mut(blocks * recipe.lasting).zip(ends).enumerate();
        let evaluate = |passing: &mut Vec<_>, (task, (lasting, ends)): (usize, (&mut [_], &[_]))| {
            inputs.evaluate(pass, task * blocks * LANES, lasting, passing, ends)
        };
        tasks.map_with(self.passing.clone(), evaluate).flatten_iter().collect()
    }

    /// The components of an output of an element.
    pub(super) fn output(&self, group: &Group, element: usize, span: Span) -> impl Iterator<Item = T> {
        let block = &self.lasting[element / LANES * group.recipe.lasting..];
        block[span.range()].iter().map(move |column| column.as_flattened()[element % LANES])
    }

    /// Bytes that last from state to state.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.lasting) + size_of_val(&*self.ends)
    }
}

/// What a state is evaluated from.
pub(super) struct Inputs<'i, T> {
    pub(super) group: &'i Group,
    pub(super) nodes: &'i Nodes<T>,
    /// What changes of the loads, in the order of the elements.
    pub(super) loads: &'i [Load],
}

impl<T: Number> Inputs<'_, T> {
    /// The elements of a task, of which the first has this place in the group, block by block.
    fn evaluate(
        &self,
        pass: &Pass,
        first: usize,
        lasting: &mut [Column<T>],
        passing: &mut [Column<T>],
        ends: &[u32],
    ) -> Vec<Failure> {
        let Group { kind, elements, recipe } = self.group;
        let mut failures = Vec::new();
        let mut loads = self.loads_from(elements[first]);
        let mut spread = vec![None; pass.reads.len()];
        let blocks = lasting.chunks_exact_mut(recipe.lasting).zip(ends.chunks(LANES * kind.nodes.len()));
        for (first, (lasting, ends)) in (first..).step_by(LANES).zip(blocks) {
            let mut lanes = Lanes { lasting, passing, first, count: ends.len() / kind.nodes.len() };
            for &(of, before) in &pass.before {
                lanes.copy(of, before);
            }
            loads = self.load(&elements[first..first + lanes.count], loads, &mut lanes);
            self.read(pass, ends, &mut lanes, &mut spread);
            for planned in &pass.steps {
                T::run(planned.step, &planned.wiring, &mut lanes, &mut failures);
            }
        }
        failures
    }

    /// The loads from this element on, if any is needed.
    fn loads_from(&self, element: u32) -> &[Load] {
        let needed = self.group.recipe.loads.iter().any(Option::is_some);
        if needed { from(self.loads, element) } else { &[] }
    }

    /// Takes over the loads of a block's elements; gives the loads after them.
    fn load<'l>(&self, elements: &[u32], mut loads: &'l [Load], lanes: &mut Lanes<'_, T>) -> &'l [Load] {
        let mut lane = 0;
        while let Some((load, rest)) = loads.split_first() {
            while elements.get(lane).is_some_and(|&element| element < load.element) {
                lane += 1;
            }
            let Some(&element) = elements.get(lane) else { break };
            if element > load.element {
                loads = from(loads, element);
                continue;
            }
            if let Some(register) = self.group.recipe.loads[usize::from(load.index)] {
                lanes.lasting[register].as_flattened_mut()[lane] = T::exactly(load.value);
            }
            loads = rest;
        }
        loads
    }

    /// Reads what a block's elements need of their nodes. A triad that all of them share stays where it was spread.
    fn read(&self, pass: &Pass, ends: &[u32], lanes: &mut Lanes<'_, T>, spread: &mut [Option<u32>]) {
        let nodes = self.nodes;
        let of = |node: usize| ends.chunks_exact(self.group.kind.nodes.len()).map(move |ends| ends[node] as usize);
        let mut common = None;
        for (&(origin, span), spread) in pass.reads.iter().zip(spread) {
            match origin {
                Origin::Position(node) => lanes.fill(span, of(node).map(|node| nodes.positions[node])),
                Origin::Increment(node) => {
                    lanes.fill(span, of(node).map(|node| nodes.positions[node] - nodes.before[node]));
                }
                Origin::Axis(node, axis) => {
                    let triad = match common {
                        Some((last, triad)) if last == node => triad,
                        _ => nodes.common_triad(of(node)),
                    };
                    common = Some((node, triad));
                    match triad {
                        None => lanes.fill(span, of(node).map(|node| nodes.triad(node)[axis])),
                        Some(triad) if *spread != Some(triad) => lanes.spread(span, nodes.shared_triad(triad)[axis]),
                        Some(_) => {}
                    }
                    *spread = triad;
                }
                _ => {}
            }
        }
    }
}

/// The loads from this element on.
fn from(loads: &[Load], element: u32) -> &[Load] {
    &loads[loads.partition_point(|load| load.element < element)..]
}
