//! What checks cost, and what the hardest points do.

use super::data::Report;
use crate::console::figure;
use jointproof::measure::{Measurement, PointTime};

/// What is said to hold of every formula: time at the hardest ordinary point, in units of that at random ones.
pub(crate) const HARDEST: f64 = 10.0;

/// Time of the checked value and Jacobian in units of the unchecked.
pub(crate) fn of_checks(measurement: &Measurement) -> Option<f64> {
    let time = |id| Some(measurement.way(id)?.jacobian.as_ref()?.time?.median);
    Some(time("checked")? / time("closed")?)
}

/// The ordinary point at which the closed form takes longest, and whether that is the value or the value with Jacobian.
pub(crate) fn hardest(measurement: &Measurement) -> Option<(&'static str, &PointTime)> {
    let closed = measurement.way("closed")?;
    let parts = [("value", &closed.value), ("value and Jacobian", &closed.jacobian)];
    let points = parts.into_iter().filter_map(|(part, figures)| Some((part, figures.as_ref()?.hardest()?)));
    points.max_by(|a, b| a.1.ratio.median.total_cmp(&b.1.ratio.median))
}

/// What is said of one formula.
pub(crate) fn said(measurement: &Measurement) -> Option<String> {
    let checks = of_checks(measurement)?;
    let hardest = hardest(measurement).map_or(String::new(), |(part, point)| {
        let ratio = figure(point.ratio.median);
        format!(
            "; at its hardest ordinary point, {}, the {part} takes {ratio} times as long as at random ones",
            point.case
        )
    });
    Some(format!("checked, value and Jacobian take {checks:.2} times as long{hardest}"))
}

/// What is said of all.
pub(crate) fn summary(report: &Report) -> Option<String> {
    let mut checks: Vec<_> = report.formulas.iter().filter_map(|one| Some((of_checks(one)?, one))).collect();
    checks.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (worst, dearest) = checks.last()?;
    let mean =
        (checks.iter().map(|(ratio, _)| ratio.ln()).sum::<f64>() / f64::from(u32::try_from(checks.len()).ok()?)).exp();
    let beyond = report.formulas.iter().filter_map(|one| Some((one, hardest(one)?)));
    let beyond: Vec<_> = beyond
        .filter(|(_, (_, point))| point.ratio.median > HARDEST)
        .map(|(one, (_, point))| format!("{} at {} ({})", one.formula, point.case, figure(point.ratio.median)))
        .collect();
    let beyond = if beyond.is_empty() { "none".to_owned() } else { beyond.join(", ") };
    Some(format!(
        "Checks: value and Jacobian take {mean:.2} times as long in the geometric mean, {worst:.2} times in the worst \
         ({}). Above {HARDEST} times the time of random points at an ordinary hard one: {beyond}.",
        dearest.formula
    ))
}
