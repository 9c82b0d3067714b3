//! Scenes: connectors and constraints evaluated together over a history of states, limited to what the outputs need.
//!
//! A scene is a JSON file: a dimension, nodes with orientations, elements of a [`Kind`] with parameters, frames that move nodes
//! and load elements, and the names of the requested outputs. [`Scene::parse`] reads it and reports every mistake with its
//! location; [`Scene::parse_in`] also reads the file of arrays that it may name. [`Plan`] finds the smallest set of formulas that
//! the outputs need; [`Run`] evaluates them state by state in `f64` or in 237 bits; [`Results`] collects the results by name,
//! [`Columns`] as arrays.
//!
//! ```
//! use jointproof::scene::{Results, Scene};
//!
//! let scene = Scene::parse(r#"{
//!     "dimension": "3d",
//!     "orientations": { "along": { "axes": [[1, 0, 0], [0, 1, 0]] } },
//!     "nodes": { "rail": { "at": [0, 0, 0], "orientation": "along" }, "car": { "at": [1, 2, 3] } },
//!     "elements": { "guide": { "kind": "slot", "nodes": ["rail", "car"], "mu": 0.25 } },
//!     "frames": [ { "time": 1, "nodes": { "car": { "u": [2.5, 0, 0] } }, "loads": { "guide": { "f2": 3, "f3": 4 } } } ],
//!     "outputs": ["U1", "FN"]
//! }"#)?;
//! let results = Results::of(&scene)?;
//! assert_eq!(results.get("guide", "U1", 0), Some(&[2.5][..]));
//! assert_eq!(results.get("guide", "FN", 0), Some(&[5.0][..]));
//! assert_eq!(results.counts.iter().map(|(formula, _)| *formula).collect::<Vec<_>>(), [
//!     "slot.relative_position", // twice: once at the start
//!     "slot.relative_motion",
//!     "slot.contact_force",
//!     "slot.normal_force",
//! ]);
//!
//! let faults = Scene::parse(r#"{ "dimension": "3d", "nodes": {}, "elements": {}, "output": [] }"#).unwrap_err();
//! assert_eq!(
//!     faults.to_string(),
//!     "output (line 1, column 51): unknown key \"output\"; \
//!      allowed is one of title, dimension, angles, columns, orientations, nodes, slide_lines, elements, frames, outputs",
//! );
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Cost
//!
//! Time is linear in elements and states, and elements are distributed over all cores; elements are independent of each other, so
//! the results have the same bits for every number of threads. Memory is bounded by [`Run::bytes`], whatever the number of
//! states; a history in columns or [tables](Tables) stays in its file, which is read once to check it and once by every run.

mod abaqus;
mod angles;
mod columns;
pub mod deck;
mod json;
mod kind;
mod model;
pub mod npz;
mod plan;
mod read;
mod results;
pub mod rules;
mod run;
mod schema;
mod start;
mod table;
mod tables;
mod values;

pub use abaqus::SAME_OUTPUTS;
pub use columns::{Column, Columns, Unwritten};
pub use deck::{Deck, LeftOut};
pub use json::{Fault, Faults};
pub use kind::{Dimension, Fallback, Kind, Origin, Use, When};
pub use model::Scene;
pub use plan::{Plan, PlanLine};
pub use results::{Results, Series};
pub use run::{Culprit, Problem, Problems, Run, Stopped, Unreadable, Warning};
pub use schema::schema;
pub use start::{Start, StartNode};
pub use table::Table;
pub use tables::{TableFault, Tables};
pub use values::Values;
