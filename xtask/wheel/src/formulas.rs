//! Formulas by their index in the catalog: their descriptions and results.

use crate::arrays::{Call, components, components_mut};
use crate::batches::BATCHES;
use crate::rows::Refused;
use crate::threads::on_all_cores;
use jointproof::Error;
use jointproof::catalog::{AnyFormula, CATALOG};
use jointproof::formula::{Field, Spec};
use jointproof::toolkit::bound::{self, Head};
use ndarray::ArrayViewMutD;
use numpy::{PyReadonlyArrayDyn, PyReadwriteArrayDyn};
use pyo3::exceptions::{PyIndexError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Value, json};

/// Why a call was rejected, as a dictionary.
type Refusal<'py> = Option<Bound<'py, PyDict>>;

/// The result, or why there is none.
type OrRefusal<'py, T> = PyResult<(Option<T>, Refusal<'py>)>;

/// The formula at this index.
pub(crate) fn formula(place: usize) -> PyResult<&'static dyn AnyFormula> {
    CATALOG.get(place).copied().ok_or_else(|| PyIndexError::new_err(format!("there is no formula in place {place}")))
}

/// All formulas in the order of the book, as JSON.
#[pyfunction]
pub(crate) fn catalog() -> String {
    CATALOG
        .iter()
        .zip(BATCHES)
        .map(|(formula, batch)| described(*formula, &(batch.entries)()))
        .collect::<Value>()
        .to_string()
}

/// What is proved of the formulas, a line each.
static PROVED: &str = include_str!(concat!(env!("OUT_DIR"), "/proved.jsonl"));

/// The bounds of η in words, with the largest η found of value and Jacobian.
pub(crate) fn accuracy(spec: &Spec, found: [Option<f64>; 2]) -> String {
    let head = PROVED.lines().filter_map(|line| Head::parse(line).ok()).find(|head| head.formula == spec.id);
    bound::accuracy(spec, head.map(|head| [head.value, head.jacobian]).as_ref(), found)
}

fn described(formula: &dyn AnyFormula, entries: &[[usize; 2]]) -> Value {
    let spec = formula.spec();
    let fields = |fields: &[Field]| fields.iter().map(field).collect::<Value>();
    json!({
        "id": spec.id,
        "title": spec.title,
        "source": spec.source.to_string(),
        "provenance": spec.source.provenance.to_string(),
        "latex": spec.latex,
        "eta": spec.eta.value,
        "eta_jacobian": spec.eta.jacobian,
        "accuracy": accuracy(&spec, [None; 2]),
        "sizes": spec.sizes(),
        "inputs": fields(formula.inputs()),
        "outputs": fields(formula.outputs()),
        "entries": entries,
    })
}

/// What is said of a field.
pub(crate) fn field(field: &Field) -> Value {
    let quantity = field.quantity;
    json!({
        "name": field.name,
        "latex": quantity.latex,
        "shape": quantity.shape.dimensions(),
        "unit": quantity.unit.to_string(),
        "allowed": quantity.domain.allowed(),
        "meaning": quantity.meaning,
    })
}

/// The kinks of a formula, as JSON: the condition in LaTeX, a point on it, and a direction across.
#[pyfunction]
pub(crate) fn kinks(py: Python<'_>, place: usize) -> PyResult<String> {
    let formula = formula(place)?;
    let kinks = py.detach(|| formula.kinks());
    let kink = |kink: &jointproof::catalog::KinkEntry| json!({ "condition": kink.condition, "at": kink.at, "across": kink.across, "one_sided": kink.one_sided });
    Ok(kinks.iter().map(kink).collect::<Value>().to_string())
}

