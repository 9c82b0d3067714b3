//! A drawing of objects in space: points are projected, and every part is one line of SVG, so that two positions of a
//! mechanism differ in few lines.

use std::borrow::Cow;
use std::fmt::Write;

use kit::tenth;
use nalgebra::{Vector2, Vector3};

pub(crate) type Point = Vector3<f64>;

/// The style of a stroke.
#[derive(Clone, Copy)]
pub(crate) enum Ink {
    /// A part.
    Solid,
    /// Thin lines: dimensions, outlines of bodies.
    Thin,
    /// A construction line, dashed.
    Dashed,
    /// An axis, with long and short dashes.
    Axis,
    /// The part in focus, in the accent colour.
    Accent,
    /// A force or moment, in the warm colour.
    Force,
}

impl Ink {
    fn colour(self) -> &'static str {
        match self {
            Self::Accent => "var(--accent, #0b57b0)",
            Self::Force => "var(--warm, #b5501b)",
            _ => "currentColor",
        }
    }

    fn stroke(self) -> String {
        let rest = match self {
            Self::Solid | Self::Accent | Self::Force => r#"stroke-width="2.2""#,
            Self::Thin => r#"stroke-width="1.1" stroke-opacity="0.7""#,
            Self::Dashed => r#"stroke-width="1.2" stroke-opacity="0.8" stroke-dasharray="4 4""#,
            Self::Axis => r#"stroke-width="1.1" stroke-dasharray="14 4 2 4""#,
        };
        format!(r#"stroke="{}" {rest}"#, self.colour())
    }

    fn tip(self) -> &'static str {
        match self {
            Self::Accent => "accent",
            Self::Force => "force",
            _ => "tip",
        }
    }
}

/// The projection of a drawing: the images of the axes, and of the origin.
pub(crate) struct View {
    axes: [Vector2<f64>; 3],
    origin: Vector2<f64>,
}

impl View {
    fn new(axes: [[f64; 2]; 3], unit: f64, origin: [f64; 2]) -> Self {
        Self { axes: axes.map(|axis| Vector2::from(axis) * unit), origin: origin.into() }
    }

    /// From the front right and above: the first axis to the right, the second up, the third towards the viewer.
    pub(crate) fn space(unit: f64, origin: [f64; 2]) -> Self {
        Self::new([[0.98, -0.2], [0.0, -1.0], [-0.52, 0.42]], unit, origin)
    }

    /// A view of space, or of the plane of the first two axes, in which all these points have room.
    pub(crate) fn fitted(points: &[Point], is_flat: bool) -> Self {
        const ROOM: [f64; 2] = [70.0, 45.0];
        let View { axes, .. } = if is_flat { Self::plane(1.0, [0.0; 2]) } else { Self::space(1.0, [0.0; 2]) };
        let placed = || points.iter().map(|p| axes[0] * p.x + axes[1] * p.y + axes[2] * p.z);
        let bound = |k: usize, pick: fn(f64, f64) -> f64| placed().map(|p| p[k]).reduce(pick).unwrap_or(0.0);
        let bounds = [0, 1].map(|k| (bound(k, f64::min), bound(k, f64::max)));
        let units = [0, 1].map(|k| (SIZE[k] - 2.0 * ROOM[k]) / (bounds[k].1 - bounds[k].0).max(f64::MIN_POSITIVE));
        let unit = units[0].min(units[1]).min(1e300);
        let origin = [0, 1].map(|k| SIZE[k] / 2.0 - unit * bounds[k].0.midpoint(bounds[k].1));
        Self { axes: axes.map(|axis| axis * unit), origin: origin.into() }
    }

    /// With the second axis to the right, for horizontal shafts.
    pub(super) fn lying(unit: f64, origin: [f64; 2]) -> Self {
        Self::new([[-0.45, 0.5], [0.98, 0.12], [0.0, -1.0]], unit, origin)
    }

    /// The plane of the first two axes.
    pub(crate) fn plane(unit: f64, origin: [f64; 2]) -> Self {
        Self::new([[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]], unit, origin)
    }
}

