//! The closest point of a smoothed corner between parabolic segments.

use super::{CornerFoot, Foot, View, check_tangent, corner};
use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{FRACTION, X1, X2, X3, X4, X5, XS};
use crate::scalar::Scalar;
use crate::slide_line::corners::{curved_corner, parabolic_corners};
use crate::slide_line::shape::{ParabolicCorner, Shape, Sides};
use crate::slide_line::{
    ClosestSmoothedLinear, LinearCornerSlave, ParabolicCornerPlace, SmoothedParabolicPoint, check_distinct, left,
    length,
};
use crate::verify::law;
use nalgebra::Vector2;

fields! {
    /// The slave point and a smoothed corner between parabolic segments.
    pub struct ParabolicCornerSlave<T> {
        xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, x4: Vector2<T> = X4,
        x5: Vector2<T> = X5, f: T = FRACTION,
    }
}

/// Closest point of a smoothed corner between parabolic segments: the nearest root of (xs − X)·X′ = 0, or an end.
#[derive(Clone, Copy, Debug)]
pub struct ClosestSmoothedParabolic;

impl<D: Scalar> ParabolicCornerSlave<D> {
    fn view(&self) -> View<D, ParabolicCorner, 5> {
        View::new(self.xs, [self.x1, self.x2, self.x3, self.x4, self.x5], self.f)
    }

    /// ∂E11/∂f beyond an end: ∂Y′/∂f = ∓8 X″ there, with X″ of the segment that the corner is tangent to.
    fn end_turning(&self, view: &View<D, ParabolicCorner, 5>, foot: &Foot<D, 5>) -> D {
        let (sides, weight) =
            if foot.u < 0.5 { ([self.x1, self.x2, self.x3], 32.0) } else { ([self.x3, self.x4, self.x5], -32.0) };
        Sides::new(sides).turn(foot.speed(view)) * foot.beyond * weight
    }
}

impl Formula for ClosestSmoothedParabolic {
    const SPEC: Spec = Spec {
        id: "slide_line.closest_smoothed_parabolic",
        title: "Closest point of a smoothed corner between parabolic segments",
        latex: r"(\mathbf{x}_s-\mathbf{X}(t))\cdot\mathbf{X}'(t) = 0,\quad 0 \le t \le 1,\qquad E_{11} = (\mathbf{x}_s-\mathbf{X})\cdot\mathbf{n}",
        source: Source::SLIDE_LINE.section("Smoothing the slide line"),
        eta: 4.0,
        // Of 100,000 entries at random points a handful is above 24: derivatives by f between nodes whose distances
        // differ by factors of 1e6, where the ends move nearly along the tangent.
        eta_jacobian: 128.0,
        objective: true,
    };
    type Inputs<T: Element> = ParabolicCornerSlave<T>;
    type Outputs<T: Element> = CornerFoot<T>;

    fn eval<D: Scalar>(i: &ParabolicCornerSlave<D>) -> CornerFoot<D> {
        let view = i.view();
        let foot = Foot::on(&view);
        CornerFoot { t: foot.u, separation: foot.separation() * view.unit }
    }

