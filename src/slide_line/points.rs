//! Points of a slide line: straight and parabolic segments.

use super::shape::{self, Sides};
use crate::Octuple;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Law, Source, Spec, along};
use crate::quantity::{CURVE, CURVE_RATE, SEGMENT_G, X1, X2, X3};
use crate::scalar::{Scalar, abs};
use crate::verify::law;
use crate::verify::{Hard, hard};
use nalgebra::Vector2;

fields! {
    /// A point of a curve, and the derivative with respect to its coordinate.
    pub struct CurvePoint<T> { x: Vector2<T> = CURVE, dx: Vector2<T> = CURVE_RATE }
}

fields! {
    /// A straight segment, and a place on it.
    pub struct LinearPlace<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2, g: T = SEGMENT_G }
}

/// Point of a straight segment: X = ½(1−g) x1 + ½(1+g) x2.
#[derive(Clone, Copy, Debug)]
pub struct LinearPoint;

impl Formula for LinearPoint {
    const SPEC: Spec = Spec {
        id: "slide_line.linear_point",
        title: "Point of a straight segment",
        latex: r"\mathbf{X} = \tfrac12(1-g)\,\mathbf{x}_1 + \tfrac12(1+g)\,\mathbf{x}_2,\quad \mathbf{X}' = \tfrac12(\mathbf{x}_2-\mathbf{x}_1)",
        source: Source::SLIDE_LINE.section("Defining a linear slide line"),
        eta: 2.0,
        eta_jacobian: 1.0,
        objective: true,
    };
    type Inputs<T: Element> = LinearPlace<T>;
    type Outputs<T: Element> = CurvePoint<T>;

    fn eval<D: Scalar>(i: &LinearPlace<D>) -> CurvePoint<D> {
        let [n1, n2] = shape::linear(i.g);
        CurvePoint { x: i.x1 * n1 + i.x2 * n2, dx: (i.x2 - i.x1) * D::from(0.5) }
    }

    fn jacobian<D: Scalar>(i: &LinearPlace<D>) -> Jacobian<Self, D> {
        let [n1, n2] = shape::linear(i.g);
        let dx = (i.x2 - i.x1) * D::from(0.5);
        let half = D::from(0.5);
        let x = |k| LinearPlace { x1: along(k, n1), x2: along(k, n2), g: dx[k] };
        let rate = |k| LinearPlace { x1: along(k, -half), x2: along(k, half), g: D::zero() };
        CurvePoint { x: Vector2::new(x(0), x(1)), dx: Vector2::new(rate(0), rate(1)) }
    }

    fn cases() -> Vec<Case<LinearPlace<f64>>> {
        let hand = LinearPlace { x1: Vector2::new(1.0, 2.0), x2: Vector2::new(5.0, -1.0), g: 0.5 };
        let mut cases = vec![
            Case::hand("three-quarters", "X = (4, -0.25), X' = (2, -1.5)", hand),
            Case::limit("first-node", "g = -1 is the first node", LinearPlace { g: -1.0, ..hand }),
            Case::limit("middle", "g = 0 is the middle", LinearPlace { g: 0.0, ..hand }),
            Case::limit("last-node", "g = 1 is the last node", LinearPlace { g: 1.0, ..hand }),
            Case::hard("near-first", "g one ulp above -1", LinearPlace { g: (-1.0_f64).next_up(), ..hand }),
            Case::hard("near-last", "g one ulp below 1", LinearPlace { g: 1.0_f64.next_down(), ..hand }),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, LinearPlace { x1, x2, g: 0.3125 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "reversing the nodes and g gives the same point and the opposite derivative",
                sides: |i| {
                    let (here, back) = (Self::eval(i), Self::eval(&LinearPlace { x1: i.x2, x2: i.x1, g: -i.g }));
                    reversed(&here, &back)
                },
            },
            Law {
                statement: "it is the parabola whose midside node is in the middle",
                sides: |i| {
                    let middle = (i.x1 + i.x2) * Octuple::from(0.5);
                    let parabola = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: middle, x3: i.x2, g: i.g });
                    same(&Self::eval(i), &parabola, size(&i.components()))
                },
            },
        ]
    }
}

fields! {
    /// A parabolic segment, and a place on it.
    pub struct ParabolicPlace<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, g: T = SEGMENT_G }
}

/// Point of a parabolic segment: X = ½g(g−1) x1 + (1−g²) x2 + ½g(g+1) x3, with x2 the midside node.
#[derive(Clone, Copy, Debug)]
pub struct ParabolicPoint;

