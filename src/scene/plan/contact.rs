//! The evaluations on slide lines that the requested outputs need.
//!
//! A node of an ISL element is searched on its line once per state, however many elements share it. Everything that follows from
//! its position is evaluated only if an output needs it: slip, pressure, shear stress, torque.

use super::line::PlanLine;
use crate::contact::coulomb::ReturnMap;
use crate::contact::isl::{IslElement, Slave, Stage, Surface, Wanted};
use crate::formula::Formula;
use crate::scene::model::{Members, Scene, SceneElement, SceneLine};
use indexmap::IndexMap;
use std::collections::HashMap;

/// The evaluations on a slide line.
#[derive(Debug)]
pub(in crate::scene) struct ContactPlan<'s> {
    /// The name of the line.
    pub(in crate::scene) name: &'s str,
    pub(in crate::scene) surface: &'s Surface,
    /// The interval in states at which the torque is output, in addition to the last state; never if it is 0.
    pub(in crate::scene) torque_frequency: u32,
    /// Every node that slides on it, once, by its number in the scene.
    pub(in crate::scene) slaves: Vec<Slave>,
    /// The elements with requested outputs, in the order of the file.
    pub(in crate::scene) elements: Vec<WantedElement>,
}

/// An element with requested outputs.
#[derive(Debug)]
pub(in crate::scene) struct WantedElement {
    /// The element and its nodes have the numbers of the scene.
    pub(in crate::scene) element: IslElement,
    /// Its nodes, by their indices among the slaves.
    pub(in crate::scene) slaves: Vec<usize>,
    pub(in crate::scene) outputs: Vec<Output>,
}

/// An output of an ISL element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scene) enum Output {
    E11,
    E12,
    S11,
    S12,
    Torque,
    Area,
    Tangent,
    Normal,
    SecondTangent,
}

impl Output {
    /// All outputs, in the order of the outputs of the kinds.
    const ALL: [Self; 9] = [
        Self::E11,
        Self::E12,
        Self::S11,
        Self::S12,
        Self::Torque,
        Self::Area,
        Self::Tangent,
        Self::Normal,
        Self::SecondTangent,
    ];

    pub(in crate::scene) fn name(self) -> &'static str {
        match self {
            Self::E11 => "E11",
            Self::E12 => "E12",
            Self::S11 => "S11",
            Self::S12 => "S12",
            Self::Torque => "T",
            Self::Area => "AREA",
            Self::Tangent => "T1",
            Self::Normal => "N",
            Self::SecondTangent => "T2",
        }
    }

    /// Whether it is an output of every node of an element.
    pub(in crate::scene) fn is_of_nodes(self) -> bool {
        self != Self::Torque
    }

    /// The number of components of an element or of each of its nodes.
    pub(in crate::scene) fn components(self) -> usize {
        if matches!(self, Self::Tangent | Self::Normal) { 2 } else { 1 }
    }

    fn of(element: &SceneElement) -> Vec<Self> {
        Self::ALL.into_iter().enumerate().filter(|(bit, _)| element.outputs >> bit & 1 == 1).map(|(_, o)| o).collect()
    }

    /// The quantities of the nodes that the output needs.
    fn wanted(self) -> Wanted {
        let (e12, s12) = (self == Self::E12, self == Self::S12);
        Wanted { e12, s11: matches!(self, Self::S11 | Self::Torque), s12 }
    }
}

impl<'s> ContactPlan<'s> {
    /// A plan for every slide line with requested outputs.
    pub(in crate::scene) fn all(scene: &'s Scene) -> Vec<Self> {
        let plan = |(name, _, line): (&'s str, _, &'s SceneLine)| Self {
            name,
            surface: &line.surface,
            torque_frequency: line.torque_frequency,
            slaves: Vec::new(),
            elements: Vec::new(),
        };
        let mut plans: Vec<Self> = scene.lines.iter().map(plan).collect();
        let mut places = HashMap::new();
        for (members, element, line) in sliding(scene) {
            let plan = &mut plans[line as usize];
            let outputs = Output::of(element);
            let wanted = outputs.iter().fold(Wanted::default(), |all, output| all.and(output.wanted()));
            let mut place = |&node: &u32| {
                let place = *places.entry((line, node)).or_insert_with(|| {
                    plan.slaves.push(Slave { node, wanted: Wanted::default() });
                    plan.slaves.len() - 1
                });
                let slave = &mut plan.slaves[place];
                slave.wanted = slave.wanted.and(wanted);
                place
            };
            for member in 0..members.len() {
                let element = isl_element(members.number(member), &element.nodes_of(member));
                let slaves = element.nodes().iter().map(&mut place).collect();
                plan.elements.push(WantedElement { element, slaves, outputs: outputs.clone() });
            }
        }
        plans.retain(|plan| !plan.elements.is_empty());
        plans
    }

    /// Whether the torque of the line is requested.
    pub(in crate::scene) fn torque(&self) -> bool {
        self.elements.iter().any(|element| element.wants(Output::Torque))
    }

    /// The plan, one line per formula.
    pub(in crate::scene) fn lines(&self) -> Vec<PlanLine> {
        let mut stages: IndexMap<_, usize> = IndexMap::new();
        for slave in &self.slaves {
            for (stage, formula) in self.surface.formulas(slave.wanted) {
                *stages.entry((stage, formula)).or_default() += 1;
            }
        }
        stages.sort_unstable_keys();
        let mut of_elements: IndexMap<_, usize> = IndexMap::new();
        for wanted in &self.elements {
            let element = &wanted.element;
            if wanted.wants(Output::Torque) {
                *of_elements.entry((element.torque_formula(), "output T")).or_default() += 1;
            }
            if wanted.wants(Output::Area) {
                *of_elements.entry((element.area_formula(), "output AREA")).or_default() += 1;
            }
        }
        of_elements.sort_unstable_keys();
        let line = |kind, formula, elements, why| PlanLine { formula, kind, elements, once: false, why };
        let of_nodes =
            stages.into_iter().map(|((stage, formula), nodes)| line("slave node", formula, nodes, why(stage)));
        of_nodes
            .chain(
                of_elements
                    .into_iter()
                    .map(|((formula, why), elements)| line("element", formula, elements, why.into())),
            )
            .collect()
    }
}

/// The sliding elements with requested outputs, with the indices of their lines.
fn sliding(scene: &Scene) -> impl Iterator<Item = (Members, &SceneElement, u32)> {
    let wanted = scene.elements.iter().filter(|(_, _, element)| element.outputs != 0);
    wanted.filter_map(|(_, members, element)| Some((members, element, element.line?)))
}

/// An element on its line.
fn isl_element(number: u32, nodes: &[u32]) -> IslElement {
    let element = match *nodes {
        [a, b] => IslElement::isl21a(number, [a, b]),
        [a, b, c] => IslElement::isl22a(number, [a, b, c]),
        _ => unreachable!("the kinds that slide have two or three nodes"),
    };
    element.expect("no element that has a node twice gets here")
}

impl WantedElement {
    /// Whether an output of the element is requested.
    pub(in crate::scene) fn wants(&self, output: Output) -> bool {
        self.outputs.contains(&output)
    }
}

fn why(stage: Stage) -> String {
    match stage {
        Stage::Search => "the closest point of every node, on the near segments only".into(),
        Stage::Slip => format!("output E12, trial of {}", ReturnMap::SPEC.id),
        Stage::Law | Stage::Damping => "outputs S11, S12 and T".into(),
        Stage::Friction => "output S12".into(),
    }
}
