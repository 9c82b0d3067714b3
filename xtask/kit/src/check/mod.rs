//! `check`: someone else's program, called through a pipe; its answers are judged like those of a function that is
//! called directly.

mod command;
mod derivative;
mod driver;
mod element;
mod json;
mod line;
mod listen;
mod peer;
mod process;
mod random;
mod violated;

pub(crate) use command::{Arguments, run};

/// What is said of a program.
struct Said {
    /// The formula, element or file that it was compared with.
    subject: String,
    is_well: bool,
    text: String,
    json: serde_json::Value,
    /// One sentence.
    claim: String,
}