impl Formula for ParabolicPoint {
    const SPEC: Spec = Spec {
        id: "slide_line.parabolic_point",
        title: "Point of a parabolic segment",
        latex: r"\mathbf{X} = \tfrac12 g(g-1)\,\mathbf{x}_1 + (1-g^2)\,\mathbf{x}_2 + \tfrac12 g(g+1)\,\mathbf{x}_3",
        source: Source::SLIDE_LINE.section("Defining a parabolic slide line"),
        eta: 3.0,
        eta_jacobian: 3.0,
        objective: true,
    };
    type Inputs<T: Element> = ParabolicPlace<T>;
    type Outputs<T: Element> = CurvePoint<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicPlace<D>) -> CurvePoint<D> {
        let [n1, n2, n3] = shape::parabolic(i.g);
        CurvePoint { x: i.x1 * n1 + i.x2 * n2 + i.x3 * n3, dx: Sides::new([i.x1, i.x2, i.x3]).rate(i.g) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicPlace<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ParabolicPlace<D>) -> (CurvePoint<D>, Jacobian<Self, D>) {
        let [n1, n2, n3] = shape::parabolic(i.g);
        let [r1, r2, r3] = shape::parabolic_rates(i.g);
        let point = Self::eval(i);
        let second = Sides::new([i.x1, i.x2, i.x3]).second_derivative();
        let x = |k| ParabolicPlace { x1: along(k, n1), x2: along(k, n2), x3: along(k, n3), g: point.dx[k] };
        let rate = |k| ParabolicPlace { x1: along(k, r1), x2: along(k, r2), x3: along(k, r3), g: second[k] };
        (point, CurvePoint { x: Vector2::new(x(0), x(1)), dx: Vector2::new(rate(0), rate(1)) })
    }

    fn cases() -> Vec<Case<ParabolicPlace<f64>>> {
        let place = |[x1, x2, x3]: [Vector2<f64>; 3], g| ParabolicPlace { x1, x2, x3, g };
        let hand = place(arch(1.0), 0.5);
        let mut cases = vec![
            Case::hand("arch", "the parabola z = 1 - (r - 2)² at r = 2.5: X = (2.5, 0.75), X' = (1, -1)", hand),
            Case::limit("first-node", "g = -1 is the first node", ParabolicPlace { g: -1.0, ..hand }),
            Case::limit("midside-node", "g = 0 is the midside node", ParabolicPlace { g: 0.0, ..hand }),
            Case::limit("last-node", "g = 1 is the last node", ParabolicPlace { g: 1.0, ..hand }),
            Case::hard("near-first", "g one ulp above -1", ParabolicPlace { g: (-1.0_f64).next_up(), ..hand }),
            Case::hard("near-last", "g one ulp below 1", ParabolicPlace { g: 1.0_f64.next_down(), ..hand }),
            Case::hard("near-midside", "g = 1e-17", ParabolicPlace { g: 1e-17, ..hand }),
        ];
        cases.extend(parabolas().into_iter().map(|p| Case::hard(p.id, p.comment, place(p.value, -0.6875))));
        cases.push(Case::hard(
            "quarter-point-end",
            "X' = 0 at the end next to a quarter-point node",
            place(quarter_point(), -1.0),
        ));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "reversing the nodes and g gives the same point and the opposite derivative",
            sides: |i| {
                let back = ParabolicPlace { x1: i.x3, x2: i.x2, x3: i.x1, g: -i.g };
                reversed(&Self::eval(i), &Self::eval(&back))
            },
        }]
    }
}

/// The parabola through (1, 0), (2, sagitta), (3, 0).
pub(super) fn arch(sagitta: f64) -> [Vector2<f64>; 3] {
    [Vector2::new(1.0, 0.0), Vector2::new(2.0, sagitta), Vector2::new(3.0, 0.0)]
}

/// Three nodes on a line, with the middle one at a quarter of it.
pub(super) fn quarter_point() -> [Vector2<f64>; 3] {
    [Vector2::new(1.0, 2.0), Vector2::new(2.0, 4.0), Vector2::new(5.0, 10.0)]
}

/// Parabolas that are hard: almost straight, with the midside node at the quarter point, far away, tiny and huge.
pub(super) fn parabolas() -> Vec<Hard<[Vector2<f64>; 3]>> {
    let straight = "almost straight: the second difference of the nodes is small";
    let base = [Vector2::new(0.0, 0.0), Vector2::new(0.375, 0.875), Vector2::new(1.25, 1.5)];
    let shifted = |offset: f64| base.map(|x| x + Vector2::new(offset, -offset));
    let scaled = |factor: f64| base.map(|x| x * factor);
    let cancels = "common offset: differences must be taken before any product";
    vec![
        Hard::new("sagitta-1e-4", straight, arch(1e-4)),
        Hard::new("sagitta-1e-8", straight, arch(1e-8)),
        Hard::new("sagitta-1e-14", straight, arch(1e-14)),
        Hard::new("straight", "sagitta 0", arch(0.0)),
        Hard::new("quarter-point", "midside node at the quarter point: X' = 0 at g = -1", quarter_point()),
        Hard::new("offset-1e8", cancels, shifted(1e8)),
        Hard::new("offset-1e12", cancels, shifted(1e12)),
        Hard::new("tiny", "lengths of 1e-200: squares underflow", scaled(1e-200)),
        Hard::new("huge", "lengths of 1e200: squares overflow", scaled(1e200)),
        Hard::new("short", "lengths of 1e-12", scaled(1e-12)),
        Hard::new("long", "lengths of 1e12", scaled(1e12)),
    ]
}

/// The same point, and the opposite derivative.
pub(super) fn reversed(here: &CurvePoint<Octuple>, back: &CurvePoint<Octuple>) -> Vec<crate::formula::Equation> {
    law::equal_all([(here.x.x, back.x.x), (here.x.y, back.x.y), (here.dx.x, -back.dx.x), (here.dx.y, -back.dx.y)])
}

/// The same point and derivative, of terms up to `size`.
pub(super) fn same(a: &CurvePoint<Octuple>, b: &CurvePoint<Octuple>, size: Octuple) -> Vec<crate::formula::Equation> {
    let pairs = a.components().into_iter().zip(b.components());
    pairs.flat_map(|(a, b)| law::equal_with(a, b, size)).collect()
}

/// Σ|x|.
pub(super) fn size(components: &[Octuple]) -> Octuple {
    components.iter().fold(0.0.into(), |sum, &x| sum + abs(x))
}
