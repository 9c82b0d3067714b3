//! Evaluations are `#[inline]`.
//!
//! `eval`, `jacobian` and `linearized` are generic, so each crate that calls them compiles them, but only once, in one
//! of its codegen units. `validate` and what is built on it is not even compiled by each crate. Without the attribute,
//! it is chance whether a caller is in the same unit, and many equations cost less than a call. With it every unit may
//! inline them, the compiler decides, and value and Jacobian evaluated together share common subexpressions.
//! `#[inline(always)]` is used where the compiler decides wrongly.

use super::finding::Finding;
use super::tree::Tree;

/// The functions of a formula that are called in loops.
const EVALUATIONS: [&str; 6] = ["eval", "jacobian", "linearized", "validate", "try_eval", "try_linearized"];

/// Every evaluation function without `#[inline]`.
pub(super) fn missing(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for source in &tree.sources {
        for formula in &source.formulas {
            let evaluations = formula.functions.iter().filter(|(name, ..)| EVALUATIONS.contains(&name.as_str()));
            findings.extend(evaluations.filter(|(.., is_inlined)| !is_inlined).map(|(name, line, _)| {
                let what = format!("`{}::{name}` is not `#[inline]`; put that above it", formula.name);
                Finding::new(&source.path, *line, what)
            }));
        }
    }
    findings
}
