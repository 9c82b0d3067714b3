//! Slide lines, interfaces, friction, and the constraint SLIDER.

use super::block::{Block, Line};
use super::field::without_blanks;
use super::mesh::range;
use super::model::{Interface, SlideLine};
use super::reading::{Context, Reading, found};

pub(super) fn slide_line(reading: &mut Reading, block: &Block) {
    let Some(elements) = block.required(&mut reading.log, "ELSET") else { return };
    if block.parameter("TYPE").is_none() {
        return reading.fault(block.place, "no TYPE", "TYPE=LINEAR or PARABOLIC");
    }
    let Some(parabolic) = reading.word(block, "TYPE", &[("LINEAR", false), ("PARABOLIC", true)]) else { return };
    let (smooth, extension) = (reading.value(block, "SMOOTH"), reading.value(block, "EXTENSIONZONE"));
    let mut nodes = Vec::new();
    let generate = block.parameter("GENERATE").is_some();
    for line in block.full(reading.sources) {
        if !generate {
            for field in line.fields().filter(|field| !field.text.is_empty()) {
                nodes.extend(reading.node(field));
            }
        } else if let Some((first, last, step)) = range(reading, line) {
            for number in (first..=last).step_by(step as usize) {
                let node = (reading.scope, number);
                nodes.push((node, line.place));
                // A wrong end may count billions.
                if !reading.model.nodes.contains_key(&node) {
                    break;
                }
            }
        }
    }
    let (scope, place) = (reading.scope, block.place);
    reading.model.lines.push(SlideLine { scope, elements, place, parabolic, nodes, smooth, extension });
}

pub(super) fn interface(reading: &mut Reading, block: &Block) {
    let Some(elements) = block.required(&mut reading.log, "ELSET") else { return };
    let scope = reading.scope;
    reading.model.interfaces.push(Interface { scope, elements, pressure: Vec::new(), friction: None });
    reading.context = Context::Interface(reading.model.interfaces.len() - 1);
}

/// The laws of pressure.
#[derive(Clone, Copy)]
enum Law {
    Hard,
    Linear,
    Exponential,
}

pub(super) fn surface_behavior(reading: &mut Reading, block: &Block) {
    let Context::Interface(interface) = reading.context else {
        return reading.log.leave_out(block.place, "the behavior of surfaces", false);
    };
    let laws = [("HARD", Law::Hard), ("LINEAR", Law::Linear), ("EXPONENTIAL", Law::Exponential)];
    let law = reading.word(block, "PRESSURE-OVERCLOSURE", &laws);
    let keys: &[&str] = match law {
        Some(Law::Linear) => &["k"],
        Some(Law::Exponential) => &["c0", "p0"],
        Some(Law::Hard) | None => &[],
    };
    let line = block.lines(reading.sources).next();
    let mut fields = line.into_iter().flat_map(Line::fields);
    for key in keys {
        let number = fields.next().and_then(|field| Some((reading.number(field)?, field.place)));
        if let Some(number) = number {
            reading.model.interfaces[interface].pressure.push((key, number));
        } else {
            let place = line.map_or(block.place, |line| line.place);
            reading.fault(place, format!("no {key}"), format!("{} of the law", keys.join(" and ")));
        }
    }
}

pub(super) fn friction(reading: &mut Reading, block: &Block) {
    match reading.context {
        Context::Nothing => reading.log.leave_out(block.place, "the friction of surfaces", false),
        Context::Interface(interface) => reading.model.interfaces[interface].friction = Some(block.place),
        Context::Behavior(index) => of_connector(reading, block, index),
    }
}

fn of_connector(reading: &mut Reading, block: &Block, index: usize) {
    let mut lines = block.full(reading.sources);
    let Some(line) = lines.next() else {
        return reading.fault(block.place, "no data line", "a line with the friction coefficient");
    };
    let mut fields = line.fields();
    let first = fields.next();
    let mu = first.and_then(|field| Some((reading.number(field)?, field.place)));
    if mu.is_none() && first.is_some_and(|field| field.text.is_empty()) {
        reading.fault(line.place, "a blank field", "the friction coefficient");
    }
    for field in fields.filter(|field| !field.text.is_empty()) {
        reading.log.leave_out(field.place, format!("{} after the friction coefficient", found(field.text)), true);
    }
    if let Some(line) = lines.next() {
        reading.log.leave_out(line.place, "a friction coefficient that is a table", true);
    }
    let behavior = reading.model.behaviors.get_index_mut(index).map(|(_, behavior)| behavior);
    match behavior.and_then(|behavior| behavior.frictions.last_mut()) {
        None => reading.fault(block.place, "friction of no *CONNECTOR FRICTION", "one below *CONNECTOR FRICTION"),
        Some(friction) => friction.mu = mu,
    }
}

pub(super) fn torque_print(reading: &mut Reading, block: &Block) {
    let Some(parameter) = block.parameter("FREQUENCY") else {
        reading.model.torque_frequency = Some((1, block.place));
        return;
    };
    let (text, place) = (parameter.value.as_deref().unwrap_or_default(), parameter.place);
    match text.parse() {
        Ok(frequency) => reading.model.torque_frequency = Some((frequency, place)),
        Err(_) => reading.fault(place, found(text), "FREQUENCY=, followed by a whole number"),
    }
}

pub(super) fn constraints(reading: &mut Reading, block: &Block) {
    for line in block.full(reading.sources) {
        let mut fields = line.fields();
        let Some(kind) = fields.next() else { continue };
        let name = without_blanks(kind.text).to_uppercase();
        if name != "SLIDER" {
            reading.log.leave_out(kind.place, format!("a constraint of type {name}"), false);
            continue;
        }
        let nodes: Vec<_> = fields.map(|field| reading.reference(field)).collect();
        let count = nodes.len();
        match <[_; 3]>::try_from(nodes) {
            Ok([Some(node), Some(first), Some(last)]) => reading.model.sliders.push([first, last, node]),
            Ok(_) => {}
            Err(_) => {
                let allowed = "3: the node on the line, and the first and the last of the line";
                reading.fault(line.place, format!("{count} nodes"), allowed);
            }
        }
    }
}
