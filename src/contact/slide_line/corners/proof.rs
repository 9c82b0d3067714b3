//! Evidence for the formulas of the parent module: cases, laws.

use super::{LinearCornerPlace, ParabolicCornerPlace, SmoothedLinearPoint, SmoothedParabolicPoint};
use crate::Octuple;
use crate::contact::slide_line::points::proof::{reversed, same, size};
use crate::contact::slide_line::points::{CurvePoint, LinearPlace, LinearPoint, ParabolicPlace, ParabolicPoint};
use crate::contact::slide_line::running::{AT_CORNER, LINE, MIDSIDE};
use crate::formula::proof::{Case, Hard, Law, Proved};
use crate::formula::{Fields, Formula};
use nalgebra::Vector2;

impl Proved for SmoothedLinearPoint {
    fn cases() -> Vec<Case<LinearCornerPlace<f64>>> {
        let hand = LinearCornerPlace {
            x1: Vector2::new(-4.0, 0.0),
            x2: Vector2::zeros(),
            x3: Vector2::new(0.0, 2.0),
            f: 0.25,
            t: 0.5,
        };
        let mut cases = vec![
            Case::hand("middle", "X = (-0.25, 0.125), X' = (1, 0.5)", hand),
            Case::hand("start", "t = 0: at f ℓ before the corner", LinearCornerPlace { t: 0.0, ..hand }),
            Case::hand("end", "t = 1: at f ℓ behind the corner", LinearCornerPlace { t: 1.0, ..hand }),
            Case::hand("default", "the default fraction 0.2", LinearCornerPlace { f: 0.2, ..hand }),
            Case::hard("sharp", "f → 0: the corner itself", LinearCornerPlace { f: 1e-200, ..hand }),
            Case::hard("widest", "f → 1/2: the whole segments", LinearCornerPlace { f: 0.5_f64.next_down(), ..hand }),
            Case::hard("near-start", "t = 1e-9", LinearCornerPlace { t: 1e-9, ..hand }),
            Case::hard("near-end", "t one ulp below 1", LinearCornerPlace { t: 1.0_f64.next_down(), ..hand }),
            {
                let ([x1, x2, x3], (_, f, t)) = (LINE, AT_CORNER);
                Case::running(
                    "a quarter of (3.4, 3.2) and (5, 4.4), half of (4, 4)",
                    LinearCornerPlace { x1, x2, x3, f, t },
                )
            },
        ];
        cases.extend(linear_corners().into_iter().map(|corner| {
            let [x1, x2, x3] = corner.value;
            Case::hard(corner.id, corner.comment, LinearCornerPlace { x1, x2, x3, f: 0.2, t: 0.375 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "it leaves the segments at f ℓ from the corner, tangent to them: X' = 2f (x2 − x1) at t = 0",
                |i| {
                    let start = Self::eval(&LinearCornerPlace { t: 0.0.into(), ..*i });
                    let g = -(i.f * 2.0) + 1.0;
                    let on = LinearPoint::eval(&LinearPlace { x1: i.x1, x2: i.x2, g });
                    same(&start, &CurvePoint { x: on.x, dx: on.dx * (i.f * 4.0) }, size(&i.components()))
                },
            ),
            Law::<Self>::new("reversing the nodes and t gives the same point and the opposite derivative", |i| {
                let back = LinearCornerPlace { x1: i.x3, x3: i.x1, t: -i.t + 1.0, ..*i };
                reversed(&Self::eval(i), &Self::eval(&back))
            }),
        ]
    }
}

impl Proved for SmoothedParabolicPoint {
    fn cases() -> Vec<Case<ParabolicCornerPlace<f64>>> {
        let place = |[x1, x2, x3, x4, x5]: [Vector2<f64>; 5], f, t| ParabolicCornerPlace { x1, x2, x3, x4, x5, f, t };
        let hand = place(straight_corner(), 0.25, 0.5);
        let mut cases = vec![
            Case::hand("straight", "the parabola of a linear slide line: X = (-0.25, 0.125), X' = (1, 0.5)", hand),
            Case::hand("curved", "curved segments", place(curved_corner(), 0.25, 0.75)),
            Case::hand("start", "t = 0: on the segment before the corner", place(curved_corner(), 0.25, 0.0)),
            Case::hand("end", "t = 1: on the segment behind the corner", place(curved_corner(), 0.25, 1.0)),
            Case::hand("default", "the default fraction 0.2", place(curved_corner(), 0.2, 0.25)),
            Case::hard("sharp", "f → 0: the corner itself", place(curved_corner(), 1e-60, 0.25)),
            Case::hard(
                "widest",
                "f → 1/2: from midside node to midside node",
                place(curved_corner(), 0.5_f64.next_down(), 0.25),
            ),
            Case::hard(
                "widest-start",
                "f → 1/2 and t = 0: the midside node",
                place(curved_corner(), 0.5_f64.next_down(), 0.0),
            ),
            Case::hard("near-start", "t = 1e-9", place(curved_corner(), 0.2, 1e-9)),
            Case::hard("near-end", "t one ulp below 1", place(curved_corner(), 0.2, 1.0_f64.next_down())),
            Case::running(
                "the same corner: the midside nodes are in the middle",
                place([LINE[0], MIDSIDE[0], LINE[1], MIDSIDE[1], LINE[2]], AT_CORNER.1, AT_CORNER.2),
            ),
        ];
        let corners = parabolic_corners().into_iter();
        cases.extend(corners.map(|corner| Case::hard(corner.id, corner.comment, place(corner.value, 0.2, 0.375))));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it leaves the segment at g = 1 − 2f, tangent to it: X' = 4f X12' at t = 0", |i| {
                let start = Self::eval(&ParabolicCornerPlace { t: 0.0.into(), ..*i });
                let g = -(i.f * 2.0) + 1.0;
                let on = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g });
                same(&start, &CurvePoint { x: on.x, dx: on.dx * (i.f * 4.0) }, size(&i.components()))
            }),
            Law::<Self>::new("between straight, evenly spaced segments it is the corner of a linear slide line", |i| {
                let half = Octuple::from(0.5);
                let straight = ParabolicCornerPlace { x2: (i.x1 + i.x3) * half, x4: (i.x3 + i.x5) * half, ..*i };
                let linear = LinearCornerPlace { x1: i.x1, x2: i.x3, x3: i.x5, f: i.f, t: i.t };
                same(&Self::eval(&straight), &SmoothedLinearPoint::eval(&linear), size(&i.components()))
            }),
            Law::<Self>::new("it is the Bézier cubic of its four control points", |i| {
                let reach = i.f * 4.0 / 3.0;
                let g = -(i.f * 2.0) + 1.0;
                let a = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g });
                let b = ParabolicPoint::eval(&ParabolicPlace { x1: i.x3, x2: i.x4, x3: i.x5, g: -g });
                let (t, s) = (i.t, -i.t + 1.0);
                let x = a.x * (s * s * s)
                    + (a.x + a.dx * reach) * (s * s * t * 3.0)
                    + (b.x - b.dx * reach) * (s * t * t * 3.0)
                    + b.x * (t * t * t);
                let point = Self::eval(i);
                same(&point, &CurvePoint { x, dx: point.dx }, size(&i.components()))
            }),
            Law::<Self>::new("reversing the nodes and t gives the same point and the opposite derivative", |i| {
                let back = ParabolicCornerPlace { x1: i.x5, x2: i.x4, x4: i.x2, x5: i.x1, t: -i.t + 1.0, ..*i };
                reversed(&Self::eval(i), &Self::eval(&back))
            }),
        ]
    }
}

