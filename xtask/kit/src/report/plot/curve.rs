//! The error of differences as a function of their step.

use super::style::{Style, style};
use crate::console::figure;
use crate::plot::{Axis, BY_CLASS, Drawing};
use jointproof::toolkit::measure::{Curve, Measurement};

const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 270.0;
const ACROSS: [f64; 2] = [46.0, WIDTH - 12.0];
const UP: [f64; 2] = [232.0, 26.0];

/// The height of the first line of the legend.
const LEGEND: f64 = 150.0;

/// Smaller errors are drawn at this value, which is below the roundoff of `f64`.
const FLOOR: f64 = 1e-17;

/// Median relative error of the Jacobian as a function of the step, for each scheme, with the minimum of each marked.
pub(crate) fn curve(measurement: &Measurement) -> String {
    let curves = &measurement.curves;
    let steps = curves.iter().flat_map(|curve| curve.points().map(|(step, _)| step));
    let x = Axis::decades("step, relative to the input", steps, 1e-16);
    let errors = curves.iter().flat_map(|curve| curve.errors.iter().copied());
    let y = Axis::decades("relative error of the Jacobian (median)", errors.chain([FLOOR, 1.0]), FLOOR);

    let title = format!("{}: error of differences over their step", measurement.formula);
    let mut drawing = Drawing::new([WIDTH, HEIGHT], &BY_CLASS, &title, &description(curves));
    drawing.below(&x, ACROSS, UP, |step| x.number(step));
    drawing.left(&y, UP, ACROSS, |error| y.number(error));
    let closed = measurement.method("closed").and_then(|method| method.jacobian.as_ref());
    if let Some(closed) = closed {
        let error = closed.random.relative;
        let height = y.at(error.max(FLOOR), UP);
        drawing.line("curve method-closed", [ACROSS[0], height], [ACROSS[1], height]);
        let name = if error == 0.0 { "closed form: exact" } else { "closed form" };
        // On the right where the legend is on the left.
        let is_at_legend = (LEGEND - 20.0..LEGEND + 60.0).contains(&height);
        let (class, x) = if is_at_legend { ("label end", ACROSS[1] - 4.0) } else { ("label", ACROSS[0] + 4.0) };
        drawing.text(class, [x, height - 5.0], name);
    }
    for curve in curves {
        let at = |(step, error): (f64, f64)| [x.at(step, ACROSS), y.at(error.max(FLOOR), UP)];
        let points: Vec<_> = curve.points().map(at).collect();
        let id = curve.scheme.id();
        drawing.path(&format!("curve method-difference dash-{id}"), &points);
        if let Some(best) = curve.best() {
            let Style { class, shape, .. } = style(id);
            drawing.mark(class, shape, at(best));
        }
    }
    legend(&mut drawing, curves);
    drawing.finish()
}

fn legend(drawing: &mut Drawing, curves: &[Curve]) {
    // Below the curves, which descend from the left.
    let (x, mut y) = (ACROSS[0] + 16.0, LEGEND);
    for curve in curves {
        let style = style(curve.scheme.id());
        drawing.line(&format!("curve method-difference dash-{}", curve.scheme.id()), [x, y], [x + 28.0, y]);
        drawing.mark(style.class, style.shape, [x + 14.0, y]);
        drawing.text("label", [x + 34.0, y + 3.5], style.name);
        y += 16.0;
    }
}

fn description(curves: &[Curve]) -> String {
    let one = |curve: &Curve| {
        let (step, error) = curve.best()?;
        Some(format!("{} are best at step {} with error {}", curve.scheme.title(), figure(step), figure(error)))
    };
    curves.iter().filter_map(one).collect::<Vec<_>>().join("; ")
}
