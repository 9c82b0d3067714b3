//! The recorded operations of a formula: each operation once, in order, and each choice with both branches.
//!
//! A formula is generic over its scalar. [`Traced`] is a scalar that computes nothing: each operation on it becomes a
//! node of a [`Graph`]. A comparison must return at once, so the formula is run again for every combination of
//! outcomes, and where two runs diverge, their results become one [`Op::Select`]. The outcome is a list of operations
//! without jumps, which has the bits of the formula in `f64` and can be printed in another language.
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
mod apart;
mod gather;
mod join;
mod level;
mod node;
mod program;
mod record;
mod recorder;
mod run;
mod slope;
mod terms;
mod text;
mod traced;
mod write;

pub use alter::Instead;
pub use node::{Binary, Graph, Node, Op, Relation, Search, Unary};
pub use program::Statement;
pub use record::{NotRecorded, record, record_element, record_with};
pub(crate) use record::{record_step, recorded};
pub use recorder::Extremes;
pub use run::Number;
pub(crate) use text::bounds;
pub use traced::Traced;
