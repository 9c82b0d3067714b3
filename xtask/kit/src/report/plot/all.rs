//! Error against time, all methods over all formulas.

use super::style::{Style, style};
use crate::plot::{Axis, BY_CLASS, Drawing};
use crate::report::spread::Spread;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 430.0;
const ACROSS: [f64; 2] = [56.0, WIDTH - 14.0];
const UP: [f64; 2] = [318.0, 26.0];
/// Smaller errors are drawn at this value.
const FLOOR: f64 = 1e-17;
/// A formula in the cloud behind a method.
const DOT: &str = "h0";

/// A mark at the medians of time and error, with bars from the first tenth of the formulas to the last, before a dot for each.
pub(crate) fn all(spreads: &[Spread]) -> String {
    let formulas = || spreads.iter().flat_map(|spread| &spread.formulas);
    let x = Axis::decades("time for value and Jacobian, closed form = 1", formulas().map(|point| point[0]), 0.1);
    let y = Axis::decades("relative error of the Jacobian", formulas().map(|point| point[1].min(1.0)), FLOOR);
    let description = spreads.iter().map(|spread| {
        let [.., time, _] = spread.ratios;
        format!("{}: {time:.2} times the closed form, error {:.1e}", spread.title, spread.errors[1])
    });
    let title = "Error against time of all methods over all formulas";
    let mut drawing = Drawing::new([WIDTH, HEIGHT], &BY_CLASS, title, &description.collect::<Vec<_>>().join("; "));
    drawing.below(&x, ACROSS, UP, |ratio| x.number(ratio));
    drawing.left(&y, UP, ACROSS, |error| y.number(error));
    let place = |[ratio, error]: [f64; 2]| [x.at(ratio, ACROSS), y.at(error.max(FLOOR), UP)];
    for spread in spreads {
        let dot = |dots: String, &formula: &[f64; 2]| {
            let [x, y] = place(formula);
            dots + &format!("M{x:.0} {y:.0}{DOT}")
        };
        let dots = spread.formulas.iter().fold(String::new(), dot);
        drawing.outline(&format!("cloud {}", style(&spread.id).class), &dots);
    }
    for (k, spread) in spreads.iter().enumerate() {
        let Style { class, shape, name } = style(&spread.id);
        let [[left, low], [middle, error], [right, high]] =
            [0, 1, 2].map(|k| place([spread.ratios[k], spread.errors[k]]));
        drawing.line(&format!("curve {class}"), [left, error], [right, error]);
        drawing.line(&format!("curve {class}"), [middle, low], [middle, high]);
        drawing.mark(class, shape, [middle, error]);
        #[expect(clippy::cast_precision_loss, reason = "a few methods")]
        let at = [ACROSS[0] + 180.0 * (k % 4) as f64, UP[0] + 56.0 + 20.0 * (k / 4) as f64];
        drawing.mark(class, shape, at);
        drawing.text("label", [at[0] + 10.0, at[1] + 3.5], name);
    }
    drawing.finish()
}
