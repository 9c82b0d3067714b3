//! The elements of a group: what they keep, and how their formulas are run, block by block.

use super::nodes::Nodes;
use super::range;
use crate::scene::model::Scene;
use crate::scene::plan::Group;
use crate::scene::recipe::{Planned, Recipe};
use crate::scene::step::{Failure, LANES, Lanes, Number};
use rayon::prelude::*;

/// What a group of elements keeps, and its results, element by element.
#[derive(Debug)]
pub(super) struct State<T> {
    pub(super) kept: Vec<T>,
    pub(super) results: Vec<T>,
    pub(super) width: usize,
    /// The nodes of every element, side by side.
    pub(super) ends: Vec<u32>,
}

impl<T: Number> State<T> {
    pub(super) fn new(scene: &Scene, group: &Group, nodes: &Nodes<T>) -> Self {
        let Recipe { kept, parameters, increments, outputs, .. } = &group.recipe;
        let width = outputs.iter().map(|(_, span)| span.len).sum();
        let ends = |&element: &u32| scene.elements.get_index(element as usize).map_or(&[][..], |(_, of)| &of.nodes);
        let mut state = Self {
            ends: group.elements.iter().flat_map(ends).copied().collect(),
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

    /// Runs steps for all elements; `finish` sees what each keeps, its lane of the registers, and its results.
    pub(super) fn blocks(
        &mut self,
        group: &Group,
        nodes: &Nodes<T>,
        steps: &[Planned],
        finish: impl Fn(&mut [T], &Lanes<'_, T>, usize, &mut [T]) + Sync,
    ) -> Vec<Failure> {
        let Recipe { stride, kept, .. } = group.recipe;
        if group.elements.is_empty() || (steps.is_empty() && group.recipe.outputs.is_empty()) {
            return Vec::new();
        }
        // A group that keeps nothing still needs its blocks.
        let mut nothing = vec![T::zero(); if kept == 0 { group.elements.len() } else { 0 }];
        let all_kept = if kept == 0 { &mut nothing } else { &mut self.kept };
        let (width, ends) = (self.width, group.kind.nodes.len());
        let blocks = all_kept
            .par_chunks_mut(LANES * kept.max(1))
            .zip(self.results.par_chunks_mut(LANES * width))
            .zip(self.ends.par_chunks(LANES * ends))
            .enumerate();
        let scratch = || (vec![T::zero(); LANES * stride], Vec::new());
        let block = |(registers, failures): &mut (Vec<T>, Vec<Failure>),
                     (index, ((all_kept, results), all_ends)): Block<'_, T>| {
            let mut lanes = Lanes { registers, count: all_ends.len() / ends };
            let all = all_kept.chunks_exact_mut(kept.max(1)).zip(all_ends.chunks_exact(ends));
            for (lane, (all_kept, ends)) in all.enumerate() {
                lanes.put(lane, 0, &all_kept[..kept]);
                gather(&group.recipe, nodes, ends, (lane, &mut lanes), &mut all_kept[..kept]);
            }
            for planned in steps {
                T::run(planned.step, &planned.wiring, &mut lanes, failures);
            }
            let all = all_kept.chunks_exact_mut(kept.max(1)).zip(results.chunks_exact_mut(width));
            for (lane, (all_kept, results)) in all.enumerate() {
                finish(&mut all_kept[..kept], &lanes, lane, results);
            }
            let found: Vec<Failure> =
                failures.drain(..).map(|f| Failure { lane: f.lane + index * LANES, ..f }).collect();
            found
        };
        blocks.map_init(scratch, block).flatten_iter().collect()
    }
}

type Block<'b, T> = (usize, ((&'b mut [T], &'b mut [T]), &'b [u32]));

/// Reads what an element needs of its nodes.
fn gather<T: Number>(
    recipe: &Recipe,
    nodes: &Nodes<T>,
    ends: &[u32],
    (lane, lanes): (usize, &mut Lanes<'_, T>),
    kept: &mut [T],
) {
    let position = |node: usize| &nodes.positions[ends[node] as usize];
    for &(node, span) in &recipe.positions {
        lanes.put(lane, span.at, &position(node).as_slice()[..span.len]);
    }
    for &(node, axis, span) in &recipe.axes {
        let axes = &nodes.triads[ends[node] as usize];
        lanes.put(lane, span.at, &axes[axis].as_slice()[..span.len]);
    }
    for &(node, span, before) in &recipe.increments {
        let position = position(node);
        for k in 0..span.len {
            lanes.put(lane, span.at + k, &[position[k] - kept[before.at + k]]);
            kept[before.at + k] = position[k];
        }
    }
}
