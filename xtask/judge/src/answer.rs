//! The answer at a point.

use std::collections::BTreeMap;

/// The answer of a program or a function.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Numbers in order; `None` for one that it does not compute.
    Numbers(Vec<Option<f64>>),
    /// It rejects the inputs, and may name one.
    Refused(Option<String>),
    /// It skips the point, and says why.
    Skipped(String),
    /// Not a valid answer; the reason in words.
    Bad(String),
}

/// Irregularities that are understood but reported: how often each occurred.
pub type Manners = BTreeMap<&'static str, usize>;

/// How a program answered, apart from the numbers.
#[derive(Debug, Default)]
pub struct Heard {
    /// The irregularities that were understood.
    pub manners: Manners,
    /// Remarks worth reporting, each once.
    pub noticed: Vec<String>,
}
