//! The statements of the documents, and what covers each of them.
//!
//! A document is a table of [statements](statement::Statement). [`faults`] finds statements that nothing covers,
//! dangling references, formulas that no statement names, and errata that do not show what they claim; `verify` fails
//! on each. The book has the same tables as the chapter "Traceability", and every entry the statements that name it.

pub(crate) mod book;
mod check;
mod document;
mod documents;
mod errata;
mod erratum;
#[cfg(test)]
mod quotations;
mod statement;
#[cfg(test)]
mod tests;
mod world;

use crate::console::say;
use check::faults;
use document::Counts;
use kit::Project;
use world::World;

/// Checks all statements and errata, and returns whether all is well, with counts.
pub(crate) fn verify(project: &Project) -> anyhow::Result<(bool, String)> {
    let (documents, errata) = (documents::all(), errata::all());
    let faults = faults(&documents, &errata, &World::read(project)?);
    for fault in &faults {
        say(fault);
    }
    let counts = Counts::of(&documents);
    Ok((faults.is_empty(), format!("{counts}; {} errata executed", errata.len())))
}
