//! Every method over all formulas: quantiles of time and error, and the evaluations that a method needs.

use super::data::Report;
use jointproof::toolkit::measure::{Figures, Measurement, Scheme};
use std::fmt::Write;

/// Quantiles over formulas: a tenth are below the first, half below the second, a tenth above the third.
pub(crate) type Quantiles = [f64; 3];

/// A method over all formulas.
pub(crate) struct Spread {
    /// The identifier of the method; of differences with a step chosen beforehand, that of the scheme and `-fixed`.
    pub(crate) id: String,
    pub(crate) title: String,
    /// Evaluations of the value for `n` inputs.
    pub(crate) evaluations: &'static str,
    /// Nanoseconds for value and Jacobian.
    pub(crate) times: Quantiles,
    /// The same, divided by the closed form's.
    pub(crate) ratios: Quantiles,
    /// The same, divided by the evaluations and by the time of a value in closed form.
    pub(crate) each: Quantiles,
    /// Relative error of the Jacobian: the median over the random points of a formula.
    pub(crate) errors: Quantiles,
    /// Ratio and error of each formula.
    pub(crate) formulas: Vec<[f64; 2]>,
}

/// The identifier of a method, and the evaluations of the value for `n` inputs in words and as a function.
type Method = (&'static str, &'static str, fn(usize) -> usize);

/// The methods that every formula has.
const METHODS: [Method; 9] = [
    ("closed", "1", |_| 1),
    ("single", "1", |_| 1),
    ("ad", "⌈n/4⌉", |n| n.div_ceil(4)),
    ("complex", "n complex + 1", |n| n + 1),
    ("forward", "n + 1", |n| n + 1),
    ("central", "2n + 1", |n| 2 * n + 1),
    ("fourth", "4n + 1", |n| 4 * n + 1),
    ("octuple", "1", |_| 1),
    ("octuple-ad", "⌈n/4⌉", |n| n.div_ceil(4)),
];

/// Whether every formula has this method.
pub(crate) fn is_common(id: &str) -> bool {
    id == "checked" || METHODS.iter().any(|(common, ..)| *common == id)
}

/// The step to choose if nothing is known, relative to the input: its truncation error is as large as the rounding error.
fn usual_step(scheme: Scheme) -> f64 {
    let u = f64::EPSILON / 2.0;
    match scheme {
        Scheme::Forward => u.sqrt(),
        Scheme::Central => u.cbrt(),
        Scheme::Fourth => u.powf(0.2),
    }
}

/// The error of differences at the tested step that is nearest to the usual one.
fn error_at_usual_step(measurement: &Measurement, scheme: Scheme) -> Option<f64> {
    let curve = measurement.curves.iter().find(|curve| curve.scheme == scheme)?;
    let far = |step: f64| (step / usual_step(scheme)).ln().abs();
    curve.points().min_by(|one, other| far(one.0).total_cmp(&far(other.0))).map(|(_, error)| error)
}

/// All methods, differences with the usual step in addition to the best.
pub(crate) fn spreads(report: &Report) -> Vec<Spread> {
    let measured = METHODS.iter().map(|&(id, evaluations, count)| {
        let error = |measurement: &Measurement| Some(jacobian(measurement, id)?.random.relative);
        spread(report, id, [id, ""], evaluations, count, error)
    });
    let fixed = Scheme::ALL.into_iter().map(|scheme| {
        let &(id, evaluations, count) = METHODS.iter().find(|(id, ..)| *id == scheme.id())?;
        spread(report, id, [&format!("{id}-fixed"), ", fixed step"], evaluations, count, |measurement| {
            error_at_usual_step(measurement, scheme)
        })
    });
    measured.chain(fixed).flatten().collect()
}

fn jacobian<'m>(measurement: &'m Measurement, id: &str) -> Option<&'m Figures> {
    measurement.method(id)?.jacobian.as_ref()
}

