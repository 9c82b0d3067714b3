//! A slide line with smoothed corners and projections onto it, and the laws of pressure and damping.

use jointproof::contact::interaction::{
    Damping, DampingContact, ExponentialContact, LinearContact, PressureExponential, PressureLinear,
};
use jointproof::contact::slide_line::{
    ClosestLinear, ClosestSmoothedLinear, LinearCornerPlace, LinearCornerSlave, LinearPlace, LinearPoint, LinearSlave,
    SmoothedLinearPoint,
};
use jointproof::formula::{Formula, value};
use kit::{Axis, Chart, Curve};
use nalgebra::Vector2;

type Point = Vector2<f64>;

const NODES: [[f64; 2]; 4] = [[0.6, 1.3], [2.4, 0.7], [4.3, 2.2], [6.1, 1.7]];
const SLAVES: [[f64; 2]; 6] = [[1.5, 2.2], [2.2, 1.8], [3.2, 2.7], [4.4, 3.3], [5.1, 1.2], [6.5, 2.6]];
const FRACTION: f64 = 0.2;
/// Points of a drawn corner.
const STEPS: u32 = 16;
/// Lifts the pen.
const GAP: (f64, f64) = (f64::NAN, f64::NAN);

/// A piece of the line.
enum Piece {
    Straight([Point; 2]),
    Corner([Point; 3]),
}

impl Piece {
    /// The point at a parameter from 0 to 1.
    fn at(&self, part: f64) -> Point {
        match *self {
            Self::Straight([x1, x2]) => LinearPoint::eval(&LinearPlace { x1, x2, g: 2.0 * part - 1.0 }).x,
            Self::Corner([x1, x2, x3]) => {
                SmoothedLinearPoint::eval(&LinearCornerPlace { x1, x2, x3, f: FRACTION, t: part }).x
            }
        }
    }

    /// The point closest to the slave point.
    fn foot(&self, xs: Point) -> Option<Point> {
        let part = match *self {
            Self::Straight([x1, x2]) => f64::midpoint(value::<ClosestLinear>(&LinearSlave { xs, x1, x2 }).ok()?.g, 1.0),
            Self::Corner([x1, x2, x3]) => {
                value::<ClosestSmoothedLinear>(&LinearCornerSlave { xs, x1, x2, x3, f: FRACTION }).ok()?.t
            }
        };
        Some(self.at(part))
    }
}

/// The pieces of the line in sequence: the remaining part of each segment, and the corners.
fn pieces(nodes: &[Point]) -> Vec<Piece> {
    let towards = |from: Point, to: Point| from + (to - from) * FRACTION;
    let last = nodes.len().saturating_sub(2);
    let mut pieces = Vec::new();
    for (k, pair) in nodes.windows(2).enumerate() {
        let start = if k == 0 { pair[0] } else { towards(pair[0], pair[1]) };
        let end = if k == last { pair[1] } else { towards(pair[1], pair[0]) };
        pieces.push(Piece::Straight([start, end]));
        pieces.extend(nodes.get(k + 2).map(|&next| Piece::Corner([pair[0], pair[1], next])));
    }
    pieces
}

fn closest(pieces: &[Piece], xs: Point) -> Option<Point> {
    let nearer = |a: Point, b: Point| if (b - xs).norm() < (a - xs).norm() { b } else { a };
    pieces.iter().filter_map(|piece| piece.foot(xs)).reduce(nearer)
}