/// Width and height of the drawing.
const SIZE: [f64; 2] = [560.0, 300.0];

/// A drawing in progress.
pub(crate) struct Sketch {
    name: Cow<'static, str>,
    title: Cow<'static, str>,
    description: Cow<'static, str>,
    view: View,
    lines: Vec<String>,
    /// The notes below.
    notes: Vec<String>,
}

impl Sketch {
    pub(crate) fn new(
        name: impl Into<Cow<'static, str>>,
        title: impl Into<Cow<'static, str>>,
        description: impl Into<Cow<'static, str>>,
        view: View,
    ) -> Self {
        let (name, title, description) = (name.into(), title.into(), description.into());
        Self { name, title, description, view, lines: Vec::new(), notes: Vec::new() }
    }

    fn place(&self, p: Point) -> Vector2<f64> {
        let View { axes, origin } = &self.view;
        origin + axes[0] * p.x + axes[1] * p.y + axes[2] * p.z
    }

    /// A polyline.
    pub(crate) fn path(&mut self, points: &[Point], ink: Ink) {
        let mut d = String::new();
        for (k, point) in points.iter().enumerate() {
            let at = self.place(*point);
            let _ = write!(d, "{}{} {}", if k == 0 { "M" } else { "L" }, tenth(at.x), tenth(at.y));
        }
        self.lines.push(format!(r#"<path d="{d}" {}/>"#, ink.stroke()));
    }

    /// A band along a line, with this width in the drawing: a groove, a tube.
    pub(crate) fn band(&mut self, points: [Point; 2], width: f64) {
        let [from, to] = points.map(|point| self.place(point));
        self.lines.push(format!(
            r#"<path d="M{} {}L{} {}" stroke="currentColor" stroke-opacity="0.13" stroke-width="{width}" stroke-linecap="butt"/>"#,
            tenth(from.x), tenth(from.y), tenth(to.x), tenth(to.y)
        ));
    }

    /// The area of a polygon.
    pub(crate) fn area(&mut self, points: &[Point], ink: Ink) {
        let all: Vec<_> = points
            .iter()
            .map(|point| self.place(*point))
            .map(|at| format!("{} {}", tenth(at.x), tenth(at.y)))
            .collect();
        self.lines.push(format!(
            r#"<path d="M{}Z" fill="{colour}" fill-opacity="0.1" stroke="{colour}" stroke-width="1.3"/>"#,
            all.join("L"),
            colour = ink.colour()
        ));
    }

    /// An arrow; one too short for a tip becomes an empty line.
    pub(crate) fn arrow(&mut self, from: Point, by: Point, ink: Ink) {
        let [start, end] = [from, from + by].map(|point| self.place(point));
        self.lines.push(if (end - start).norm() < 3.0 {
            String::new()
        } else {
            format!(
                r#"<path d="M{} {}L{} {}" {} marker-end="url(#{}-{})"/>"#,
                tenth(start.x),
                tenth(start.y),
                tenth(end.x),
                tenth(end.y),
                ink.stroke(),
                self.name,
                ink.tip()
            )
        });
    }

    /// A node.
    pub(crate) fn dot(&mut self, at: Point, ink: Ink) {
        let at = self.place(at);
        self.lines.push(format!(
            r#"<circle cx="{}" cy="{}" r="5.5" fill="{}"/>"#,
            tenth(at.x),
            tenth(at.y),
            ink.colour()
        ));
    }

    /// A label next to a point: `e_1a` has a subscript, and a name that starts with `*` is bold.
    pub(crate) fn label(&mut self, at: Point, beside: [f64; 2], name: &str, ink: Ink) {
        let at = self.place(at) + Vector2::from(beside);
        self.lines.push(format!(
            r#"<text x="{}" y="{}" fill="{}">{}</text>"#,
            tenth(at.x),
            tenth(at.y),
            ink.colour(),
            set(name, svg)
        ));
    }

    /// Three labelled arrows for the triad of a node called `of`.
    pub(crate) fn triad(&mut self, at: Point, axes: [Point; 3], length: f64, of: &str, ink: Ink) {
        for (k, axis) in axes.iter().enumerate() {
            self.arrow(at, axis * length, ink);
            let end = self.place(at + axis * length) - self.place(at);
            let away = end / end.norm().max(1.0);
            // A label extends to the right.
            let beside = away * 12.0 + Vector2::new(-5.0 + 14.0 * away.x.min(0.0), 5.0);
            self.label(at + axis * length, beside.into(), &format!("*e_{}{of}", k + 1), ink);
        }
    }

    /// Adds a line of numbers below the drawing.
    pub(super) fn note(&mut self, text: impl Into<String>) {
        self.notes.push(text.into());
    }

    /// The SVG element, one line per part, and a paragraph for each note, in the text size of the page on any screen.
    pub(crate) fn html(self) -> String {
        let [width, height] = SIZE;
        let Self { name, title, description, lines, notes, .. } = self;
        let marker = |tip: &str, colour: &str| {
            format!(
                r#"<marker id="{name}-{tip}" viewBox="0 0 10 10" refX="8.5" refY="5" markerWidth="6.5" markerHeight="6.5" orient="auto"><path d="M0 1 9 5 0 9Z" fill="{colour}" stroke="none"/></marker>"#
            )
        };
        let markers = [Ink::Solid, Ink::Accent, Ink::Force].map(|ink| marker(ink.tip(), ink.colour())).concat();
        let notes: Vec<_> =
            notes.iter().map(|note| format!("<p class=\"readout\">{}</p>\n", set(note, html))).collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sketch\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-labelledby=\"{name}-title {name}-desc\" \
             fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" font-size=\"17\">\n<title id=\"{name}-title\">{title}</title>\n\
             <desc id=\"{name}-desc\">{description}</desc>\n<defs>{markers}</defs>\n{}\n</svg>\n{}",
            lines.join("\n"),
            notes.concat()
        )
    }
}

/// A number for a note: two decimals, with a true minus sign.
pub(super) fn number(x: f64) -> String {
    format!("{:.2}", (x * 100.0).round() / 100.0 + 0.0).replace('-', "−")
}

/// A name with its subscript, if it has one, and the text that follows it.
struct Name<'a> {
    is_bold: bool,
    letters: &'a str,
    index: &'a str,
    after: &'a str,
}

