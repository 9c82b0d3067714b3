//! A plan in words.

use std::fmt;

/// A formula in a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanLine {
    /// The identifier of the formula.
    pub formula: &'static str,
    /// What it is evaluated for: a kind of element, or slave nodes.
    pub kind: &'static str,
    /// The number of these.
    pub elements: usize,
    /// Whether it is evaluated once, in the initial configuration, or in every state.
    pub once: bool,
    /// The purpose of the formula.
    pub why: String,
}

impl fmt::Display for PlanLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { formula, kind, elements, once, why } = self;
        let when = if *once { "at the start" } else { "every state" };
        write!(f, "{formula:<34} {elements:>9} × {kind:<10} {when:<12} {why}")
    }
}
