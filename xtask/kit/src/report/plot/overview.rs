//! Overview of one family: one row per formula, time from left to right.

use super::style::{Style, style, time};
use crate::plot::{Axis, BY_CLASS, Drawing};
use jointproof::toolkit::measure::{Measurement, MethodFigures};

const WIDTH: f64 = 760.0;
const ACROSS: [f64; 2] = [190.0, WIDTH - 14.0];
const ROW: f64 = 22.0;
const TOP: f64 = 30.0;

/// The methods shown.
const METHODS: [&str; 6] = ["single", "ad", "central", "octuple", "octuple-ad", "closed"];

/// Time for value and Jacobian by the main methods, and of copying alone.
pub(crate) fn overview(family: &str, measurements: &[&Measurement]) -> String {
    #[expect(clippy::cast_precision_loss, reason = "a few formulas")]
    let bottom = TOP + ROW * measurements.len() as f64;
    let shown = |measurement: &'_ Measurement| {
        let time = |method: &MethodFigures| Some(method.jacobian.as_ref()?.time?.median);
        METHODS.map(|id| measurement.method(id).and_then(time).map(|time| (id, time)))
    };
    let times = measurements.iter().flat_map(|measurement| shown(measurement)).flatten().map(|(_, time)| time);
    let copies = measurements.iter().filter_map(|measurement| Some(measurement.copy?.median));
    let x = Axis::decades("time for value and Jacobian", times.chain(copies), 0.1);

    let title = format!("{family}: time for value and Jacobian");
    let description = "A row a formula; the table below has the same figures.";
    let mut drawing = Drawing::new([WIDTH, bottom + 36.0], &BY_CLASS, &title, description);
    drawing.below(&x, ACROSS, [bottom, TOP - 6.0], time);
    legend(&mut drawing);
    let mut y = TOP + ROW / 2.0;
    for measurement in measurements {
        drawing.text("tick end", [ACROSS[0] - 8.0, y + 3.5], &measurement.formula);
        drawing.line("grid", [ACROSS[0], y], [ACROSS[1], y]);
        if let Some(copy) = measurement.copy {
            let at = x.at(copy.median, ACROSS);
            drawing.line("axis", [at, y - 6.0], [at, y + 6.0]);
        }
        for (id, time) in shown(measurement).into_iter().flatten() {
            let Style { class, shape, .. } = style(id);
            drawing.mark(class, shape, [x.at(time, ACROSS), y]);
        }
        y += ROW;
    }
    drawing.finish()
}

fn legend(drawing: &mut Drawing) {
    let [mut x, _] = ACROSS;
    drawing.line("axis", [x, 4.0], [x, 16.0]);
    drawing.text("label", [x + 6.0, 13.5], "copying");
    x += 72.0;
    for id in METHODS {
        let style = style(id);
        drawing.mark(style.class, style.shape, [x, 10.0]);
        drawing.text("label", [x + 9.0, 13.5], style.name);
        #[expect(clippy::cast_precision_loss, reason = "a short name")]
        let width = style.name.len() as f64;
        x += 26.0 + 6.6 * width;
    }
}
