//! Lines, text and axes as SVG elements, whose look is that of their classes.

use super::Axis;
use std::fmt::Write;

/// A drawing in progress.
pub(crate) struct Drawing(String);

impl Drawing {
    /// With its class, and a title and a description for readers who cannot see it.
    pub(crate) fn new([width, height]: [f64; 2], class: &str, title: &str, description: &str) -> Self {
        let [title, description] = [title, description].map(escape);
        Self(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{class}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\
             <title>{title}</title><desc>{description}</desc>"
        ))
    }

    /// A style sheet, for a drawing that is on no page.
    pub(crate) fn style(&mut self, rules: &str) {
        let _ = write!(self.0, "<style>{rules}</style>");
    }

    pub(crate) fn line(&mut self, class: &str, from: [f64; 2], to: [f64; 2]) {
        self.path(class, &[from, to]);
    }

    /// A line through the points; one that is not finite breaks it.
    pub(crate) fn path(&mut self, class: &str, points: &[[f64; 2]]) {
        let (mut d, mut pen) = (String::new(), 'M');
        for [x, y] in points {
            if x.is_finite() && y.is_finite() {
                let _ = write!(d, "{pen}{x:.1} {y:.1}");
                pen = 'L';
            } else {
                pen = 'M';
            }
        }
        let _ = write!(self.0, "<path class=\"{class}\" d=\"{d}\"/>");
    }

    pub(crate) fn text(&mut self, class: &str, [x, y]: [f64; 2], text: &str) {
        let _ = write!(self.0, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", escape(text));
    }

    /// An outline, relative to its centre.
    pub(crate) fn mark(&mut self, class: &str, outline: &str, [x, y]: [f64; 2]) {
        let _ = write!(self.0, "<path class=\"{class}\" d=\"M{x:.1} {y:.1}{outline}\"/>");
    }

    /// The horizontal axis between these ends, with grid lines from `y` up to `top`.
    pub(crate) fn below(
        &mut self,
        axis: &Axis<'_>,
        ends: [f64; 2],
        [y, top]: [f64; 2],
        number: impl Fn(f64) -> String,
    ) {
        for &tick in &axis.ticks {
            let x = axis.at(tick, ends);
            self.line("grid", [x, y], [x, top]);
            self.text("tick middle", [x, y + 14.0], &number(tick));
        }
        self.line("axis", [ends[0], y], [ends[1], y]);
        self.text("name end", [ends[1], y + 29.0], axis.label);
    }

    /// The vertical axis between these ends, with grid lines from `x` to `right`.
    pub(crate) fn left(
        &mut self,
        axis: &Axis<'_>,
        ends: [f64; 2],
        [x, right]: [f64; 2],
        number: impl Fn(f64) -> String,
    ) {
        for &tick in &axis.ticks {
            let y = axis.at(tick, ends);
            self.line("grid", [x, y], [right, y]);
            self.text("tick end", [x - 5.0, y + 3.5], &number(tick));
        }
        self.line("axis", [x, ends[0]], [x, ends[1]]);
        self.text("name", [4.0, ends[1] - 9.0], axis.label);
    }

    pub(crate) fn finish(mut self) -> String {
        self.0.push_str("</svg>");
        self.0
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
