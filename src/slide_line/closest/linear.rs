//! The closest point of a straight segment.

use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{SEGMENT_G, SEPARATION, X1, X2, XS};
use crate::scalar::{Scalar, sign};
use crate::slide_line::basis::length_and_tangent;
use crate::slide_line::{LinearPlace, LinearPoint, check_distinct, left, length};
use crate::verify::{hard, law};
use nalgebra::Vector2;

fields! {
    /// The slave point and a straight segment.
    pub struct LinearSlave<T> { xs: Vector2<T> = XS, x1: Vector2<T> = X1, x2: Vector2<T> = X2 }
}
fields! {
    /// The closest point of a segment, and the separation from it.
    pub struct SegmentFoot<T> { g: T = SEGMENT_G, separation: T = SEPARATION }
}

/// Closest point of a straight segment: (xs − X)·X′ = 0, or the nearer end; E11 = (xs − X)·n.
///
/// The separation is the distance from the whole straight line, beyond the ends too, so an end is a kink of g alone.
#[derive(Clone, Copy, Debug)]
pub struct ClosestLinear;

/// What value and Jacobian have in common.
struct Projection<D> {
    /// 1/ℓ.
    per_length: D,
    t: Vector2<D>,
    /// Distance of the slave point from the straight line, to the left of it.
    separation: D,
    /// Weights of the nodes at the foot on the whole line: inside the segment where both are positive.
    weights: [D; 2],
}

impl<D: Scalar> Projection<D> {
    #[inline]
    fn new(i: &LinearSlave<D>) -> Self {
        let (length, t) = length_and_tangent(i.x2 - i.x1);
        let per_length = length.recip();
        let (from_1, from_2) = (i.xs - i.x1, i.xs - i.x2);
        let (n1, n2) = (-from_2.dot(&t) * per_length, from_1.dot(&t) * per_length);
        // From the nearer node, so that the far one does not blur it.
        let gap = if n1 > n2 { from_1 } else { from_2 };
        Self { per_length, t, separation: t.perp(&gap), weights: [n1, n2] }
    }

    /// −1 or 1 at an end, 0 inside.
    #[inline]
    fn end(&self) -> f64 {
        let [n1, n2] = self.weights;
        f64::from(n1 <= 0.0) - f64::from(n2 <= 0.0)
    }

    #[inline]
    fn foot(&self) -> SegmentFoot<D> {
        let ([n1, n2], end) = (self.weights, self.end());
        // From the smaller weight, which keeps g between the ends: the rounded weights do not add up to 1.
        let inside = if n1 > n2 { n2 * 2.0 - 1.0 } else { -(n1 * 2.0) + 1.0 };
        SegmentFoot { g: if end == 0.0 { inside } else { D::from(end) }, separation: self.separation }
    }

    /// ∂g/∂xs = 2t/ℓ, and a turn of the segment moves the foot by the separation.
    #[inline]
    fn gradients(&self) -> SegmentFoot<LinearSlave<D>> {
        let [n1, n2] = self.weights;
        let n = left(self.t);
        let separation = LinearSlave { xs: n, x1: n * -n1, x2: n * -n2 };
        if self.end() != 0.0 {
            return SegmentFoot { g: LinearSlave::filled(D::zero()), separation };
        }
        let rate = self.per_length * 2.0;
        let along = self.t * rate;
        let across = n * (self.separation * self.per_length * rate);
        let g = LinearSlave { xs: along, x1: along * -n1 - across, x2: across - along * n2 };
        SegmentFoot { g, separation }
    }
}