    fn jacobian<D: Scalar>(i: &ParabolicCornerSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    /// With respect to f an end moves along its own tangent, so only the turning of that matters there.
    fn linearized<D: Scalar>(i: &ParabolicCornerSlave<D>) -> (CornerFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        let foot = Foot::on(&view);
        let value = CornerFoot { t: foot.u, separation: foot.separation() * view.unit };
        let ([n1, n2, n3, n4, n5], [m1, m2, m3, m4, m5]) = (foot.weights, foot.rates);
        let t = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        // By f: of X, Y′ and Y″, and of X′, which is f Y′ and hence quadratic in f.
        let [point, rate, second] = ParabolicCorner::by_fraction(i.f, foot.u).map(|weights| view.combination(weights));
        let rate_of_point = view.combination(ParabolicCorner::rates(i.f * 2.0, foot.u));
        let (point, rate) = (point + rate_of_point * foot.missing, rate + second * foot.missing);
        let gradients = CornerFoot {
            t: ParabolicCornerSlave {
                xs: t(-D::one(), D::zero()),
                x1: t(n1, m1),
                x2: t(n2, m2),
                x3: t(n3, m3),
                x4: t(n4, m4),
                x5: t(n5, m5),
                f: (point.dot(&foot.rate) - foot.gap.dot(&rate)) * foot.per_slope,
            },
            separation: ParabolicCornerSlave {
                xs: normal,
                x1: normal * -n1,
                x2: normal * -n2,
                x3: normal * -n3,
                x4: normal * -n4,
                x5: normal * -n5,
                f: if foot.inside { -(normal.dot(&point) * view.unit) } else { i.end_turning(&view, &foot) },
            },
        };
        (value, gradients)
    }

    fn validate(i: &ParabolicCornerSlave<f64>) -> Result<(), Error> {
        check_distinct(&[("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])?;
        check_distinct(&[("x3", i.x3), ("x4", i.x4), ("x5", i.x5)])?;
        check_tangent(&i.view(), "t")
    }

    fn cases() -> Vec<Case<ParabolicCornerSlave<f64>>> {
        let mut cases =
            vec![Case::hand("open", "straight segments, z = r² + 1/4: foot (0, 0.25) at t = 1/2", at_corner(0.0, 0.5))];
        cases.extend(corner::cases(at_corner));
        let beside = |[x1, x2, x3, x4, x5]: [Vector2<f64>; 5], f, t| {
            let on = SmoothedParabolicPoint::eval(&ParabolicCornerPlace { x1, x2, x3, x4, x5, f, t });
            ParabolicCornerSlave { xs: on.x + left(on.dx) * 0.3125, x1, x2, x3, x4, x5, f }
        };
        let curved = |f| ParabolicCornerSlave { f, ..beside(curved_corner(), 0.2, 0.375) };
        cases.extend([
            Case::limit("default", "the default fraction 0.2", curved(0.2)),
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
            Case::invalid("coincident", "two nodes at one place", at([0.0, 1.0], on_axis([1.0, 2.0, 3.0, 3.0, 4.0]))),
            Case::invalid("folded", "the line turns straight back", at([9.0, 0.0], on_axis([1.0, 2.0, 3.0, 2.0, 1.0]))),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        corner::kinks::<Self>(
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
            Law {
                statement: "half-way to the foot, the foot is the same and the separation half",
                sides: |i| {
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
            },
            Law {
                statement: "between straight, evenly spaced segments it is that of the linear slide line",
                sides: |i| {
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
                },
            },
            Law {
                statement: "reversing the nodes turns t into 1 − t and reverses the sign of the separation",
                sides: |i| {
                    let reversed = ParabolicCornerSlave { x1: i.x5, x2: i.x4, x4: i.x2, x5: i.x1, ..*i };
                    let (here, back) = (Self::eval(i), Self::eval(&reversed));
                    [
                        law::equal_with(here.t + back.t, 1.0.into(), 0.0.into()),
                        law::equal_with(here.separation, -back.separation, length(i.xs - i.x1)),
                    ]
                    .concat()
                },
            },
        ]
    }
}

/// A slave point at (r, z) from the corner (3, 1) between straight segments of unit height and width.
///
/// Seen from there the smoothed corner is z = r² + 1/4, with r = t − 1/2.
fn at_corner(r: f64, z: f64) -> ParabolicCornerSlave<f64> {
    let at = |r: f64, z: f64| Vector2::new(3.0 + r, 1.0 + z);
    let [x1, x2, x3, x4, x5] = [-2.0_f64, -1.0, 0.0, 1.0, 2.0].map(|r| at(r, r.abs()));
    ParabolicCornerSlave { xs: at(r, z), x1, x2, x3, x4, x5, f: 0.25 }
}

fn along_r() -> ParabolicCornerSlave<f64> {
    ParabolicCornerSlave { xs: Vector2::new(1.0, 0.0), ..ParabolicCornerSlave::filled(0.0) }
}
