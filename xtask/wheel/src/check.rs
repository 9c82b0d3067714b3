//! Python functions, judged like programs.

use crate::audits::options;
use crate::formulas::formula;
use crate::threads::on_all_cores;
use judge::{Answer, Grade, Number};
use numpy::PyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// The points at which a function is called.
#[pyclass(frozen)]
pub(crate) struct Called {
    called: judge::Called,
    inputs: usize,
}

/// The judgement of its answers.
#[pyclass(frozen, get_all)]
pub(crate) struct Judged {
    is_well: bool,
    text: String,
    causes: Vec<String>,
    /// The parts of the verdict.
    parts: Vec<Py<Part>>,
    numbers: Vec<Py<Found>>,
}

/// A part of the verdict.
#[pyclass(frozen, get_all)]
pub(crate) struct Part {
    title: &'static str,
    conclusion: &'static str,
    right: usize,
    of: usize,
    says: String,
    details: Vec<String>,
    /// The simplest point that is not right, as JSON.
    point: Option<String>,
}

/// The result for one number of the answers.
#[pyclass(frozen, get_all)]
pub(crate) struct Found {
    name: String,
    grade: &'static str,
    checked: usize,
    off: usize,
    bound: f64,
    /// The largest η, with the computed and the exact number.
    worst: Option<(f64, f64, f64)>,
    /// The inputs there, as JSON.
    inputs: Option<String>,
}

/// An answer: numbers, `None` for those that are not computed, or a text that starts with its kind.
#[derive(FromPyObject)]
enum Said {
    Numbers(Vec<Option<f64>>),
    Words((String, String)),
}

impl From<Said> for Answer {
    fn from(said: Said) -> Self {
        match said {
            Said::Numbers(numbers) => Self::Numbers(numbers),
            Said::Words((kind, words)) => match kind.as_str() {
                "refused" => Self::Refused(Some(words).filter(|words| !words.is_empty())),
                "skipped" => Self::Skipped(words),
                _ => Self::Bad(words),
            },
        }
    }
}

#[pymethods]
impl Called {
    #[new]
    fn new(
        py: Python<'_>,
        place: usize,
        with_jacobian: bool,
        samples: Option<usize>,
        seed: Option<u64>,
        with_invalid_inputs: bool,
    ) -> PyResult<Self> {
        let formula = formula(place)?;
        let options = options(samples, seed);
        let inputs = formula.inputs().iter().map(jointproof::formula::Field::len).sum();
        let called = on_all_cores(py, || judge::Called::new(formula, with_jacobian, &options, with_invalid_inputs));
        Ok(Self { called, inputs })
    }

    /// The inputs of every point, one row each, by components in order.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows: Vec<Vec<f64>> = self.called.points().map(<[f64]>::to_vec).collect();
        if rows.is_empty() {
            return Ok(PyArray2::zeros(py, [0, self.inputs], false));
        }
        PyArray2::from_vec2(py, &rows).map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// The indices of the points, in the order in which they are asked for the second time.
    fn other_order(&self) -> Vec<usize> {
        self.called.other_order()
    }

    /// Judges both sets of answers, in the order of the points, with remarks on how they came about.
    fn judge(
        &self,
        py: Python<'_>,
        name: &str,
        first: Vec<Bound<'_, PyAny>>,
        second: Vec<Bound<'_, PyAny>>,
        strict: bool,
        noticed: Vec<String>,
    ) -> PyResult<Judged> {
        let answers = [answers(&first)?, answers(&second)?];
        let judged = on_all_cores(py, || self.called.judge(name, &answers, strict, noticed));
        let judged = judged.ok_or_else(|| PyValueError::new_err("an answer has not as many numbers as the formula"))?;
        let parts = judged.parts.into_iter().map(|(part, point)| Py::new(py, Part::of(part, point)));
        let numbers = judged.numbers.into_iter().map(|number| Py::new(py, Found::from(number)));
        Ok(Judged {
            is_well: judged.is_well,
            text: judged.text,
            causes: judged.causes,
            parts: parts.collect::<PyResult<_>>()?,
            numbers: numbers.collect::<PyResult<_>>()?,
        })
    }
}

fn answers(said: &[Bound<'_, PyAny>]) -> PyResult<Vec<Answer>> {
    said.iter().map(|said| Ok(said.extract::<Said>()?.into())).collect()
}

impl Part {
    fn of(part: judge::Part, point: Option<serde_json::Value>) -> Self {
        let judge::Part { title, standing, right: [right, of], says, details, .. } = part;
        let point = point.map(|inputs| inputs.to_string());
        Self { title, conclusion: standing.name(), right, of, says, details, point }
    }
}

impl From<Number> for Found {
    fn from(number: Number) -> Self {
        let Number { name, grade, counts: [checked, off], bound, worst, inputs } = number;
        let grade = match grade {
            Grade::Right => "right",
            Grade::Inaccurate => "inaccurate",
            Grade::Wrong => "wrong",
        };
        let worst = worst.map(|[eta, found, exact]| (eta, found, exact));
        Self { name, grade, checked, off, bound, worst, inputs: inputs.map(|inputs| inputs.to_string()) }
    }
}
