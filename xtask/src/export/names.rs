//! Temporaries that are results of other formulas, by the names that they have there.

use super::recorded::Recorded;
use jointproof::formula::Field;
use jointproof::graph::Node;
use std::collections::{HashMap, HashSet};

/// The names in one formula, from others that take inputs of the same names.
pub(super) fn of(one: &Recorded, all: &[Recorded]) -> HashMap<Node, String> {
    let fields = one.formula.inputs().iter().chain(one.formula.outputs());
    let mut taken: HashSet<_> = fields.map(|field| field.name.to_lowercase()).collect();
    let mut names = HashMap::new();
    for other in all.iter().filter(|other| other.formula.spec().id != one.formula.spec().id) {
        let Some(inputs) = positions(other.formula.inputs(), one.formula.inputs()) else { continue };
        let found = other.graph.value_within(&one.graph, &inputs);
        for (name, node) in components(other.formula.outputs()).zip(found) {
            let Some(node) = node.filter(|node| !one.graph.is_atom(*node) && !names.contains_key(node)) else {
                continue;
            };
            if taken.insert(name.clone()) {
                names.insert(node, name);
            }
        }
    }
    names
}

/// Where the components of some fields are among those of others, if all of them are there by their names.
fn positions(fields: &[Field], among: &[Field]) -> Option<Vec<usize>> {
    let mut positions = Vec::new();
    for field in fields {
        let before = among.iter().take_while(|other| other.name != field.name);
        let from: usize = before.map(Field::len).sum();
        among.iter().find(|other| other.name == field.name && other.len() == field.len())?;
        positions.extend(from..from + field.len());
    }
    Some(positions)
}

/// The names of components, in lower case: some languages do not tell the cases apart.
fn components(fields: &[Field]) -> impl Iterator<Item = String> {
    let of = |field: &Field| match field.len() {
        1 => vec![format!("{}_", field.name.to_lowercase())],
        len => (1..=len).map(|k| format!("{}_{k}", field.name.to_lowercase())).collect(),
    };
    fields.iter().flat_map(of)
}