fn spread(
    report: &Report,
    id: &str,
    [shown, addition]: [&str; 2],
    evaluations: &'static str,
    count: fn(usize) -> usize,
    error: impl Fn(&Measurement) -> Option<f64>,
) -> Option<Spread> {
    let (mut times, mut each, mut formulas) = (Vec::new(), Vec::new(), Vec::new());
    for measurement in &report.formulas {
        let time = |id| jacobian(measurement, id).and_then(|figures| figures.time).map(|time| time.median);
        let value = measurement.method("closed").and_then(|method| method.value.as_ref()?.time);
        let (Some(time), Some(closed), Some(value), Some(error)) =
            (time(id), time("closed"), value, error(measurement))
        else {
            continue;
        };
        #[expect(clippy::cast_precision_loss, reason = "a few inputs")]
        each.push(time / (value.median * count(measurement.inputs) as f64));
        times.push(time);
        formulas.push([time / closed, error]);
    }
    let title = &report.formulas.first()?.method(id)?.title;
    let [ratios, errors] = [0, 1].map(|k| quantiles(formulas.iter().map(|formula| formula[k]).collect()));
    Some(Spread {
        id: shown.into(),
        title: format!("{title}{addition}"),
        evaluations,
        times: quantiles(times),
        ratios,
        each: quantiles(each),
        errors,
        formulas,
    })
}

fn quantiles(mut all: Vec<f64>) -> Quantiles {
    all.sort_by(f64::total_cmp);
    let last = all.len().saturating_sub(1);
    [1, 5, 9].map(|tenths| all.get(last * tenths / 10).copied().unwrap_or(0.0))
}

/// The report as comma-separated values: a row a formula and method.
pub(crate) fn csv(report: &Report) -> String {
    let mut text = "formula,inputs,outputs,method,step,value_ns,jacobian_ns,jacobian_ns_low,jacobian_ns_high,\
                    eta_median,eta_99,eta_max,relative_error,eta_max_at_hard_points\n"
        .to_owned();
    for measurement in &report.formulas {
        for method in &measurement.methods {
            let value = method.value.as_ref().and_then(|figures| figures.time).map(|time| time.median);
            let figures = method.jacobian.as_ref();
            let time = figures.and_then(|figures| figures.time);
            let random = figures.map(|figures| &figures.random);
            let numbers = [
                method.step,
                value,
                time.map(|time| time.median),
                time.map(|time| time.low),
                time.map(|time| time.high),
                random.map(|errors| errors.eta.median),
                random.map(|errors| errors.eta.p99),
                random.map(|errors| errors.eta.max),
                random.map(|errors| errors.relative),
                figures.and_then(|figures| figures.hard.as_ref()).map(|errors| errors.eta.max),
            ];
            let numbers = numbers.map(|number| number.map_or(String::new(), |x| format!("{x:e}"))).join(",");
            let Measurement { formula, inputs, outputs, .. } = measurement;
            let _ = writeln!(text, "{formula},{inputs},{outputs},{},{numbers}", method.id);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_of_all_formulas() {
        assert_eq!(quantiles((0..=10).rev().map(f64::from).collect()), [1.0, 5.0, 9.0]);
        assert_eq!((quantiles(vec![3.0]), quantiles(Vec::new())), ([3.0; 3], [0.0; 3]));
    }

    #[test]
    fn every_method_is_compared_with_the_closed_form() {
        let report = crate::sample::report();
        let spreads = spreads(&report);
        let closed = spreads.iter().find(|spread| spread.id == "closed").unwrap();
        // Of the second formula the value alone was not timed.
        assert_eq!((closed.ratios, closed.formulas.len()), ([1.0; 3], 1));
        let rows = csv(&report);
        let columns = |line: &str| line.matches(',').count();
        let head = rows.lines().next().unwrap();
        assert!(
            rows.lines().count() > report.formulas.len() && rows.lines().all(|line| columns(line) == columns(head))
        );
    }

    #[test]
    fn the_step_chosen_beforehand_is_the_tested_one_nearest_to_the_usual() {
        let [forward, central, fourth] = Scheme::ALL.map(usual_step);
        assert!((forward / 1.05e-8 - 1.0).abs() < 0.01 && (central / 4.8e-6 - 1.0).abs() < 0.01 && fourth < 1e-3);
    }
}
