//! From what a deck says to the text of a scene.

use super::ends::Ends;
use super::log::Log;
use super::model::{Element, Interface, Model, Numbered, Section, SlideLine, Type};
use super::plan::{Planned, planned};
use super::requests::Requested;
use super::sets::{members, sliders};
use super::source::Place;
use super::terms::{GLOBAL_IF_NONE, dimension_of};
use super::text::{ARRAY, OBJECT, Text};
use super::triads::{Triad, Triads};
use crate::scene::kind::{Dimension, Kind};
use crate::scene::plan::wanted;
use crate::scene::read::keys;
use indexmap::IndexMap;

/// A scene before it is text: its parts in order.
struct Draft<'m> {
    model: &'m Model,
    dimension: Dimension,
    /// The section, slide line and interface of each element, by its index.
    sections: Vec<Option<u32>>,
    lines: Vec<Option<u32>>,
    interfaces: Vec<Option<u32>>,
    plans: Vec<Vec<Planned>>,
    sliders: Vec<([Numbered; 3], Place)>,
    requested: Requested,
    triads: Triads,
    ends: Ends,
    /// Whether the scene has a node, by its index.
    is_used: Vec<bool>,
}

/// The text of the scene.
pub(super) fn write(model: &Model, log: &mut Log) -> Text {
    let mut text = Text::default();
    let Some(dimension) = dimension(model, log) else { return text };
    let plans: Vec<_> = model.sections.iter().map(|section| planned(model, section, dimension, log)).collect();
    let owners = |named: Vec<(u32, &str, Place)>, what, is_of: &dyn Fn(&Element) -> bool, log: &mut Log| {
        owners(model, named, what, is_of, log)
    };
    let named =
        model.sections.iter().map(|section| (section.scope, &*section.elements.0.key, section.elements.1)).collect();
    let sections = owners(named, "connector section", &|element| !element.of.slides(), log);
    let named = model.lines.iter().map(|line| (line.scope, &*line.elements.0.key, line.elements.1)).collect();
    let lines = owners(named, "slide line", &|element| element.of.slides(), log);
    let named = model.interfaces.iter().map(|of| (of.scope, &*of.elements.0.key, of.elements.1)).collect();
    let interfaces = owners(named, "interface", &|element| element.of.slides(), log);
    let (triads, ends, is_used) = (Triads::default(), Ends::default(), vec![false; model.nodes.len()]);
    let sliders = sliders(model, log);
    let is_planned = |section: u32| !plans[section as usize].is_empty();
    let has = |index: usize| lines[index].is_some() || sections[index].is_some_and(is_planned);
    let is_there = |of: &Type| model.elements.values().any(|element| element.of == *of);
    let slide = [Type::Linear, Type::Parabolic].into_iter().filter(is_there);
    let slide = slide.filter_map(|of| sliding_kind(of, dimension));
    let kinds: Vec<_> = plans.iter().flatten().map(|plan| plan.kind).chain(slide).collect();
    let requested = Requested::of(model, &kinds, &has, log);
    let mut draft =
        Draft { model, dimension, sections, lines, interfaces, plans, sliders, requested, triads, ends, is_used };
    draft.check(log);
    draft.write(&mut text, log);
    text
}

/// The dimension of the elements.
fn dimension(model: &Model, log: &mut Log) -> Option<Dimension> {
    let of = |element: &Element| match element.of {
        Type::Connector => Dimension::Space,
        Type::PlaneConnector => Dimension::Plane,
        Type::Linear | Type::Parabolic => Dimension::Axisymmetric,
    };
    let others = || model.others.keys().find_map(|other| dimension_of(other));
    let slides = model.elements.values().any(|element| element.of.slides());
    // Connectors of the plane are also those of axisymmetric models.
    let first = model.elements.values().next().map(of);
    let dimension = if slides { Some(Dimension::Axisymmetric) } else { first };
    let dimension = match dimension {
        Some(Dimension::Plane) => others().filter(|of| *of == Dimension::Axisymmetric).or(dimension),
        None => Some(others().unwrap_or(Dimension::Space)),
        _ => dimension,
    }?;
    let allowed = |element: &Element| {
        let of = of(element);
        of == dimension || of == Dimension::Plane && dimension == Dimension::Axisymmetric
    };
    if let Some(element) = model.elements.values().find(|element| !allowed(element)) {
        let name = Type::ALL.iter().find(|(_, of)| *of == element.of).map_or("", |(name, _)| name);
        log.fault(
            element.place,
            format!("an element of type {name} in a model that is {}", dimension.name()),
            "elements of one dimension",
        );
        return None;
    }
    Some(dimension)
}

