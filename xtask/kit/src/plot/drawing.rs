//! Lines, text and axes as SVG elements.

use super::Axis;
use std::fmt::Write;

/// A drawing in progress.
pub(crate) struct Drawing {
    svg: String,
    look: &'static Look,
}

/// The look of a drawing.
pub(crate) struct Look {
    /// The attributes of the whole drawing.
    pub(crate) whole: &'static str,
    /// The attributes of an element of this kind.
    pub(crate) element: fn(&str) -> String,
    /// The height of a line of text.
    pub(crate) line: f64,
}

/// The look on a page, whose style sheet has rules for the kinds of elements.
pub(crate) const BY_CLASS: Look = Look { whole: "", element: |kind| format!("class=\"{kind}\""), line: 14.5 };

impl Drawing {
    /// With a title and a description for readers who cannot see it.
    pub(crate) fn new([width, height]: [f64; 2], look: &'static Look, title: &str, description: &str) -> Self {
        let whole = look.whole;
        let [title, description] = [title, description].map(escape);
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\"{whole}>\
             <title>{title}</title><desc>{description}</desc>"
        );
        Self { svg, look }
    }

    pub(crate) fn line(&mut self, kind: &str, from: [f64; 2], to: [f64; 2]) {
        let [[x, y], [right, top]] = [from, to].map(|point| point.map(tenth));
        if y == top {
            self.outline(kind, &format!("M{x} {y}H{right}"));
        } else if x == right {
            self.outline(kind, &format!("M{x} {y}V{top}"));
        } else {
            self.path(kind, &[from, to]);
        }
    }

    /// A line through the points; one that is not finite breaks it.
    pub(crate) fn path(&mut self, kind: &str, points: &[[f64; 2]]) {
        let (mut d, mut pen) = (String::new(), 'M');
        for [x, y] in points {
            if x.is_finite() && y.is_finite() {
                let _ = write!(d, "{pen}{} {}", tenth(*x), tenth(*y));
                pen = 'L';
            } else {
                pen = 'M';
            }
        }
        self.outline(kind, &d);
    }

    pub(crate) fn text(&mut self, kind: &str, [x, y]: [f64; 2], text: &str) {
        let ([x, y], text) = ([x, y].map(tenth), escape(text));
        let _ = write!(self.svg, "<text {} x=\"{x}\" y=\"{y}\">{text}</text>", (self.look.element)(kind));
    }

    /// An outline by its path.
    pub(crate) fn outline(&mut self, kind: &str, d: &str) {
        let _ = write!(self.svg, "<path {} d=\"{d}\"/>", (self.look.element)(kind));
    }

    /// An outline, relative to its centre.
    pub(crate) fn mark(&mut self, kind: &str, outline: &str, [x, y]: [f64; 2]) {
        self.outline(kind, &format!("M{} {}{outline}", tenth(x), tenth(y)));
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
            self.text("tick middle", [x, y + self.look.line], &number(tick));
        }
        self.line("axis", [ends[0], y], [ends[1], y]);
        self.text("name end", [ends[1], y + 2.0 * self.look.line], axis.label);
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
        self.svg.push_str("</svg>");
        self.svg
    }
}

/// Rounds a coordinate to a tenth, without a negative zero.
pub fn tenth(x: f64) -> f64 {
    (x * 10.0).round() / 10.0 + 0.0
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
