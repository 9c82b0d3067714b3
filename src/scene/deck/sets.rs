//! Members of sets, which may contain other sets.

use super::log::Log;
use super::model::{Item, Members, Model, Named, Numbered, Reference, Scope};
use super::source::Place;
use crate::scene::json::some_of;
use std::collections::{HashMap, HashSet};

/// The name of a set or an orientation: in this scope, in the assembly, or in an instance that the name begins with.
pub(super) fn candidates(model: &Model, scope: Scope, key: &str) -> Vec<Named> {
    let mut all = vec![(scope, key.to_owned())];
    if scope > 0 {
        all.push((0, key.to_owned()));
    }
    if let Some((instance, rest)) = key.split_once('.')
        && let Some(&scope) = model.scope_of.get(instance)
    {
        all.push((scope, rest.to_owned()));
    }
    all
}

/// What kind of members a set has, for messages.
pub(super) type What = &'static str;

/// A number, or first, last and increment of several, in a scope.
type Part = (Scope, [u32; 3], Place);

/// The parts of a set and of those that it contains, in order, each set once; `missing` is called for those that there are not.
fn parts(
    model: &Model,
    sets: &HashMap<Named, Vec<Item>>,
    (scope, key, place): (Scope, &str, Place),
    missing: &mut dyn FnMut(&str, Place),
) -> Vec<Part> {
    let (mut found, mut entered) = (Vec::new(), HashSet::new());
    // What remains of the sets that are open, the innermost last.
    let root = [Item { scope, of: Members::Set(key.into()), place }];
    let mut open: Vec<std::slice::Iter<Item>> = vec![root.iter()];
    while let Some(items) = open.last_mut() {
        let Some(Item { scope, of, place }) = items.next() else {
            open.pop();
            continue;
        };
        match of {
            Members::One(number) => found.push((*scope, [*number, *number, 1], *place)),
            Members::Range(first, last, step) => found.push((*scope, [*first, *last, *step], *place)),
            Members::Set(key) => {
                match candidates(model, *scope, key).into_iter().find(|name| sets.contains_key(name)) {
                    None => missing(key, *place),
                    Some(name) => {
                        let items = sets[&name].iter();
                        if entered.insert(name) {
                            open.push(items);
                        }
                    }
                }
            }
        }
    }
    found
}

/// The members of a set, in order, each once, with their places. Members that are not known end a range.
pub(super) fn members(
    model: &Model,
    sets: &HashMap<Named, Vec<Item>>,
    what: What,
    named: (Scope, &str, Place),
    log: &mut Log,
    is_known: &dyn Fn(Numbered) -> bool,
) -> Vec<(Numbered, Place)> {
    let mut missing = |key: &str, place| {
        let mut names: Vec<_> = sets.keys().map(|(_, name)| name).collect();
        names.sort_unstable();
        names.dedup();
        let some = some_of(names.into_iter());
        let allowed = if some.is_empty() { "no set, there are none".into() } else { format!("one of {some}") };
        log.fault(place, format!("no {what} set {key:?}"), allowed);
    };
    let parts = parts(model, sets, named, &mut missing);
    let (mut found, mut seen) = (Vec::new(), HashSet::new());
    for (scope, [first, last, step], place) in parts {
        for number in (first..=last).step_by(step as usize) {
            let member = (scope, number);
            if !is_known(member) {
                log.fault(place, format!("no {what} {}", model.shown(member)), format!("the number of a {what}"));
                break;
            }
            if seen.insert(member) {
                found.push((member, place));
            }
        }
    }
    found
}

/// Whether each element, by its index, is in a set, which may have others, too.
pub(super) fn are_in(model: &Model, scope: Scope, key: &str, place: Place) -> Vec<bool> {
    let mut are_in = vec![false; model.elements.len()];
    for (scope, [first, last, step], _) in parts(model, &model.element_sets, (scope, key, place), &mut |_, _| {}) {
        // A range may be longer than the model.
        if (last - first) as usize > are_in.len() {
            for (is_in, &(of, number)) in are_in.iter_mut().zip(model.elements.keys()) {
                *is_in |= of == scope && (first..=last).contains(&number) && (number - first).is_multiple_of(step);
            }
            continue;
        }
        for number in (first..=last).step_by(step as usize) {
            model.elements.get_index_of(&(scope, number)).into_iter().for_each(|index| are_in[index] = true);
        }
    }
    are_in
}

/// The nodes that a reference names.
fn nodes_of(model: &Model, reference: &Reference, log: &mut Log) -> Vec<(Numbered, Place)> {
    let Reference { scope, of, place, .. } = reference;
    let is_known = |node| model.nodes.contains_key(&node);
    match of {
        Members::Set(key) => members(model, &model.node_sets, "node", (*scope, key, *place), log, &is_known),
        Members::One(number) if is_known((*scope, *number)) => vec![((*scope, *number), *place)],
        Members::One(_) | Members::Range(..) => {
            log.fault(*place, format!("no node {}", reference.shown), "the number of a node, or the name of a set");
            Vec::new()
        }
    }
}

/// The nodes of each SLIDER: first, last and the node between.
pub(super) fn sliders(model: &Model, log: &mut Log) -> Vec<([Numbered; 3], Place)> {
    let mut all = Vec::new();
    for references in &model.sliders {
        let [first, last, nodes] = references.each_ref().map(|reference| nodes_of(model, reference, log));
        for (k, &(node, _)) in nodes.iter().enumerate() {
            // A set for an end of the line has one node, or one for each node on it.
            let end = |ends: &[(Numbered, Place)]| ends.get(if ends.len() == 1 { 0 } else { k }).map(|&(end, _)| end);
            match (end(&first), end(&last)) {
                (Some(first), Some(last)) => all.push(([first, last, node], references[2].place)),
                _ if first.is_empty() || last.is_empty() => {}
                _ => {
                    let found = format!("{} nodes for {} ends of lines", nodes.len(), first.len().min(last.len()));
                    log.fault(references[2].place, found, "one line, or one for each node");
                    break;
                }
            }
        }
    }
    all
}
