//! From the requested outputs to the formulas that they need, and to no others.

mod contact;
mod line;
mod needs;
mod recipe;
mod signature;

pub(super) use contact::{ContactPlan, Output, WantedElement};
pub use line::PlanLine;
pub(super) use needs::{Needs, answerable, wanted};
pub(super) use recipe::{Parameter, Pass, Recipe};
pub(super) use signature::Signature;

use super::kind::Kind;
use super::model::{Scene, SceneElement};
use crate::contact::increments::Follow;
use crate::formula::Formula;
use indexmap::IndexMap;
use std::collections::HashMap;

/// The formulas to be evaluated, for which elements, and in which order.
#[derive(Debug)]
pub struct Plan<'s> {
    pub(super) scene: &'s Scene,
    pub(super) groups: Vec<Group>,
    pub(super) contacts: Vec<ContactPlan<'s>>,
}

/// Elements for which the same formulas are evaluated.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) kind: &'static Kind,
    pub(super) elements: Vec<u32>,
    pub(super) recipe: Recipe,
}

impl<'s> Plan<'s> {
    /// The smallest plan that provides the scene's outputs.
    pub fn new(scene: &'s Scene) -> Self {
        let mut known = HashMap::new();
        let mut groups: Vec<Group> = Vec::new();
        for (_, members, element) in scene.elements.iter() {
            if element.outputs == 0 || element.line.is_some() {
                continue;
            }
            let SceneElement { kind, outputs, .. } = *element;
            let parameters: Vec<_> = element.parameters.iter().collect();
            for (signature, alike) in Signature::of_members(kind, &parameters, outputs, members.len()) {
                let group = *known.entry(signature).or_insert_with_key(|signature| {
                    groups.push(Group { kind, elements: Vec::new(), recipe: Recipe::new(signature) });
                    groups.len() - 1
                });
                groups[group].elements.extend(alike.map(|member| members.number(member)));
            }
        }
        Self { scene, groups, contacts: ContactPlan::all(scene) }
    }

    /// The scene.
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// The plan, one line per formula and group of elements, in the order of evaluation.
    pub fn lines(&self) -> Vec<PlanLine> {
        let contacts = self.contacts.iter().flat_map(ContactPlan::lines);
        self.groups.iter().flat_map(Group::lines).chain(contacts).collect()
    }

    /// The number of evaluations of each formula over this many states, in the order of evaluation. For the search on a slide
    /// line it is the number of searches; the number of segments and corners examined is known only after a run.
    pub fn counts(&self, states: usize) -> Vec<(&'static str, usize)> {
        let mut counts: IndexMap<_, usize> = IndexMap::new();
        for line in self.lines() {
            *counts.entry(line.formula).or_default() += line.elements * if line.once { 1 } else { states };
        }
        counts.into_iter().collect()
    }
}

impl Group {
    /// Whether it follows angles over full turns.
    pub(super) fn follows(&self) -> bool {
        self.recipe.state.steps.iter().any(|planned| planned.step.spec().id == Follow::SPEC.id)
    }

    fn lines(&self) -> Vec<PlanLine> {
        let of_pass = |pass: &Pass, once| {
            let (kind, elements) = (self.kind.name, self.elements.len());
            let line = |step: &recipe::Planned| PlanLine {
                formula: step.step.spec().id,
                kind,
                elements,
                once,
                why: step.why.clone(),
            };
            pass.steps.iter().map(line).collect::<Vec<_>>()
        };
        [of_pass(&self.recipe.start, true), of_pass(&self.recipe.state, false)].concat()
    }
}
