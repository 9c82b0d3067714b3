//! Names temporaries after results of other formulas.

use super::subject::Subject;
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Graph, Node};
use std::collections::{HashMap, HashSet};

/// A formula or an element and its graph.
type Known = (Subject, Graph);

/// The names in one formula, from others whose inputs have the same names.
///
/// There are none in an element, whose operations are simplified together.
pub(super) fn of((subject, graph): &Known, all: &[Known]) -> HashMap<Node, String> {
    let Subject::Formula(formula) = subject else { return HashMap::new() };
    let fields = formula.inputs().iter().chain(formula.outputs());
    let mut taken: HashSet<_> = fields.map(|field| field.name.to_lowercase()).collect();
    let mut names = HashMap::new();
    for (other, other_graph) in all {
        let Subject::Formula(other) = other else { continue };
        if other.spec().id == formula.spec().id {
            continue;
        }
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

/// The positions of the components of some fields among those of others, if all of them occur there by name.
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

/// The names of components, in lower case, since some languages are case-insensitive.
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
            (Subject::Formula(formula), formula.graph().unwrap())
        });
        let names = of(&all[0], &all);
        assert_eq!(names.values().collect::<Vec<_>>(), ["fc_"]);
        assert!(names.keys().all(|node| !all[0].1.is_atom(*node)));
    }

    /// The names in the friction of a slot.
    fn names_of_friction(others: &[Known]) -> Vec<(Node, String)> {
        let friction = known("slot.friction");
        of(&friction, others).into_iter().collect()
    }

    fn known(id: &str) -> Known {
        let formula = find(id).unwrap();
        (Subject::Formula(formula), formula.graph().unwrap())
    }

    /// Pretends that this formula, which has the same inputs, has the contact force or one of its operands as its value.
    fn known_as(id: &str, of_force: impl Fn(&Graph, Node) -> bool) -> Known {
        let (_, mut graph) = known("slot.contact_force");
        let node = graph.needed(&graph.value).into_iter().find(|&node| of_force(&graph, node)).unwrap();
        graph.value = vec![node];
        (Subject::Formula(find(id).unwrap()), graph)
    }

    #[test]
    fn the_first_of_two_formulas_gives_the_name() {
        let same = |id| known_as(id, |graph, node| graph.value[0] == node);
        let [contact, radial] = ["slot.contact_force", "translator.radial_force"].map(same);
        let names = [[contact.clone(), radial.clone()], [radial, contact]].map(|others| names_of_friction(&others));
        assert_eq!(names.map(|names| names.into_iter().map(|(_, name)| name).collect::<Vec<_>>()), [["fc_"], ["fr_"]]);
    }

    #[test]
    fn an_input_keeps_its_own_name() {
        assert_eq!(names_of_friction(&[known_as("translator.radial_force", Graph::is_atom)]), []);
    }

    #[test]
    fn no_two_results_have_one_name() {
        let forces = known("join.nodal_forces");
        // Pretends that another formula with the same inputs has the forces of JOIN on b as its outputs.
        let mut whole = (Subject::Formula(find("join.geometric_stiffness").unwrap()), forces.1.clone());
        whole.1.value.drain(..6);
        // Pretends that the terms are the components of that force.
        let mut terms = whole.clone();
        let graph = &mut terms.1;
        let is_term = |node: &Node| !graph.is_atom(*node) && !graph.value.contains(node);
        graph.value = graph.needed(&graph.value).into_iter().filter(is_term).take(3).collect();
        let names = |others: &[Known]| {
            let mut names: Vec<_> = of(&forces, others).into_values().collect();
            names.sort_unstable();
            names
        };
        for others in [vec![whole.clone()], vec![terms.clone()], vec![whole, terms]] {
            assert_eq!(names(&others), ["k_ua_ta_1", "k_ua_ta_2", "k_ua_ta_3"]);
        }
    }

    #[test]
    fn components_are_named_in_lower_case_and_by_their_number() {
        let names: Vec<_> = components(find("join.nodal_forces").unwrap().outputs()).collect();
        assert_eq!(names, ["fa_1", "fa_2", "fa_3", "ma_1", "ma_2", "ma_3", "fb_1", "fb_2", "fb_3"]);
    }

    #[test]
    fn fields_are_found_by_their_names_or_not_at_all() {
        let inputs = |id| find(id).unwrap().inputs();
        assert_eq!(positions(inputs("slot.contact_force"), inputs("slot.contact_force")), Some(vec![0, 1]));
        assert_eq!(positions(inputs("slot.contact_force"), inputs("coulomb.yield")), None);
        assert_eq!(positions(&inputs("coulomb.yield")[1..], inputs("coulomb.yield")), Some(vec![1, 2]));
    }
}
