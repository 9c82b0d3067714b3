//! Nodes, elements, sets and orientations.

use super::block::{Block, Line};
use super::field::Field;
use super::model::{Element, Item, Members, Node, Orientation, Points, Type};
use super::motion::{System, cylindrical};
use super::reading::{Reading, found};
use arrayvec::ArrayVec;

pub(super) fn heading(reading: &mut Reading, block: &Block) {
    let title = block.full(reading.sources).next();
    if let Some(title) = title.filter(|_| reading.model.title.is_empty()) {
        reading.model.title = title.text.trim().into();
    }
}

pub(super) fn node(reading: &mut Reading, block: &Block) {
    let in_cylinder = reading.word(block, "SYSTEM", &[("R", false), ("C", true)]) == Some(true);
    let set = block.label(&mut reading.log, "NSET").map(|(label, _)| (reading.scope, label.key));
    let mut members = Vec::new();
    for line in block.full(reading.sources) {
        let mut fields = line.fields();
        let Some(first) = fields.next() else { continue };
        let Some(number) = reading.identifier(first) else { continue };
        let (mut at, mut rest) = ([0.0; 3], 0);
        for (k, field) in fields.enumerate() {
            // A normal may follow the coordinates.
            let number = reading.number(field).unwrap_or(0.0);
            match at.get_mut(k) {
                Some(coordinate) => *coordinate = number,
                None if k < 6 => {}
                None => rest += 1,
            }
        }
        if rest > 0 {
            reading.fault(
                line.place,
                format!("a line of {} fields", 7 + rest),
                "a number, three coordinates, and a normal",
            );
        }
        if in_cylinder {
            at = cylindrical(at);
        }
        if let Some(motion) = &reading.motion {
            at = motion.of_point(at);
        }
        add_node(reading, number, Node { at, place: first.place });
        if set.is_some() {
            members.push(Item { scope: reading.scope, of: Members::One(number), place: first.place });
        }
    }
    if let Some(set) = set {
        reading.model.node_sets.entry(set).or_default().append(&mut members);
    }
}

pub(super) fn add_node(reading: &mut Reading, number: u32, node: Node) {
    let known = reading.model.nodes.insert((reading.scope, number), node);
    if known.is_some_and(|known| known.at != node.at) {
        let shown = reading.model.shown((reading.scope, number));
        reading.fault(node.place, format!("node {shown} for the second time, elsewhere"), "each node once");
    }
}

pub(super) fn element(reading: &mut Reading, block: &Block) {
    let Some((label, place)) = block.required(&mut reading.log, "TYPE") else { return };
    let Some(&(_, of)) = Type::ALL.iter().find(|(name, _)| *name == label.key) else {
        reading.model.others.entry(label.key.clone()).or_insert(place);
        return reading.log.leave_out(place, format!("elements of type {}", label.key), false);
    };
    let set = block.label(&mut reading.log, "ELSET").map(|(label, _)| (reading.scope, label.key));
    let mut members = Vec::new();
    let mut lines = block.full(reading.sources).peekable();
    while let Some(line) = lines.next() {
        let mut fields: Vec<Field> = line.fields().collect();
        let mut last = line;
        // A comma at the end continues a line that has too few nodes. But a connector may have one node, and a line with more than
        // another node is the next one.
        let is_more = |fields: &[Field], next: &Line| of.slides() || fields.len() + next.fields().count() <= 3;
        while fields.len() < of.nodes() + 1 && last.text.trim_end().ends_with(',') {
            let Some(next) = lines.next_if(|next| is_more(&fields, next)) else { break };
            fields.extend(next.fields());
            last = next;
        }
        let Some(number) = reading.identifier(fields[0]) else { continue };
        // The node that is not named is on the ground.
        if !of.slides() && fields.len() == 2 {
            fields.push(Field { text: "", place: line.place });
        }
        if fields.len() != of.nodes() + 1 {
            let found = format!("{} nodes", fields.len() - 1);
            let or = if of.slides() { "" } else { ", or 1 and ground" };
            reading.fault(line.place, found, format!("{} nodes{or}, for {}", of.nodes(), label.key));
            continue;
        }
        let is_ground = |field: &Field| !of.slides() && field.text.is_empty();
        let one_is_named = !fields[1..].iter().all(is_ground);
        let ground = (!reading.scope, number);
        let mut end = |field: &Field| {
            if is_ground(field) && one_is_named { Some((ground, field.place)) } else { reading.node(*field) }
        };
        let ends: Option<ArrayVec<_, 3>> = fields[1..].iter().map(&mut end).collect();
        let Some(nodes) = ends else { continue };
        let place = fields[0].place;
        add_element(reading, number, Element { of, nodes, place });
        members.push(Item { scope: reading.scope, of: Members::One(number), place });
    }
    if let Some(set) = set {
        reading.model.element_sets.entry(set).or_default().append(&mut members);
    }
}

pub(super) fn add_element(reading: &mut Reading, number: u32, element: Element) {
    let place = element.place;
    if reading.model.elements.insert((reading.scope, number), element).is_some() {
        let shown = reading.model.shown((reading.scope, number));
        reading.fault(place, format!("element {shown} for the second time"), "each element once");
    }
}

pub(super) fn node_set(reading: &mut Reading, block: &Block) {
    if let Some((label, _)) = block.required(&mut reading.log, "NSET") {
        let mut members = members(reading, block);
        reading.model.node_sets.entry((reading.scope, label.key)).or_default().append(&mut members);
    }
}

pub(super) fn element_set(reading: &mut Reading, block: &Block) {
    if let Some((label, _)) = block.required(&mut reading.log, "ELSET") {
        let mut members = members(reading, block);
        reading.model.element_sets.entry((reading.scope, label.key)).or_default().append(&mut members);
    }
}

