//! What is answered at a point.

use std::collections::BTreeMap;

/// What a program or a function answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Numbers in order; `None` for one that it does not compute.
    Numbers(Vec<Option<f64>>),
    /// It refuses the inputs, and may name one.
    Refused(Option<String>),
    /// It leaves the point out, and says why.
    Skipped(String),
    /// What is no answer, in words.
    Bad(String),
}

/// Manners that are understood, but worth a word: how often each was seen.
pub type Manners = BTreeMap<&'static str, usize>;

/// How a program answered, beside what.
#[derive(Debug, Default)]
pub struct Heard {
    /// What was understood.
    pub manners: Manners,
    /// What is worth a word, each once.
    pub noticed: Vec<String>,
}