/// The outputs at one point, by components in order, or why it is rejected.
#[pyfunction]
pub(crate) fn value_at(py: Python<'_>, place: usize, inputs: Vec<f64>) -> OrRefusal<'_, Vec<f64>> {
    one(py, formula(place)?.value(&inputs))
}

/// Outputs and Jacobian at one point, as in [`value_at`].
#[pyfunction]
pub(crate) fn linearize_at(py: Python<'_>, place: usize, inputs: Vec<f64>) -> OrRefusal<'_, (Vec<f64>, Vec<f64>)> {
    one(py, formula(place)?.value_and_jacobian(&inputs))
}

fn one<T>(py: Python<'_>, results: Result<T, Error>) -> OrRefusal<'_, T> {
    match results {
        Ok(results) => Ok((Some(results), None)),
        Err(error) => Ok((None, Refused::new(0, error, 1).into_dict(py)?)),
    }
}

/// The outputs, and the Jacobian if an array for it is given, over arrays: one per field, with the axes of the field
/// last and the shape of the call before them. Of the Jacobian, whose last two axes are components of outputs and
/// inputs, only entries that are not identically zero are written.
#[pyfunction]
pub(crate) fn over_arrays<'py>(
    py: Python<'py>,
    place: usize,
    shape: Vec<usize>,
    inputs: Vec<PyReadonlyArrayDyn<'py, f64>>,
    mut outputs: Vec<PyReadwriteArrayDyn<'py, f64>>,
    mut jacobian: Option<PyReadwriteArrayDyn<'py, f64>>,
) -> PyResult<Refusal<'py>> {
    let formula = formula(place)?;
    let batch = &BATCHES[place];
    let mut columns = Vec::new();
    for (field, array) in formula.inputs().iter().zip(&inputs) {
        let axes = axes(field);
        has_axes(array.as_array().ndim(), &shape, axes)?;
        columns.extend(components(array.as_array(), axes));
    }
    let mut results = Vec::new();
    for (field, array) in formula.outputs().iter().zip(&mut outputs) {
        let axes = axes(field);
        has_axes(array.as_array().ndim(), &shape, axes)?;
        results.extend(components_mut(array.as_array_mut(), axes));
    }
    let with_jacobian = jacobian.is_some();
    if let Some(jacobian) = &mut jacobian {
        has_axes(jacobian.as_array().ndim(), &shape, 2)?;
        let all = components_mut(jacobian.as_array_mut(), 2);
        results.extend(chosen(all, &(batch.entries)(), columns.len()));
    }
    let call = Call::new(&shape, columns, results).ok_or_else(another_shape)?;
    let refused = if call.is_small() {
        py.detach(|| call.run(batch, with_jacobian))
    } else {
        on_all_cores(py, || call.run(batch, with_jacobian))
    };
    refused.map_err(|error| PyRuntimeError::new_err(error.to_string()))?.into_dict(py)
}

/// Selects the arrays of a Jacobian that belong to these entries, which are in order.
fn chosen<'a>(
    all: Vec<ArrayViewMutD<'a, f64>>,
    entries: &[[usize; 2]],
    inputs: usize,
) -> impl Iterator<Item = ArrayViewMutD<'a, f64>> {
    let mut places = entries.iter().map(move |[output, input]| output * inputs + input).peekable();
    all.into_iter().enumerate().filter(move |(place, _)| places.next_if_eq(place).is_some()).map(|(_, array)| array)
}

/// The number of axes of a field.
fn axes(field: &Field) -> usize {
    field.quantity.shape.dimensions().len()
}

fn has_axes(found: usize, shape: &[usize], axes: usize) -> PyResult<()> {
    if found == shape.len() + axes { Ok(()) } else { Err(another_shape()) }
}

fn another_shape() -> PyErr {
    PyValueError::new_err("an array has not the shape of the call")
}

/// The outputs, and the entries of the Jacobian, in 237 bits at one point: decimal numbers with the fewest digits that
/// identify them. On a switch there is no Jacobian.
#[pyfunction]
pub(crate) fn exact(
    py: Python<'_>,
    place: usize,
    inputs: Vec<f64>,
    with_jacobian: bool,
) -> OrRefusal<'_, (Vec<String>, Option<Vec<String>>)> {
    let formula = formula(place)?;
    let truth = py.detach(|| formula.judge().at(&inputs, with_jacobian));
    let numbers =
        |known: Vec<jointproof::toolkit::verify::Known>| known.iter().map(|known| known.exact.to_string()).collect();
    one(py, truth.map(|truth| (numbers(truth.value), truth.jacobian.map(numbers))))
}
