//! Connector sections and their behavior.

use super::block::{Block, Line};
use super::field::{Label, without_blanks};
use super::model::{Behavior, Friction, Section, Stop};
use super::reading::{Context, Reading, found};

pub(super) fn section(reading: &mut Reading, block: &Block) {
    let Some(elements) = block.required(&mut reading.log, "ELSET") else { return };
    let behavior = block.label(&mut reading.log, "BEHAVIOR");
    let mut lines = block.lines(reading.sources);
    let first = lines.next();
    let kinds: Vec<_> = first
        .into_iter()
        .flat_map(Line::fields)
        .filter(|field| !field.text.is_empty())
        .map(|field| (without_blanks(field.text).to_uppercase(), field.place))
        .collect();
    match kinds[..] {
        [] => reading.fault(
            block.place,
            "no type of connection",
            "a data line with one type, or a basic type of each kind",
        ),
        [_] | [_, _] => {}
        [_, _, (_, place), ..] => {
            reading.fault(place, "a third type of connection", "one type, or a basic type of each kind");
        }
    }
    let mut orientations = [None, None];
    if let Some(line) = lines.next() {
        for (k, field) in line.fields().enumerate() {
            match orientations.get_mut(k) {
                _ if field.text.is_empty() => {}
                Some(orientation) => {
                    let label = Label::new(field.text);
                    if label.is_none() {
                        reading.fault(field.place, found(field.text), "the name of an orientation");
                    }
                    *orientation = label.map(|label| (label, field.place));
                }
                None => reading.fault(field.place, found(field.text), "the orientations at a and at b"),
            }
        }
    }
    if let Some(line) = lines.find(|line| !line.is_blank()) {
        reading.fault(line.place, "a third data line", "types of connection, and orientations");
    }
    let (scope, place) = (reading.scope, block.place);
    reading.model.sections.push(Section { scope, elements, place, kinds, orientations, behavior });
}

pub(super) fn behavior(reading: &mut Reading, block: &Block) {
    let Some((label, place)) = block.required(&mut reading.log, "NAME") else { return };
    if reading.model.behaviors.contains_key(&label.key) {
        return reading.fault(
            place,
            format!("connector behavior {:?} for the second time", label.shown),
            "each name once",
        );
    }
    let index = reading.model.behaviors.insert_full(label.key, Behavior::default()).0;
    reading.context = Context::Behavior(index);
}

/// The behavior to which a block belongs; a fault if there is none.
fn of<'r>(reading: &'r mut Reading, block: &Block) -> Option<&'r mut Behavior> {
    if let Context::Behavior(index) = reading.context {
        return reading.model.behaviors.get_index_mut(index).map(|(_, behavior)| behavior);
    }
    reading.fault(block.place, "a keyword of no connector behavior", "one below *CONNECTOR BEHAVIOR");
    None
}

/// What the scene does not have of a behavior.
pub(super) fn other(reading: &mut Reading, block: &Block) {
    if let Some(behavior) = of(reading, block) {
        behavior.others.push(("connectors depend on it", block.place));
    }
}

pub(super) fn friction(reading: &mut Reading, block: &Block) {
    let predefined = block.parameter("PREDEFINED").is_some();
    let stick = reading.value(block, "STICKSTIFFNESS");
    let mut parameters = Vec::new();
    for line in block.lines(reading.sources) {
        for field in line.fields() {
            parameters.push((reading.number(field), field.place));
        }
    }
    while parameters.pop_if(|(number, _)| number.is_none()).is_some() {}
    let place = block.place;
    if let Some(behavior) = of(reading, block) {
        if !predefined {
            behavior.others.push(("connectors depend on it, without PREDEFINED", place));
        }
        let again = predefined && behavior.predefined().is_some();
        behavior.frictions.push(Friction { place, predefined, parameters, stick, mu: None });
        if again {
            reading.fault(place, "predefined friction for the second time", "one of each connector behavior");
        }
    }
}

pub(super) fn stop(reading: &mut Reading, block: &Block) {
    let component = component(reading, block);
    let Some(line) = block.lines(reading.sources).next() else {
        return reading.fault(block.place, "no data line", "a line with the lower and the upper limit");
    };
    let mut limits = [None, None];
    for (k, field) in line.fields().enumerate() {
        let number = reading.number(field).map(|number| (number, field.place));
        match limits.get_mut(k) {
            Some(limit) => *limit = number,
            None if number.is_none() => {}
            None => reading.fault(field.place, found(field.text), "the lower and the upper limit"),
        }
    }
    if let (Some(behavior), Some(component)) = (of(reading, block), component) {
        if behavior.stops.iter().any(|stop| stop.component == component) {
            return reading.fault(
                block.place,
                format!("a stop of component {component} for the second time"),
                "each once",
            );
        }
        behavior.stops.push(Stop { component, limits, place: block.place });
    }
}

/// The component of relative motion that a parameter names.
fn component(reading: &mut Reading, block: &Block) -> Option<u8> {
    let allowed = "COMPONENT=, followed by a number from 1 to 6";
    let Some(parameter) = block.parameter("COMPONENT") else {
        reading.fault(block.place, "no COMPONENT", allowed);
        return None;
    };
    let text = parameter.value.as_deref().unwrap_or_default();
    let component = text.parse().ok().filter(|component| (1..=6).contains(component));
    if component.is_none() {
        reading.fault(parameter.place, found(text), allowed);
    }
    component
}

pub(super) fn reference(reading: &mut Reading, block: &Block) {
    let mut given = Vec::new();
    let lines = block.full(reading.sources);
    for (field, component) in lines.flat_map(Line::fields).zip(1..) {
        if component > 6 {
            reading.fault(field.place, found(field.text), "6 references");
            break;
        }
        given.extend(reading.number(field).map(|number| (component, (number, field.place))));
    }
    if let Some(behavior) = of(reading, block) {
        if !behavior.reference.is_empty() {
            return reading.fault(
                block.place,
                "references for the second time",
                "one *CONNECTOR CONSTITUTIVE REFERENCE",
            );
        }
        behavior.reference.append(&mut given);
    }
}
