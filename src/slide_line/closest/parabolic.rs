//! The closest point of a parabolic segment.

use super::{Foot, SegmentFoot, View, check_tangent};
use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{X1, X2, X3, XS};
use crate::scalar::{Scalar, norm, sign};
use crate::slide_line::points::{arch, parabolas, quarter_point};
use crate::slide_line::shape::Parabola;
use crate::slide_line::{ClosestLinear, LinearSlave, ParabolicPlace, ParabolicPoint, check_distinct, left, length};
use crate::verify::law;
use nalgebra::Vector2;

fields! {
    /// The slave point and a parabolic segment.
    pub struct ParabolicSlave<T> {
        xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3,
    }
}

/// Closest point of a parabolic segment: the nearest root of (xs − X)·X′ = 0, or an end; E11 = (xs − X)·n.
#[derive(Clone, Copy, Debug)]
pub struct ClosestParabolic;

impl<D: Scalar> ParabolicSlave<D> {
    fn view(&self) -> View<D, Parabola, 3> {
        View::new(self.xs, [self.x1, self.x2, self.x3], D::zero())
    }
}

impl Formula for ClosestParabolic {
    const SPEC: Spec = Spec {
        id: "slide_line.closest_parabolic",
        title: "Closest point of a parabolic segment",
        latex: r"(\mathbf{x}_s-\mathbf{X}(g))\cdot\mathbf{X}'(g) = 0,\quad -1 \le g \le 1,\qquad E_{11} = (\mathbf{x}_s-\mathbf{X})\cdot\mathbf{n}",
        source: Source::SLIDE_LINE.section("Element output"),
        eta: 4.0,
        eta_jacobian: 12.0,
        objective: true,
    };
    type Inputs<T: Element> = ParabolicSlave<T>;
    type Outputs<T: Element> = SegmentFoot<T>;

    fn eval<D: Scalar>(i: &ParabolicSlave<D>) -> SegmentFoot<D> {
        let view = i.view();
        let foot = Foot::on(&view);
        SegmentFoot { g: foot.u, separation: foot.separation() * view.binade.unit }
    }