/// The members of a set.
fn members(reading: &mut Reading, block: &Block) -> Vec<Item> {
    let instance = reading.instance(block);
    let mut members = Vec::new();
    if block.parameter("INSTANCE").is_some() && instance.is_none() {
        return members;
    }
    let scope = instance.unwrap_or(reading.scope);
    if block.parameter("GENERATE").is_some() {
        for line in block.full(reading.sources) {
            if let Some((first, last, step)) = range(reading, line) {
                members.push(Item { scope, of: Members::Range(first, last, step), place: line.place });
            }
        }
        return members;
    }
    for line in block.full(reading.sources) {
        for field in line.fields().filter(|field| !field.text.is_empty()) {
            members.extend(reading.item(field, instance));
        }
    }
    members
}

/// First, last and increment.
pub(super) fn range(reading: &mut Reading, line: Line) -> Option<(u32, u32, u32)> {
    let fields: Vec<_> = line.fields().collect();
    let (&[first, last, ref rest @ ..], true) = (&fields[..], fields.len() <= 3) else {
        reading.fault(
            line.place,
            format!("{} numbers", fields.len()),
            "the first, the last, and the increment if it is not 1",
        );
        return None;
    };
    let step = rest.first().filter(|step| !step.text.is_empty());
    let (from, to) = (reading.identifier(first), reading.identifier(last));
    let step = step.map_or(Some(1), |&step| reading.identifier(step))?;
    let (from, to) = (from?, to?);
    if from > to || !(to - from).is_multiple_of(step) {
        reading.fault(last.place, found(last.text), format!("{from} and a multiple of {step} more"));
        return None;
    }
    Some((from, to, step))
}

/// How points are given.
#[derive(Clone, Copy)]
enum Definition {
    Coordinates,
    Nodes,
    OfElements,
}

pub(super) fn orientation(reading: &mut Reading, block: &Block) {
    let Some((label, place)) = block.required(&mut reading.log, "NAME") else { return };
    let systems = [
        ("RECTANGULAR", Some(System::Rectangular)),
        ("Z RECTANGULAR", Some(System::ThirdRectangular)),
        ("CYLINDRICAL", Some(System::Cylindrical)),
        ("SPHERICAL", Some(System::Spherical)),
        ("USER", None),
    ];
    let definitions = [
        ("COORDINATES", Definition::Coordinates),
        ("NODES", Definition::Nodes),
        ("OFFSET TO NODES", Definition::OfElements),
    ];
    let system = reading.word(block, "SYSTEM", &systems);
    let (Some(system), Some(definition)) = (system, reading.word(block, "DEFINITION", &definitions)) else { return };
    let mut lines = block.full(reading.sources);
    let (first, second) = (lines.next(), lines.next());
    let points = match (system, definition, first) {
        (None, ..) | (_, Definition::OfElements, _) => None,
        (.., None) => {
            return reading.fault(
                block.place,
                "no data line",
                "a line with points a and b, and the origin if it is not 0",
            );
        }
        (_, Definition::Nodes, Some(line)) => points_by_nodes(reading, line),
        (_, Definition::Coordinates, Some(line)) => points(reading, line),
    };
    // More rotations than one.
    let points = points.filter(|_| lines.next().is_none());
    let turn = second.filter(|_| points.is_some()).and_then(|line| turn(reading, line));
    let (motion, system) = (reading.motion.clone(), system.unwrap_or(System::Rectangular));
    let of_axes = first.filter(|_| points.is_some()).map_or(place, |line| line.place);
    let orientation = Orientation { shown: label.shown, place: of_axes, system, points, turn, motion };
    if let Some(known) = reading.model.orientations.insert((reading.scope, label.key), orientation) {
        reading.fault(place, format!("orientation {:?} for the second time", known.shown), "each name once");
    }
}

fn points_by_nodes(reading: &mut Reading, line: Line) -> Option<Points> {
    let nodes: Vec<_> = line.fields().map(|field| reading.node(field)).collect();
    match nodes[..] {
        [Some(a), Some(b)] => Some(Points::Nodes([a, b], None)),
        [Some(a), Some(b), Some(c)] => Some(Points::Nodes([a, b], Some(c))),
        _ => {
            reading.fault(line.place, format!("{} nodes", nodes.len()), "2 or 3 nodes");
            None
        }
    }
}

fn points(reading: &mut Reading, line: Line) -> Option<Points> {
    // The name of a distribution.
    if line.text.trim_start().starts_with(|c: char| c.is_alphabetic() || c == '"' || c == '_') {
        return None;
    }
    let count = line.fields().count();
    if count < 4 {
        reading.fault(line.place, format!("{count} numbers"), "6 or 9: points a and b, and the origin");
    }
    let [ax, ay, az, bx, by, bz, cx, cy, cz] = reading.numbers(line.fields());
    Some(Points::Coordinates([[ax, ay, az], [bx, by, bz], [cx, cy, cz]]))
}

/// The local direction, from 0, and the angle about it.
fn turn(reading: &mut Reading, line: Line) -> Option<(usize, f64)> {
    let [axis, angle] = reading.numbers(line.fields());
    let axis = match axis {
        // The default is the first.
        0.0 | 1.0 => 0,
        2.0 => 1,
        3.0 => 2,
        _ => {
            let allowed = "the local direction 1, 2 or 3, and an angle in degrees";
            reading.fault(line.place, format!("{axis:?}"), allowed);
            return None;
        }
    };
    (angle != 0.0).then_some((axis, angle))
}
