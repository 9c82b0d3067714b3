//! The kit: what proves a catalog of formulas, as commands.
//!
//! A crate with formulas of its own gets `verify`, `golden`, `audit`, `report`, `book` and `new` by a `main` like this:
//!
//! ```no_run
//! use kit::Project;
//! use std::process::ExitCode;
//! # use jointproof::catalog::CATALOG;
//!
//! fn main() -> ExitCode {
//!     kit::main(&Project::new(env!("CARGO_PKG_NAME"), env!("CARGO_MANIFEST_DIR"), CATALOG))
//! }
//! ```
//!
//! `report` times a program that is built with optimisation: the same one, with the feature `measure`
//! alone.

#[cfg(any(feature = "commands", feature = "measuring"))]
pub mod measuring;
mod project;

#[cfg(feature = "commands")]
pub mod audit;
#[cfg(feature = "judge")]
pub mod audited;
#[cfg(feature = "commands")]
mod book;
#[cfg(feature = "judge")]
pub mod check;
#[cfg(feature = "commands")]
mod commands;
#[cfg(feature = "judge")]
pub mod console;
#[cfg(feature = "commands")]
mod equation;
#[cfg(feature = "commands")]
mod evidence;
#[cfg(feature = "commands")]
mod export;
#[cfg(feature = "commands")]
mod extension;
#[cfg(feature = "commands")]
pub mod files;
#[cfg(feature = "commands")]
mod formulas;
#[cfg(feature = "commands")]
mod golden;
#[cfg(feature = "judge")]
mod looked;
#[cfg(feature = "commands")]
mod new;
#[cfg(feature = "commands")]
mod outcome;
#[cfg(feature = "commands")]
mod owed;
#[cfg(feature = "commands")]
mod prose;
#[cfg(feature = "commands")]
mod report;
#[cfg(feature = "commands")]
mod review;
#[cfg(all(test, feature = "commands"))]
mod sample;
#[cfg(feature = "commands")]
mod selection;
#[cfg(feature = "commands")]
mod since;
#[cfg(feature = "commands")]
mod verify;

#[cfg(feature = "commands")]
pub use book::{Fault, listing_page, uncovered};
#[cfg(feature = "commands")]
pub use commands::main;
#[cfg(feature = "commands")]
pub use extension::{Beside, Exhibits, Fact, Moving, Served, Slider, Table};
#[cfg(all(feature = "measuring", not(feature = "commands")))]
pub use measuring::main;
#[cfg(feature = "commands")]
pub use outcome::{Outcome, Usage};
pub use project::{Catalog, Project};
#[cfg(feature = "commands")]
pub use project::{Check, Reach};
