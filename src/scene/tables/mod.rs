//! Histories as tables: a row for each state and node, or each state and element, as postprocessors write them.
//!
//! The first row names the columns. A table of nodes has `time`, `node` and some of `u1`, `u2`, `u3`, `ur1`, `ur2`, `ur3`; one of
//! loads `time`, `element` and some of `f1`, `f2`, `f3`, `m1`, `m2`, `m3`; one of pressures `time`, `node` and `pressure`. A column
//! that is missing is 0, another one is ignored and noted. Rotations are in radians. The rows of a state are together, and states
//! are in order of time, so that one state at a time is in memory: a table is read once to check it and once by every run.

mod fault;
mod header;
mod history;
mod lines;
mod rows;

pub use fault::TableFault;
pub(super) use rows::Rows;

use super::table::Table;

/// The tables of a history; those of loads and pressures have the times of that of nodes.
#[derive(Clone, Debug, Default)]
pub struct Tables {
    /// Displacements and rotation vectors of nodes.
    pub nodes: Option<Table>,
    /// Forces and moments of elements.
    pub loads: Option<Table>,
    /// Pressures of hard contact of nodes on slide lines.
    pub pressures: Option<Table>,
}
