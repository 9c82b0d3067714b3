//! What a scene is at the start: where its elements are, which parameters they lack, and what is undefined there.

use super::kind::Kind;
use super::model::{Frame, History, Parameter, Scene, SceneElement};
use super::plan::{Needs, Signature, answerable, wanted};
use super::results::Results;
use super::run::{Culprit, Stopped};
use std::collections::HashMap;

/// Outputs that are positions, angles, lengths, areas, and distances from stops.
const GEOMETRY: [&str; 16] = [
    "X", "Y", "Z", "ALPHA", "BETA", "GAMMA", "L", "N", "AREA", "E11", "GAPMIN", "GAPMAX", "GAP1MIN", "GAP1MAX",
    "GAP3MIN", "GAP3MAX",
];

/// An element at the start, or a set of elements.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Start {
    /// Its name.
    pub element: String,
    /// Its kind.
    pub kind: &'static Kind,
    /// The number of elements.
    pub count: u32,
    /// Its nodes; those of a set are those of its first element.
    pub nodes: Vec<StartNode>,
    /// The nodes of the slide line on which it slides.
    pub line: Vec<StartNode>,
    /// Positions, angles, lengths, areas and distances from stops, by the names of outputs.
    pub geometry: Vec<(&'static str, Vec<f64>)>,
    /// Parameters that are not given, and the outputs that need them.
    pub missing: Vec<(&'static str, Vec<&'static str>)>,
    /// What is undefined at the start.
    pub problems: Vec<String>,
}

/// A node at the start.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct StartNode {
    /// Its name.
    pub name: String,
    /// Its position.
    pub at: [f64; 3],
    /// Its orientation, if it has one: three axes.
    pub axes: Option<[[f64; 3]; 3]>,
}

impl Scene {
    /// The elements at the start, in the order of the file. Where the formulas of an element are undefined, that is one of its
    /// problems, and its geometry is empty.
    ///
    /// # Errors
    /// What belongs to no element.
    pub fn start(&self) -> Result<Vec<Start>, Stopped> {
        let mut problems = vec![Vec::new(); self.elements.things().len()];
        loop {
            match Results::of(&self.still(&problems)) {
                Ok(results) => return Ok(self.described(&results, problems)),
                Err(Stopped::Problems(found)) => {
                    let mut any = false;
                    for problem in &found.0 {
                        for index in self.concerned(&problem.culprit) {
                            any = true;
                            problems[index].push(problem.to_string());
                        }
                    }
                    if !any {
                        return Err(Stopped::Problems(found));
                    }
                }
                Err(stopped) => return Err(stopped),
            }
        }
    }

    /// The scene at the start with outputs of geometry, for the elements that have no problems.
    fn still(&self, problems: &[Vec<String>]) -> Self {
        let mut still = self.clone();
        still.history = History::Frames(vec![Frame::default()]);
        let mut places = 0..;
        let elements = still.elements.each(|element| {
            let is_sound = places.next().is_some_and(|index: usize| problems[index].is_empty());
            let outputs = if is_sound { geometry(&element) } else { 0 };
            Some(SceneElement { outputs, ..element })
        });
        still.elements = elements.unwrap_or_default();
        still
    }

    /// The indices of the elements to which a problem belongs.
    fn concerned(&self, culprit: &Culprit) -> Vec<usize> {
        let on = |line: &str| {
            let line = self.lines.members(line).map(|members| members.number(0));
            let all = self.elements.things().iter().enumerate();
            all.filter(|(_, element)| element.line.is_some() && element.line == line).map(|(index, _)| index).collect()
        };
        match culprit {
            Culprit::Element(element) | Culprit::SlidingElement { element, .. } => {
                let members = self.elements.members(element);
                members.map(|members| self.elements.locate(members.number(0)).0).into_iter().collect()
            }
            Culprit::SlideLine(line) | Culprit::SlidingNode { slide_line: line, .. } => on(line),
        }
    }

    fn described(&self, results: &Results, problems: Vec<Vec<String>>) -> Vec<Start> {
        let mut known = HashMap::new();
        let mut all: Vec<_> = self
            .elements
            .iter()
            .zip(problems)
            .map(|((name, members, element), problems)| Start {
                element: name.into(),
                kind: element.kind,
                count: members.len(),
                nodes: element.nodes.iter().map(|node| self.node_at_start(node.number(0))).collect(),
                line: element.line.map_or_else(Vec::new, |line| {
                    self.lines[line].surface.line.nodes().map(|node| self.node_at_start(node)).collect()
                }),
                geometry: Vec::new(),
                missing: missing(&mut known, element),
                problems,
            })
            .collect();
        for series in &results.series {
            let member = self.elements.members(&series.element).map(|members| members.number(0));
            let Some((index, 0)) = member.map(|number| self.elements.locate(number)) else { continue };
            if let Some(values) = series.values.get(0) {
                all[index].geometry.push((series.output, values.to_vec()));
            }
        }
        all
    }

    fn node_at_start(&self, number: u32) -> StartNode {
        let axes = self.nodes[number]
            .orientation
            .map(|orientation| self.orientations[orientation].axes::<f64>().map(Into::into));
        StartNode { name: self.nodes.name(number).to_string(), at: self.at[number as usize], axes }
    }
}

/// The outputs of geometry that an element can have.
fn geometry(element: &SceneElement) -> u64 {
    let count = SceneElement::count(&element.nodes).unwrap_or(1);
    let is_geometry = |&(_, (name, _)): &(usize, (&str, &str))| GEOMETRY.contains(&name);
    let outputs = element.kind.outputs().enumerate().filter(is_geometry).fold(0, |mask, (bit, _)| mask | 1 << bit);
    outputs & answerable(element.kind, &element.parameters, count)
}

/// Parameters, and the outputs that need them.
type Missing = Vec<(&'static str, Vec<&'static str>)>;

/// The parameters that are not given to the first of these elements; found once for elements that are given the same.
fn missing(known: &mut HashMap<Signature, Missing>, element: &SceneElement) -> Missing {
    if element.kind.slides() {
        return Missing::new();
    }
    let parameters: Vec<&Parameter> = element.parameters.iter().collect();
    let of = |outputs| Signature::of_members(element.kind, &parameters, outputs, 1).swap_remove(0).0;
    let find = || {
        let mut all = Missing::new();
        for (bit, (output, _)) in wanted(element.kind, u64::MAX).enumerate() {
            let signature = of(1 << bit);
            for name in Needs::of_outputs(&signature).missing(&signature) {
                match all.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, outputs)) => outputs.push(output),
                    None => all.push((name, vec![output])),
                }
            }
        }
        all
    };
    known.entry(of(0)).or_insert_with(find).clone()
}
