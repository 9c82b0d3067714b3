//! From wanted outputs to the formulas they need, and to nothing else.

use super::contact::ContactPlan;
use super::kind::{Kind, When};
use super::model::{Element, Scene};
use super::recipe::{Planned, Recipe};
use std::collections::HashMap;
use std::fmt;

/// Which formulas are evaluated, for which elements, in which order.
#[derive(Debug)]
pub struct Plan {
    pub(super) groups: Vec<Group>,
    pub(super) contacts: Vec<ContactPlan>,
    /// What is evaluated on slide lines.
    contact_lines: Vec<Line>,
}

/// Elements for which the same formulas are evaluated.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) kind: &'static Kind,
    pub(super) elements: Vec<u32>,
    pub(super) recipe: Recipe,
}

/// A formula in a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The identifier of the formula.
    pub formula: &'static str,
    /// The kind of the elements.
    pub kind: &'static str,
    /// How many elements it is evaluated for.
    pub elements: usize,
    /// Whether it is evaluated once, in the initial configuration, or in every state.
    pub once: bool,
    /// What it is needed for.
    pub why: String,
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { formula, kind, elements, once, why } = self;
        let when = if *once { "at the start" } else { "every state" };
        write!(f, "{formula:<34} {elements:>9} × {kind:<10} {when:<12} {why}")
    }
}

impl Plan {
    /// The least that the scene's outputs need.
    pub fn new(scene: &Scene) -> Self {
        let mut known = HashMap::new();
        let mut groups: Vec<Group> = Vec::new();
        for (index, element) in (0..).zip(scene.elements.values()) {
            if element.outputs == 0 || element.line.is_some() {
                continue;
            }
            let group = *known.entry(Signature::of(element)).or_insert_with_key(|signature| {
                groups.push(Group { kind: element.kind, elements: Vec::new(), recipe: Recipe::new(signature) });
                groups.len() - 1
            });
            groups[group].elements.push(index);
        }
        let contacts = ContactPlan::all(scene);
        let contact_lines = contacts.iter().flat_map(|contact| contact.lines(scene)).collect();
        Self { groups, contacts, contact_lines }
    }

    /// The plan, a line a formula and group of elements, in the order of evaluation.
    pub fn lines(&self) -> Vec<Line> {
        let line = |group: &Group, planned: &Planned, once| Line {
            formula: planned.step.id(),
            kind: group.kind.name,
            elements: group.elements.len(),
            once,
            why: planned.why.clone(),
        };
        let of_group = |group: &Group| {
            let start: Vec<_> = group.recipe.start.steps.iter().map(|planned| line(group, planned, true)).collect();
            start
                .into_iter()
                .chain(group.recipe.state.steps.iter().map(|planned| line(group, planned, false)).collect::<Vec<_>>())
        };
        self.groups.iter().flat_map(of_group).chain(self.contact_lines.iter().cloned()).collect()
    }

    /// How often each formula is evaluated over this many states, in the order of evaluation.
    pub fn counts(&self, states: usize) -> Vec<(&'static str, usize)> {
        let mut counts: indexmap::IndexMap<_, usize> = indexmap::IndexMap::new();
        for line in self.lines() {
            *counts.entry(line.formula).or_default() += line.elements * if line.once { 1 } else { states };
        }
        counts.into_iter().collect()
    }
}

/// What decides which formulas an element needs.
#[derive(Clone, Copy)]
pub(super) struct Signature {
    pub(super) kind: &'static Kind,
    pub(super) outputs: u64,
    /// A bit per parameter: not 0.
    on: u64,
    /// A bit per parameter: given.
    given: u64,
}

impl Signature {
    pub(super) fn of(element: &Element) -> Self {
        let (mut on, mut given) = (0, 0);
        for (bit, (value, (_, fallback))) in element.parameters.iter().zip(element.kind.parameters()).enumerate() {
            let number = value.or(fallback.number());
            on |= u64::from(number.is_none_or(|number| number != 0.0)) << bit;
            given |= u64::from(number.is_some()) << bit;
        }
        Self { kind: element.kind, outputs: element.outputs, on: on & element.kind.switches(), given }
    }

    fn key(&self) -> (&'static str, &'static str, u64, u64, u64) {
        (self.kind.name, self.kind.dimension.name(), self.outputs, self.on, self.given)
    }

    pub(super) fn applies(&self, when: When) -> bool {
        let any = |names: &[&str]| {
            let mut parameters = self.kind.parameters().enumerate();
            parameters.any(|(bit, (name, _))| names.contains(&name) && self.on >> bit & 1 == 1)
        };
        match when {
            When::Always => true,
            When::AllZero(names) => !any(names),
            When::NotAllZero(names) => any(names),
        }
    }

    pub(super) fn gives(&self, parameter: &str) -> bool {
        self.kind.parameters().enumerate().any(|(bit, (name, _))| name == parameter && self.given >> bit & 1 == 1)
    }
}

impl PartialEq for Signature {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}
impl Eq for Signature {}
impl std::hash::Hash for Signature {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}
