//! The elements of a group: what they keep, and how their formulas are run, block by block.

use super::nodes::Nodes;
use super::range;
use crate::scene::model::Scene;
use crate::scene::plan::Group;
use crate::scene::recipe::{Planned, Recipe};
use crate::scene::step::{Failure, Lanes, Number};
use rayon::prelude::*;

/// Elements evaluated together: few enough for the registers to stay in the first-level cache.
const BLOCK: usize = 32;

/// What a group of elements keeps, and its results, element by element.
#[derive(Debug)]
pub(super) struct State<T> {
    pub(super) kept: Vec<T>,
    pub(super) results: Vec<T>,
    pub(super) width: usize,
}

impl<T: Number> State<T> {
    pub(super) fn new(scene: &Scene, group: &Group, nodes: &Nodes<T>) -> Self {
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
    pub(super) fn blocks(
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
