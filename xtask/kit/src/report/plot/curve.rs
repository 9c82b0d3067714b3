//! The error of differences as a function of their step.

use super::drawing::{Axis, Drawing, power, style};
use crate::console::figure;
use jointproof::toolkit::measure::{Curve, Measurement};

const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 270.0;
const LEFT: f64 = 46.0;
const BOTTOM: f64 = 232.0;

/// Smaller errors are drawn at this value, which is below the roundoff of `f64`.
const FLOOR: f64 = 1e-17;

/// Median relative error of the Jacobian as a function of the step, for each scheme, with the minimum of each marked.
pub(crate) fn curve(measurement: &Measurement) -> String {
    let curves = &measurement.curves;
    let steps = curves.iter().flat_map(|curve| curve.points().map(|(step, _)| step));
    let x = Axis::around(steps, 1e-16, [LEFT, WIDTH - 12.0]);
    let errors = curves.iter().flat_map(|curve| curve.errors.iter().copied());
    let y = Axis::around(errors.chain([FLOOR, 1.0]), FLOOR, [BOTTOM, 26.0]);

    let title = format!("{}: error of differences over their step", measurement.formula);
    let mut drawing = Drawing::new(WIDTH, HEIGHT, &title, &description(curves));
    drawing.below(&x, BOTTOM, y.ends[1], "step, relative to the input", power);
    drawing.left(&y, LEFT, x.ends[1], "relative error of the Jacobian (median)", power);
    let closed = measurement.method("closed").and_then(|method| method.jacobian.as_ref());
    if let Some(closed) = closed {
        let error = closed.random.relative;
        let height = y.at(error.max(FLOOR));
        drawing.line("curve way-closed", [LEFT, height], [x.ends[1], height]);
        let name = if error == 0.0 { "closed form: exact" } else { "closed form" };
        drawing.text("label", [LEFT + 4.0, height - 5.0], name);
    }
    for curve in curves {
        let at = |(step, error): (f64, f64)| [x.at(step), y.at(error.max(FLOOR))];
        let points: Vec<_> = curve.points().map(at).collect();
        let id = curve.scheme.id();
        drawing.path(&format!("curve way-difference dash-{id}"), &points);
        if let Some(best) = curve.best() {
            drawing.mark(&style(id), at(best));
        }
    }
    legend(&mut drawing, curves);
    drawing.finish()
}

fn legend(drawing: &mut Drawing, curves: &[Curve]) {
    // Below the curves, which descend from the left.
    let (x, mut y) = (LEFT + 16.0, 150.0);
    for curve in curves {
        let style = style(curve.scheme.id());
        drawing.line(&format!("curve way-difference dash-{}", curve.scheme.id()), [x, y], [x + 28.0, y]);
        drawing.mark(&style, [x + 14.0, y]);
        drawing.text("label", [x + 34.0, y + 3.5], style.name);
        y += 14.0;
    }
}

fn description(curves: &[Curve]) -> String {
    let one = |curve: &Curve| {
        let (step, error) = curve.best()?;
        Some(format!("{} are best at step {} with error {}", curve.scheme.title(), figure(step), figure(error)))
    };
    curves.iter().filter_map(one).collect::<Vec<_>>().join("; ")
}
