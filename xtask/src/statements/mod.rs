//! What the documents say, statement by statement, and what covers it.
//!
//! A document is a table of [statements](statement::Statement). [`faults`] finds a statement that nothing covers, a
//! reference to nothing, a formula that no statement names, and an erratum that does not show what it says; `verify` fails
//! on each. The book has the same tables as the chapter "Traceability", and every entry the statements that name it.

pub(crate) mod book;
mod check;
mod document;
mod documents;
mod errata;
mod erratum;
mod statement;
#[cfg(test)]
mod tests;
mod world;

use crate::console::say;
use check::faults;
use document::Counts;
use kit::Project;
use world::World;

/// Checks all statements and errata: whether all is well, and counts.
pub(crate) fn verify(project: &Project) -> anyhow::Result<(bool, String)> {
    let (documents, errata) = (documents::all(), errata::all());
    let faults = faults(&documents, &errata, &World::read(project)?);
    for fault in &faults {
        say(fault);
    }
    let counts = Counts::of(&documents);
    Ok((faults.is_empty(), format!("{counts}; {} errata executed", errata.len())))
}