/// Formats words: `e_1a` has a subscript and `*e` is bold; subscripts end at a space or at punctuation.
fn set(text: &str, written: fn(&Name<'_>) -> String) -> String {
    let words = text.split(' ').map(|word| {
        let (is_bold, word) = word.strip_prefix('*').map_or((false, word), |rest| (true, rest));
        let (letters, rest) = word.split_once('_').unwrap_or((word, ""));
        let (index, after) = rest.split_at(rest.find([',', ':', ';', ')', '=']).unwrap_or(rest.len()));
        written(&Name { is_bold, letters, index, after })
    });
    words.collect::<Vec<_>>().join(" ")
}

/// A name in a drawing.
fn svg(name: &Name<'_>) -> String {
    let Name { is_bold, letters, index, after } = name;
    let letters =
        if *is_bold { format!(r#"<tspan font-weight="700">{letters}</tspan>"#) } else { (*letters).to_owned() };
    if index.is_empty() {
        return letters;
    }
    format!(r#"{letters}<tspan dy="5" font-size="0.72em">{index}</tspan><tspan dy="-5">{after}&#8203;</tspan>"#)
}

/// A name in the text below it.
fn html(name: &Name<'_>) -> String {
    let Name { is_bold, letters, index, after } = name;
    let letters = if *is_bold { format!("<b>{letters}</b>") } else { (*letters).to_owned() };
    if index.is_empty() { letters } else { format!("{letters}<sub>{index}</sub>{after}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_indices_and_numbers_true_signs() {
        assert_eq!(set("a b_1, c", html), "a b<sub>1</sub>, c");
        assert!(set("*e_1a", svg).contains("font-weight=\"700\">e</tspan><tspan dy=\"5\" font-size=\"0.72em\">1a<"));
        assert_eq!([number(-0.001), number(-1.5)], ["0.00", "−1.50"]);
    }
}