impl Formula for ClosestLinear {
    const SPEC: Spec = Spec {
        id: "slide_line.closest_linear",
        title: "Closest point of a straight segment",
        latex: r"(\mathbf{x}_s-\mathbf{X}(g))\cdot\mathbf{X}' = 0,\quad -1 \le g \le 1,\qquad E_{11} = (\mathbf{x}_s-\mathbf{X})\cdot\mathbf{n}",
        source: Source::SLIDE_LINE.section("Element output"),
        eta: 6.0,
        eta_jacobian: 8.0,
        objective: true,
    };
    type Inputs<T: Element> = LinearSlave<T>;
    type Outputs<T: Element> = SegmentFoot<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearSlave<D>) -> SegmentFoot<D> {
        Projection::new(i).foot()
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearSlave<D>) -> Jacobian<Self, D> {
        Projection::new(i).gradients()
    }

    #[inline]
    fn linearized<D: Scalar>(i: &LinearSlave<D>) -> (SegmentFoot<D>, Jacobian<Self, D>) {
        let projection = Projection::new(i);
        (projection.foot(), projection.gradients())
    }

    fn validate(i: &LinearSlave<f64>) -> Result<(), Error> {
        check_distinct(&[("x1", i.x1), ("x2", i.x2)])
    }

    fn cases() -> Vec<Case<LinearSlave<f64>>> {
        let on = |xs: [f64; 2], x1: [f64; 2], x2: [f64; 2]| LinearSlave { xs: xs.into(), x1: x1.into(), x2: x2.into() };
        let flat = |xs| on(xs, [1.0, 0.0], [5.0, 0.0]);
        let mut cases = vec![
            Case::hand("open", "a quarter of the way, 2 above: g = -0.5", flat([2.0, 2.0])),
            Case::hand("closed", "2 below: penetration", flat([2.0, -2.0])),
            Case::hand(
                "inclined",
                "3-4-5: the foot is (4, 5), the separation 5",
                on([0.0, 8.0], [1.0, 1.0], [7.0, 9.0]),
            ),
            Case::limit("on-the-segment", "separation 0", on([2.5, 3.0], [1.0, 1.0], [7.0, 9.0])),
            Case::limit("beyond-first", "the foot stays at the first node", flat([-2.0, 2.0])),
            Case::limit("beyond-last", "the foot stays at the last node", flat([9.0, -2.0])),
            Case::hard("at-first", "foot exactly at the first node: g has a kink", flat([1.0, 2.0])),
            Case::hard("at-last", "foot exactly at the last node: g has a kink", flat([5.0, 2.0])),
            Case::hard("inside-last", "one ulp before the last node", flat([5.0_f64.next_down(), 2.0])),
            Case::hard("outside-last", "one ulp behind the last node", flat([5.0_f64.next_up(), 2.0])),
            Case::hard("far-slave", "the slave point 1e12 away", flat([2.0, 1e12])),
            Case::hard("near-slave", "the slave point 1e-12 away", flat([2.25, 1e-12])),
            Case::hard(
                "end-at-origin",
                "the far node must not blur the foot",
                on([1e-9, 2e-9], [-3.0, -4.0], [0.0, 0.0]),
            ),
        ];
        let places = hard::places().into_iter().filter(|place| place.id != "coincident");
        cases.extend(places.map(|place| {
            let [x1, x2] = place.value;
            let chord = x2 - x1;
            let xs = x1 + chord * 0.5625 + left(chord) * 0.3125;
            Case::hard(place.id, place.comment, LinearSlave { xs, x1, x2 })
        }));
        let scaled = |factor: f64| {
            let LinearSlave { xs, x1, x2 } = on([0.5, 2.0], [1.0, 1.0], [4.0, 5.0]);
            LinearSlave { xs: xs * factor, x1: x1 * factor, x2: x2 * factor }
        };
        cases.push(Case::hard("tiny", "lengths of 1e-200: squares underflow", scaled(1e-200)));
        cases.push(Case::hard("huge", "lengths of 1e200: squares overflow", scaled(1e200)));
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearSlave<f64>>> {
        let (xs, x) = (Vector2::new(1.0, 3.0), Vector2::new(1.0, 2.0));
        vec![Case::invalid("coincident", "no tangent", LinearSlave { xs, x1: x, x2: x })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: r"(\mathbf{x}_s-\mathbf{x}_1)\cdot\mathbf{X}' = 0",
                convention: Convention::Switch,
                holds: |i| (i.xs - i.x1).dot(&(i.x2 - i.x1)) == 0.0,
                at: || above(1.0),
                across: along_r,
            },
            Kink {
                condition: r"(\mathbf{x}_s-\mathbf{x}_2)\cdot\mathbf{X}' = 0",
                convention: Convention::Switch,
                holds: |i| (i.xs - i.x2).dot(&(i.x2 - i.x1)) == 0.0,
                at: || above(5.0),
                across: along_r,
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "the gap from the foot is perpendicular to the segment, or the foot is an end",
                sides: |i| {
                    let g = Self::eval(i).g;
                    let gap = i.xs - LinearPoint::eval(&LinearPlace { x1: i.x1, x2: i.x2, g }).x;
                    let (chord, zero) = (i.x2 - i.x1, Octuple::from(0.0));
                    let along = gap.dot(&chord);
                    let outside = g * g == 1.0 && sign(along) == sign(g);
                    let size = (i.xs - i.x1).dot(&(i.xs - i.x1)) + chord.dot(&chord);
                    law::equal_with(if outside { zero } else { along }, zero, size)
                },
            },
            Law {
                statement: "reversing the nodes reverses g and the sign of the separation",
                sides: |i| {
                    let (here, back) = (Self::eval(i), Self::eval(&LinearSlave { x1: i.x2, x2: i.x1, ..*i }));
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

/// A slave point above the segment from (1, 0) to (5, 0).
fn above(r: f64) -> LinearSlave<f64> {
    LinearSlave { xs: Vector2::new(r, 2.0), x1: Vector2::new(1.0, 0.0), x2: Vector2::new(5.0, 0.0) }
}

fn along_r() -> LinearSlave<f64> {
    LinearSlave { xs: Vector2::new(1.0, 0.0), ..LinearSlave::filled(0.0) }
}
