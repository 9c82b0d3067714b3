//! Plots of results over the history.

use crate::figures::chart::{Axis, Chart, Curve};
use jointproof::scene::Results;

/// The largest number of curves in a chart; a fifth style would not be distinguishable from the first.
const CURVES: usize = 4;

/// An SVG for each output with one component; none if there is only one state.
pub(crate) fn charts(results: &Results) -> Vec<(&'static str, String)> {
    let mut outputs: Vec<&'static str> = Vec::new();
    for series in &results.series {
        let drawable = results.times.len() > 1 && series.values.width() <= 1;
        if drawable && !outputs.contains(&series.output) {
            outputs.push(series.output);
        }
    }
    outputs.into_iter().map(|output| (output, chart(results, output, output, output, ""))).collect()
}

/// One output over time.
pub(crate) fn chart(results: &Results, output: &str, name: &str, label: &str, description: &str) -> String {
    let alone = results.series.iter().filter(|series| series.output == output).count() == 1;
    let of_output = results.series.iter().filter(|series| series.output == output).take(CURVES);
    let curves: Vec<_> = of_output
        .enumerate()
        .map(|(k, series)| {
            let values = results.times.iter().zip(series.values.iter());
            let points: Vec<_> = values.filter_map(|(&time, values)| Some((time, *values.first()?))).collect();
            // The names are written at different points, so that they do not overlap.
            let label_at = points.len() * (k + 1) / (CURVES + 1);
            // A single curve needs no name: the axis names the quantity.
            let name = if alone { "" } else { &*series.element };
            Curve { name, label_at, points }
        })
        .collect();
    let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|&(_, value)| value));
    let what = label.split(',').next().unwrap_or(label);
    let title = format!("{what} over time");
    let description = if description.is_empty() { &title } else { description };
    Chart {
        name,
        title: &title,
        description,
        x: axis("time", results.times.iter().copied()),
        y: axis(label, values()),
        curves,
    }
    .svg()
}

/// A linear axis with round ticks that contains the values.
fn axis(label: &str, values: impl Iterator<Item = f64>) -> Axis<'_> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    // A constant needs an interval of non-zero length.
    let room = if high > low { 0.0 } else { high.abs().max(1e-300) * 0.5 };
    let (low, high) = (low - room, high + room);
    let rough = (high - low) / 5.0;
    let decade = 10_f64.powf(rough.log10().floor());
    let step =
        [1.0, 2.0, 5.0, 10.0].map(|factor| factor * decade).into_iter().find(|&step| step >= rough).unwrap_or(rough);
    let (first, last) = ((low / step).floor(), (high / step).ceil());
    // Divided by the reciprocal if that is an integer, so that 0.1 × 3 is printed as 0.3.
    let tick = |k: f64| if step < 1.0 { k / (1.0 / step).round() } else { k * step };
    let mut ticks = Vec::new();
    let mut k = first;
    while k <= last && ticks.len() < 20 {
        ticks.push(tick(k));
        k += 1.0;
    }
    Axis { label, from: first * step, to: last * step, logarithmic: false, ticks }
}
