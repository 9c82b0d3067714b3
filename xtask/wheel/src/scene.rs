//! Scenes: columns of results.

use crate::threads::on_all_cores;
use jointproof::scene;
use numpy::PyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::path::PathBuf;

/// The results of a scene.
#[pyclass(frozen, get_all)]
pub(crate) struct Scene {
    title: String,
    times: Vec<f64>,
    counts: Vec<(&'static str, usize)>,
    series: Vec<Py<Series>>,
    /// What was ambiguous, in words.
    warnings: Vec<String>,
    /// What was ignored, in words.
    notes: Vec<String>,
}

/// A table of a history: a name in messages and its text, or a file.
#[derive(FromPyObject)]
enum Table {
    Text(String, Vec<u8>),
    File(PathBuf),
}

impl From<Table> for scene::Table {
    fn from(table: Table) -> Self {
        match table {
            Table::Text(name, text) => Self::text(&name, text),
            Table::File(path) => Self::file(&path),
        }
    }
}

/// An output of an element over the states, one row per state: NaN where it is not available.
#[pyclass(frozen, get_all)]
pub(crate) struct Series {
    element: String,
    output: &'static str,
    values: Py<PyArray2<f64>>,
}

fn invalid(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl Scene {
    /// Evaluates the text of a scene file, which may refer to files in this folder, in doubles, or in 237 bits rounded once; with
    /// tables of nodes, loads and pressures as its history if there are any.
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        exact: bool,
        folder: Option<PathBuf>,
        tables: [Option<Table>; 3],
    ) -> PyResult<Self> {
        let [nodes, loads, pressures] = tables.map(|table| table.map(scene::Table::from));
        let results = on_all_cores(py, || {
            let parsed = match &folder {
                Some(folder) => scene::Scene::parse_in(folder, text),
                None => scene::Scene::parse(text),
            };
            let mut scene = parsed.map_err(|error| error.to_string())?;
            if nodes.is_some() || loads.is_some() || pressures.is_some() {
                let tables = scene::Tables { nodes, loads, pressures };
                scene = scene.with_tables(tables).map_err(|fault| fault.to_string())?;
            }
            let results = if exact { scene::Results::exact(&scene) } else { scene::Results::of(&scene) };
            Ok((results.map_err(|error| error.to_string())?, scene.notes().to_vec()))
        });
        let (results, notes) = results.map_err(|error: String| invalid(error))?;
        let scene::Results { title, times, counts, series, warnings, .. } = results;
        let series = series.into_iter().map(|series| Py::new(py, Series::of(py, series)?));
        Ok(Self { title, times, counts, series: series.collect::<PyResult<_>>()?, warnings, notes })
    }
}

impl Series {
    fn of(py: Python<'_>, series: scene::Series) -> PyResult<Self> {
        let scene::Series { element, output, values } = series;
        let width = values.width();
        let row = |state: &[f64]| if state.is_empty() { vec![f64::NAN; width] } else { state.to_vec() };
        let rows: Vec<Vec<f64>> = values.iter().map(row).collect();
        let values = PyArray2::from_vec2(py, &rows).map_err(invalid)?.unbind();
        Ok(Self { element, output, values })
    }
}