    fn jacobian<D: Scalar>(i: &ParabolicSlave<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    fn linearized<D: Scalar>(i: &ParabolicSlave<D>) -> (SegmentFoot<D>, Jacobian<Self, D>) {
        let view = i.view();
        let foot = Foot::on(&view);
        let value = SegmentFoot { g: foot.u, separation: foot.separation() * view.binade.unit };
        let ([n1, n2, n3], [m1, m2, m3]) = (foot.weights, foot.rates);
        let g = |n, m| view.per_unit(foot.coordinate_by(n, m));
        let normal = foot.normal();
        let gradients = SegmentFoot {
            g: ParabolicSlave { xs: g(-D::one(), D::zero()), x1: g(n1, m1), x2: g(n2, m2), x3: g(n3, m3) },
            separation: ParabolicSlave { xs: normal, x1: normal * -n1, x2: normal * -n2, x3: normal * -n3 },
        };
        (value, gradients)
    }

    fn validate(i: &ParabolicSlave<f64>) -> Result<(), Error> {
        check_distinct(&[("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])?;
        check_tangent(&i.view(), "g")
    }

    fn cases() -> Vec<Case<ParabolicSlave<f64>>> {
        let mut cases = vec![
            Case::hand(
                "below-centre",
                "on the axis of z = (r-2)², below the centre of curvature (2, 0.5)",
                in_bowl(2.0, 0.25),
            ),
            Case::hand("on-the-curve", "separation 0", in_bowl(2.5, 0.25)),
            Case::hand("outside", "penetration of 3 at the vertex", in_bowl(2.0, -3.0)),
            Case::hand("tied", "(2, 1) is as near to g = -√½ as to g = √½: the smaller is taken", in_bowl(2.0, 1.0)),
            Case::limit("beyond-first", "the foot stays at the first node", in_bowl(-2.0, 1.0)),
            Case::limit("beyond-last", "the foot stays at the last node", in_bowl(5.0, 1.0)),
            Case::hand("at-first", "foot exactly at the first node", in_bowl(-1.0, 0.0)),
            Case::hand("at-last", "foot exactly at the last node", in_bowl(5.0, 0.0)),
            Case::hard("centre", "on the centre of curvature: three feet merge", in_bowl(2.0, 0.5)),
            Case::hard("near-centre-1e-4", "1e-4 beside the centre of curvature", in_bowl(2.0 + 1e-4, 0.5)),
            Case::hard("near-centre-1e-8", "1e-8 beside the centre of curvature", in_bowl(2.0 + 1e-8, 0.5)),
            Case::hard("near-centre-1e-10", "1e-10 beside the centre of curvature", in_bowl(2.0 + 1e-10, 0.5)),
            Case::hard(
                "two-feet",
                "above the centre of curvature: two roots nearly equal",
                in_bowl(2.0 + 1e-9, 0.5 + 1e-5),
            ),
            Case::hard("near-medial", "1e-12 beside the medial axis", in_bowl(2.0 + 1e-12, 1.0)),
            Case::hard("far-slave", "the slave point 1e10 away", in_bowl(2.5, -1e10)),
            Case::hard("near-slave", "the slave point 1e-12 away", in_bowl(2.5, 0.25 + 1e-12)),
            Case::hard("inside-last", "1e-8 before the last node", in_bowl(5.0 - 1e-8, 0.0)),
        ];
        let slave = |[x1, x2, x3]: [Vector2<f64>; 3], along: f64, across: f64| {
            let chord = x3 - x1;
            ParabolicSlave { xs: x1 + chord * along + left(chord) * across, x1, x2, x3 }
        };
        cases.extend(parabolas().into_iter().map(|p| Case::hard(p.id, p.comment, slave(p.value, 0.5625, 0.3125))));
        cases.push(Case::hard(
            "quarter-point-tip",
            "close to the end next to a quarter-point node, where X' nearly vanishes",
            slave(quarter_point(), 1e-6, 1e-3),
        ));
        cases.push(Case::hard(
            "needle",
            "the curve nearly folds back, and the slave point is before the tip",
            slave([Vector2::new(1.0, 0.0), Vector2::new(4.0, 1e-3), Vector2::new(5.0, 0.0)], 1.25, 0.0),
        ));
        cases.push(Case::hard(
            "end-at-origin",
            "far nodes must not blur the foot",
            ParabolicSlave {
                xs: Vector2::new(-1e-9, 3e-9),
                x1: Vector2::new(-4.0, -6.0),
                x2: Vector2::new(-2.0, -2.5),
                x3: Vector2::zeros(),
            },
        ));
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicSlave<f64>>> {
        let at = |xs: [f64; 2], [x1, x2, x3]: [Vector2<f64>; 3]| ParabolicSlave { xs: xs.into(), x1, x2, x3 };
        let [x1, x2, _] = arch(1.0);
        let folded = [[1.0, 1.0], [4.0, 4.0], [5.0, 5.0]].map(Vector2::from);
        vec![
            Case::invalid("coincident", "two nodes at one place", at([1.0, 3.0], [x1, x2, x2])),
            Case::invalid("quarter-point-end", "foot where X' = 0", at([0.0, 1.0], quarter_point())),
            Case::invalid(
                "folded",
                "the curve turns back on itself before it reaches the slave point",
                at([9.0, 9.0], folded),
            ),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: r"(\mathbf{x}_s-\mathbf{X})\cdot\mathbf{X}' = 0 \text{ at } g = \pm 1",
                convention: Convention::Switch,
                holds: |i| Foot::on(&i.view()).is_exactly_at_end(&i.view()),
                at: || in_bowl(5.0, 0.0),
                across: along_r,
            },
            Kink {
                condition: r"\text{two places equally near}",
                convention: Convention::Switch,
                holds: |i| i.view().is_tied(),
                at: || in_bowl(2.0, 1.0),
                across: along_r,
            },
            Kink {
                condition: r"\mathbf{x}_s \text{ on the centre of curvature}",
                convention: Convention::Switch,
                holds: |i| Foot::on(&i.view()).is_centre_of_curvature(),
                at: || in_bowl(2.0, 0.5),
                across: along_r,
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "the gap from the foot is perpendicular to the curve, or the foot is an end",
                sides: |i| {
                    let g = Self::eval(i).g;
                    let point = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g });
                    let (along, zero) = ((i.xs - point.x).dot(&point.dx), Octuple::from(0.0));
                    let outside = g * g == 1.0 && sign(along) == sign(g);
                    let size = norm([i.xs - i.x1, i.x2 - i.x1, i.x3 - i.x1].map(length));
                    law::equal_with(if outside { zero } else { along }, zero, size * size)
                },
            },
            Law {
                statement: "half-way to the foot, the foot is the same and the separation half",
                sides: |i| {
                    let here = Self::eval(i);
                    let foot = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g: here.g }).x;
                    let nearer = Self::eval(&ParabolicSlave { xs: (i.xs + foot) * Octuple::from(0.5), ..*i });
                    let size = length(i.xs - foot) + length(i.x3 - i.x1);
                    [
                        law::equal_with(here.g, nearer.g, 1.0.into()),
                        law::equal_with(here.separation, nearer.separation * 2.0, size),
                    ]
                    .concat()
                },
            },
            Law {
                statement: "with the midside node in the middle it is the closest point of the straight segment",
                sides: |i| {
                    let middle = (i.x1 + i.x3) * Octuple::from(0.5);
                    let straight = Self::eval(&ParabolicSlave { x2: middle, ..*i });
                    let linear = ClosestLinear::eval(&LinearSlave { xs: i.xs, x1: i.x1, x2: i.x3 });
                    [
                        law::equal_with(straight.g, linear.g, 1.0.into()),
                        law::equal_with(straight.separation, linear.separation, length(i.xs - i.x1)),
                    ]
                    .concat()
                },
            },
            Law {
                statement: "reversing the nodes reverses g and the sign of the separation",
                sides: |i| {
                    let (here, back) = (Self::eval(i), Self::eval(&ParabolicSlave { x1: i.x3, x3: i.x1, ..*i }));
                    [
                        law::equal_with(here.g, -back.g, 1.0.into()),
                        law::equal_with(here.separation, -back.separation, length(i.xs - i.x1)),
                    ]
                    .concat()
                },
            },
        ]
    }
}

/// A slave point beside the parabola z = (r − 2)² from (1, 1) to (3, 1), at r = g + 2.
fn in_bowl(r: f64, z: f64) -> ParabolicSlave<f64> {
    let [x1, x2, x3] = arch(-1.0).map(|x| x + Vector2::new(0.0, 1.0));
    ParabolicSlave { xs: Vector2::new(r, z), x1, x2, x3 }
}

fn along_r() -> ParabolicSlave<f64> {
    ParabolicSlave { xs: Vector2::new(1.0, 0.0), ..ParabolicSlave::filled(0.0) }
}
