//! The points at which an export is compared, and what Rust finds there.

use super::recorded::Recorded;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::measure::Options;
use jointproof::verify::golden::components;

/// A point of a formula, and value and Jacobian there; `None` where the inputs are refused.
pub(super) struct Point {
    pub(super) name: String,
    pub(super) inputs: Vec<f64>,
    pub(super) results: Option<Vec<f64>>,
}

/// The points of every formula: all golden cases, valid or not, and random ones.
pub(super) fn all(recorded: &[Recorded], samples: usize) -> Vec<Vec<Point>> {
    recorded.iter().map(|one| of(one.formula, samples)).collect()
}

fn of(formula: &'static dyn AnyFormula, samples: usize) -> Vec<Point> {
    let point = |name, inputs: Vec<f64>| {
        let results = formula.value_and_jacobian(&inputs).ok();
        Point { name, results: results.map(|(value, jacobian)| [value, jacobian].concat()), inputs }
    };
    let cases = formula.golden().cases;
    let cases = cases.into_iter().filter_map(|case| {
        let inputs = components(formula.inputs(), &case.inputs).ok()?;
        Some(point(case.id, inputs))
    });
    let options = Options { timing_points: samples, ..Options::quick() };
    let random = formula.timing_inputs(&options);
    let count = formula.inputs().iter().map(Field::len).sum();
    let random = random.chunks(count).enumerate().map(|(k, inputs)| point(format!("random {k}"), inputs.to_vec()));
    cases.chain(random).collect()
}
