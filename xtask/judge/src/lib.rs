//! The judge: reports of audits, and the results of foreign code for a formula, judged in 237 bits.
//!
//! It has no command line and no book: it is the part that the Python package compiles, and that the commands use for reports.

mod answer;
pub mod audited;
mod called;
pub mod console;
mod diagnosis;
pub mod examination;
mod judgement;
mod map;
pub mod mathematics;
mod parts;
mod question;
mod report;
mod scale;
mod taylor;
#[cfg(test)]
mod tests;
mod verdict;

pub use answer::{Answer, Heard, Manners};
pub use called::{Called, Judged, Number};
pub use judgement::Judgement;
pub use map::components;
pub use parts::{Part, Standing};
pub use question::{Question, Wanted, of_points, other_order, sizes};
pub use taylor::questions;
pub use verdict::{Bounds, Court, Grade};
