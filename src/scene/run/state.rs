//! The elements of a group: what they keep, and how their formulas are evaluated, block by block.

use super::nodes::Nodes;
use crate::scene::kind::Origin;
use crate::scene::model::{Load, Scene};
use crate::scene::plan::Group;
use crate::scene::recipe::{Pass, Span};
use crate::scene::step::{Column, Failure, LANES, Lanes, Number};
use rayon::prelude::*;

/// What the elements of a group keep from state to state, their results among it.
#[derive(Debug)]
pub(super) struct State<T> {
    /// Block by block, a column per register that lasts.
    lasting: Vec<Column<T>>,
    /// The other registers of a block.
    scratch: Vec<Column<T>>,
    /// The nodes of every element, side by side.
    ends: Vec<u32>,
}

impl<T: Number> State<T> {
    /// The elements with their parameters, and zeros.
    pub(super) fn new(scene: &Scene, group: &Group) -> Self {
        let recipe = &group.recipe;
        let zeros = |columns: usize| vec![[T::zero(); LANES]; columns];
        let mut lasting = zeros(group.elements.len().div_ceil(LANES) * recipe.lasting);
        let mut ends = Vec::with_capacity(group.elements.len() * group.kind.nodes.len());
        for (place, &element) in group.elements.iter().enumerate() {
            let element = &scene.elements[element as usize];
            ends.extend_from_slice(&element.nodes);
            let (block, lane) = (place / LANES * recipe.lasting, place % LANES);
            for &(index, fallback, register) in &recipe.parameters {
                lasting[block + register][lane] = T::exactly(element.parameters[index].unwrap_or(fallback));
            }
        }
        Self { lasting, scratch: zeros(recipe.registers - recipe.lasting), ends }
    }

    /// Evaluates the formulas of a pass for every element.
    pub(super) fn evaluate(&mut self, pass: &Pass, inputs: &Inputs<'_, T>) -> Vec<Failure> {
        let lasting = T::BLOCKS * inputs.group.recipe.lasting;
        let ends = T::BLOCKS * LANES * inputs.group.kind.nodes.len();
        if self.lasting.len() <= lasting {
            return inputs.evaluate(pass, 0, &mut self.lasting, &mut self.scratch, &self.ends);
        }
        let tasks = self.lasting.par_chunks_mut(lasting).zip(self.ends.par_chunks(ends)).enumerate();
        let task = |scratch: &mut Vec<_>, (task, (lasting, ends)): (usize, (&mut [_], &[_]))| {
            inputs.evaluate(pass, task * T::BLOCKS * LANES, lasting, scratch, ends)
        };
        tasks.map_with(self.scratch.clone(), task).flatten_iter().collect()
    }

    /// The components of an output of an element.
    pub(super) fn output(&self, group: &Group, element: usize, span: Span) -> impl Iterator<Item = T> {
        let first = element / LANES * group.recipe.lasting + span.at;
        self.lasting[first..first + span.len].iter().map(move |column| column[element % LANES])
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
        scratch: &mut [Column<T>],
        ends: &[u32],
    ) -> Vec<Failure> {
        let Group { kind, elements, recipe } = self.group;
        let mut failures = Vec::new();
        let mut loads = self.loads_from(elements[first]);
        let blocks = lasting.chunks_exact_mut(recipe.lasting).zip(ends.chunks(LANES * kind.nodes.len()));
        for (first, (lasting, ends)) in (first..).step_by(LANES).zip(blocks) {
            let count = ends.len() / kind.nodes.len();
            let mut lanes = Lanes { lasting, scratch, first, count };
            for (of, before) in &pass.before {
                for k in 0..of.len {
                    *lanes.column(before.at + k) = *lanes.column(of.at + k);
                }
            }
            self.load(&elements[first..first + count], &mut loads, &mut lanes);
            self.read(pass, ends, &mut lanes);
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

    /// Takes over the loads of a block's elements.
    fn load(&self, elements: &[u32], loads: &mut &[Load], lanes: &mut Lanes<'_, T>) {
        for (lane, &element) in elements.iter().enumerate() {
            if loads.first().is_some_and(|load| load.element < element) {
                *loads = from(loads, element);
            }
            while let Some((load, rest)) = loads.split_first().filter(|(load, _)| load.element == element) {
                if let Some(register) = self.group.recipe.loads[usize::from(load.index)] {
                    lanes.column(register)[lane] = T::exactly(load.value);
                }
                *loads = rest;
            }
        }
    }

    /// Reads what a block's elements need of their nodes.
    fn read(&self, pass: &Pass, ends: &[u32], lanes: &mut Lanes<'_, T>) {
        let nodes = self.nodes;
        for &(origin, span) in &pass.reads {
            for k in 0..span.len {
                let column = lanes.column(span.at + k).iter_mut();
                let of = |node: usize| ends.iter().skip(node).step_by(self.group.kind.nodes.len()).map(|&node| node as usize);
                match origin {
                    Origin::Position(node) => column.zip(of(node)).for_each(|(x, node)| *x = nodes.positions[node][k]),
                    Origin::Increment(node) => column
                        .zip(of(node))
                        .for_each(|(dx, node)| *dx = nodes.positions[node][k] - nodes.before[node][k]),
                    Origin::Axis(node, axis) => {
                        column.zip(of(node)).for_each(|(e, node)| *e = nodes.triad(node)[axis][k]);
                    }
                    _ => {}
                }
            }
        }
    }
}

/// The loads from this element on.
fn from(loads: &[Load], element: u32) -> &[Load] {
    &loads[loads.partition_point(|load| load.element < element)..]
}
