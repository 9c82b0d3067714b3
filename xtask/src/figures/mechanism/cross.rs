//! Rotated triads: the Cardan angles, UNIVERSAL and UJOINT.

use jointproof::connector::ujoint::{CrossAxes, CrossDirection, CrossLoads, Decomposition};
use jointproof::connector::universal::{Angles, Constraint, Shafts};
use jointproof::element::cardan::Triads;
use jointproof::formula::Formula;
use kit::Moving;

use super::along::{Along, angles, moving, turned, upright};
use crate::figures::sketch::{Ink, Point, Sketch, View, number};

fn degrees(label: &'static str, to: f64, start: usize) -> Along {
    Along { label, unit: "°", from: -to, to, steps: 12, start }
}

/// The triad of b, rotated by the first two Cardan angles.
pub(super) fn cardan() -> Moving {
    moving(
        "cardan-moving",
        &[degrees("α, about e1a", 60.0, 9), degrees("β, about the rotated second axis", 84.0, 9)],
        |alpha, beta| {
            let (a, b) = (upright(), turned(alpha, beta, 25.0));
            let found = angles(a, b);
            let mut sketch = Sketch::new(
                "cardan-moving",
                "The triad of b, rotated relative to that of a",
                "Two triads with one origin: that of a in the colour of the text, that of b in another colour, turned by α about e1a, then by β \
             about the second axis, then by γ of 25 degrees about the third.",
                View::space(120.0, [270.0, 160.0]),
            );
            let origin = Point::zeros();
            sketch.triad(origin, a, 1.0, "a", Ink::Solid);
            sketch.triad(origin, b, 1.0, "b", Ink::Accent);
            // The path of e3b as β grows, for this α.
            let arc: Vec<_> = (0..=24).map(|k| turned(alpha, beta * f64::from(k) / 24.0, 0.0)[2]).collect();
            sketch.path(&arc, Ink::Dashed);
            let arc: Vec<_> = (0..=24).map(|k| turned(alpha * f64::from(k) / 24.0, 0.0, 0.0)[2]).collect();
            sketch.path(&arc, Ink::Dashed);
            sketch.note(format!(
                "the formula finds α = {}°, β = {}°, γ = {}°",
                number(found[0]),
                number(found[1]),
                number(found[2])
            ));
            sketch.html()
        },
    )
}

/// Two shafts, their yokes drawn in these inks, and the cross between them.
fn joint(sketch: &mut Sketch, a: [Point; 3], b: [Point; 3], inks: [Ink; 2]) {
    let origin = Point::zeros();
    let arm = 0.55;
    // Shafts lie along the second axes: a's to the left, b's to the right.
    let shafts = [(-a[1], a[0], "shaft of a"), (b[1], b[2], "shaft of b")];
    for ((shaft, axis, name), ink) in shafts.into_iter().zip(inks) {
        sketch.path(&[origin + shaft * 1.0, origin + shaft * 1.6], ink);
        for side in [-1.0, 1.0] {
            sketch.path(
                &[origin + axis * (side * arm), origin + axis * (side * arm) + shaft * 0.7, origin + shaft * 1.0],
                ink,
            );
        }
        sketch.label(origin + shaft * 1.6, [-36.0, 26.0], name, ink);
    }
    sketch.path(&[a[0] * -arm, a[0] * arm], Ink::Solid);
    sketch.path(&[b[2] * -arm, b[2] * arm], Ink::Accent);
    for side in [-1.0, 1.0] {
        sketch.dot(a[0] * (side * arm), Ink::Solid);
        sketch.dot(b[2] * (side * arm), Ink::Accent);
    }
    sketch.label(a[0] * arm, [10.0, 16.0], "*e_1a", Ink::Solid);
    sketch.label(b[2] * arm, [-34.0, 4.0], "*e_3b", Ink::Accent);
}

/// A sketch with horizontal shafts.
fn lying(name: &'static str, title: &'static str, description: &'static str) -> Sketch {
    Sketch::new(name, title, description, View::lying(140.0, [280.0, 150.0]))
}

/// UNIVERSAL: two rotations are free, and the arms stay at right angles.
pub(super) fn universal() -> Moving {
    moving(
        "universal-moving",
        &[degrees("α, about the arm e1a", 48.0, 9), degrees("γ, about the arm e3b", 48.0, 6)],
        |alpha, gamma| {
            let (a, b) = (upright(), turned(alpha, 0.0, gamma));
            let held = Constraint::eval(&Shafts { e1a: a[0], e3b: b[2], c0: 0.0 }).g;
            let free = Angles::eval(&Triads::new(a, b));
            let mut sketch = lying(
                "universal-moving",
                "The mechanism of JOIN and UNIVERSAL",
                "A cross with two arms. The yoke of shaft a turns about the arm e1a, that of shaft b about the arm e3b. The centres stay together.",
            );
            joint(&mut sketch, a, b, [Ink::Solid, Ink::Accent]);
            sketch.note(format!(
                "free: α = {}°, γ = {}°",
                number(free.alpha.to_degrees()),
                number(free.gamma.to_degrees())
            ));
            sketch.note(format!("constrained: e_1a · e_3b = {}; the centres by JOIN", number(held)));
            sketch.html()
        },
    )
}

/// The length of an arrow for a force of 1.
const SIZE: f64 = 0.9;

/// UJOINT: the components of a force at the centre along the arms and perpendicular to them.
pub(super) fn forces() -> Moving {
    let turn = Along { label: "direction of the force", unit: "°", from: 0.0, to: 180.0, steps: 12, start: 4 };
    moving("ujoint-moving", &[degrees("α, about the arm e1a", 48.0, 9), turn], |alpha, direction| {
        let (a, b) = (upright(), turned(alpha, 0.0, 0.0));
        let (f3, f1) = direction.to_radians().sin_cos();
        let [e1a, e2a, e3a] = a;
        let of = Decomposition::eval(&CrossLoads { e1a, e2a, e3a, e3b: b[2], f1, f2: 0.35, f3 });
        let across = CrossDirection::eval(&CrossAxes { e1a, e3b: b[2] }).e_cross;
        let mut sketch = lying(
            "ujoint-moving",
            "The force on the cross of a UJOINT",
            "The cross of a universal joint between two shafts, and a force at its centre with its components along the arm e1a, along the arm e3b \
             and normal to the cross.",
        );
        joint(&mut sketch, a, b, [Ink::Thin; 2]);
        let force = e1a * f1 + e2a * 0.35 + e3a * f3;
        let parts = [e1a * of.f_axial1, b[2] * of.f_axial3, across * of.f_bend];
        for part in parts {
            sketch.arrow(Point::zeros(), part * SIZE, Ink::Force);
        }
        let corner = parts[0] + parts[1];
        sketch.path(&[parts[0] * SIZE, corner * SIZE, force * SIZE], Ink::Dashed);
        sketch.arrow(Point::zeros(), force * SIZE, Ink::Solid);
        sketch.label(force * SIZE, [8.0, 0.0], "*F", Ink::Solid);
        sketch.label(parts[2] * SIZE, [6.0, 18.0], "F_bend", Ink::Force);
        sketch.note(format!("F along e_1a: {}, along e_3b: {}", number(of.f_axial1), number(of.f_axial3)));
        sketch.note(format!("F_bend, normal to the cross: {}; it bends the pins", number(of.f_bend)));
        sketch.html()
    })
}
