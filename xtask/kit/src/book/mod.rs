//! The book: chapters on disk, entries from the catalog, and listings of the sources.

mod browser;
mod build;
mod calculator;
mod command;
mod content;
pub(crate) mod coverage;
mod deferred;
mod downloads;
mod entry;
mod fault;
mod figure;
mod flow;
mod gather;
mod glance;
mod html;
mod links;
mod locate;
mod markdown;
mod math;
mod mend;
mod moving;
mod numeral;
mod output;
mod pages;
pub(crate) mod permalinks;
mod preprocessor;
pub(crate) mod prose;
mod rust;
mod search;
mod sheet;
mod source;
mod speed;
mod tables;
#[cfg(test)]
mod tests;
mod theme;
mod visit;
mod worked;

pub(crate) use build::Summary;
pub(crate) use command::{Arguments, build_book, run};
pub(crate) use content::CodeSpan;
pub use coverage::uncovered;
pub use fault::Fault;
pub(crate) use gather::functions;
pub(crate) use numeral::{Numeral, Origin, is_rounded};
pub use source::listing_page;