/// Hard corners between straight segments.
pub(crate) fn linear_corners() -> Vec<Hard<[Vector2<f64>; 3]>> {
    let base = [Vector2::new(-1.0, 0.25), Vector2::new(0.125, -0.5), Vector2::new(0.75, 1.0)];
    let nodes = |x1: [f64; 2], x2: [f64; 2], x3: [f64; 2]| [x1.into(), x2.into(), x3.into()];
    let mut corners = vec![
        Hard::new("straight", "no corner at all", nodes([-1.0, 0.0], [0.0, 0.0], [2.0, 0.0])),
        Hard::new("nearly-straight", "a corner of 1e-14", nodes([-1.0, 0.0], [0.0, 1e-14], [2.0, 0.0])),
        Hard::new("needle", "the line nearly turns back", nodes([-1.0, 0.0], [1.0, 1e-6], [-1.0, 2e-6])),
        Hard::new("uneven", "one segment 1e12 of the other", nodes([-1e12, 3e11], [0.125, -0.5], [0.75, 1.0])),
    ];
    corners.extend(moved(base));
    corners
}

/// Hard corners between parabolas.
pub(crate) fn parabolic_corners() -> Vec<Hard<[Vector2<f64>; 5]>> {
    let [x1, x2, x3, x4, x5] = curved_corner();
    let mut corners = vec![
        Hard::new("no-corner", "no corner and no bend", [-2.0, -1.0, 0.0, 1.5, 3.0].map(|r| Vector2::new(r, 0.5 * r))),
        Hard::new(
            "almost-straight",
            "segments with sagittas of 1e-14",
            [[-2.0, 0.0], [-1.0, 1e-14], [0.0, 0.0], [0.0, 1.0], [1e-14, 2.0]].map(Vector2::from),
        ),
        Hard::new(
            "quarter-point",
            "midside nodes at the quarter points next to the corner: X' = 0 at the corner itself",
            [x1, x3 + (x1 - x3) * 0.25, x3, x3 + (x5 - x3) * 0.25, x5],
        ),
        Hard::new("uneven", "one segment 1e12 of the other", [x1 * 1e12, x2 * 1e12, x3, x4, x5]),
    ];
    corners.extend(moved(curved_corner()));
    corners
}

/// Straight, evenly spaced segments: the corner of [`SmoothedLinearPoint`]'s first case.
pub(crate) fn straight_corner() -> [Vector2<f64>; 5] {
    [[-4.0, 0.0], [-2.0, 0.0], [0.0, 0.0], [0.0, 1.0], [0.0, 2.0]].map(Vector2::from)
}

/// Two curved segments.
pub(crate) fn curved_corner() -> [Vector2<f64>; 5] {
    [[-2.0, 0.5], [-1.125, 0.875], [0.0, 0.25], [0.75, 0.625], [1.0, 1.75]].map(Vector2::from)
}

/// The same nodes far away, tiny and huge.
fn moved<const N: usize>(base: [Vector2<f64>; N]) -> Vec<Hard<[Vector2<f64>; N]>> {
    let shifted = |offset: f64| base.map(|x| x + Vector2::new(offset, -offset));
    let scaled = |factor: f64| base.map(|x| x * factor);
    let cancels = "common offset: differences must be taken before any product";
    vec![
        Hard::new("offset-1e8", cancels, shifted(1e8)),
        Hard::new("offset-1e12", cancels, shifted(1e12)),
        Hard::new("tiny", "lengths of 1e-200: squares underflow", scaled(1e-200)),
        Hard::new("huge", "lengths of 1e200: squares overflow", scaled(1e200)),
        Hard::new("short", "lengths of 1e-12", scaled(1e-12)),
        Hard::new("long", "lengths of 1e12", scaled(1e12)),
    ]
}
