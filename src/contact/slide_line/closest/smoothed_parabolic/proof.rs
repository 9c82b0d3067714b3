//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{ClosestSmoothedParabolic, ParabolicCornerSlave};
use crate::Octuple;
use crate::contact::slide_line::closest::{Foot, evidence};
use crate::contact::slide_line::corners::proof::{curved_corner, parabolic_corners};
use crate::contact::slide_line::running::{AT_CORNER, LINE, MIDSIDE};
use crate::contact::slide_line::{
    ClosestSmoothedLinear, LinearCornerSlave, ParabolicCornerPlace, SmoothedParabolicPoint, left, length,
};
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use nalgebra::Vector2;

impl Proved for ClosestSmoothedParabolic {
    fn placed(drawn: ParabolicCornerSlave<f64>) -> ParabolicCornerSlave<f64> {
        let ParabolicCornerSlave { xs, x1, x2, x3, x4, x5, f } = drawn;
        let on = |along: f64| {
            let t = along.midpoint(1.0);
            let on = SmoothedParabolicPoint::eval(&ParabolicCornerPlace { x1, x2, x3, x4, x5, f, t });
            [on.x, on.dx]
        };
        ParabolicCornerSlave { xs: evidence::slave_point(xs, on), ..drawn }
    }

    fn cases() -> Vec<Case<ParabolicCornerSlave<f64>>> {
        let mut cases = vec![
            Case::hand("open", "straight segments, z = r² + 1/4: foot (0, 0.25) at t = 1/2", at_corner(0.0, 0.5)),
            {
                let ([x1, x3, x5], [x2, x4], (xs, f, _)) = (LINE, MIDSIDE, AT_CORNER);
                Case::running("the same corner", ParabolicCornerSlave { xs, x1, x2, x3, x4, x5, f })
            },
        ];
        cases.extend(evidence::cases(at_corner));
        let beside = |[x1, x2, x3, x4, x5]: [Vector2<f64>; 5], f, t| {
            let on = SmoothedParabolicPoint::eval(&ParabolicCornerPlace { x1, x2, x3, x4, x5, f, t });
            ParabolicCornerSlave { xs: on.x + left(on.dx) * 0.3125, x1, x2, x3, x4, x5, f }
        };
        let curved = |f| ParabolicCornerSlave { f, ..beside(curved_corner(), 0.2, 0.375) };
        cases.extend([
            Case::hand("default", "the default fraction 0.2", curved(0.2)),
            Case::hard("sharp", "f → 0", curved(1e-8)),
            Case::hard("widest", "f → 1/2", curved(0.5_f64.next_down())),
        ]);
        let corners = parabolic_corners().into_iter();
        cases.extend(corners.map(|corner| Case::hard(corner.id, corner.comment, beside(corner.value, 0.2, 0.375))));
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicCornerSlave<f64>>> {
        let at = |xs: [f64; 2], [x1, x2, x3, x4, x5]: [[f64; 2]; 5]| ParabolicCornerSlave {
            xs: xs.into(),
            x1: x1.into(),
            x2: x2.into(),
            x3: x3.into(),
            x4: x4.into(),
            x5: x5.into(),
            f: 0.25,
        };
        let on_axis = |r: [f64; 5]| r.map(|r| [r, 0.0]);
        vec![
            Case::invalid("coincident", "two nodes coincide", at([0.0, 1.0], on_axis([1.0, 2.0, 3.0, 3.0, 4.0]))),
            Case::invalid("folded", "the line turns straight back", at([9.0, 0.0], on_axis([1.0, 2.0, 3.0, 2.0, 1.0]))),
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
                    let ParabolicCornerSlave { xs, x1, x2, x3, x4, x5, f } = *i;
                    let place = ParabolicCornerPlace { x1, x2, x3, x4, x5, f, t: here.t };
                    let foot = SmoothedParabolicPoint::eval(&place).x;
                    let nearer = Self::eval(&ParabolicCornerSlave { xs: (xs + foot) * Octuple::from(0.5), ..*i });
                    let size = length(xs - foot) + length(x5 - x1);
                    [
                        law::equal_with(here.t, nearer.t, 1.0.into()),
                        law::equal_with(here.separation, nearer.separation * 2.0, size),
                    ]
                    .concat()
                },
            ),
            Law::<Self>::new("between straight, evenly spaced segments it is that of the linear slide line", |i| {
                let half = Octuple::from(0.5);
                let (x2, x4) = ((i.x1 + i.x3) * half, (i.x3 + i.x5) * half);
                let here = Self::eval(&ParabolicCornerSlave { x2, x4, ..*i });
                let linear = LinearCornerSlave { xs: i.xs, x1: i.x1, x2: i.x3, x3: i.x5, f: i.f };
                let there = ClosestSmoothedLinear::eval(&linear);
                [
                    law::equal_with(here.t, there.t, 1.0.into()),
                    law::equal_with(here.separation, there.separation, length(i.xs - i.x3)),
                ]
                .concat()
            }),
            Law::<Self>::new("reversing the nodes turns t into 1 − t and reverses the sign of the separation", |i| {
                let reversed = ParabolicCornerSlave { x1: i.x5, x2: i.x4, x4: i.x2, x5: i.x1, ..*i };
                let (here, back) = (Self::eval(i), Self::eval(&reversed));
                [
                    law::equal_with(here.t + back.t, 1.0.into(), 0.0.into()),
                    law::equal_with(here.separation, -back.separation, length(i.xs - i.x1)),
                ]
                .concat()
            }),
        ]
    }
}

/// A slave point at (r, z) relative to the corner (3, 1) between straight segments of unit height and width.
///
/// In these coordinates the smoothed corner is z = r² + 1/4, with r = t − 1/2.
fn at_corner(r: f64, z: f64) -> ParabolicCornerSlave<f64> {
    let at = |r: f64, z: f64| Vector2::new(3.0 + r, 1.0 + z);
    let [x1, x2, x3, x4, x5] = [-2.0_f64, -1.0, 0.0, 1.0, 2.0].map(|r| at(r, r.abs()));
    ParabolicCornerSlave { xs: at(r, z), x1, x2, x3, x4, x5, f: 0.25 }
}

fn along_r() -> ParabolicCornerSlave<f64> {
    ParabolicCornerSlave { xs: Vector2::new(1.0, 0.0), ..ParabolicCornerSlave::filled(0.0) }
}
