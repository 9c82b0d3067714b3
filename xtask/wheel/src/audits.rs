//! Audits, and parts of them, as JSON.

use crate::formulas::accuracy;
use crate::threads::on_all_cores;
use jointproof::catalog::{AnyFormula, CATALOG, find};
use jointproof::toolkit::verify::{Audit, Options, Part, Shard};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

fn found(id: &str) -> PyResult<&'static dyn AnyFormula> {
    find(id).ok_or_else(|| PyKeyError::new_err(id.to_owned()))
}

fn invalid(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

fn written(value: &impl serde::Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(invalid)
}

fn read<T: serde::de::DeserializeOwned>(text: &str) -> PyResult<T> {
    serde_json::from_str(text).map_err(invalid)
}

/// Options not given have the defaults of the commands.
pub(crate) fn options(samples: Option<usize>, seed: Option<u64>) -> Options {
    let usual = Options::default();
    Options { samples: samples.unwrap_or(usual.samples), seed: seed.unwrap_or(usual.seed) }
}

/// The audits of these formulas.
#[pyfunction]
pub(crate) fn audit(py: Python<'_>, ids: Vec<String>, samples: Option<usize>, seed: Option<u64>) -> PyResult<String> {
    let formulas = ids.iter().map(|id| found(id)).collect::<PyResult<Vec<_>>>()?;
    let options = options(samples, seed);
    let audits = on_all_cores(py, || formulas.par_iter().map(|formula| formula.audit(&options)).collect::<Vec<_>>());
    written(&audits)
}

/// A part of the audit of a formula, given by its number, counted from 1, and the number of parts.
#[pyfunction]
pub(crate) fn audit_part(
    py: Python<'_>,
    id: &str,
    samples: Option<usize>,
    seed: Option<u64>,
    index: usize,
    of: usize,
) -> PyResult<String> {
    let formula = found(id)?;
    let shard = Shard::new(index, of).map_err(invalid)?;
    let options = options(samples, seed);
    written(&on_all_cores(py, || formula.audit_part(&options, shard)))
}

/// Merges two consecutive parts.
#[pyfunction]
pub(crate) fn merge_parts(one: &str, next: &str) -> PyResult<String> {
    written(&read::<Part>(one)?.and(read(next)?).map_err(invalid)?)
}

/// Merges parts into audits in the order of the catalog; the order of the parts does not matter.
#[pyfunction]
pub(crate) fn merge_all(parts: Vec<String>) -> PyResult<String> {
    let mut parts = parts.iter().map(|part| read::<Part>(part)).collect::<PyResult<Vec<_>>>()?;
    let place = |part: &Part| CATALOG.iter().position(|formula| formula.spec().id == part.formula());
    parts.sort_by_cached_key(|part| (place(part), part.first()));
    let mut audits = Vec::new();
    let mut rest = parts.into_iter().peekable();
    while let Some(mut whole) = rest.next() {
        while let Some(next) = rest.next_if(|next| next.formula() == whole.formula()) {
            whole = whole.and(next).map_err(invalid)?;
        }
        audits.push(whole.into_audit().map_err(invalid)?);
    }
    written(&audits)
}

/// The report of audits, and whether all of them passed.
#[pyfunction]
pub(crate) fn audit_text(audits: &str) -> PyResult<(String, bool)> {
    let audits: Vec<Audit> = read(audits)?;
    let accuracy = |audit: &Audit| find(&audit.formula).map(|formula| accuracy(&formula.spec(), audit.largest_eta()));
    let text = judge::audited::text(&audits, Audit::passed, &accuracy).map_err(invalid)?;
    Ok((judge::console::plain(&text), audits.iter().all(Audit::passed)))
}
