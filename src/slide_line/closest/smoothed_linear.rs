//! The closest point of a smoothed corner between straight segments.

use super::{Foot, View, check_tangent, corner};
use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{CORNER_T, FRACTION, SEPARATION, X1, X2, X3, XS};
use crate::scalar::{Scalar, abs};
use crate::slide_line::corners::linear_corners;
use crate::slide_line::shape::{LinearCorner, Sides};
use crate::slide_line::{
    ClosestLinear, LinearCornerPlace, LinearSlave, SmoothedLinearPoint, check_distinct, left, length,
};
use crate::verify::law;
use nalgebra::Vector2;

fields! {
    /// The slave point and a smoothed corner between straight segments.
    pub struct LinearCornerSlave<T> {
        xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, f: T = FRACTION,
    }
}
fields! {
    /// The closest point of a smoothed corner, and the separation from it.
    pub struct CornerFoot<T> { t: T = CORNER_T, separation: T = SEPARATION }
}

/// Closest point of a smoothed corner between straight segments: the nearest root of (xs − X)·X′ = 0, or an end.
#[derive(Clone, Copy, Debug)]
pub struct ClosestSmoothedLinear;

impl<D: Scalar> LinearCornerSlave<D> {
    fn view(&self) -> View<D, LinearCorner, 3> {
        View::new(self.xs, [self.x1, self.x2, self.x3], self.f)
    }

    /// Y′·∂X/∂f with ∂X/∂f = s² (x1−x2) + t² (x3−x2).
    ///
    /// ∂X/∂f = (X − x2)/f, and at the foot Y′·X = Y′·xs: where the terms of Y′·(xs − x2)/f are the smaller ones, it is free
    /// of the cancellation in the sum.
    fn bulge(&self, view: &View<D, LinearCorner, 3>, foot: &Foot<D, 3>) -> D {
        let terms = |v: Vector2<D>| abs(v.x * foot.rate.x) + abs(v.y * foot.rate.y);
        let [s, t] = foot.parts();
        let (first, last) = (view.in_unit(self.x1 - self.x2) * (s * s), view.in_unit(self.x3 - self.x2) * (t * t));
        let arm = view.in_unit(self.xs - self.x2);
        let bulge = if terms(arm) < self.f * (terms(first) + terms(last)) { arm / self.f } else { first + last };
        bulge.dot(&foot.rate)
    }
}

impl Formula for ClosestSmoothedLinear {
    const SPEC: Spec = Spec {
        id: "slide_line.closest_smoothed_linear",
        title: "Closest point of a smoothed corner between straight segments",
        latex: r"(\mathbf{x}_s-\mathbf{X}(t))\cdot\mathbf{X}'(t) = 0,\quad 0 \le t \le 1,\qquad E_{11} = (\mathbf{x}_s-\mathbf{X})\cdot\mathbf{n}",
        source: Source::SLIDE_LINE.section("Smoothing the slide line"),
        eta: 4.0,
        // Above 8 at few random points: the separation by f, where both segments are nearly in line.
        eta_jacobian: 48.0,
        objective: true,
    };
    type Inputs<T: Element> = LinearCornerSlave<T>;
    type Outputs<T: Element> = CornerFoot<T>;

    fn eval<D: Scalar>(i: &LinearCornerSlave<D>) -> CornerFoot<D> {
        let view = i.view();
        let foot = Foot::on(&view);
        CornerFoot { t: foot.u, separation: foot.separation() * view.unit }
    }

    fn jacobian<D: Scalar>(i: &LinearCornerSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    /// With respect to f: since n ⟂ Y′, n·∂X/∂f = 2st (x2−x1) × (x3−x2)/|Y′|.
    fn linearized<D: Scalar>(i: &LinearCornerSlave<D>) -> (CornerFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        let foot = Foot::on(&view);
        let value = CornerFoot { t: foot.u, separation: foot.separation() * view.unit };
        let ([n1, n2, n3], [m1, m2, m3]) = (foot.weights, foot.rates);
        let t = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        let [before, behind] = foot.parts();
        let opening = Sides::new([i.x1, i.x2, i.x3]).turn(foot.speed(&view)) * before * behind * -2.0;
        let gradients = CornerFoot {
            t: LinearCornerSlave {
                xs: t(-D::one(), D::zero()),
                x1: t(n1, m1),
                x2: t(n2, m2),
                x3: t(n3, m3),
                f: i.bulge(&view, &foot) * foot.per_slope,
            },
            separation: LinearCornerSlave {
                xs: normal,
                x1: normal * -n1,
                x2: normal * -n2,
                x3: normal * -n3,
                f: if foot.inside { opening } else { D::zero() },
            },
        };
        (value, gradients)
    }

    fn validate(i: &LinearCornerSlave<f64>) -> Result<(), Error> {
        check_distinct(&[("x1", i.x1), ("x2", i.x2)])?;
        check_distinct(&[("x2", i.x2), ("x3", i.x3)])?;
        check_tangent(&i.view(), "t")
    }

    fn cases() -> Vec<Case<LinearCornerSlave<f64>>> {
        let mut cases =
            vec![Case::hand("open", "the corner is z = r² + 1/4: foot (0, 0.25) at t = 1/2", at_corner(0.0, 0.5))];
        cases.extend(corner::cases(at_corner));
        cases.extend([
            Case::limit("default", "the default fraction 0.2", LinearCornerSlave { f: 0.2, ..at_corner(0.125, 0.125) }),
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
            Case::invalid("coincident", "two nodes at one place", at([0.0, 1.0], [[1.0, 0.0], [2.0, 0.0], [2.0, 0.0]])),
            Case::invalid(
                "folded",
                "the line turns straight back",
                at([9.0, 0.0], [[1.0, 0.0], [3.0, 0.0], [1.0, 0.0]]),
            ),
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
            },
            Law {
                statement: "where the line is straight the separation is that from the straight line",
                sides: |i| {
                    let straight = LinearCornerSlave { x3: i.x2 * Octuple::from(2.0) - i.x1, ..*i };
                    let linear = LinearSlave { xs: i.xs, x1: i.x1, x2: straight.x3 };
                    let (here, there) = (Self::eval(&straight), ClosestLinear::eval(&linear));
                    law::equal_with(here.separation, there.separation, length(i.xs - i.x1))
                },
            },
            Law {
                statement: "reversing the nodes turns t into 1 − t and reverses the sign of the separation",
                sides: |i| {
                    let (here, back) = (Self::eval(i), Self::eval(&LinearCornerSlave { x1: i.x3, x3: i.x1, ..*i }));
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

/// A slave point at (r, z) from the corner (3, 1) of the line (1, 3), (3, 1), (5, 3).
///
/// Seen from there the smoothed corner is z = r² + 1/4, with r = t − 1/2.
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
