//! Nodes and elements that are generated from others.

use super::block::Block;
use super::mesh::{add_element, add_node, range};
use super::model::{Element, Item, Members, Node};
use super::motion::{exactly, rounded};
use super::reading::Reading;
use super::source::Place;
use crate::Octuple;

/// The most that a line can generate: more would be a slip, and not fit into memory.
const MOST: u64 = 10_000_000;

/// Nodes at equal distances on the straight line between two.
pub(super) fn nodes(reading: &mut Reading, block: &Block) {
    if let Some(line) = block.parameter("LINE") {
        return reading.log.leave_out(line.place, "nodes along an arc or a parabola", true);
    }
    let scope = reading.scope;
    let set = block.label(&mut reading.log, "NSET").map(|(label, _)| (scope, label.key));
    for line in block.full(reading.sources) {
        let Some((first, last, step)) = range(reading, line) else { continue };
        let ends = [first, last].map(|number| reading.model.nodes.get(&(scope, number)).map(|node| exactly(node.at)));
        let [Some(a), Some(b)] = ends else {
            let missing = if ends[0].is_none() { first } else { last };
            let shown = reading.model.shown((scope, missing));
            reading.fault(line.place, format!("no node {shown}"), "the numbers of two nodes above");
            continue;
        };
        let parts = (last - first) / step;
        if !is_few(reading, line.place, u64::from(parts)) {
            continue;
        }
        for part in 1..parts {
            let at = rounded(a + (b - a) * (Octuple::from(f64::from(part)) / f64::from(parts)));
            add_node(reading, first + part * step, Node { at, place: line.place });
        }
        if let Some(set) = &set {
            let members = Item { scope, of: Members::Range(first, last, step), place: line.place };
            reading.model.node_sets.entry(set.clone()).or_default().push(members);
        }
    }
}

/// How many there are along a direction, and by how much the numbers of nodes and of elements grow from one to the next.
#[derive(Clone, Copy)]
struct Direction {
    count: u32,
    nodes: u32,
    elements: u32,
}

/// Copies of an element in a row, in rows, and in layers of rows.
pub(super) fn elements(reading: &mut Reading, block: &Block) {
    let scope = reading.scope;
    let set = block.label(&mut reading.log, "ELSET").map(|(label, _)| (scope, label.key));
    for line in block.full(reading.sources) {
        let place = line.place;
        let mut numbers = [1; 10];
        let fields: Vec<_> = line.fields().collect();
        if !(2..=numbers.len()).contains(&fields.len()) {
            let allowed = "the number of an element, how many in its row, increments of the numbers of nodes and of elements; the same of rows, and of layers";
            reading.fault(place, format!("{} numbers", fields.len()), allowed);
            continue;
        }
        let mut is_sound = true;
        for (number, &field) in numbers.iter_mut().zip(&fields).filter(|(_, field)| !field.text.is_empty()) {
            let read = reading.identifier(field);
            is_sound &= read.is_some();
            *number = read.unwrap_or(1);
        }
        let [master, ref directions @ ..] = numbers;
        let (directions, _) = directions.as_chunks();
        let [row, rows, layers] = [0, 1, 2].map(|k| {
            let [count, nodes, elements] = directions[k];
            Direction { count, nodes, elements }
        });
        let all = [row, rows, layers].iter().fold(1, |all: u64, direction| all.saturating_mul(direction.count.into()));
        if !is_sound || !is_few(reading, place, all) {
            continue;
        }
        let Some(element) = reading.model.elements.get(&(scope, master)).cloned() else {
            let shown = reading.model.shown((scope, master));
            if reading.model.others.is_empty() {
                reading.fault(place, format!("no element {shown}"), "the number of an element above");
            } else {
                // The numbers of elements of other types are not kept: it may be one of these, or a slip.
                reading.log.leave_out(block.place, "copies of elements that are left out or missing", false);
            }
            continue;
        };
        let mut members = Vec::new();
        for layer in 0..layers.count {
            for row_of_layer in 0..rows.count {
                for of_row in 0..row.count {
                    let steps = [(row, of_row), (rows, row_of_layer), (layers, layer)];
                    let number = copy(reading, (master, &element), steps, place);
                    members.extend(number.map(|number| Item { scope, of: Members::One(number), place }));
                }
            }
        }
        if let Some(set) = &set {
            reading.model.element_sets.entry(set.clone()).or_default().append(&mut members);
        }
    }
}

/// A copy of an element so many steps along each direction, if it is not the element itself; and its number.
fn copy(
    reading: &mut Reading,
    (master, element): (u32, &Element),
    steps: [(Direction, u32); 3],
    place: Place,
) -> Option<u32> {
    let moved = |number: u32, by: fn(Direction) -> u32| {
        let by = steps.map(|(direction, steps)| u64::from(by(direction)) * u64::from(steps));
        u32::try_from(by.into_iter().fold(number.into(), u64::saturating_add)).ok()
    };
    let own = moved(master, |direction| direction.elements);
    let ends = element.nodes.iter().map(|&((scope, number), _)| {
        // The ground of a connector has its number.
        let number = if scope == !reading.scope { own } else { moved(number, |direction| direction.nodes) };
        Some(((scope, number?), place))
    });
    let (Some(own), Some(nodes)) = (own, ends.collect()) else {
        reading.fault(place, "numbers that are too large", "numbers up to 4294967295");
        return None;
    };
    if own != master {
        add_element(reading, own, Element { of: element.of, nodes, place });
    }
    Some(own)
}

fn is_few(reading: &mut Reading, place: Place, count: u64) -> bool {
    if count > MOST {
        reading.fault(place, format!("{count} of them"), format!("at most {MOST} generated by a line"));
    }
    count <= MOST
}
