//! Records the graph of a formula, or explains why there is none.

use super::node::Graph;
use super::recorder::{self, Escape, Extremes, Failure, MOST_RUNS};
use super::traced::Traced;
use crate::formula::error::Error;
use crate::formula::proof::{self, ProvedElement, Step};
use crate::formula::{Field, Fields, Formula, entries};
use std::any::TypeId;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::fmt;
use std::sync::{LazyLock, Mutex, OnceLock, PoisonError};

/// Why a formula was not recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotRecorded {
    /// The value of a number that depends on the inputs is requested as a double.
    Value,
    /// It calls a function that the graph does not know.
    Function(&'static str),
    /// Its comparisons have more combinations of outcomes than this.
    Combinations(usize),
    /// It does not terminate, whatever the outcomes of comparisons.
    Endless,
    /// It panics, whatever the outcomes of comparisons.
    Panics,
}

impl fmt::Display for NotRecorded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value => f.write_str("the value of a number that depends on the inputs leaves the graph as a double"),
            Self::Function(name) => write!(f, "it calls {name}, which the graph does not know"),
            Self::Combinations(most) => write!(f, "its comparisons come out in more than {most} ways"),
            Self::Endless => f.write_str("it does not end where comparisons come out as they like"),
            Self::Panics => f.write_str("it panics where comparisons come out as they like"),
        }
    }
}

impl std::error::Error for NotRecorded {}

/// The graph of a formula.
///
/// # Errors
/// The reason why the formula cannot be recorded.
pub fn record<F: Formula>() -> Result<Graph, NotRecorded> {
    record_with::<F>(Extremes::Computed)
}

/// The graph of a formula, recorded once per process and kept while it runs: in unoptimised builds recording takes seconds.
pub(crate) fn recorded<F: Formula>() -> &'static Result<Graph, NotRecorded> {
    type Place = OnceLock<Result<Graph, NotRecorded>>;
    static GRAPHS: LazyLock<Mutex<HashMap<TypeId, &'static Place>>> = LazyLock::new(Mutex::default);
    let place = *GRAPHS.lock().unwrap_or_else(PoisonError::into_inner).entry(TypeId::of::<F>()).or_insert_with(|| {
        // One leak per formula.
        Box::leak(Box::default())
    });
    place.get_or_init(record::<F>)
}

/// The graph of a formula with the given treatment of extreme numbers.
///
/// # Errors
/// The reason why the formula cannot be recorded.
pub fn record_with<F: Formula>(extremes: Extremes) -> Result<Graph, NotRecorded> {
    let inputs = || traced::<F::Inputs<Traced>>();
    let results = || {
        if const { F::SPEC.is_closed() } {
            let (value, jacobian) = F::linearized(&inputs());
            [value.components(), entries(&jacobian)]
        } else {
            [F::eval(&inputs()).components(), Vec::new()]
        }
    };
    written(extremes, &|| F::validate(&inputs()), &results)
}

/// The graph of an element with or without friction: its inputs are nodes, multipliers, start, contact and state, its results
/// residuals, rows, forces, stiffness, derivative with respect to the multipliers, and the state after the step.
///
/// # Errors
/// The reason why the element cannot be recorded.
pub fn record_element<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize>(
    rubs: bool,
    extremes: Extremes,
) -> Result<Graph, NotRecorded> {
    let validate = |inputs: &[Traced]| {
        let Step { nodes, parameters, .. } = Step::<E, Traced, M, DOFS>::of(inputs, rubs);
        E::validate(&nodes, &parameters)
    };
    let results = |inputs: &[Traced]| Step::<E, Traced, M, DOFS>::of(inputs, rubs).results();
    record_step(proof::inputs::<E, M, DOFS>(rubs), extremes, &validate, &results)
}

/// The graph of a function of these inputs that has the results of an element.
///
/// # Errors
/// The reason why it cannot be recorded.
pub(crate) fn record_step(
    inputs: &[Field],
    extremes: Extremes,
    validate: &dyn Fn(&[Traced]) -> Result<(), Error>,
    results: &dyn Fn(&[Traced]) -> Vec<Traced>,
) -> Result<Graph, NotRecorded> {
    let number: usize = inputs.iter().map(Field::len).sum();
    let inputs = || (0..number).map(Traced::input).collect::<Vec<_>>();
    let all = || [results(&inputs()), Vec::new()];
    Ok(written(extremes, &|| validate(&inputs()), &all)?.without_zero_terms())
}

/// The inputs of a formula.
fn traced<I: Fields<Traced>>() -> I {
    let inputs: Vec<_> = (0..I::LEN).map(Traced::input).collect();
    I::from_slice(&inputs).expect("so many were made")
}

/// The graph of `validate`, value and Jacobian.
fn written(
    extremes: Extremes,
    validate: &dyn Fn() -> Result<(), Error>,
    results: &dyn Fn() -> [Vec<Traced>; 2],
) -> Result<Graph, NotRecorded> {
    let (errors, values) = (RefCell::new(Vec::new()), Cell::new(0));
    let refusal = || vec![Traced::from(refusal(validate(), &errors)).node()];
    let results = || {
        let [value, jacobian] = results();
        no_value_was_asked();
        values.set(value.len());
        value.into_iter().chain(jacobian).map(Traced::node).collect()
    };
    let (mut graph, [refusal, results]) = recorder::record(extremes, [&refusal, &results])?;
    let (value, jacobian) = results.split_at(values.get());
    (graph.value, graph.jacobian) = (value.to_vec(), jacobian.to_vec());
    graph.refusals = errors.into_inner();
    graph.refusal = refusal.first().copied().filter(|_| !graph.refusals.is_empty());
    let graph = graph.pruned();
    // Where both sides of every choice are computed, no work is shared by choices.
    Ok(if extremes == Extremes::Ignored { graph } else { graph.gathered() })
}

/// 0 if the inputs are valid together, else the position of the error among all errors, from 1.
fn refusal(found: Result<(), Error>, errors: &RefCell<Vec<Error>>) -> f64 {
    let Err(error) = found else {
        no_value_was_asked();
        return 0.0;
    };
    // An error contains values.
    recorder::has_asked();
    let mut errors = errors.borrow_mut();
    let position = errors.iter().position(|known: &Error| known.is_alike(&error));
    let position = position.unwrap_or(errors.len());
    if position == errors.len() {
        errors.push(error);
    }
    f64::from(u32::try_from(position + 1).expect("a formula has few refusals"))
}

fn no_value_was_asked() {
    if recorder::has_asked() {
        recorder::escape(Escape::Value);
    }
}

impl From<Failure> for NotRecorded {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Panic => Self::Panics,
            Failure::Escape(Escape::Value) => Self::Value,
            Failure::Escape(Escape::Function(name)) => Self::Function(name),
            Failure::Escape(Escape::Combinations) => Self::Combinations(MOST_RUNS),
            Failure::Escape(Escape::Endless) => Self::Endless,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::contact::coulomb::ReturnMap;

    #[test]
    fn the_graph_of_each_formula_is_kept() {
        let (slips, touches, again) = (recorded::<ReturnMap>(), recorded::<ContactForce>(), recorded::<ReturnMap>());
        assert!(std::ptr::eq(slips, again));
        let value = |graph: &Result<Graph, _>, inputs: &[f64]| graph.as_ref().expect("it is recorded").run(inputs).0;
        assert_eq!([value(slips, &[3.0, 0.5, 4.0]), value(touches, &[3.0, 4.0])], [[2.0], [5.0]]);
    }
}
