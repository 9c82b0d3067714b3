//! The statements in the book: traceability, sources, errata, and the statements listed in entries.

use super::document::{Counts, Document};
use super::documents;
use super::errata;
use super::statement::{Cover, Formula, Statement, Status};
use super::world::{self, World};
use crate::scene;
use jointproof::catalog::CATALOG;
use kit::{Fact, Project, listing_page};
use std::fmt::Write;

/// The page on traceability.
const PAGE: &str = "traceability.html";

/// Texts that chapters include by `{{#text name}}`, in Markdown.
pub(crate) fn texts(project: &Project) -> anyhow::Result<Vec<(String, String)>> {
    let (documents, world) = (documents::all(), World::read(project)?);
    let mut texts = vec![
        ("statements".to_owned(), traceability(&documents, &world)),
        ("documents".to_owned(), sources(&documents)),
    ];
    texts.extend(errata::all().iter().map(|erratum| (format!("erratum-{}", erratum.anchor), erratum.markdown())));
    Ok(texts)
}

/// The facts listed in every entry: the statements that name its formula.
pub(crate) fn facts(project: &Project) -> anyhow::Result<Vec<Fact>> {
    let (documents, world) = (documents::all(), World::read(project)?);
    let fact = |id: &str| {
        let mut lines = of_formula(&documents, &world, id);
        if lines.is_empty() {
            lines.push("none: no document states it".into());
        }
        Fact { formula: id.into(), name: "Statements".into(), lines }
    };
    Ok(CATALOG.iter().map(|formula| fact(formula.spec().id)).collect())
}

/// The statements that name a formula, one line each (text).
pub(super) fn of_formula(documents: &[Document], world: &World, id: &str) -> Vec<String> {
    let lines = documents.iter().flat_map(|document| {
        document.statements.iter().filter(|statement| statement.names(id)).map(move |statement| {
            let others: Vec<_> = statement.covers.iter().filter_map(|cover| beside(cover, id, world)).collect();
            let others = if others.is_empty() { String::new() } else { format!(" ({})", others.join(", ")) };
            let (title, anchor) = (document.source.title, document.anchor_of(statement));
            format!("[{title} {}]({PAGE}#{anchor}): {}{others}", statement.id, statement.says)
        })
    });
    lines.collect()
}

/// A case, function, output or erratum of a statement, as linked from an entry; laws are listed in the entry already.
fn beside(cover: &Cover, id: &str, world: &World) -> Option<String> {
    match cover {
        Cover::Case(formula, case) if formula.spec().id == id => Some(golden(*formula, case)),
        Cover::Item(_) | Cover::Output(_) | Cover::Erratum(_) => Some(reference(cover, world)),
        _ => None,
    }
}

/// A table for each document.
fn traceability(documents: &[Document], world: &World) -> String {
    let mut text = format!("{}.\n\n", Counts::of(documents));
    for document in documents {
        let _ =
            write!(text, "## {}\n\n| | Statement | Status | Covered by |\n|---|---|---|---|\n", document.source.title);
        for statement in &document.statements {
            let _ = writeln!(text, "{}", row(document, statement, world));
        }
        text.push('\n');
    }
    text
}

fn row(document: &Document, statement: &Statement, world: &World) -> String {
    let Statement { id, says, status, covers } = statement;
    let covers: Vec<_> = covers.iter().map(|cover| reference(cover, world)).collect();
    let anchor = document.anchor_of(statement);
    let cell = |text: &str| text.replace('|', "\\|");
    format!("| <a id=\"{anchor}\"></a>{id} | {} | {} | {} |", cell(says), stands(*status), cell(&covers.join(", ")))
}

fn stands(status: Status) -> String {
    match status {
        Status::Covered => "covered".into(),
        Status::Erratum => "erratum".into(),
        Status::Outside(why) => format!("outside: {why}"),
    }
}

/// What covers a statement, with a link if there is a target (Markdown).
fn reference(cover: &Cover, world: &World) -> String {
    match *cover {
        Cover::Formula(formula) => format!("`{}`", formula.spec().id),
        Cover::Law(formula, words) => format!("law of `{}`: “{words} …”", formula.spec().id),
        Cover::Case(formula, case) => format!("{} of `{}`", golden(formula, case), formula.spec().id),
        Cover::Item(path) => linked(&short(path), world.item(path)),
        Cover::Test(test) => linked(&format!("test `{test}`"), world.test(test)),
        Cover::Output(name) => output(name),
        Cover::Chapter(place) => chapter(place),
        Cover::Erratum(anchor) => format!("[erratum](errata.html#{anchor})"),
    }
}

/// A golden case, as a link to its file.
fn golden(formula: Formula, case: &str) -> String {
    format!("[case `{case}`](golden/{}.json)", formula.spec().id)
}

/// An output of scenes, as a link to the tables of its kind.
fn output(name: &str) -> String {
    let shown = match name.split_once('@').and_then(|(kind, rest)| Some((kind, rest.split_once('/')?))) {
        Some((kind, (dimension, output))) => format!("{kind}/{output} in {dimension}"),
        None => name.to_owned(),
    };
    match world::output(name) {
        Some(kind) => format!("[{shown}](scenes.html#{})", scene::anchor(kind)),
        None => shown,
    }
}

/// A location in the book, as a link.
fn chapter(place: &str) -> String {
    let (file, anchor) = place.split_once('#').unwrap_or((place, ""));
    let page = file.trim_end_matches(".md");
    format!("[{page}: {}]({page}.html#{anchor})", anchor.replace('-', " "))
}

/// Words with a link into a listing.
fn linked(words: &str, place: Option<world::Place>) -> String {
    match place {
        Some(world::Place { file, line }) => format!("[{words}]({}#L{line})", listing_page(&file)),
        None => words.to_owned(),
    }
}

/// A path from its type onwards, as code.
fn short(path: &str) -> String {
    let plain = world::plain(path);
    let parts: Vec<_> = plain.split("::").collect();
    let start =
        parts.iter().position(|part| part.starts_with(char::is_uppercase)).unwrap_or(parts.len().saturating_sub(2));
    format!("`{}`", parts[start..].join("::"))
}

/// The description of each document, how to find it, its sections, and the text that was used.
fn sources(documents: &[Document]) -> String {
    let mut text = String::new();
    for Document { source, about, found, sections, text: used, statements, .. } in documents {
        let sections = match *sections {
            [] => "none in our copy".to_owned(),
            sections => sections.iter().map(|section| format!("*{section}*")).collect::<Vec<_>>().join("; "),
        };
        let used = match used {
            Some((bytes, sha256)) => format!("{bytes} bytes, SHA-256 `{sha256}`"),
            None => "the public page, as it was in November 2026".to_owned(),
        };
        let anchor = source.title.to_lowercase().replace(' ', "-");
        let _ = write!(
            text,
            "## {title}\n\n{about}\n\n- **To find it:** {found}\n- **Sections:** {sections}\n- **Text used:** {used}\n\
             - **Statements:** [{count}](traceability.html#{anchor})\n\n",
            title = source.title,
            count = statements.len()
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn paths_are_shown_from_their_type_on_or_with_the_module_of_a_function() {
        assert_eq!(short("a::b::Type<c::D>::method"), "`Type::method`");
        assert_eq!(short("a::b::c::function"), "`c::function`");
        assert_eq!(short("function"), "`function`");
    }
}
