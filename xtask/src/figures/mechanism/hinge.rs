//! HINGE: two leaves on a pin, and a force on it.

use jointproof::connector::hinge::{ContactMoment, PinLoads};
use jointproof::connector::revolute::{Across, Angle, Axes, Constraint};
use jointproof::formula::Formula;
use kit::Moving;

use super::along::{Along, moving, turned, upright};
use crate::figures::sketch::{Ink, Point, Sketch, View, number};

/// The half length of the pin, and how far a leaf reaches from it.
const PIN: f64 = 0.9;
const LEAF: f64 = 1.1;
/// The force on the pin, and the length of its arrow.
const FORCE: f64 = 4.0;
const ARROW: f64 = 0.9;

/// A leaf between both ends of the pin, in this direction.
fn leaf(sketch: &mut Sketch, along: Point, out: Point, ink: Ink) {
    let [near, far] = [along * -PIN, along * PIN];
    sketch.path(&[near, near + out * LEAF, far + out * LEAF, far, near], ink);
}

/// One rotation is free; the force on the pin produces the contact moment.
pub(super) fn hinge() -> Moving {
    let rotation = Along { label: "α, about the pin", unit: "°", from: -120.0, to: 120.0, steps: 12, start: 9 };
    let force = Along { label: "angle of the force to the pin", unit: "°", from: 0.0, to: 90.0, steps: 12, start: 4 };
    moving("hinge-moving", &[rotation, force], |alpha, direction| {
        let (a, b) = (upright(), turned(alpha, 0.0, 0.0));
        let [e1a, e2a, e3a] = a;
        let [_, e2b, e3b] = b;
        let held = Constraint::eval(&Axes { e1a, e2b, e3b, c2: 0.0, c3: 0.0 });
        let found = Angle::eval(&Across { e2a, e3a, e3b }).alpha;
        let (across, along) = direction.to_radians().sin_cos();
        let (f1, f2) = (FORCE * along, FORCE * across);
        let loads = PinLoads { f1, f2, f3: 0.0, m2: 0.0, m3: 0.0, rp: 0.5, ra: 0.25, ls: 0.0 };
        let mut sketch = Sketch::new(
            "hinge-moving",
            "The mechanism of a HINGE",
            "Two leaves on a pin. The leaf of b rotates about the pin, that of a does not; a force acts on the pin.",
            View::space(90.0, [270.0, 125.0]),
        );
        leaf(&mut sketch, e1a, -e2a, Ink::Solid);
        leaf(&mut sketch, b[0], e2b, Ink::Accent);
        sketch.path(&[e1a * -PIN * 1.2, e1a * PIN * 1.2], Ink::Thin);
        sketch.label(e1a * PIN * 1.2, [8.0, 10.0], "*e_1a = *e_1b", Ink::Solid);
        sketch.label(-e2a * LEAF, [-26.0, 18.0], "a", Ink::Solid);
        sketch.label(e2b * LEAF, [10.0, 4.0], "b", Ink::Accent);
        sketch.arrow(Point::zeros(), (e1a * along + e2a * across) * ARROW, Ink::Force);
        sketch.note(format!("free: α = {}°", number(found.to_degrees())));
        sketch.note(format!("constrained: e_1a · e_2b = {}, e_1a · e_3b = {}", number(held.g2), number(held.g3)));
        sketch.note(format!(
            "M_C of a force of 4, with R_p = 0.5 and R_a = 0.25: {}",
            number(ContactMoment::eval(&loads).mc)
        ));
        sketch.html()
    })
}
