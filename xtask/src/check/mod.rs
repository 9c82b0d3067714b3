//! What somebody else computes for a formula, judged: a program over a pipe by the command `check`, or a function that is called.

mod answer;
mod called;
#[cfg(feature = "commands")]
mod command;
mod diagnosis;
#[cfg(feature = "commands")]
mod driver;
#[cfg(feature = "commands")]
mod json;
mod judgement;
#[cfg(feature = "commands")]
mod line;
#[cfg(feature = "commands")]
mod listen;
mod map;
#[cfg(feature = "commands")]
mod peer;
#[cfg(feature = "commands")]
mod process;
mod question;
mod report;
#[cfg(feature = "commands")]
mod taylor;
#[cfg(all(test, feature = "commands"))]
mod tests;
mod verdict;

pub use answer::Answer;
pub use called::{Called, Judged, Number};
#[cfg(feature = "commands")]
pub(crate) use command::{Arguments, run};
pub use verdict::Grade;
