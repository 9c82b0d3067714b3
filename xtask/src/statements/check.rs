//! Checks of the statements.

use super::document::Document;
use super::erratum::Erratum;
use super::statement::{Cover, Formula, Statement, Status};
use super::world::{self, World};
use jointproof::catalog::CATALOG;
use jointproof::formula::Provenance;
use std::collections::BTreeSet;

/// The chapter of the errata.
const ERRATA: &str = "errata.md";

/// All faults, one line each.
pub(super) fn faults(documents: &[Document], errata: &[Erratum], world: &World) -> Vec<String> {
    let mut faults = Vec::new();
    let mut anchors = BTreeSet::new();
    for document in documents {
        for statement in &document.statements {
            let anchor = document.anchor_of(statement);
            faults.extend(of_statement(statement, errata, world).into_iter().map(|fault| format!("{anchor}: {fault}")));
            if !anchors.insert(anchor.clone()) {
                faults.push(format!("{anchor}: a statement of this id is there already"));
            }
        }
    }
    faults.extend(CATALOG.iter().filter_map(|formula| unnamed(*formula, documents)));
    faults.extend(errata.iter().flat_map(|erratum| of_erratum(erratum, world)));
    faults
}

/// The faults of one statement.
fn of_statement(statement: &Statement, errata: &[Erratum], world: &World) -> Vec<String> {
    let mut faults: Vec<_> =
        statement.covers.iter().filter(|cover| !exists(cover, errata, world)).map(reference).collect();
    let has = |is: fn(&Cover) -> bool| statement.covers.iter().any(is);
    match statement.status {
        Status::Covered if statement.covers.is_empty() => faults.push("nothing covers it".into()),
        Status::Erratum if !has(|cover| !matches!(cover, Cover::Erratum(_))) => {
            faults.push("nothing but an erratum covers it".into());
        }
        Status::Outside("") => faults.push("it does not say why".into()),
        Status::Outside(_) if !statement.covers.is_empty() => faults.push("it is outside, and covered".into()),
        _ => {}
    }
    faults
}

/// Whether the target of a reference exists. Formulas and functions exist, or this would not compile; a function that
/// cannot be found in its file could not be shown.
fn exists(cover: &Cover, errata: &[Erratum], world: &World) -> bool {
    match *cover {
        Cover::Formula(formula) => CATALOG.iter().any(|known| known.spec().id == formula.spec().id),
        Cover::Law(formula, words) => formula.laws().iter().filter(|law| law.starts_with(words)).count() == 1,
        Cover::Case(formula, case) => world.has_case(formula.spec().id, case),
        Cover::Item(path) => world.item(path).is_some(),
        Cover::Output(name) => world::output(name).is_some(),
        Cover::Test(test) => world.test(test).is_some(),
        Cover::Chapter(place) => world.has_place(place),
        Cover::Erratum(anchor) => errata.iter().any(|erratum| erratum.anchor == anchor),
    }
}

/// A dangling reference, in words.
fn reference(cover: &Cover) -> String {
    match *cover {
        Cover::Formula(formula) => format!("the formula {} is not in the catalog", formula.spec().id),
        Cover::Law(formula, words) => format!("{} has not one law that begins with \"{words}\"", formula.spec().id),
        Cover::Case(formula, case) => format!("{} has no golden case {case}", formula.spec().id),
        Cover::Item(path) => format!("{path} is not found in its file"),
        Cover::Output(name) => format!("scenes have no output {name}"),
        Cover::Test(test) => format!("there is no test {test}"),
        Cover::Chapter(place) => format!("the book has no {place}"),
        Cover::Erratum(anchor) => format!("there is no erratum {anchor}"),
    }
}

/// A formula that no statement names, unless it is derived by us, or one whose section is not in its document.
fn unnamed(formula: Formula, documents: &[Document]) -> Option<String> {
    let spec = formula.spec();
    let (id, source) = (spec.id, spec.source);
    let named = documents.iter().flat_map(|document| &document.statements).any(|statement| statement.names(id));
    let is_section = |document: &Document| source.section.is_empty() || document.sections.contains(&source.section);
    let of_document = |document: &&Document| document.source == source.document;
    if !named && !matches!(source.provenance, Provenance::Ours(_)) {
        return Some(format!("{id}: no statement of a document names this formula, and it is not ours"));
    }
    if !documents.iter().find(of_document).is_some_and(is_section) {
        return Some(format!("{id}: its section \"{}\" is not one of {}", source.section, source.document.title));
    }
    None
}

/// The faults of an erratum: of its comparisons, and of its location in the chapter.
fn of_erratum(erratum: &Erratum, world: &World) -> Vec<String> {
    let mut faults = erratum.faults();
    let anchor = erratum.anchor;
    let text = world.chapter(ERRATA).unwrap_or_default();
    if !world::anchors(text).contains(anchor) || !text.contains(&format!("{{{{#text erratum-{anchor}}}}}")) {
        faults.push(format!(
            "erratum {anchor}: {ERRATA} has no heading `{{#{anchor}}}` with `{{{{#text erratum-{anchor}}}}}` below"
        ));
    }
    faults
}
