//! SLOT and TRANSLATOR.

use jointproof::connector::slot::{
    Constraint, ConstraintForce, CrossForces, CrossFrame, Positions, RelativePosition, SlotPositions,
};
use jointproof::connector::translator::{Bending, BendingForce, ContactForce, ContactLoads, RadialForce};
use jointproof::formula::Formula;
use kit::Moving;
use nalgebra::{Rotation3, Vector3};

use super::along::{Along, moving};
use crate::figures::sketch::{Ink, Sketch, View, number};

/// The offsets of the slot, and the multipliers drawn.
const Y0: f64 = 0.9;
const Z0: f64 = 0.8;
const FORCES: [f64; 2] = [0.8, 0.6];

/// Node b in the slot of node a; a rotates, b slides.
pub(super) fn slot(name: &'static str) -> Moving {
    let along = Along { label: "x, position of b along the slot", unit: "", from: 0.4, to: 3.0, steps: 13, start: 8 };
    let turn = Along { label: "rotation of node a", unit: "°", from: -16.0, to: 16.0, steps: 8, start: 4 };
    moving(name, &[along, turn], |x, degrees| {
        let turn = Rotation3::new(Vector3::z() * degrees.to_radians());
        let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis);
        let xa = Vector3::zeros();
        let on_line = |x: f64| xa + e1a * x + e2a * Y0 + e3a * Z0;
        let xb = on_line(x);
        let place = RelativePosition::eval(&Positions { e1a, e2a, e3a, xa, xb });
        let off = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0: Y0, z0: Z0 });
        let [f2, f3] = FORCES;
        let force = ConstraintForce::eval(&CrossFrame { e2a, e3a, f2, f3 }).f;
        let mut sketch = Sketch::new(
            name,
            "The mechanism of SLOT",
            "Node a carries the triad e1a, e2a, e3a. The slot is parallel to e1a at the offsets y0 along e2a and z0 along e3a. Node b \
             is in the slot, at the distance x along it. An arrow shows the force of the slot on b for positive f2 and f3.",
            View::space(92.0, [150.0, 214.0]),
        );
        sketch.band([on_line(-0.3), on_line(3.4)], 22.0);
        sketch.path(&[on_line(-0.5), on_line(3.6)], Ink::Axis);
        sketch.path(&[xa, xa + e3a * Z0, on_line(0.0)], Ink::Dashed);
        sketch.path(&[on_line(0.0), xb], Ink::Accent);
        sketch.triad(xa, [e1a, e2a, e3a], 0.75, "a", Ink::Solid);
        sketch.dot(xa, Ink::Solid);
        sketch.arrow(xb, force, Ink::Force);
        sketch.dot(xb, Ink::Accent);
        sketch.label(xa, [-4.0, 24.0], "a", Ink::Solid);
        sketch.label(xb, [-2.0, 26.0], "b", Ink::Accent);
        sketch.label(on_line(x / 2.0), [-4.0, -12.0], "x", Ink::Accent);
        sketch.label(xa + e3a * (Z0 * 0.6), [4.0, 16.0], "z_0", Ink::Solid);
        sketch.label(xa + e3a * Z0 + e2a * (Y0 / 2.0), [-26.0, 2.0], "y_0", Ink::Solid);
        sketch.label(xb + force, [6.0, 4.0], "force on b", Ink::Force);
        sketch.note(format!("free: x = {} along e_1a", number(place.x)));
        sketch.note(format!(
            "constrained: y − y_0 = {}, z − z_0 = {}; f_2 and f_3 are positive here",
            number(off.gy),
            number(off.gz)
        ));
        sketch.html()
    })
}

/// A shaft in its sleeve under a load at a distance from the middle of the overlap.
pub(super) fn translator() -> Moving {
    let lever = Along { label: "distance of the load", unit: "", from: 0.0, to: 3.0, steps: 12, start: 6 };
    let overlap = Along { label: "overlap L", unit: "", from: 1.0, to: 3.0, steps: 8, start: 4 };
    moving("translator-moving", &[lever, overlap], |lever, l| {
        let load = 1.0;
        let (f2, m3) = (-load, -load * lever);
        let bending = BendingForce::eval(&Bending { m2: 0.0, m3, l });
        let radial = RadialForce::eval(&CrossForces { f2, f3: 0.0 }).fr;
        let fc = ContactForce::eval(&ContactLoads { f2, f3: 0.0, m1: 0.0, m2: 0.0, m3, rr: 0.3, l }).fc;
        let mut sketch = Sketch::new(
            "translator-moving",
            "The contact forces of TRANSLATOR under an eccentric load",
            "A shaft in a sleeve that overlap by L. A load acts on the shaft at a lever from the middle of the overlap. Below it stand the \
             forces between shaft and sleeve: across the slot, and two opposite ones at the ends of the overlap that carry the moment.",
            View::plane(66.0, [180.0, 150.0]),
        );
        let at = |x: f64, y: f64| Vector3::new(x, y, 0.0);
        let half = l / 2.0;
        // The sleeve, in section, with the shaft in it.
        for side in [-1.0, 1.0] {
            sketch.area(
                &[at(-half, side * 0.34), at(half, side * 0.34), at(half, side * 0.62), at(-half, side * 0.62)],
                Ink::Solid,
            );
        }
        sketch.area(&[at(-half - 0.3, -0.3), at(4.4, -0.3), at(4.4, 0.3), at(-half - 0.3, 0.3)], Ink::Accent);
        sketch.path(&[at(-2.6, 0.0), at(4.8, 0.0)], Ink::Axis);
        sketch.arrow(at(lever, 1.3), at(0.0, -0.95), Ink::Solid);
        sketch.label(at(lever, 1.3), [8.0, 6.0], "load 1", Ink::Solid);
        // The forces on the shaft, with lengths computed by the formulas.
        let unit = 0.8;
        let end = bending.f_bend / 2.0 * unit;
        sketch.arrow(at(half, -0.32 - end), at(0.0, end), Ink::Force);
        sketch.arrow(at(-half, 0.32 + end), at(0.0, -end), Ink::Force);
        sketch.arrow(at(0.0, -0.32 - radial * unit), at(0.0, radial * unit), Ink::Force);
        sketch.path(&[at(-half, -1.05), at(half, -1.05)], Ink::Thin);
        sketch.path(&[at(-half, -1.15), at(-half, -0.95)], Ink::Thin);
        sketch.path(&[at(half, -1.15), at(half, -0.95)], Ink::Thin);
        sketch.label(at(0.0, -1.05), [-5.0, 18.0], "L", Ink::Solid);
        sketch.label(at(-half, 0.62), [-88.0, 6.0], "sleeve, a", Ink::Solid);
        sketch.label(at(3.6, 0.3), [0.0, -8.0], "shaft, b", Ink::Accent);
        sketch.note(format!("radial force F_r = {}; from bending F_bend = {}", number(radial), number(bending.f_bend)));
        sketch.note(format!("contact force F_C = {}", number(fc)));
        sketch.html()
    })
}
