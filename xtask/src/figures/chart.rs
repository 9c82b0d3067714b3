//! A line chart as SVG in the colours of the theme: the text colour for axes and the first curve, the accent colour
//! for the second, and dashes so that curves are not distinguished by colour alone.

use std::fmt::Write;

/// An axis, linear or logarithmic.
pub(crate) struct Axis<'a> {
    /// The quantity shown, with its unit.
    pub(crate) label: &'a str,
    /// The value at the left or the bottom.
    pub(crate) from: f64,
    /// The value at the right or the top; less than `from` to run backwards.
    pub(crate) to: f64,
    /// Whether it is logarithmic.
    pub(crate) logarithmic: bool,
    /// Values with a tick and a number.
    pub(crate) ticks: Vec<f64>,
}

/// A curve with its name, written at one of its points.
pub(crate) struct Curve<'a> {
    /// The name, written next to the point with index `label_at`.
    pub(crate) name: &'a str,
    /// The index of the point that carries the name.
    pub(crate) label_at: usize,
    /// The points; one that is not finite is omitted and breaks the line.
    pub(crate) points: Vec<(f64, f64)>,
}

/// The chart.
pub(crate) struct Chart<'a> {
    /// The name of the figure, used in the identifiers within the drawing.
    pub(crate) name: &'a str,
    /// A short title.
    pub(crate) title: &'a str,
    /// A description of the picture for readers who cannot see it.
    pub(crate) description: &'a str,
    /// Horizontal axis.
    pub(crate) x: Axis<'a>,
    /// Vertical axis.
    pub(crate) y: Axis<'a>,
    /// The curves.
    pub(crate) curves: Vec<Curve<'a>>,
}

const LEFT: f64 = 84.0;
const RIGHT: f64 = 560.0;
const TOP: f64 = 20.0;
const BOTTOM: f64 = 290.0;

/// Stroke and dashes, curve by curve.
const STYLES: [(&str, &str); 4] = [
    ("currentColor", ""),
    ("var(--accent, #0b57b0)", "7 4"),
    ("var(--warm, #c2571a)", "2 4"),
    ("currentColor", "10 3 2 3"),
];

impl Axis<'_> {
    /// The position of a value between the ends, from 0 to 1.
    fn share(&self, value: f64) -> f64 {
        let scale = |x: f64| if self.logarithmic { x.log10() } else { x };
        (scale(value) - scale(self.from)) / (scale(self.to) - scale(self.from))
    }

    /// The number at a tick.
    fn number(&self, value: f64) -> String {
        let exponent = value.log10();
        if self.logarithmic && exponent.fract() == 0.0 && !(-1.0..=2.0).contains(&exponent) {
            return format!(
                r#"10<tspan dy="-5" font-size="0.77em">{}</tspan>"#,
                exponent.to_string().replace('-', "−")
            );
        }
        value.to_string().replace('-', "−")
    }
}

impl Chart<'_> {
    /// The SVG element.
    pub(crate) fn svg(&self) -> String {
        let Self { name, title, description, .. } = self;
        let mut svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" class="chart" viewBox="0 0 600 346" role="img" aria-labelledby="{name}-title {name}-desc" fill="none" stroke-linecap="round" stroke-linejoin="round" font-size="13">
  <title id="{name}-title">{title}</title>
  <desc id="{name}-desc">{description}</desc>
"#
        );
        self.grid(&mut svg);
        for (curve, (colour, dashes)) in self.curves.iter().zip(STYLES.iter().cycle()) {
            self.curve(&mut svg, curve, colour, dashes);
        }
        svg + "</svg>\n"
    }

    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (LEFT + (RIGHT - LEFT) * self.x.share(x), BOTTOM + (TOP - BOTTOM) * self.y.share(y))
    }

    fn grid(&self, svg: &mut String) {
        let mut lines = String::new();
        let mut numbers = String::new();
        for &tick in &self.x.ticks {
            let (x, _) = self.place((tick, self.y.from));
            let _ = write!(lines, "M{x:.1} {TOP}V{BOTTOM}");
            let _ = write!(numbers, r#"<text x="{x:.1}" y="310" text-anchor="middle">{}</text>"#, self.x.number(tick));
        }
        for &tick in &self.y.ticks {
            let (_, y) = self.place((self.x.from, tick));
            let _ = write!(lines, "M{LEFT} {y:.1}H{RIGHT}");
            let number = self.y.number(tick);
            let _ = write!(numbers, r#"<text x="76" y="{:.1}" text-anchor="end">{number}</text>"#, y + 4.5);
        }
        let (x, y) = (self.x.label, self.y.label);
        let _ = writeln!(
            svg,
            r#"  <path d="{lines}" stroke="currentColor" stroke-opacity="0.18"/>
  <g fill="currentColor">{numbers}
    <text x="322" y="338" font-size="14" text-anchor="middle">{x}</text>
    <text x="18" y="155" font-size="14" text-anchor="middle" transform="rotate(-90 18 155)">{y}</text>
  </g>"#
        );
    }

    fn curve(&self, svg: &mut String, curve: &Curve<'_>, colour: &str, dashes: &str) {
        let inside = |axis: &Axis<'_>, value: f64| (-0.001..=1.001).contains(&axis.share(value));
        let mut path = String::new();
        let mut pen = 'M';
        for &point in &curve.points {
            if inside(&self.x, point.0) && inside(&self.y, point.1) {
                let (x, y) = self.place(point);
                let _ = write!(path, "{pen}{x:.1} {y:.1}");
                pen = 'L';
            } else if !(point.0.is_finite() && point.1.is_finite()) {
                pen = 'M';
            }
        }
        let _ = writeln!(svg, r#"  <path d="{path}" stroke="{colour}" stroke-width="2" stroke-dasharray="{dashes}"/>"#);
        if let Some(&point) = curve.points.get(curve.label_at) {
            let (x, y) = self.place(point);
            // To the right of the point, and below if the curve rises there, so that the curve does not cross its name.
            let next = curve.points.get(curve.label_at + 1).map_or(y, |&next| self.place(next).1);
            let beside = if next < y - 3.0 { 16.0 } else { -8.0 };
            let _ = writeln!(svg, r#"  <text x="{x:.1}" y="{:.1}" fill="{colour}">{}</text>"#, y + beside, curve.name);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lie_where_their_axis_says() {
        let axis = |from, to| Axis { label: "", from, to, logarithmic: true, ticks: Vec::new() };
        assert_eq!(axis(1.0, 100.0).share(10.0), 0.5);
        assert_eq!(axis(100.0, 1.0).share(100.0), 0.0);
        assert!(!axis(1.0, 100.0).share(-1.0).is_finite());
        assert_eq!(axis(1.0, 100.0).number(1e-8), r#"10<tspan dy="-5" font-size="0.77em">−8</tspan>"#);
    }
}
