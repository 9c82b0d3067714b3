//! The operations of formulas and elements, from which the build prints them for arrays of any library.

use crate::formulas::field;
use crate::threads::on_all_cores;
use jointproof::catalog::{AnyElement, AnyFormula, CATALOG, ELEMENTS};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Extremes, Graph, NotRecorded};
use pyo3::prelude::*;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde_json::{Value, json};

/// The programs of all formulas and all elements, as JSON, each with its identifier and what it is.
#[pyfunction]
pub(crate) fn programs(py: Python<'_>) -> String {
    let forms: Vec<_> = ELEMENTS.iter().flat_map(|&element| [false, true].map(|rubs| (element, rubs))).collect();
    let has = |(element, rubs): &&(&'static dyn AnyElement, bool)| !rubs || !element.layout().contact.is_empty();
    let (formulas, elements): (Vec<_>, Vec<_>) = on_all_cores(py, || {
        rayon::join(
            || CATALOG.par_iter().map(|formula| of_formula(*formula)).collect(),
            || forms.par_iter().filter(has).map(|(element, rubs)| of_element(*element, *rubs)).collect(),
        )
    });
    json!({ "formulas": formulas, "elements": elements }).to_string()
}

fn of_formula(formula: &dyn AnyFormula) -> Value {
    let graph = formula.graph_with(Extremes::Ignored);
    json!({ "id": formula.spec().id, "program": program(graph, formula.inputs()) })
}

fn of_element(element: &dyn AnyElement, rubs: bool) -> Value {
    let (spec, layout, inputs) = (element.spec(), element.layout(), element.inputs(rubs));
    let len = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let [n, m, held] = [layout.unknowns, layout.residuals, layout.multipliers].map(len);
    let after = if rubs { len(layout.state) } else { 0 };
    json!({
        "id": spec.id,
        "title": spec.title,
        "source": spec.source.to_string(),
        "rubs": rubs,
        "inputs": inputs.iter().map(field).collect::<Vec<_>>(),
        "unknowns": layout.unknowns.iter().map(field).collect::<Vec<_>>(),
        "outputs": [
            ("residuals", vec![m]),
            ("rows", vec![m, n]),
            ("forces", vec![n]),
            ("stiffness", vec![n, n]),
            ("by_multipliers", vec![n, held]),
            ("after", vec![after]),
        ],
        "program": program(element.graph(rubs, Extremes::Ignored), inputs),
    })
}

/// Operations and results by their places, conditions on components of the inputs, and what is required of all of them; or why there
/// is no program.
fn program(graph: Result<Graph, NotRecorded>, inputs: &[Field]) -> Value {
    let graph = match graph {
        Ok(graph) => graph,
        Err(why) => return json!({ "missing": why.to_string() }),
    };
    let text = graph.text(inputs);
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect("a line is JSON")).collect();
    let conditions = inputs.iter().flat_map(|field| vec![field.quantity.domain.comparisons(); field.len()]);
    let required: Vec<_> = graph.refusals.iter().map(jointproof::Error::required).collect();
    json!({
        "lines": lines,
        "conditions": conditions.collect::<Vec<_>>(),
        "refusal": graph.refusal.map(jointproof::toolkit::graph::Node::index),
        "required": required,
    })
}
