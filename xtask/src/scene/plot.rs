//! Plots of results over the history.

use jointproof::scene::Results;
use kit::{Axis, Chart, Curve};

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
    outputs.into_iter().map(|output| (output, chart(results, output, output, ["time", output], ""))).collect()
}

/// The first component of an output over what the results have as times; `labels` are those of the axes.
pub(crate) fn chart(results: &Results, output: &str, name: &str, labels: [&str; 2], description: &str) -> String {
    let [x, label] = labels;
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
    let over = x.split(',').next().unwrap_or(x);
    let title = format!("{what} over {over}");
    let description = if description.is_empty() { &title } else { description };
    Chart {
        name,
        title: &title,
        description,
        x: Axis::linear(x, results.times.iter().copied()),
        y: Axis::linear(label, values()),
        curves,
    }
    .svg()
}
