//! The description of an error.

use jointproof::toolkit::verify::Audit;
use judge::Judged;

/// What an error makes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Planted {
    Value,
    Jacobian,
}

impl Planted {
    /// The two numbers that a claim compares, the planted one marked.
    pub(crate) fn compared(self, claim: &str) -> [String; 2] {
        let is_value = self == Self::Value;
        // The name of each number, and whether it is the planted one.
        let named = if claim.starts_with("closed form =") {
            [("closed form", !is_value), ("automatic differentiation of the value", is_value)]
        } else if claim.starts_with("printed equation") {
            [("printed equation", false), ("value", is_value)]
        } else if claim.starts_with("derivative of the printed equation") {
            [("derivative of the printed equation", false), ("Jacobian", !is_value)]
        } else if claim.starts_with("\u{3b7} of") {
            [("in f64", true), ("exact", false)]
        } else {
            [("one side", false), ("the other", false)]
        };
        named.map(|(name, is_planted)| if is_planted { format!("{name} (planted)") } else { name.to_owned() })
    }
}

/// A re-enacted error.
pub(crate) struct Piece {
    /// The public thread that reported it (Markdown, with links).
    pub(crate) thread: &'static str,
    /// What was wrong in the original.
    pub(crate) there: &'static str,
    /// What is wrong in the re-enactment.
    pub(crate) here: &'static str,
    /// The formula in which it is re-enacted.
    pub(crate) formula: &'static str,
    /// A part of the claim that detects it.
    pub(crate) claim: &'static str,
    /// What is wrong.
    pub(crate) planted: Planted,
    /// The audit with the error.
    pub(crate) audit: fn() -> Audit,
    /// The audit of the same formula in the same wrapping, without the error.
    pub(crate) control: fn() -> Audit,
    /// What `check` says of a program that is the formula with the error, and of one without it.
    pub(crate) judged: [fn() -> Judged; 2],
}
