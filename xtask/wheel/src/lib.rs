//! The compiled part of the Python package `jointproof`: formulas over NumPy arrays, exact numbers, audits, checks, scenes.
//!
//! Arrays are read and written in place, with the interpreter's lock released. Descriptions of formulas and audits are passed as
//! JSON; names, broadcasting and errors are handled by the package in `python/jointproof`.

#![expect(clippy::needless_pass_by_value, reason = "what comes from Python is handed over")]

mod arrays;
mod audits;
mod batches;
mod check;
mod formulas;
mod programs;
mod rows;
mod scene;
mod threads;

use pyo3::pymodule;

/// The compiled part of the package `jointproof`.
#[pymodule]
mod _jointproof {
    /// The version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use super::audits::{audit, audit_part, audit_text, merge_all, merge_parts};
    #[pymodule_export]
    use super::check::{Called, Found, Judged};
    #[pymodule_export]
    use super::formulas::{catalog, exact, kinks, linearize_at, over_arrays, value_at};
    #[pymodule_export]
    use super::programs::programs;
    #[pymodule_export]
    use super::scene::{Scene, Series};
}
