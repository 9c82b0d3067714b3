//! Temporaries that are results of other formulas, by the names that they have there.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::graph::{Graph, Node};
use std::collections::{HashMap, HashSet};

/// A formula and its graph.
type Known = (&'static dyn AnyFormula, Graph);

/// The names in one formula, from others that take inputs of the same names.
pub(super) fn of((formula, graph): &Known, all: &[Known]) -> HashMap<Node, String> {
    let fields = formula.inputs().iter().chain(formula.outputs());
    let mut taken: HashSet<_> = fields.map(|field| field.name.to_lowercase()).collect();
    let mut names = HashMap::new();
    for (other, other_graph) in all.iter().filter(|(other, _)| other.spec().id != formula.spec().id) {
        let Some(inputs) = positions(other.inputs(), formula.inputs()) else { continue };
        let found = other_graph.value_within(graph, &inputs);
        for (name, node) in components(other.outputs()).zip(found) {
            let Some(node) = node.filter(|node| !graph.is_atom(*node) && !names.contains_key(node)) else { continue };
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

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::find;

    #[test]
    fn what_another_formula_computes_has_its_name() {
        let all = ["slot.friction", "slot.contact_force"].map(|id| {
            let formula = find(id).unwrap();
            (formula, formula.graph().unwrap())
        });
        let names = of(&all[0], &all);
        assert_eq!(names.values().collect::<Vec<_>>(), ["fc_"]);
        assert!(names.keys().all(|node| !all[0].1.is_atom(*node)));
    }

    #[test]
    fn fields_are_found_by_their_names_or_not_at_all() {
        let inputs = |id| find(id).unwrap().inputs();
        assert_eq!(positions(inputs("slot.contact_force"), inputs("slot.contact_force")), Some(vec![0, 1]));
        assert_eq!(positions(inputs("slot.contact_force"), inputs("coulomb.yield")), None);
        assert_eq!(positions(&inputs("coulomb.yield")[1..], inputs("coulomb.yield")), Some(vec![1, 2]));
    }
}
