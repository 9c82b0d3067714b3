//! The description of an error.

use jointproof::toolkit::verify::Audit;
use judge::Judged;

/// A re-enacted error.
pub(crate) struct Piece {
    /// The public thread that reported it.
    pub(crate) thread: &'static str,
    /// What was wrong in the original.
    pub(crate) there: &'static str,
    /// What is wrong in the re-enactment.
    pub(crate) here: &'static str,
    /// The formula in which it is re-enacted.
    pub(crate) formula: &'static str,
    /// A part of the claim that detects it.
    pub(crate) claim: &'static str,
    /// The audit with the error.
    pub(crate) audit: fn() -> Audit,
    /// The audit of the same formula in the same wrapping, without the error.
    pub(crate) control: fn() -> Audit,
    /// What `check` says of a program that is the formula with the error, and of one without it.
    pub(crate) judged: [fn() -> Judged; 2],
}
