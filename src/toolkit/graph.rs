//! What a formula does to its inputs, written down: every operation once, in order, and every choice with both its sides.
//!
//! A formula is generic over its scalar. [`Traced`] is a scalar that computes nothing: each operation on it becomes a node of
//! a [`Graph`]. A comparison has to answer at once, so the formula is run again for every way in which its comparisons can
//! come out, and where two runs part the results become one [`Op::Select`]. What comes out is a list of operations without
//! jumps, which gives the bits of the formula in `f64` and can be printed in another language.
//!
//! ```
//! use jointproof::toolkit::graph::{Graph, record};
//! use jointproof::connector::slot::NormalForce;
//!
//! let graph: Graph = record::<NormalForce>()?;
//! assert_eq!(graph.run(&[3.0, 0.5]).0, [3.5]);
//! # Ok::<(), jointproof::toolkit::graph::NotRecorded>(())
//! ```

mod alter;
mod gather;
mod join;
mod level;
mod node;
mod program;
mod record;
mod recorder;
mod run;
mod slope;
mod traced;
mod write;

pub use alter::Instead;
pub use node::{Binary, Graph, Node, Op, Relation, Search, Unary};
pub use program::Statement;
pub(crate) use record::recorded;
pub use record::{NotRecorded, record, record_element, record_with};
pub use recorder::Extremes;
pub use run::Number;
pub use traced::Traced;
