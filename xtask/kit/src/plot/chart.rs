//! A line chart in the colours of the theme: the text colour for axes and the first curve, other colours for the next, and dashes so
//! that curves are not distinguished by colour alone.

use super::drawing::Look;
use super::{Axis, Drawing};

/// A curve with its name, written at one of its points.
pub struct Curve<'a> {
    /// The name, written next to the point with index `label_at`.
    pub name: &'a str,
    /// The index of the point that carries the name.
    pub label_at: usize,
    /// The points; one that is not finite is omitted and breaks the line.
    pub points: Vec<(f64, f64)>,
}

/// The chart.
pub struct Chart<'a> {
    /// The name of the figure.
    pub name: &'a str,
    /// A short title.
    pub title: &'a str,
    /// A description of the picture for readers who cannot see it.
    pub description: &'a str,
    /// Horizontal axis.
    pub x: Axis<'a>,
    /// Vertical axis.
    pub y: Axis<'a>,
    /// The curves, four at most: a fifth style would not be distinguishable from the first.
    pub curves: Vec<Curve<'a>>,
}

const ACROSS: [f64; 2] = [66.0, 580.0];
const UP: [f64; 2] = [300.0, 30.0];

/// Attributes and no classes: a chart may be on no page.
const LOOK: Look = Look {
    whole: r#" class="chart" fill="none" stroke-linecap="round" stroke-linejoin="round" font-size="13""#,
    element,
    line: 19.0,
};

/// Colour and dashes, curve by curve.
const STYLES: [(&str, &str); 4] = [
    ("currentColor", ""),
    ("var(--accent, #0b57b0)", "7 4"),
    ("var(--warm, #c2571a)", "2 4"),
    ("currentColor", "10 3 2 3"),
];

/// The attributes of an element; a curve and its name are `curve` and `label` with its number.
fn element(kind: &str) -> String {
    let (kind, detail) = kind.split_once(' ').unwrap_or((kind, ""));
    let (colour, dashes) = STYLES[detail.parse().unwrap_or(0) % STYLES.len()];
    match kind {
        "grid" => r#"stroke="currentColor" stroke-opacity="0.18""#.to_owned(),
        "axis" => r#"stroke="currentColor" stroke-opacity="0.5""#.to_owned(),
        "curve" => format!(r#"stroke="{colour}" stroke-width="2" stroke-dasharray="{dashes}""#),
        "label" => format!(r#"fill="{colour}""#),
        _ if detail.is_empty() => r#"fill="currentColor""#.to_owned(),
        _ => format!(r#"fill="currentColor" text-anchor="{detail}""#),
    }
}

impl Chart<'_> {
    /// The SVG element.
    pub fn svg(&self) -> String {
        let mut drawing = Drawing::new([600.0, 346.0], &LOOK, self.title, self.description);
        drawing.below(&self.x, ACROSS, UP, |tick| self.x.number(tick));
        drawing.left(&self.y, UP, ACROSS, |tick| self.y.number(tick));
        for (k, curve) in self.curves.iter().enumerate() {
            self.curve(&mut drawing, curve, k);
        }
        drawing.finish()
    }

    fn place(&self, (x, y): (f64, f64)) -> [f64; 2] {
        [self.x.at(x, ACROSS), self.y.at(y, UP)]
    }

    /// A point beyond the axes is left out; the line joins its neighbours.
    fn curve(&self, drawing: &mut Drawing, curve: &Curve<'_>, k: usize) {
        let inside = |axis: &Axis<'_>, value: f64| (-0.001..=1.001).contains(&axis.share(value));
        let points = curve.points.iter().filter_map(|&point| {
            if !(point.0.is_finite() && point.1.is_finite()) {
                return Some([f64::NAN; 2]);
            }
            (inside(&self.x, point.0) && inside(&self.y, point.1)).then(|| self.place(point))
        });
        drawing.path(&format!("curve {k}"), &points.collect::<Vec<_>>());
        if let Some(&point) = curve.points.get(curve.label_at) {
            let [x, y] = self.place(point);
            // To the right of the point, and below if the curve rises there, so that the curve does not cross its name.
            let next = curve.points.get(curve.label_at + 1).map_or(y, |&next| self.place(next)[1]);
            let beside = if next < y - 3.0 { 16.0 } else { -8.0 };
            drawing.text(&format!("label {k}"), [x, y + beside], curve.name);
        }
    }
}
