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

/// The members of a set, in order, each once, with their places. Members that are not known end a range.
pub(super) fn members(
    model: &Model,
    sets: &HashMap<Named, Vec<Item>>,
    what: What,
    named: (Scope, &str, Place),
    log: &mut Log,
    is_known: &dyn Fn(Numbered) -> bool,
) -> Vec<(Numbered, Place)> {
    let (scope, key, place) = named;
    let mut found = Vec::new();
    let mut seen = HashSet::new();
    let mut entered: HashSet<Named> = HashSet::new();
    // What remains of the sets that are open, the innermost last.
    let root = [Item { scope, of: Members::Set(key.into()), place }];
    let mut open: Vec<std::slice::Iter<Item>> = vec![root.iter()];
    while let Some(items) = open.last_mut() {
        let Some(Item { scope, of, place }) = items.next() else {
            open.pop();
            continue;
        };
        let (first, last, step) = match of {
            Members::One(number) => (*number, *number, 1),
            Members::Range(first, last, step) => (*first, *last, *step),
            Members::Set(key) => {
                let known = candidates(model, *scope, key).into_iter().find(|name| sets.contains_key(name));
                match known {
                    None => {
                        let mut names: Vec<_> = sets.keys().map(|(_, name)| name).collect();
                        names.sort_unstable();
                        names.dedup();
                        let allowed = if names.is_empty() {
                            "no set, there are none".into()
                        } else {
                            format!("one of {}", some_of(names.into_iter()))
                        };
                        log.fault(*place, format!("no {what} set {key:?}"), allowed);
                    }
                    Some(name) => {
                        if entered.insert(name.clone()) {
                            open.push(sets[&name].iter());
                        }
                    }
                }
                continue;
            }
        };
        for number in (first..=last).step_by(step as usize) {
            let member = (*scope, number);
            if !is_known(member) {
                log.fault(*place, format!("no {what} {}", model.shown(member)), format!("the number of a {what}"));
                break;
            }
            if seen.insert(member) {
                found.push((member, *place));
            }
        }
    }
    found
}

/// The nodes that a reference names.
pub(super) fn nodes_of(model: &Model, reference: &Reference, log: &mut Log) -> Vec<(Numbered, Place)> {
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
