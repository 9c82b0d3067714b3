//! Identifiers of formulas are taken from `SPEC.id`. They are not typed elsewhere in code, except in tests and documentation.

use super::finding::Finding;
use super::tree::Tree;
use std::collections::BTreeMap;

/// Every string that is the identifier of a formula, or looks like one of an existing family.
pub(super) fn typed(tree: &Tree) -> Vec<Finding> {
    let owners: BTreeMap<&str, &str> = owners(tree).collect();
    let finding = |file: usize, id: &str, line: usize| {
        let remedy = match owners.get(id) {
            Some(owner) => format!("write `{owner}::SPEC.id`"),
            None => "no formula is called so; take the id of one from its `SPEC`".to_owned(),
        };
        Finding::new(&tree.sources[file].path, line, format!("the identifier \"{id}\" is typed; {remedy}"))
    };
    let families: Vec<&str> = owners.keys().filter_map(|id| family(id)).collect();
    let is_id = |text: &str| owners.contains_key(text) || family(text).is_some_and(|family| families.contains(&family));
    let strings =
        tree.modules.iter().flat_map(|module| module.words.strings.iter().map(|string| (module.file, string)));
    strings.filter(|(_, (text, _))| is_id(text)).map(|(file, (text, line))| finding(file, text, *line)).collect()
}

/// Every identifier that a `SPEC` declares, with the type that has it.
fn owners(tree: &Tree) -> impl Iterator<Item = (&str, &str)> {
    let formulas = tree.sources.iter().flat_map(|source| &source.formulas);
    formulas.filter_map(|formula| {
        let id = formula.spec.iter().map(|(text, _)| text.as_str()).find(|text| family(text).is_some());
        id.map(|id| (id, formula.name.as_str()))
    })
}

/// The family of a string that looks like an identifier: `slot` of `slot.contact_force`.
fn family(text: &str) -> Option<&str> {
    let (family, name) = text.split_once('.')?;
    let is_word = |text: &str, others: fn(char) -> bool| {
        !text.is_empty() && text.chars().all(|c| c.is_ascii_lowercase() || c == '_' || others(c))
    };
    (is_word(family, |_| false) && is_word(name, |c| c.is_ascii_digit())).then_some(family)
}
