//! Friction, the pressure of interaction laws, and the torque of a slide-line element.

use jointproof::contact::coulomb::{ReturnMap, Tractions, Trial, Yield};
use jointproof::contact::interaction::{
    Damping, DampingContact, ExponentialContact, LinearContact, PressureExponential, PressureLinear,
};
use jointproof::contact::slide_line::{LinearPressures, TorqueLinear};
use jointproof::formula::Formula;
use kit::Moving;
use nalgebra::{Vector2, Vector3};

use super::along::{Along, moving};
use crate::figures::sketch::{Ink, Point, Sketch, View, number};

const MU: f64 = 0.5;

fn at(x: f64, y: f64) -> Point {
    Vector3::new(x, y, 0.0)
}

/// A block pushed along a surface: the friction force as a function of the trial force.
pub(super) fn stick_and_slip() -> Moving {
    let trial = Along { label: "trial force", unit: "", from: -2.0, to: 2.0, steps: 20, start: 16 };
    let normal = Along { label: "F_N, normal force", unit: "", from: 0.0, to: 2.0, steps: 8, start: 6 };
    moving("friction-moving", &[trial, normal], |f_trial, normal| {
        let f = ReturnMap::eval(&Trial { f_trial, mu: MU, r#fn: normal }).f;
        let phi = Yield::eval(&Tractions { p: f_trial.abs(), mu: MU, r#fn: normal }).phi;
        let mut sketch = Sketch::new(
            "friction-moving",
            "Stick and slip",
            "On the left a block that is pressed on a surface and pushed along it; an arrow shows the friction force. On the right the friction \
             force over the trial force: it follows it up to the limits of plus and minus μ F_N and stays there.",
            View::plane(62.0, [130.0, 170.0]),
        );
        sketch.area(&[at(-0.7, 0.0), at(0.7, 0.0), at(0.7, 0.9), at(-0.7, 0.9)], Ink::Accent);
        sketch.path(&[at(-1.9, 0.0), at(1.9, 0.0)], Ink::Solid);
        sketch.arrow(at(0.0, 0.95 + normal * 0.6), at(0.0, -normal * 0.6), Ink::Solid);
        sketch.arrow(at(0.0, 0.45), at(f_trial * 0.6, 0.0), Ink::Solid);
        sketch.arrow(at(0.0, -0.08), at(-f * 0.6, 0.0), Ink::Force);
        sketch.label(at(0.0, 0.95 + normal * 0.6), [8.0, 4.0], "F_N", Ink::Solid);
        sketch.label(at(f_trial * 0.6, 0.45), [4.0, -8.0], "trial", Ink::Solid);
        sketch.label(at(-f * 0.6, -0.08), [-10.0, 24.0], "f", Ink::Force);
        // The diagram, with its origin to the right.
        let d = |x: f64, y: f64| at(4.6 + x * 0.85, 0.6 + y * 1.1);
        sketch.arrow(d(-2.3, 0.0), at(4.1, 0.0), Ink::Thin);
        sketch.arrow(d(0.0, -1.3), at(0.0, 3.0), Ink::Thin);
        let curve: Vec<_> = (-40..=40)
            .map(|k| f64::from(k) / 20.0)
            .map(|x| d(x, ReturnMap::eval(&Trial { f_trial: x, mu: MU, r#fn: normal }).f))
            .collect();
        sketch.path(&curve, Ink::Accent);
        sketch.path(&[d(f_trial, 0.0), d(f_trial, f)], Ink::Dashed);
        sketch.dot(d(f_trial, f), Ink::Force);
        sketch.label(d(2.3, 0.0), [-26.0, 18.0], "trial", Ink::Solid);
        sketch.label(d(0.0, 1.4), [6.0, 6.0], "f", Ink::Force);
        let state = if phi < 0.0 { "sticks" } else { "slips" };
        sketch.note(format!("μ = {}, so the limit is {}", number(MU), number(MU * normal)));
        sketch.note(format!("Φ of the trial force = {}: it {state}, f = {}", number(phi), number(f)));
        sketch.html()
    })
}

/// Two approaching surfaces: the pressure of each law.
pub(super) fn pressure() -> Moving {
    let overclosure = Along { label: "h, overclosure", unit: "", from: -1.5, to: 1.0, steps: 20, start: 16 };
    let rate = Along { label: "v, closing rate", unit: "", from: -1.0, to: 1.0, steps: 8, start: 6 };
    moving("interaction-moving", &[overclosure, rate], |h, v| {
        let linear = PressureLinear::eval(&LinearContact { h, k: 1.0 }).p;
        let exponential = PressureExponential::eval(&ExponentialContact { h, c0: 1.0, p0: 1.0 }).p;
        let damping = Damping::eval(&DampingContact { h, v, mu0: 1.0, c0: 1.0, eta: 0.4 }).p;
        let mut sketch = Sketch::new(
            "interaction-moving",
            "The pressure between two surfaces by three laws",
            "Two surfaces, the upper one at the clearance minus h from the lower one. Beside them three columns: the pressure of the linear law, of \
             the exponential law, and of damping.",
            View::plane(70.0, [60.0, 200.0]),
        );
        sketch.area(&[at(0.0, 0.0), at(2.2, 0.0), at(2.2, -0.5), at(0.0, -0.5)], Ink::Solid);
        sketch.area(&[at(0.0, -h), at(2.2, -h), at(2.2, 0.7 - h), at(0.0, 0.7 - h)], Ink::Accent);
        sketch.arrow(at(1.1, 0.5 - h), at(0.0, -v * 0.7), Ink::Solid);
        sketch.label(at(1.1, 0.5 - h - v * 0.35), [10.0, 5.0], "v", Ink::Solid);
        sketch.path(&[at(2.35, 0.0), at(2.35, -h)], Ink::Force);
        sketch.label(at(2.35, -h / 2.0), [8.0, 5.0], "h", Ink::Force);
        for (place, name, p) in [(3.3, "linear", linear), (4.3, "exponential", exponential), (6.1, "damping", damping)]
        {
            let top = p.clamp(-0.8, 2.2);
            sketch.area(&[at(place, 0.0), at(place + 0.5, 0.0), at(place + 0.5, top), at(place, top)], Ink::Force);
            sketch.label(at(place, 0.0), [-10.0, if top < 0.0 { -8.0 } else { 20.0 }], name, Ink::Solid);
            sketch.label(at(place, top.max(0.0)), [2.0, -8.0], &number(p), Ink::Force);
        }
        sketch.path(&[at(3.0, 0.0), at(7.0, 0.0)], Ink::Thin);
        sketch.note("k = 1, c_0 = 1, p_0 = 1, μ_0 = 1, η = 0.4");
        sketch.note(if h > 0.0 { "the surfaces overlap by h" } else { "the surfaces are −h apart" });
        sketch.html()
    })
}

/// An axisymmetric element under pressure: the torque transmitted by friction with coefficient 1.
pub(super) fn torque() -> Moving {
    let slope = Along { label: "pressure at the outer node", unit: "", from: 0.0, to: 2.0, steps: 10, start: 7 };
    let radius = Along { label: "radius of the inner node", unit: "", from: 0.5, to: 2.0, steps: 6, start: 2 };
    moving("torque-moving", &[slope, radius], |p2, r1| {
        let p1 = 1.0;
        let (x1, x2) = (Vector2::new(r1, 0.6), Vector2::new(r1 + 2.4, 1.4));
        let t = TorqueLinear::eval(&LinearPressures { x1, x2, p1, p2 }).t;
        let mut sketch = Sketch::new(
            "torque-moving",
            "The torque of a slide-line element",
            "A half plane with the axis of rotation at the left. An element runs from an inner to an outer node; arrows show the pressure on it, \
             which is linear along it.",
            View::plane(80.0, [60.0, 250.0]),
        );
        sketch.path(&[at(0.0, -0.2), at(0.0, 2.8)], Ink::Axis);
        sketch.label(at(0.0, 2.8), [6.0, 6.0], "axis", Ink::Solid);
        sketch.arrow(at(0.0, 0.0), at(5.6, 0.0), Ink::Thin);
        sketch.label(at(5.6, 0.0), [-8.0, 18.0], "r", Ink::Solid);
        let along = |s: f64| x1 + (x2 - x1) * s;
        let normal = {
            let d = (x2 - x1).normalize();
            at(-d.y, d.x)
        };
        let heads: Vec<_> =
            [0.0, 1.0].map(|s| at(along(s).x, along(s).y) + normal * ((p1 + (p2 - p1) * s) * 0.5)).into();
        sketch.area(&[at(x1.x, x1.y), heads[0], heads[1], at(x2.x, x2.y)], Ink::Force);
        for k in 0..=6 {
            let s = f64::from(k) / 6.0;
            let p = normal * ((p1 + (p2 - p1) * s) * 0.5);
            sketch.arrow(at(along(s).x, along(s).y) + p, -p, Ink::Force);
        }
        sketch.path(&[at(x1.x, x1.y), at(x2.x, x2.y)], Ink::Solid);
        for (node, name) in [(x1, "1"), (x2, "2")] {
            sketch.path(&[at(0.0, node.y), at(node.x, node.y)], Ink::Dashed);
            sketch.dot(at(node.x, node.y), Ink::Accent);
            sketch.label(at(node.x, node.y), [-4.0, 24.0], name, Ink::Accent);
        }
        sketch.note(format!("pressure {} at node 1, {} at node 2", number(p1), number(p2)));
        sketch.note(format!("torque with friction 1: {}", number(t)));
        sketch.html()
    })
}