/// The line, the corners removed by smoothing, and slave points with their closest points.
pub(crate) fn line() -> Chart<'static> {
    let drawn = |x: Point| (x.x, x.y);
    let pieces = pieces(&NODES.map(Point::from));
    let mut smoothed = Vec::new();
    let mut sharp = Vec::new();
    for piece in &pieces {
        match piece {
            Piece::Straight(ends) => smoothed.extend(ends.iter().copied().map(drawn)),
            Piece::Corner([_, vertex, _]) => {
                smoothed.extend((1..STEPS).map(|k| drawn(piece.at(f64::from(k) / f64::from(STEPS)))));
                sharp.extend([drawn(piece.at(0.0)), drawn(*vertex), drawn(piece.at(1.0)), GAP]);
            }
        }
    }
    let mut projections = Vec::new();
    for xs in SLAVES.map(Point::from) {
        let arm = |x: f64, y: f64| drawn(xs + Point::new(x, y));
        let cross = [arm(-0.06, -0.06), arm(0.06, 0.06), GAP, arm(-0.06, 0.06), arm(0.06, -0.06), GAP];
        projections.extend(cross);
        projections.extend(closest(&pieces, xs).into_iter().flat_map(|foot| [drawn(xs), drawn(foot), GAP]));
    }
    // The same scale on both axes: 476 by 270 units.
    let axis = |label, to: f64, ticks| Axis { label, from: 0.0, to, logarithmic: false, ticks };
    Chart {
        name: "slide-line",
        title: "A slide line with smoothed corners",
        description: "Three straight segments, which run from left to right through a valley and over a ridge. At both \
            corners a parabola replaces a fifth of each segment; the corner itself is dashed. Six slave points are \
            joined to their closest points: above a segment, above the valley, above a segment, above the ridge, below \
            the last segment, and beyond its end.",
        x: axis("r", 7.0, vec![0.0, 2.0, 4.0, 6.0]),
        y: axis("z", 7.0 * 270.0 / 476.0, vec![0.0, 1.0, 2.0, 3.0]),
        curves: vec![
            Curve { name: "", label_at: 0, points: smoothed },
            Curve { name: "", label_at: 0, points: sharp },
            Curve { name: "", label_at: 0, points: projections },
        ],
    }
}

/// Evenly spaced numbers from `from` to `to`.
fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=120_u32).map(move |k| from + (to - from) * f64::from(k) / 120.0)
}

/// The pressure laws in units of c0 and p0.
pub(crate) fn pressure_laws() -> Chart<'static> {
    let linear = |h| value::<PressureLinear>(&LinearContact { h, k: 1.0 }).map_or(f64::NAN, |out| out.p);
    let exponential =
        |h| value::<PressureExponential>(&ExponentialContact { h, c0: 1.0, p0: 1.0 }).map_or(f64::NAN, |out| out.p);
    let curve = |law: &dyn Fn(f64) -> f64| steps(-1.5, 1.5).map(|h| (h, law(h))).collect();
    Chart {
        name: "pressure-laws",
        title: "Contact pressure over overclosure",
        description: "Hard contact: no pressure in the open, and any at overclosure 0. The linear law: no pressure in \
            the open, then a straight line of slope 1. The exponential law begins at the overclosure -1, touches the \
            axis there, passes the pressure 1 at overclosure 0 and 3 near 0.5.",
        x: Axis {
            label: "overclosure h / c₀",
            from: -1.5,
            to: 1.5,
            logarithmic: false,
            ticks: vec![-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5],
        },
        y: Axis { label: "pressure p / p₀", from: 0.0, to: 3.0, logarithmic: false, ticks: vec![0.0, 1.0, 2.0, 3.0] },
        curves: vec![
            Curve { name: "linear", label_at: 105, points: curve(&linear) },
            Curve { name: "exponential", label_at: 62, points: curve(&exponential) },
            Curve { name: "hard", label_at: 0, points: vec![(-1.5, 0.0), (0.0, 0.0), (0.0, 3.0)] },
        ],
    }
}

/// The damping coefficient as a function of the clearance.
pub(crate) fn damping_coefficient() -> Chart<'static> {
    let coefficient = |clearance: f64| {
        let contact = DampingContact { h: -clearance, v: 1.0, mu0: 1.0, c0: 1.0, eta: 0.4 };
        value::<Damping>(&contact).map_or(f64::NAN, |out| out.p)
    };
    Chart {
        name: "damping-coefficient",
        title: "Damping coefficient over clearance",
        description: "The coefficient is 1 up to the clearance 0.4, falls in a straight line to 0 at the clearance 1, and \
            stays 0.",
        x: Axis {
            label: "clearance −h / c₀",
            from: -0.2,
            to: 1.2,
            logarithmic: false,
            ticks: vec![-0.2, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2],
        },
        y: Axis { label: "coefficient / μ₀", from: 0.0, to: 1.2, logarithmic: false, ticks: vec![0.0, 0.5, 1.0] },
        curves: vec![Curve {
            name: "",
            label_at: 0,
            points: steps(-0.2, 1.2).map(|clearance| (clearance, coefficient(clearance))).collect(),
        }],
    }
}
