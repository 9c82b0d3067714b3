//! Which formulas of slide lines the outputs need, node by node.

use super::Line;
use crate::scene::model::{Element, Scene};
use crate::scene::plan;
use crate::slide_line;
use std::collections::HashMap;

/// What is evaluated on a slide line.
#[derive(Debug)]
pub(in crate::scene) struct ContactPlan {
    /// The line, by its place in the scene.
    pub(super) line: usize,
    /// Every node that slides on it, once.
    pub(super) slaves: Vec<Slave>,
    /// The elements of which something is wanted, in the order of the file.
    pub(super) elements: Vec<Wanted>,
}

/// A node that slides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slave {
    /// The node, by its place in the scene.
    pub(super) node: u32,
    pub(super) needs: Needs,
}

/// What is needed beyond the separation, which is always known.
#[derive(Clone, Copy, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "four things, each needed or not")]
pub(super) struct Needs {
    pub(super) slip: bool,
    /// Motion along the normal, for damping.
    pub(super) closing: bool,
    pub(super) pressure: bool,
    pub(super) shear: bool,
}

/// An element of which something is wanted.
#[derive(Debug)]
pub(super) struct Wanted {
    /// The element, by its place in the scene.
    pub(super) element: u32,
    /// Its nodes, by their place among the slaves.
    pub(super) nodes: Vec<usize>,
    pub(super) outputs: Vec<Output>,
}

/// An output of an ISL element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Output {
    E11,
    E12,
    S11,
    S12,
    Torque,
}

impl Output {
    /// All, in the order of the outputs of the kinds.
    const ALL: [Self; 5] = [Self::E11, Self::E12, Self::S11, Self::S12, Self::Torque];

    pub(super) fn name(self) -> &'static str {
        ["E11", "E12", "S11", "S12", "T"][self as usize]
    }

    fn of(element: &Element) -> Vec<Self> {
        Self::ALL.into_iter().enumerate().filter(|(bit, _)| element.outputs >> bit & 1 == 1).map(|(_, o)| o).collect()
    }

    fn needs(self, line: &Line) -> Needs {
        let shear = self == Self::S12 && line.rubs;
        let pressure = shear || matches!(self, Self::S11 | Self::Torque);
        Needs { slip: shear || self == Self::E12, closing: pressure && line.damped, pressure, shear }
    }
}

impl Needs {
    fn and(&mut self, more: Self) {
        self.slip |= more.slip;
        self.closing |= more.closing;
        self.pressure |= more.pressure;
        self.shear |= more.shear;
    }
}

impl ContactPlan {
    /// A plan per slide line of which something is wanted.
    pub(in crate::scene) fn all(scene: &Scene) -> Vec<Self> {
        let mut plans: Vec<Self> =
            (0..scene.lines.len()).map(|line| Self { line, slaves: Vec::new(), elements: Vec::new() }).collect();
        let mut places = HashMap::new();
        for (index, element) in (0..).zip(scene.elements.values()) {
            let on_line = element.line.filter(|_| element.outputs != 0).map(|line| line as usize);
            let Some((at, (_, line))) = on_line.and_then(|at| Some((at, scene.lines.get_index(at)?))) else { continue };
            let Some(plan) = plans.get_mut(at) else { continue };
            let outputs = Output::of(element);
            let mut nodes = Vec::new();
            for &node in &element.nodes {
                let place = *places.entry((at, node)).or_insert_with(|| {
                    plan.slaves.push(Slave { node, needs: Needs::default() });
                    plan.slaves.len() - 1
                });
                for output in &outputs {
                    plan.slaves[place].needs.and(output.needs(line));
                }
                nodes.push(place);
            }
            plan.elements.push(Wanted { element: index, nodes, outputs });
        }
        plans.retain(|plan| !plan.elements.is_empty());
        plans
    }

    /// Whether something asks for the torque of the line.
    pub(super) fn torque(&self) -> bool {
        self.elements.iter().any(|element| element.outputs.contains(&Output::Torque))
    }

    /// The formula by which a foot is found, which also counts how many pieces of the line were looked at.
    pub(super) fn search(line: &Line) -> &'static str {
        match (line.path.interpolation(), line.path.smoothing()) {
            (slide_line::Interpolation::Linear, None) => "slide_line.closest_linear",
            (slide_line::Interpolation::Linear, Some(_)) => "slide_line.closest_smoothed_linear",
            (slide_line::Interpolation::Parabolic, None) => "slide_line.closest_parabolic",
            (slide_line::Interpolation::Parabolic, Some(_)) => "slide_line.closest_smoothed_parabolic",
        }
    }

    /// The plan, a line a formula.
    pub(in crate::scene) fn lines(&self, scene: &Scene) -> Vec<plan::Line> {
        let Some((_, line)) = scene.lines.get_index(self.line) else { return Vec::new() };
        let mut lines = Vec::new();
        let mut add = |formula, elements: usize, why: &str| {
            if elements > 0 {
                lines.push(plan::Line { formula, kind: "slide line", elements, once: false, why: why.into() });
            }
        };
        let nodes = |wanted: fn(&Needs) -> bool| self.slaves.iter().filter(|slave| wanted(&slave.needs)).count();
        let parabolic = line.path.interpolation() == slide_line::Interpolation::Parabolic;
        let slip = if parabolic { "slide_line.slip_increment_parabolic" } else { "slide_line.slip_increment_linear" };
        add(Self::search(line), self.slaves.len(), "the place of every node, among the near segments only");
        add(slip, nodes(|needs| needs.slip), "output E12, trial of coulomb.return_map");
        if let Some(law) = line.law() {
            add(law, nodes(|needs| needs.pressure), "outputs S11, S12 and T");
        }
        add("interaction.damping", nodes(|needs| needs.closing), "outputs S11, S12 and T");
        add("coulomb.return_map", nodes(|needs| needs.shear), "output S12");
        for (formula, nodes) in [("slide_line.torque_linear", 2), ("slide_line.torque_parabolic", 3)] {
            let wanted = |element: &&Wanted| element.nodes.len() == nodes && element.outputs.contains(&Output::Torque);
            add(formula, self.elements.iter().filter(wanted).count(), "output T");
        }
        lines
    }
}
