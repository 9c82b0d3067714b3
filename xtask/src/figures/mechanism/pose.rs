//! JOIN and ALIGN: in the triad of node a, the position of node b is fixed, or its orientation.

use jointproof::connector::align::{self, ConstraintMoment, Moments, Orientations};
use jointproof::connector::join::{self, Joined};
use jointproof::element::cardan::{Angles, Triads};
use jointproof::formula::Formula;
use kit::Moving;
use nalgebra::{Rotation3, Vector3};

use super::along::{Along, moving, turned};
use crate::figures::sketch::{Ink, Point, Sketch, View, number};

/// The triad of a, rotated about the third axis of the drawing.
fn turned_about_third(degrees: f64) -> [Point; 3] {
    let turn = Rotation3::new(Vector3::z() * degrees.to_radians());
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis)
}

fn turn_of_a() -> Along {
    Along { label: "rotation of node a", unit: "°", from: -20.0, to: 12.0, steps: 8, start: 5 }
}

/// JOIN: b keeps its position in the triad of a, and rotates freely.
pub(super) fn join() -> Moving {
    let turn_of_b = Along { label: "rotation of node b", unit: "°", from: -60.0, to: 60.0, steps: 12, start: 8 };
    moving("join-moving", &[turn_of_a(), turn_of_b], |of_a, of_b| {
        let [e1a, e2a, e3a] = turned_about_third(of_a);
        let d0 = Vector3::new(1.9, 0.7, 0.25);
        let xa = Vector3::zeros();
        let xb = xa + e1a * d0.x + e2a * d0.y + e3a * d0.z;
        let g = join::Constraint::eval(&Joined { e1a, e2a, e3a, xa, xb, d0 }).g;
        let mut sketch = Sketch::new(
            "join-moving",
            "The mechanism of JOIN",
            "Node a with its triad e1a, e2a, e3a. Node b is at fixed components d01, d02, d03 along that triad and moves with it. The triad of b \
             turns freely.",
            View::space(95.0, [150.0, 215.0]),
        );
        let first = xa + e1a * d0.x;
        sketch.path(&[xa, first, first + e2a * d0.y, xb], Ink::Dashed);
        sketch.triad(xa, [e1a, e2a, e3a], 0.7, "a", Ink::Solid);
        sketch.triad(xb, turned(of_b, of_b / 2.0, 0.0), 0.6, "b", Ink::Accent);
        sketch.dot(xa, Ink::Solid);
        sketch.dot(xb, Ink::Accent);
        sketch.label(xa, [-18.0, -8.0], "a", Ink::Solid);
        sketch.label(xb, [-18.0, -8.0], "b", Ink::Accent);
        sketch.label(xa + e1a * 1.3, [-4.0, 22.0], "d_01", Ink::Solid);
        sketch.label(first + e2a * (d0.y / 2.0), [8.0, 5.0], "d_02", Ink::Solid);
        sketch.note("free: the three rotations of b");
        sketch.note(format!("constrained: g_1 = {}, g_2 = {}, g_3 = {}", number(g.x), number(g.y), number(g.z)));
        sketch.html()
    })
}

/// ALIGN: b keeps its orientation in the triad of a, and translates freely.
pub(super) fn align() -> Moving {
    let place = Along { label: "position of node b", unit: "", from: 1.2, to: 3.0, steps: 9, start: 5 };
    moving("align-moving", &[turn_of_a(), place], |of_a, place| {
        let a = turned_about_third(of_a);
        // Initially aligned: b has the triad of a.
        let aligned = Orientations::new(&Triads::new(a, a), &Angles { alpha: 0.0, beta: 0.0, gamma: 0.0 });
        let off = align::Constraint::eval(&aligned);
        let [e1a, e2a, e3a] = a;
        let moment = ConstraintMoment::eval(&Moments { e1a, e2a, e3a, m1: 0.6, m2: 0.6, m3: 0.0 }).m;
        let (xa, xb) = (Vector3::zeros(), Vector3::new(place, 0.9 - place / 4.0, 0.2));
        let mut sketch = Sketch::new(
            "align-moving",
            "The mechanism of ALIGN",
            "Two nodes with parallel triads. When node a turns, node b turns with it. Node b may be anywhere. An arrow shows the moment on b for \
             positive m1 and m2.",
            View::space(105.0, [130.0, 200.0]),
        );
        sketch.triad(xa, a, 0.7, "a", Ink::Solid);
        sketch.triad(xb, a, 0.7, "b", Ink::Accent);
        sketch.arrow(xb, moment, Ink::Force);
        sketch.label(xb + moment, [8.0, 6.0], "moment on b", Ink::Force);
        sketch.dot(xa, Ink::Solid);
        sketch.dot(xb, Ink::Accent);
        sketch.label(xa, [-18.0, -8.0], "a", Ink::Solid);
        sketch.label(xb, [-18.0, -8.0], "b", Ink::Accent);
        sketch.note("free: the three displacements of b");
        sketch.note(format!(
            "constrained: u_r1 = {}, u_r2 = {}, u_r3 = {}",
            number(off.ur1),
            number(off.ur2),
            number(off.ur3)
        ));
        sketch.html()
    })
}
