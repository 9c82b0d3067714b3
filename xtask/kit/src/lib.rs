//! The kit: commands that prove a catalog of formulas.
//!
//! A crate with its own formulas gets `verify`, `golden`, `audit`, `report`, `book` and `new` from a `main` like this:
//!
//! ```no_run
//! use kit::Project;
//! use std::process::ExitCode;
//! # use jointproof::catalog::CATALOG;
//!
//! fn main() -> ExitCode {
//!     kit::main(Project::new(env!("CARGO_PKG_NAME"), env!("CARGO_MANIFEST_DIR"), CATALOG))
//! }
//! ```
//!
//! `report` times a separate optimised program that does not contain the kit: a package whose `main` is
//! [`measuring::main`], named by [`Project::measured_by`].

mod attack;
mod audit;
mod book;
mod check;
mod commands;
pub mod console;
mod elements;
mod equation;
mod evidence;
mod export;
mod extension;
pub mod files;
mod formulas;
mod golden;
mod missing;
mod new;
mod outcome;
mod plot;
mod project;
mod prose;
mod prove;
mod report;
mod review;
#[cfg(test)]
mod sample;
mod selection;
mod since;
pub mod sources;
mod template;
mod uel;
mod verify;

pub use book::{Fault, listing_page, uncovered};
pub use commands::main;
pub use extension::{Beside, Extras, Fact, Moving, Served, Slider, Table};
pub use outcome::{Outcome, Usage};
pub use plot::{Axis, Chart, Curve, tenth};
pub use project::{Catalog, Check, Project, Reach};
