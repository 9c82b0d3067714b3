//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{ClosestSmoothedLinear, LinearCornerSlave};
use crate::Octuple;
use crate::contact::slide_line::closest::{Foot, evidence};
use crate::contact::slide_line::corners::proof::linear_corners;
use crate::contact::slide_line::running::{AT_CORNER, LINE};
use crate::contact::slide_line::{ClosestLinear, LinearCornerPlace, LinearSlave, SmoothedLinearPoint, left, length};
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use nalgebra::Vector2;

impl Proved for ClosestSmoothedLinear {
    fn placed(drawn: LinearCornerSlave<f64>) -> LinearCornerSlave<f64> {
        let LinearCornerSlave { xs, x1, x2, x3, f } = drawn;
        let on = |along: f64| {
            let on = SmoothedLinearPoint::eval(&LinearCornerPlace { x1, x2, x3, f, t: along.midpoint(1.0) });
            [on.x, on.dx]
        };
        LinearCornerSlave { xs: evidence::slave_point(xs, on), ..drawn }
    }

    fn cases() -> Vec<Case<LinearCornerSlave<f64>>> {
        let mut cases =
            vec![Case::hand("open", "the corner is z = r² + 1/4: foot (0, 0.25) at t = 1/2", at_corner(0.0, 0.5)), {
                let ([x1, x2, x3], (xs, f, _)) = (LINE, AT_CORNER);
                Case::running("(4.1, 3.9) is nearest", LinearCornerSlave { xs, x1, x2, x3, f })
            }];
        cases.extend(evidence::cases(at_corner));
        cases.extend([
            Case::hand("default", "the default fraction 0.2", LinearCornerSlave { f: 0.2, ..at_corner(0.125, 0.125) }),
            Case::hard("sharp", "f → 0", LinearCornerSlave { f: 1e-8, ..at_corner(0.125, -0.375) }),
            Case::hard("widest", "f → 1/2", LinearCornerSlave { f: 0.5_f64.next_down(), ..at_corner(0.125, -0.375) }),
        ]);
        cases.extend(linear_corners().into_iter().filter(|corner| corner.id != "needle").map(|corner| {
            let [x1, x2, x3] = corner.value;
            let on = SmoothedLinearPoint::eval(&LinearCornerPlace { x1, x2, x3, f: 0.2, t: 0.375 });
            let xs = on.x + left(on.dx) * 0.3125;
            Case::hard(corner.id, corner.comment, LinearCornerSlave { xs, x1, x2, x3, f: 0.2 })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearCornerSlave<f64>>> {
        let at = |xs: [f64; 2], [x1, x2, x3]: [[f64; 2]; 3]| LinearCornerSlave {
            xs: xs.into(),
            x1: x1.into(),
            x2: x2.into(),
            x3: x3.into(),
            f: 0.25,
        };
        vec![
            Case::invalid("coincident", "two nodes coincide", at([0.0, 1.0], [[1.0, 0.0], [2.0, 0.0], [2.0, 0.0]])),
            Case::invalid(
                "folded",
                "the line turns straight back",
                at([9.0, 0.0], [[1.0, 0.0], [3.0, 0.0], [1.0, 0.0]]),
            ),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        evidence::kinks::<Self>(
            [
                |i| Foot::on(&i.view()).is_exactly_at_end(&i.view()),
                |i| i.view().is_tied(),
                |i| Foot::on(&i.view()).is_centre_of_curvature(),
            ],
            [|| at_corner(1.0, 0.0), || at_corner(0.0, 0.875), || at_corner(0.0, 0.75)],
            along_r,
        )
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "half-way to the closest point, the closest point is the same and the separation is half",
                |i| {
                    let here = Self::eval(i);
                    let place = LinearCornerPlace { x1: i.x1, x2: i.x2, x3: i.x3, f: i.f, t: here.t };
                    let foot = SmoothedLinearPoint::eval(&place).x;
                    let nearer = Self::eval(&LinearCornerSlave { xs: (i.xs + foot) * Octuple::from(0.5), ..*i });
                    let size = length(i.xs - foot) + length(i.x3 - i.x1);
                    [
                        law::equal_with(here.t, nearer.t, 1.0.into()),
                        law::equal_with(here.separation, nearer.separation * 2.0, size),
                    ]
                    .concat()
                },
            ),
            Law::<Self>::new("if the line is straight, the separation is the distance from it", |i| {
                let straight = LinearCornerSlave { x3: i.x2 * Octuple::from(2.0) - i.x1, ..*i };
                let linear = LinearSlave { xs: i.xs, x1: i.x1, x2: straight.x3 };
                let (here, there) = (Self::eval(&straight), ClosestLinear::eval(&linear));
                law::equal_with(here.separation, there.separation, length(i.xs - i.x1))
            }),
            Law::<Self>::new("reversing the nodes turns t into 1 − t and reverses the sign of the separation", |i| {
                let (here, back) = (Self::eval(i), Self::eval(&LinearCornerSlave { x1: i.x3, x3: i.x1, ..*i }));
                [
                    law::equal_with(here.t + back.t, 1.0.into(), 0.0.into()),
                    law::equal_with(here.separation, -back.separation, length(i.xs - i.x1)),
                ]
                .concat()
            }),
        ]
    }
}

/// A slave point at (r, z) relative to the corner (3, 1) of the line (1, 3), (3, 1), (5, 3).
///
/// In these coordinates the smoothed corner is z = r² + 1/4, with r = t − 1/2.
fn at_corner(r: f64, z: f64) -> LinearCornerSlave<f64> {
    LinearCornerSlave {
        xs: Vector2::new(3.0 + r, 1.0 + z),
        x1: Vector2::new(1.0, 3.0),
        x2: Vector2::new(3.0, 1.0),
        x3: Vector2::new(5.0, 3.0),
        f: 0.25,
    }
}

fn along_r() -> LinearCornerSlave<f64> {
    LinearCornerSlave { xs: Vector2::new(1.0, 0.0), ..LinearCornerSlave::filled(0.0) }
}
