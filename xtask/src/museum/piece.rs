//! What is said of an error.

use jointproof::toolkit::verify::Audit;

/// An error, re-enacted.
pub(crate) struct Piece {
    /// Where it was told of, in public.
    pub(crate) thread: &'static str,
    /// What was wrong there.
    pub(crate) there: &'static str,
    /// What is wrong here.
    pub(crate) here: &'static str,
    /// The formula in which it is made again.
    pub(crate) formula: &'static str,
    /// A part of the claim that catches it.
    pub(crate) claim: &'static str,
    /// The audit with the error in it.
    pub(crate) audit: fn() -> Audit,
    /// The audit of the same formula in the same wrapping, without the error.
    pub(crate) control: fn() -> Audit,
}
