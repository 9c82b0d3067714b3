//! Axes, and the marks common to all plots.

use std::fmt::Write;

/// A logarithmic axis between two powers of ten.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    /// Exponents at the ends.
    exponents: [i32; 2],
    /// The coordinates of the ends.
    pub(super) ends: [f64; 2],
}

impl Axis {
    /// The shortest axis that contains all values, at least a decade; values of 0 or below `floor` are drawn at `floor`.
    pub(super) fn around(values: impl IntoIterator<Item = f64>, floor: f64, ends: [f64; 2]) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values {
            let exponent = value.clamp(floor, 1e300).log10();
            (low, high) = (low.min(exponent), high.max(exponent));
        }
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        #[expect(clippy::cast_possible_truncation, reason = "exponents of doubles")]
        let [low, high] = [(low + 1e-9).floor() as i32, (high - 1e-9).ceil() as i32];
        Self { exponents: [low, high.max(low + 1)], ends }
    }

    /// The coordinate of a value.
    pub(super) fn at(&self, value: f64) -> f64 {
        let [low, high] = self.exponents.map(f64::from);
        let fraction = (value.max(1e-300).log10().clamp(low, high) - low) / (high - low);
        self.ends[0] + fraction * (self.ends[1] - self.ends[0])
    }

    /// Exponents to be labelled, at most seven.
    pub(super) fn ticks(&self) -> Vec<i32> {
        let [low, high] = self.exponents;
        let stride = ((high - low) / 7 + 1).max(1);
        (low..=high).filter(|exponent| exponent.rem_euclid(stride) == 0).collect()
    }
}

/// A drawing in progress.
pub(super) struct Drawing(String);

impl Drawing {
    /// With a title and a description for readers who cannot see it.
    pub(super) fn new(width: f64, height: f64, title: &str, description: &str) -> Self {
        let [title, description] = [title, description].map(escape);
        Self(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\">\
             <title>{title}</title><desc>{description}</desc>"
        ))
    }

    pub(super) fn line(&mut self, class: &str, from: [f64; 2], to: [f64; 2]) {
        let [[x1, y1], [x2, y2]] = [from, to];
        let _ = write!(self.0, "<path class=\"{class}\" d=\"M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}\"/>");
    }

    pub(super) fn path(&mut self, class: &str, points: &[[f64; 2]]) {
        let mut d = String::new();
        for (k, [x, y]) in points.iter().enumerate() {
            let _ = write!(d, "{}{x:.1} {y:.1}", if k == 0 { 'M' } else { 'L' });
        }
        let _ = write!(self.0, "<path class=\"{class}\" d=\"{d}\"/>");
    }

    pub(super) fn text(&mut self, class: &str, [x, y]: [f64; 2], text: &str) {
        let _ = write!(self.0, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", escape(text));
    }

    pub(super) fn mark(&mut self, style: &Style, [x, y]: [f64; 2]) {
        let _ = write!(self.0, "<path class=\"{}\" d=\"M{x:.1} {y:.1}{}\"/>", style.class, style.shape);
    }

    /// The horizontal axis, with grid lines up to `top`.
    pub(super) fn below(&mut self, axis: &Axis, y: f64, top: f64, name: &str, label: impl Fn(i32) -> String) {
        for exponent in axis.ticks() {
            let x = axis.at(10.0_f64.powi(exponent));
            self.line("grid", [x, y], [x, top]);
            self.text("tick middle", [x, y + 14.0], &label(exponent));
        }
        self.line("axis", [axis.ends[0], y], [axis.ends[1], y]);
        self.text("name end", [axis.ends[1], y + 29.0], name);
    }

    /// The vertical axis, with grid lines to the right.
    pub(super) fn left(&mut self, axis: &Axis, x: f64, right: f64, name: &str, label: impl Fn(i32) -> String) {
        for exponent in axis.ticks() {
            let y = axis.at(10.0_f64.powi(exponent));
            self.line("grid", [x, y], [right, y]);
            self.text("tick end", [x - 5.0, y + 3.5], &label(exponent));
        }
        self.line("axis", [x, axis.ends[0]], [x, axis.ends[1]]);
        self.text("name", [4.0, axis.ends[1] - 9.0], name);
    }

    pub(super) fn finish(mut self) -> String {
        self.0.push_str("</svg>");
        self.0
    }
}

pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The style of a method in a plot, and its name there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    /// The colour.
    class: &'static str,
    /// The outline, relative to the centre.
    shape: &'static str,
    /// A short name; that of the method itself if empty.
    pub(super) name: &'static str,
}

pub(super) const CIRCLE: &str = "m-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0z";
/// Thin, since it surrounds the mark of another.
pub(super) const RING: &str = "m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0zm1.5 0a4 4 0 1 1 8 0a4 4 0 1 1-8 0z";
pub(super) const SQUARE: &str = "m-4-4h8v8h-8z";
pub(super) const DIAMOND: &str = "m0-5.5 5.5 5.5-5.5 5.5-5.5-5.5z";
pub(super) const UP: &str = "m0-5 5 8.6h-10z";
pub(super) const DOWN: &str = "m0 5-5-8.6h10z";
pub(super) const BAR: &str = "m-5.5-2h11v4h-11z";
pub(super) const PLUS: &str = "m-1.7-5h3.4v3.3h3.3v3.4h-3.3v3.3h-3.4v-3.3h-3.3v-3.4h3.3z";
pub(super) const HOURGLASS: &str = "m-4.5-4.5h9l-9 9h9z";

/// The style of a method.
pub(super) fn style(id: &str) -> Style {
    let (class, shape, name) = match id {
        "closed" => ("way-closed", CIRCLE, "closed form"),
        "checked" => ("way-closed", RING, "checked"),
        "single" => ("way-single", SQUARE, "single"),
        "ad" => ("way-ad", UP, "AD"),
        "forward" => ("way-difference", DIAMOND, "forward"),
        "central" => ("way-difference", PLUS, "central"),
        "fourth" => ("way-difference", BAR, "4th order"),
        "octuple" => ("way-octuple", CIRCLE, "237 bits"),
        "octuple-ad" => ("way-octuple", UP, "AD, 237 bits"),
        _ => ("way-own", if id.len().is_multiple_of(2) { DOWN } else { HOURGLASS }, ""),
    };
    Style { class, shape, name }
}

/// A power of ten with a real exponent: 10⁻⁷; 0.1, 1, 10 and 100 as they are.
pub(super) fn power(exponent: i32) -> String {
    match exponent {
        -1 => "0.1".into(),
        0 => "1".into(),
        1 => "10".into(),
        2 => "100".into(),
        _ => format!("10{}", superscript(exponent)),
    }
}

pub(super) fn superscript(number: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(u32::from(digit) - u32::from('0') + u32::from('⁰')).unwrap_or(digit),
    };
    number.to_string().chars().map(raised).collect()
}

/// Nanoseconds as axis labels: 10 ns, 1 µs, 10 ms.
pub(super) fn time(exponent: i32) -> String {
    let units = ["ps", "ns", "µs", "ms", "s"];
    let unit = usize::try_from(exponent.div_euclid(3) + 1).ok().and_then(|k| units.get(k));
    let number = 10_i32.pow(exponent.rem_euclid(3).unsigned_abs());
    unit.map_or_else(|| format!("{} ns", power(exponent)), |unit| format!("{number} {unit}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    pub(super) fn an_axis_holds_all_its_values_and_puts_zero_at_its_floor() {
        let axis = Axis::around([0.0, 3e4], 0.1, [0.0, 100.0]);
        assert_eq!(axis.exponents, [-1, 5]);
        assert_eq!((axis.at(0.0), axis.at(1e5)), (0.0, 100.0));
        assert_eq!(Axis::around([], 0.1, [0.0, 1.0]).exponents, [0, 1]);
        assert_eq!(Axis::around([10.0], 0.1, [0.0, 1.0]).exponents, [1, 2]);
    }

    #[test]
    pub(super) fn ticks_are_few_and_round() {
        let axis = Axis { exponents: [-17, 2], ends: [0.0, 1.0] };
        assert_eq!(axis.ticks(), [-15, -12, -9, -6, -3, 0]);
    }

    #[test]
    pub(super) fn powers_and_times_read_well() {
        assert_eq!([-12, -1, 1, 6].map(power), ["10⁻¹²", "0.1", "10", "10⁶"]);
        assert_eq!([-1, 0, 1, 3, 5, 6].map(time), ["100 ps", "1 ns", "10 ns", "1 µs", "100 µs", "1 ms"]);
    }
}
