//! SLIDER, and the closest point of a slide line.

use jointproof::connector::slider::Slider;
use jointproof::contact::slide_line::{
    ClosestLinear, ClosestSmoothedLinear, LinearCornerPlace, LinearCornerSlave, LinearPlace, LinearPoint, LinearSlave,
    SmoothedLinearPoint,
};
use jointproof::formula::{Formula, value};
use kit::Moving;
use nalgebra::{Vector2, Vector3};

use super::along::{Along, moving};
use crate::figures::sketch::{Ink, Point, Sketch, View, number};

/// Node m on the line of nodes 1 and n: two of its coordinates follow from the third.
pub(super) fn slider() -> Moving {
    let kept = Along { label: "kept coordinate of m", unit: "", from: -0.4, to: 3.4, steps: 19, start: 11 };
    let height = Along { label: "height of node n", unit: "", from: 0.0, to: 1.6, steps: 8, start: 5 };
    moving("slider-moving", &[kept, height], |x, height| {
        let x1 = Vector3::new(0.0, 0.2, 0.3);
        let xn = Vector3::new(3.0, height, 0.8);
        let line = Slider::new(x1, xn).expect("the nodes are apart");
        // The line is longest along the first axis, so this coordinate is kept, and the other two follow.
        let xm = line.place(Vector3::new(x, 0.0, 0.0)).expect("the place is finite");
        let across = line.basis();
        let mut sketch = Sketch::new(
            "slider-moving",
            "The mechanism of SLIDER",
            "A straight line through node 1 and node n, and node m on it. Two directions normal to the line, t1 and t2, begin at node m; in them m is \
             constrained, along the line it is free. Dashed lines show the coordinates of m.",
            View::space(118.0, [110.0, 210.0]),
        );
        let beyond = |share: f64| x1 + (xn - x1) * share;
        sketch.path(&[beyond(-0.2), beyond(1.25)], Ink::Axis);
        sketch.path(&[x1, xn], Ink::Solid);
        sketch.path(&[Vector3::new(xm.x, 0.0, 0.0), Vector3::new(xm.x, 0.0, xm.z), xm], Ink::Dashed);
        sketch.arrow(Vector3::zeros(), Vector3::new(3.6, 0.0, 0.0), Ink::Thin);
        sketch.arrow(Vector3::zeros(), Vector3::new(0.0, 1.2, 0.0), Ink::Thin);
        sketch.arrow(Vector3::zeros(), Vector3::new(0.0, 0.0, 1.0), Ink::Thin);
        sketch.arrow(xm, across.t1 * 0.6, Ink::Force);
        sketch.arrow(xm, across.t2 * 0.6, Ink::Force);
        sketch.label(xm + across.t1 * 0.6, [6.0, 4.0], "*t_1", Ink::Force);
        sketch.label(xm + across.t2 * 0.6, [6.0, 4.0], "*t_2", Ink::Force);
        sketch.dot(x1, Ink::Solid);
        sketch.dot(xn, Ink::Solid);
        sketch.dot(xm, Ink::Accent);
        sketch.label(x1, [-16.0, -8.0], "1", Ink::Solid);
        sketch.label(xn, [10.0, -6.0], "n", Ink::Solid);
        sketch.label(xm, [-6.0, -14.0], "m", Ink::Accent);
        sketch.note(format!(
            "x_m = {} is given; y_m = {} and z_m = {} follow",
            number(xm.x),
            number(xm.y),
            number(xm.z)
        ));
        sketch.note("free: along the line; constrained: along t_1 and t_2");
        sketch.html()
    })
}

/// The smoothed corner of a slide line, and the closest point of a slave node that passes it.
pub(super) fn smoothed() -> Moving {
    let place = Along { label: "position of the slave node", unit: "", from: 0.4, to: 5.6, steps: 26, start: 12 };
    let fraction =
        Along { label: "smoothed part f of each segment", unit: "", from: 0.05, to: 0.5, steps: 9, start: 3 };
    moving("slide-line-moving", &[place, fraction], |x, f| {
        let [x1, x2, x3] = [[0.2, 0.3], [3.0, 1.5], [5.8, 0.1]].map(Vector2::from);
        let xs = Vector2::new(x, 2.2);
        let mut sketch = Sketch::new(
            "slide-line-moving",
            "The closest point on a slide line with a smoothed corner",
            "Two straight segments with a rounded corner, a slave node above them, and the line from it to its closest point, which is \
             perpendicular to the slide line there. The closest point passes the corner without a jump.",
            View::plane(84.0, [30.0, 240.0]),
        );
        let on = |p: Vector2<f64>| Point::new(p.x, p.y, 0.0);
        let straight =
            |from: Vector2<f64>, to: Vector2<f64>, g: f64| LinearPoint::eval(&LinearPlace { x1: from, x2: to, g }).x;
        let corner = |t: f64| SmoothedLinearPoint::eval(&LinearCornerPlace { x1, x2, x3, f, t }).x;
        // The line drawn: from node 1 to the corner, along the corner, and on to node 3.
        let mut line = vec![on(x1)];
        line.extend((0..=24).map(|k| on(corner(f64::from(k) / 24.0))));
        line.push(on(x3));
        sketch.path(&[on(x1), on(x2), on(x3)], Ink::Dashed);
        sketch.path(&line, Ink::Solid);
        // The formula finds the closest point on each piece, and the nearest of the three is used.
        let on_straight = |from, to, range: [f64; 2]| {
            let g = value::<ClosestLinear>(&LinearSlave { xs, x1: from, x2: to }).ok()?.g.clamp(range[0], range[1]);
            Some(straight(from, to, g))
        };
        let on_corner =
            value::<ClosestSmoothedLinear>(&LinearCornerSlave { xs, x1, x2, x3, f }).ok().map(|found| corner(found.t));
        let feet = [on_straight(x1, x2, [-1.0, 1.0 - 2.0 * f]), on_corner, on_straight(x2, x3, [2.0 * f - 1.0, 1.0])];
        let nearer = |p: Vector2<f64>, q: Vector2<f64>| if (q - xs).norm() < (p - xs).norm() { q } else { p };
        let foot = feet.into_iter().flatten().reduce(nearer).unwrap_or(x2);
        sketch.path(&[on(xs), on(foot)], Ink::Accent);
        for (node, name, beside) in [(x1, "1", [-4.0, 24.0]), (x2, "2", [10.0, -4.0]), (x3, "3", [-4.0, 24.0])] {
            sketch.dot(on(node), Ink::Solid);
            sketch.label(on(node), beside, name, Ink::Solid);
        }
        sketch.dot(on(xs), Ink::Accent);
        sketch.dot(on(foot), Ink::Accent);
        sketch.label(on(xs), [10.0, -4.0], "slave node", Ink::Accent);
        sketch.note(format!("closest point at ({}, {})", number(foot.x), number(foot.y)));
        sketch.note(format!("distance {}", number((foot - xs).norm())));
        sketch.html()
    })
}