/// The section, line or interface of each element, by its index; each element has at most one.
fn owners(
    model: &Model,
    named: Vec<(u32, &str, Place)>,
    what: &str,
    is_of: &dyn Fn(&Element) -> bool,
    log: &mut Log,
) -> Vec<Option<u32>> {
    let mut owners = vec![None; model.elements.len()];
    let is_known = |element| model.elements.get(&element).is_some_and(is_of);
    for (owner, (scope, key, place)) in (0..).zip(named) {
        for (element, at) in members(model, &model.element_sets, "element", (scope, key, place), log, &is_known) {
            let Some(index) = model.elements.get_index_of(&element) else { continue };
            if owners[index].replace(owner).is_some_and(|before| before != owner) {
                let found = format!("element {} in a second {what}", model.shown(element));
                log.fault(at, found, format!("one {what} for each element"));
            }
        }
    }
    owners
}

impl Draft<'_> {
    fn use_node(&mut self, node: Numbered, place: Place, log: &mut Log) -> Option<usize> {
        let index = self.model.nodes.get_index_of(&node);
        match index {
            Some(index) => self.is_used[index] = true,
            None => log.fault(place, format!("no node {}", self.model.shown(node)), "the number of a node"),
        }
        index
    }

    /// Which nodes there are, and their triads; and whether every element has what it needs.
    fn check(&mut self, log: &mut Log) {
        let model = self.model;
        for (index, element) in model.elements.values().enumerate() {
            let is_left_out = |section: u32| self.plans[section as usize].is_empty();
            if self.sections[index].is_some_and(is_left_out) {
                continue;
            }
            let nodes: Vec<_> = element.nodes.iter().map(|&(node, place)| self.use_node(node, place, log)).collect();
            if element.of.slides() {
                for (owner, keyword) in [(self.lines[index], "*SLIDE LINE"), (self.interfaces[index], "*INTERFACE")] {
                    if owner.is_none() {
                        log.fault(
                            element.place,
                            format!("an element of no {keyword}"),
                            "an element of one of its sets",
                        );
                    }
                }
                continue;
            }
            let Some(section) = self.sections[index] else {
                log.fault(element.place, "a connector of no *CONNECTOR SECTION", "an element of one of its sets");
                continue;
            };
            let [Some(a), Some(b)] = nodes[..] else { continue };
            for k in 0..self.plans[section as usize].len() {
                let kind = self.plans[section as usize][k].kind;
                self.orient(kind, &model.sections[section as usize], (index, [a, b]), log);
            }
        }
        let of_lines = model.lines.iter().flat_map(|line| line.nodes.iter().copied());
        let of_sliders = self.sliders.iter().flat_map(|&(nodes, place)| nodes.map(|node| (node, place)));
        for (node, place) in of_lines.chain(of_sliders).collect::<Vec<_>>() {
            self.use_node(node, place, log);
        }
        let planned =
            |index: usize| self.sections[index].is_none_or(|section| !self.plans[section as usize].is_empty());
        if self.sliders.is_empty() && !(0..self.model.elements.len()).any(planned) {
            let first = self.model.elements.values().next();
            let place = first.map_or(Place { file: 0, at: 0 }, |element| element.place);
            log.fault(
                place,
                "no connector that a scene can have",
                "elements CONN3D2, CONN2D2, ISL21A or ISL22A, or *MPC SLIDER",
            );
        }
    }

    /// Gives a connector the triads of its section at its nodes.
    fn orient(&mut self, kind: &Kind, section: &Section, (connector, [a, b]): (usize, [usize; 2]), log: &mut Log) {
        let is_plane = self.dimension != Dimension::Space;
        let [at_a, at_b] = &section.orientations;
        let triads = &mut self.triads;
        let triad_of_a = match at_a {
            _ if !kind.reads_triad(0) => None,
            Some((label, place)) => triads.find(self.model, a, (section.scope, label, *place), is_plane, log),
            None if GLOBAL_IF_NONE.contains(&kind.name) => Some(triads.global(section.place)),
            None => {
                let found = format!("no orientation at a, in whose axes {} measures", kind.name.to_uppercase());
                log.fault(section.place, found, "a second data line with the name of an orientation");
                None
            }
        };
        if let Some(triad) = triad_of_a {
            self.ends.give(connector, 0, a, triad);
        }
        match (at_b, triad_of_a) {
            _ if !kind.reads_triad(1) => {}
            (Some((label, place)), _) => {
                if let Some(triad) = triads.find(self.model, b, (section.scope, label, *place), is_plane, log) {
                    self.ends.give(connector, 1, b, triad);
                }
            }
            // The connection library lets it be that of a.
            (None, Some(triad)) => self.ends.inherit(connector, 1, b, triad),
            (None, None) => {}
        }
    }

    /// The name of a node in a triad that is not its own.
    fn with_triad(&self, node: Numbered, triad: usize) -> String {
        format!("{} ({})", self.model.shown(node), self.triads.list[triad].name)
    }

    fn write(&mut self, text: &mut Text, log: &mut Log) {
        text.json.push_str("{\n");
        if !self.model.title.is_empty() {
            text.json.push_str("  \"title\": ");
            text.string(&self.model.title);
            text.json.push_str(",\n");
        }
        text.json.push_str("  \"dimension\": ");
        text.string(self.dimension.name());
        if !self.triads.list.is_empty() {
            text.json.push_str(",\n  \"orientations\": ");
            text.list(OBJECT, true, &self.triads.list, |text, Triad { name, place, axes }| {
                text.from(*place).key(name);
                text.list(OBJECT, false, [axes], |text, axes| match axes {
                    Err(angle) => {
                        text.key(keys::PLANE_ORIENTATION[0]);
                        text.number(*angle);
                    }
                    Ok(axes) => {
                        text.key(keys::SPACE_ORIENTATION[0]);
                        text.list(ARRAY, false, axes, |text, axis| text.list(ARRAY, false, *axis, Text::number));
                    }
                });
            });
        }
        text.json.push_str(",\n  \"nodes\": ");
        self.write_nodes(text, log);
        if !self.model.lines.is_empty() {
            text.json.push_str(",\n  \"slide_lines\": ");
            let lines = self.model.lines.iter().enumerate();
            text.list(OBJECT, true, lines, |text, (index, line)| self.write_line(text, index, line, log));
        }
        text.json.push_str(",\n  \"elements\": ");
        let outputs = self.outputs();
        self.write_elements(text, &outputs);
        text.json.push_str(",\n  \"outputs\": ");
        text.list(ARRAY, false, outputs, Text::string);
        text.json.push_str("\n}\n");
    }

    fn write_nodes(&self, text: &mut Text, log: &mut Log) {
        let others = self.ends.others();
        let others = |index| others.get(&index).into_iter().flatten().map(|&other| Some(other));
        let used = self.model.nodes.iter().enumerate().filter(|(index, _)| self.is_used[*index]);
        let nodes = used.flat_map(|(index, node)| {
            std::iter::once(None).chain(others(index)).map(move |other| (index, node, other))
        });
        let coordinates = self.dimension.coordinates();
        let orientation = |text: &mut Text, triad: usize| {
            text.json.push_str(", ");
            text.key(keys::NODE[1]);
            text.string(&self.triads.list[triad].name);
        };
        text.list(OBJECT, true, nodes, |text, (index, (&number, node), other)| {
            let name = other.map_or_else(|| self.model.shown(number), |triad| self.with_triad(number, triad));
            text.from(node.place).key(&name);
            text.json.push_str("{ ");
            if let Some(triad) = other {
                text.key(keys::NODE[2]);
                text.string(&self.model.shown(number));
                orientation(text, triad);
                return text.json.push_str(" }");
            }
            text.key(keys::NODE[0]);
            text.list(ARRAY, false, &node.at[..coordinates], |text, coordinate| text.number(*coordinate));
            if let Some(triad) = self.ends.triad(index) {
                orientation(text, triad);
            }
            text.json.push_str(" }");
            if let Some(third) = node.at[coordinates..].iter().find(|third| **third != 0.0) {
                log.fault(node.place, format!("a third coordinate of {third:?}"), "0, in the plane");
            }
        });
    }

    fn write_line(&self, text: &mut Text, index: usize, line: &SlideLine, log: &mut Log) {
        let of = |owner: &Option<u32>| owner.is_some_and(|owner| owner as usize == index);
        let mut interfaces: Vec<u32> = Vec::new();
        for (owner, interface) in self.lines.iter().zip(&self.interfaces) {
            interfaces.extend(interface.filter(|interface| of(owner) && !interfaces.contains(interface)));
        }
        if let [_, second, ..] = interfaces[..] {
            let place = self.model.interfaces[second as usize].elements.1;
            log.fault(place, "elements of one slide line with two interfaces", "one interface for all of them");
        }
        text.from(line.elements.1).key(&line.elements.0.shown);
        let interface = interfaces.first().map(|&interface| &self.model.interfaces[interface as usize]);
        let parts: Vec<_> = keys::SLIDE_LINE.iter().filter(|key| self.has(line, interface, key)).collect();
        text.from(line.place).list(OBJECT, false, parts, |text, key| {
            text.key(key);
            self.write_part(text, line, interface, key);
        });
        if let Some(friction) = interface.and_then(|interface| interface.friction) {
            let what = "friction of the slide line: the scene needs \"k_stick\", which a deck does not give";
            log.leave_out(friction, what, true);
        }
    }

    fn has(&self, line: &SlideLine, interface: Option<&Interface>, key: &str) -> bool {
        match key {
            "type" | "nodes" => true,
            "smooth" => line.smooth.is_some(),
            "extension_zone" => line.extension.is_some(),
            "pressure" => interface.is_some_and(|interface| !interface.pressure.is_empty()),
            "torque_frequency" => self.model.torque_frequency.is_some(),
            _ => false,
        }
    }

    fn write_part(&self, text: &mut Text, line: &SlideLine, interface: Option<&Interface>, key: &str) {
        let number = |text: &mut Text, given: Option<(f64, Place)>| {
            if let Some((number, place)) = given {
                text.from(place).number(number);
            }
        };
        match key {
            "type" => text.string(if line.parabolic { "parabolic" } else { "linear" }),
            "nodes" => {
                let from = line.nodes.first().map_or(line.place, |&(_, place)| place);
                text.from(from).list(ARRAY, false, &line.nodes, |text, &(node, place)| {
                    text.from(place).string(&self.model.shown(node));
                });
            }
            "pressure" => {
                let law = interface.map(|interface| &*interface.pressure).unwrap_or_default();
                text.list(OBJECT, false, law, |text, &(key, (number, place))| {
                    text.from(place).key(key);
                    text.number(number);
                });
            }
            "torque_frequency" => {
                if let Some((frequency, place)) = self.model.torque_frequency {
                    text.from(place).json.push_str(&frequency.to_string());
                }
            }
            "extension_zone" => number(text, line.extension),
            _ => number(text, line.smooth),
        }
    }

    /// The outputs of an element of a kind, one bit per output: of those that it can have, the requested ones.
    fn outputs_of(&self, index: usize, kind: &'static Kind, mask: u64) -> u64 {
        if self.requested.is_empty() { mask } else { mask & self.requested.of_element(index, kind) }
    }

    /// The outputs of the scene: of each kind those that all its elements have.
    fn outputs(&self) -> Vec<&'static str> {
        let mut of_kinds: IndexMap<&'static str, (&'static Kind, u64)> = IndexMap::new();
        let mut note =
            |kind: &'static Kind, outputs: u64| of_kinds.entry(kind.name).or_insert((kind, outputs)).1 &= outputs;
        for (index, element) in self.model.elements.values().enumerate() {
            for plan in self.plans_of(index) {
                note(plan.kind, self.outputs_of(index, plan.kind, plan.outputs));
            }
            if let Some(kind) = sliding_kind(element.of, self.dimension) {
                note(kind, self.outputs_of(index, kind, u64::MAX));
            }
        }
        if let Some(kind) = self.sliders.first().and_then(|_| Kind::find("slider", self.dimension)) {
            note(kind, u64::MAX);
        }
        let mut outputs = Vec::new();
        for (output, _) in of_kinds.into_values().flat_map(|(kind, mask)| wanted(kind, mask)) {
            if !outputs.contains(&output) {
                outputs.push(output);
            }
        }
        outputs
    }

    /// What a connector is; nothing if it is left out.
    fn plans_of(&self, index: usize) -> &[Planned] {
        self.sections[index].map(|section| &*self.plans[section as usize]).unwrap_or_default()
    }

    /// Its own outputs, if an element of a kind has others than the scene gives it.
    fn write_outputs(&self, text: &mut Text, (index, kind, mask): (usize, &'static Kind, u64), outputs: &[&str]) {
        let own = || wanted(kind, self.outputs_of(index, kind, mask)).map(|(output, _)| output);
        let given = wanted(kind, u64::MAX).map(|(output, _)| output).filter(|output| outputs.contains(output));
        if !given.eq(own()) {
            text.json.push_str(", ");
            text.key(keys::ELEMENT[2]);
            text.list(ARRAY, false, own(), Text::string);
        }
    }

    fn write_elements(&self, text: &mut Text, outputs: &[&str]) {
        let of_deck = self.model.elements.iter().enumerate().flat_map(|(index, (&number, element))| {
            let plans = self.plans_of(index);
            let sliding = self.lines[index].and_then(|line| Some((sliding_kind(element.of, self.dimension)?, line)));
            let connectors =
                plans.iter().map(move |plan| Entry::Connector(index, number, element, plan, plans.len() > 1));
            connectors.chain(sliding.map(|(kind, line)| Entry::Sliding(index, number, element, kind, line)))
        });
        let sliders = (0..self.sliders.len()).map(Entry::Slider);
        text.list(OBJECT, true, of_deck.chain(sliders), |text, entry| self.write_element(text, &entry, outputs));
    }

    fn write_element(&self, text: &mut Text, entry: &Entry, outputs: &[&str]) {
        let named = |text: &mut Text, nodes: &[(Numbered, Place)], name: &dyn Fn(usize, Numbered) -> String| {
            text.json.push_str(", ");
            text.key(keys::ELEMENT[1]);
            text.list(ARRAY, false, nodes.iter().enumerate(), |text, (end, &(node, place))| {
                text.from(place).string(&name(end, node));
            });
        };
        let nodes = |text: &mut Text, nodes: &[_]| named(text, nodes, &|_, node| self.model.shown(node));
        match *entry {
            Entry::Connector(index, number, element, plan, is_part) => {
                let of = if is_part { format!(" {}", plan.kind.name) } else { String::new() };
                text.from(element.place).key(&(self.model.shown(number) + &of));
                let section =
                    self.sections[index].map_or(element.place, |section| self.model.sections[section as usize].place);
                text.from(section).json.push_str("{ ");
                text.key(keys::ELEMENT[0]);
                text.string(plan.kind.name);
                text.from(element.place);
                named(text, &element.nodes, &|end, node| match self.ends.other(index, end) {
                    Some(triad) => self.with_triad(node, triad),
                    None => self.model.shown(node),
                });
                for &(key, number, place) in &plan.parameters {
                    text.from(place).json.push_str(", ");
                    text.key(key);
                    text.number(number);
                }
                self.write_outputs(text, (index, plan.kind, plan.outputs), outputs);
            }
            Entry::Sliding(index, number, element, kind, line) => {
                text.from(element.place).key(&self.model.shown(number));
                text.json.push_str("{ ");
                text.key(keys::ELEMENT[0]);
                text.string(kind.name);
                nodes(text, &element.nodes);
                text.json.push_str(", ");
                text.key(keys::SLIDING_ELEMENT[3]);
                text.string(&self.model.lines[line as usize].elements.0.shown);
                self.write_outputs(text, (index, kind, u64::MAX), outputs);
            }
            Entry::Slider(index) => {
                let ([first, last, node], place) = self.sliders[index];
                let before = self.sliders[..index].iter().filter(|([.., other], _)| *other == node).count();
                let again = if before == 0 { String::new() } else { format!(" {}", before + 1) };
                text.from(place).key(&format!("slider {}{again}", self.model.shown(node)));
                text.json.push_str("{ ");
                text.key(keys::ELEMENT[0]);
                text.string("slider");
                nodes(text, &[first, last, node].map(|node| (node, place)));
            }
        }
        text.json.push_str(" }");
    }
}

/// The kind of an element that slides on a line.
fn sliding_kind(of: Type, dimension: Dimension) -> Option<&'static Kind> {
    match of {
        Type::Linear => Kind::find("isl21a", dimension),
        Type::Parabolic => Kind::find("isl22a", dimension),
        Type::Connector | Type::PlaneConnector => None,
    }
}

/// An element of the scene.
enum Entry<'m> {
    /// The index and the number, and whether it is one of several.
    Connector(usize, Numbered, &'m Element, &'m Planned, bool),
    /// The index, the number, and the slide line.
    Sliding(usize, Numbered, &'m Element, &'static Kind, u32),
    Slider(usize),
}
