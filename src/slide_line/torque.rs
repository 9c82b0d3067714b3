//! The greatest torque that a slide line transmits: T = ∬ r² p ds dθ, as if the friction coefficient were 1.

use super::basis::length_and_tangent;
use super::points::parabolas;
use super::{check_radii, length};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{P1, P2, P3, TORQUE, X1, X2, X3};
use crate::scalar::{self, Leaf, Scalar, pi};
use crate::verify::{hard, law};
use nalgebra::Vector2;

const SOURCE: Source = Source::SLIDE_LINE
    .section("Obtaining the \"maximum torque\" that can be transmitted across axisymmetric slide lines");

fields! {
    /// The two nodes of an ISL21A element, and the pressures there.
    pub struct LinearPressures<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2, p1: T = P1, p2: T = P2 }
}
fields! {
    /// Torque.
    pub struct Torque<T> { t: T = TORQUE }
}

/// Torque over an ISL21A element, radius and pressure linear along it, integrated exactly.
///
/// ∬ r² p ds dθ = (πℓ/6) [p1 (3r1² + 2r1r2 + r2²) + p2 (r1² + 2r1r2 + 3r2²)].
#[derive(Clone, Copy, Debug)]
pub struct TorqueLinear;

impl Formula for TorqueLinear {
    const SPEC: Spec = Spec {
        id: "slide_line.torque_linear",
        title: "Torque over ISL21A",
        latex: r"T = 2\pi\ell\left[p_1\Bigl(\tfrac{r_1^2}{4}+\tfrac{r_1 r_2}{6}+\tfrac{r_2^2}{12}\Bigr) + p_2\Bigl(\tfrac{r_1^2}{12}+\tfrac{r_1 r_2}{6}+\tfrac{r_2^2}{4}\Bigr)\right]",
        source: SOURCE,
        eta: 3.0,
        eta_jacobian: 8.0,
        objective: false,
    };
    type Inputs<T: Element> = LinearPressures<T>;
    type Outputs<T: Element> = Torque<T>;

    fn eval<D: Scalar>(i: &LinearPressures<D>) -> Torque<D> {
        let (length, _) = length_and_tangent(i.x2 - i.x1);
        let (r1, r2) = (i.x1.x, i.x2.x);
        let (q1, q2, mixed) = (r1 * r1, r2 * r2, r1 * r2 * 2.0);
        let moment = i.p1 * (q1 * 3.0 + mixed + q2) + i.p2 * (q1 + mixed + q2 * 3.0);
        Torque { t: pi::<D>() / 6.0 * length * moment }
    }

    fn jacobian<D: Scalar>(i: &LinearPressures<D>) -> Jacobian<Self, D> {
        let (length, t) = length_and_tangent(i.x2 - i.x1);
        let (r1, r2) = (i.x1.x, i.x2.x);
        let (q1, q2, mixed) = (r1 * r1, r2 * r2, r1 * r2 * 2.0);
        let (m1, m2) = (q1 * 3.0 + mixed + q2, q1 + mixed + q2 * 3.0);
        let sixth = pi::<D>() / 6.0;
        let band = sixth * length;
        let stretch = t * (sixth * (i.p1 * m1 + i.p2 * m2));
        let twice = band * 2.0;
        let radius = |moment| Vector2::new(twice * moment, D::zero());
        let x1 = radius(i.p1 * (r1 * 3.0 + r2) + i.p2 * (r1 + r2)) - stretch;
        let x2 = radius(i.p1 * (r1 + r2) + i.p2 * (r1 + r2 * 3.0)) + stretch;
        Torque { t: LinearPressures { x1, x2, p1: band * m1, p2: band * m2 } }
    }

    fn validate(i: &LinearPressures<f64>) -> Result<(), Error> {
        check_radii(&[("x1", i.x1), ("x2", i.x2)])
    }

    fn cases() -> Vec<Case<LinearPressures<f64>>> {
        let on = |x1: [f64; 2], x2: [f64; 2], p1, p2| LinearPressures { x1: x1.into(), x2: x2.into(), p1, p2 };
        let mut cases = vec![
            Case::hand("cylinder", "2π r² ℓ p = 2π × 4 × 3 × 0.5", on([2.0, 0.0], [2.0, 3.0], 0.5, 0.5)),
            Case::hand("disc", "2π p r³/3 from the axis to r = 3: 18π p", on([0.0, 1.0], [3.0, 1.0], 1.0, 1.0)),
            Case::hand("ramp", "p = r/3 on the disc: 2π/3 × 3⁴/4", on([0.0, 1.0], [3.0, 1.0], 0.0, 1.0)),
            Case::limit("axis", "r → 0: nothing on the axis", on([0.0, 1.0], [0.0, 2.0], 5.0, 7.0)),
            Case::limit("open", "no pressure, no torque", on([1.0, 1.0], [2.0, 3.0], 0.0, 0.0)),
            Case::hard("near-axis", "r = 1e-200", on([1e-200, 1.0], [1e-200, 2.0], 5.0, 7.0)),
            Case::hard("coincident", "ℓ = 0: derivative 0 by convention", on([1.5, 1.0], [1.5, 1.0], 2.0, 3.0)),
            Case::hard("tiny", "lengths of 1e-100", on([3e-100, 1e-100], [7e-100, 4e-100], 1e-5, 3e-5)),
            Case::hard("huge", "lengths of 1e100", on([3e100, 1e100], [7e100, 4e100], 1e-5, 3e-5)),
        ];
        cases.extend(hard::places().into_iter().filter(|place| place.id != "coincident").map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, LinearPressures { x1, x2, p1: 0.75, p2: 2.5 })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearPressures<f64>>> {
        let (x1, x2) = (Vector2::new(1.0, 0.0), Vector2::new(-1.0, 0.0));
        vec![Case::invalid("negative-radius", "left of the axis", LinearPressures { x1, x2, p1: 1.0, p2: 1.0 })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\mathbf{x}_1 = \mathbf{x}_2",
            convention: Convention::Subgradient,
            holds: |i| i.x1 == i.x2,
            at: || LinearPressures { x1: Vector2::new(1.5, 1.0), x2: Vector2::new(1.5, 1.0), p1: 2.0, p2: 3.0 },
            across: || LinearPressures { x1: Vector2::zeros(), x2: Vector2::new(0.6, 0.8), p1: 0.0, p2: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "cutting the element in two adds up to the same torque",
                sides: |i| {
                    let third = |a, b| a + (b - a) / 3.0;
                    let cut = Vector2::new(third(i.x1.x, i.x2.x), third(i.x1.y, i.x2.y));
                    let p = third(i.p1, i.p2);
                    let first = Self::eval(&LinearPressures { x2: cut, p2: p, ..*i }).t;
                    let second = Self::eval(&LinearPressures { x1: cut, p1: p, ..*i }).t;
                    law::equal(Self::eval(i).t, first + second)
                },
            },
            Law {
                statement: "it does not depend on the sequence of the nodes",
                sides: |i| {
                    let back = LinearPressures { x1: i.x2, x2: i.x1, p1: i.p2, p2: i.p1 };
                    law::equal(Self::eval(i).t, Self::eval(&back).t)
                },
            },
        ]
    }
}

fields! {
    /// The three nodes of an ISL22A element, and the pressures there; the second is the midside node.
    pub struct ParabolicPressures<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, p1: T = P1, p2: T = P2, p3: T = P3,
    }
}

/// Torque over an ISL22A element: T = 2π Σ w r² p |X′| over the five points of Gauss and Legendre, p parabolic.
#[derive(Clone, Copy, Debug)]
pub struct TorqueParabolic;

/// The rule of Gauss and Legendre with five points, which integrates polynomials of degree 9 exactly.
///
/// A row per point g = 0, ⅓√(5 − 2√(10/7)), ⅓√(5 + 2√(10/7)): 2πw, g − ½, and the weights N1, N2, N3 of the nodes. The points
/// at −g are their mirror images.
const RULE: [[f64; 5]; 3] = [
    [3.574_434_308_084_387, -0.5, 0.0, 1.0, 0.0],
    [
        3.007_312_630_076_519,
        0.038_469_310_105_683_094,
        -0.124_260_056_089_996_39,
        0.710_050_802_074_309_7,
        0.414_209_254_015_686_7,
    ],
    [
        1.488_655_523_060_874,
        0.406_179_845_938_664,
        -0.042_508_966_376_621_59,
        0.178_838_086_814_579_2,
        0.863_670_879_562_042_4,
    ],
];

/// A row of it by its definition, by roots of the Legendre polynomial.
fn definition<L: Leaf>(row: usize) -> [L; 5] {
    let number = |x: f64| L::from(x);
    let root = (number(10.0) / 7.0).sqrt() * 2.0;
    let [inner, outer] = [number(5.0) - root, number(5.0) + root].map(|square| square.sqrt() / 3.0);
    let root = number(70.0).sqrt() * 13.0;
    let [heavy, light] = [number(322.0) + root, number(322.0) - root].map(|w| w / 900.0);
    let (g, w) = [(number(0.0), number(128.0) / 225.0), (inner, heavy), (outer, light)][row];
    let [n1, n2, n3] = super::shape::parabolic(g);
    [L::pi() * 2.0 * w, g - 0.5, n1, n2, n3]
}

/// An integration point: radius, pressure and X′ there, |X′|, and 2πw r.
struct Station<D> {
    radius: D,
    pressure: D,
    rate: Vector2<D>,
    length: D,
    moment: D,
}

// Five of these stand in a row in every result; as calls they took as long as all the rest.
#[expect(clippy::inline_always, reason = "measured")]
impl<D: Scalar> Station<D> {
    #[inline(always)]
    fn new(weight: D, radius: D, pressure: D, rate: Vector2<D>) -> Self {
        Self { radius, pressure, rate, length: length(rate), moment: weight * radius }
    }

    /// The point at g of a row of the rule, and that at −g: X′(g) = b + (g − ½)(b − a), X′(−g) = a − (g − ½)(b − a) with the
    /// halves a = x2 − x1 and b = x3 − x2.
    #[inline(always)]
    fn pair(i: &ParabolicPressures<D>, row: usize, [a, b]: [Vector2<D>; 2]) -> [Self; 2] {
        let [weight, k, n1, n2, n3] = rule::<D>(row);
        let (r2, p2, turn) = (i.x2.x * n2, i.p2 * n2, (b - a) * k);
        let radii = [i.x1.x * n1 + r2 + i.x3.x * n3, i.x1.x * n3 + r2 + i.x3.x * n1];
        let pressures = [i.p1 * n1 + p2 + i.p3 * n3, i.p1 * n3 + p2 + i.p3 * n1];
        [Self::new(weight, radii[0], pressures[0], b + turn), Self::new(weight, radii[1], pressures[1], a - turn)]
    }

    /// The middle, and the points on both sides of it in pairs.
    #[inline(always)]
    fn all(i: &ParabolicPressures<D>) -> (Self, [[Self; 2]; 2]) {
        let halves = [i.x2 - i.x1, i.x3 - i.x2];
        let middle = Self::new(rule::<D>(0)[0], i.x2.x, i.p2, (i.x3 - i.x1) * D::from(0.5));
        (middle, [Self::pair(i, 1, halves), Self::pair(i, 2, halves)])
    }

    /// Torque by the pressure here.
    #[inline(always)]
    fn by_pressure(&self) -> D {
        self.moment * self.length * self.radius
    }

    /// Half of torque by the radius here.
    #[inline(always)]
    fn by_radius(&self) -> D {
        self.moment * self.length * self.pressure
    }

    /// Torque by X′ here.
    #[inline(always)]
    fn by_rate(&self) -> Vector2<D> {
        let along = self.moment * (self.radius * self.pressure) / self.length;
        self.rate * if self.length == 0.0 { D::zero() } else { along }
    }
}

/// A row of the rule.
#[expect(clippy::inline_always, reason = "constants should be seen as such")]
#[inline(always)]
fn rule<D: Scalar>(row: usize) -> [D; 5] {
    D::Leaf::constants(RULE[row], || definition(row)).map(scalar::constant)
}

impl Formula for TorqueParabolic {
    const SPEC: Spec = Spec {
        id: "slide_line.torque_parabolic",
        title: "Torque over ISL22A",
        latex: r"T = 2\pi \sum_{q=1}^{5} w_q\, r(g_q)^2\, p(g_q)\, \lvert\mathbf{X}'(g_q)\rvert",
        source: SOURCE,
        // A quadratic that is ≥ 0 at the nodes can be negative between them, and the weights of a node always are
        // somewhere: terms of either sign then cancel in the sum.
        eta: 8.0,
        eta_jacobian: 48.0,
        objective: false,
    };
    type Inputs<T: Element> = ParabolicPressures<T>;
    type Outputs<T: Element> = Torque<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ParabolicPressures<D>) -> Torque<D> {
        let (middle, pairs) = Station::all(i);
        let torque = |station: &Station<D>| station.by_pressure() * station.pressure;
        Torque { t: pairs.iter().fold(torque(&middle), |t, [after, before]| t + (torque(after) + torque(before))) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ParabolicPressures<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &ParabolicPressures<D>) -> (Torque<D>, Jacobian<Self, D>) {
        let (middle, pairs) = Station::all(i);
        let zero = D::zero();
        let (mut p, mut r) = ([zero, middle.by_pressure(), zero], [zero, middle.by_radius(), zero]);
        let mut t = p[1] * middle.pressure;
        // By the halves of the element; in the middle X′ is half their sum, and x2 drops out.
        let (mut first, mut second) = (Vector2::from_element(zero), Vector2::from_element(zero));
        for (row, [after, before]) in [1, 2].into_iter().zip(&pairs) {
            let [_, k, n1, n2, n3] = rule::<D>(row);
            let (a, b) = (after.by_pressure(), before.by_pressure());
            t += a * after.pressure + b * before.pressure;
            p = [p[0] + (a * n1 + b * n3), p[1] + (a + b) * n2, p[2] + (a * n3 + b * n1)];
            let (a, b) = (after.by_radius(), before.by_radius());
            r = [r[0] + (a * n1 + b * n3), r[1] + (a + b) * n2, r[2] + (a * n3 + b * n1)];
            let (a, b) = (after.by_rate(), before.by_rate());
            let turn = (a - b) * k;
            first += b - turn;
            second += a + turn;
        }
        let middle = middle.by_rate() * D::from(0.5);
        let [r1, r2, r3] = r.map(|r| Vector2::new(r + r, zero));
        let (x1, x2, x3) = (r1 - (first + middle), r2 + (first - second), r3 + (second + middle));
        let [p1, p2, p3] = p;
        (Torque { t }, Torque { t: ParabolicPressures { x1, x2, x3, p1, p2, p3 } })
    }

    fn validate(i: &ParabolicPressures<f64>) -> Result<(), Error> {
        check_radii(&[("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])
    }

    fn cases() -> Vec<Case<ParabolicPressures<f64>>> {
        let on = |[x1, x2, x3]: [[f64; 2]; 3], [p1, p2, p3]: [f64; 3]| ParabolicPressures {
            x1: x1.into(),
            x2: x2.into(),
            x3: x3.into(),
            p1,
            p2,
            p3,
        };
        let bowl = [[1.0, 0.0], [2.0, 0.5], [3.0, 2.0]];
        let mut cases = vec![
            Case::hand("cylinder", "2π r² ℓ p = 2π × 4 × 6 × 0.5", on([[2.0, 0.0], [2.0, 3.0], [2.0, 6.0]], [0.5; 3])),
            Case::hand(
                "disc",
                "p = r/6 from the axis to r = 6: 2π/6 × 6⁴/4",
                on([[0.0, 1.0], [3.0, 1.0], [6.0, 1.0]], [0.0, 0.5, 1.0]),
            ),
            Case::hand(
                "parabolic-pressure",
                "p = (r/6)² on that disc: 2π/36 × 6⁵/5",
                on([[0.0, 1.0], [3.0, 1.0], [6.0, 1.0]], [0.0, 0.25, 1.0]),
            ),
            Case::limit(
                "axis",
                "r → 0: nothing on the axis",
                on([[0.0, 1.0], [0.0, 2.0], [0.0, 2.5]], [5.0, 6.0, 7.0]),
            ),
            Case::limit("open", "no pressure, no torque", on(bowl, [0.0; 3])),
            Case::hand("bowl", "a curved element", on(bowl, [0.5, 0.25, 0.75])),
            Case::hard("near-axis", "r = 1e-200", on([[1e-200, 1.0], [1e-200, 2.0], [1e-200, 3.5]], [5.0, 6.0, 7.0])),
            Case::hard("closed", "x1 = x3, X'(0) = 0", on([[1.0, 1.0], [2.0, 1.5], [1.0, 1.0]], [1.0, 2.0, 3.0])),
            Case::hard("coincident", "all nodes at one place", on([[1.5, 1.0]; 3], [1.0, 2.0, 3.0])),
        ];
        cases.extend(parabolas().into_iter().map(|p| {
            // Moved right of the axis, and to sizes whose third power is a double.
            let factor = match p.id {
                "tiny" => 1e100,
                "huge" => 1e-100,
                _ => 1.0,
            };
            let [x1, x2, x3] = p.value.map(|x| x * factor);
            let right = Vector2::new((-x1.x).max(0.0), 0.0);
            let (x1, x2, x3) = (x1 + right, x2 + right, x3 + right);
            Case::hard(p.id, p.comment, ParabolicPressures { x1, x2, x3, p1: 0.75, p2: 2.5, p3: 1.25 })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicPressures<f64>>> {
        let on = |r| Vector2::new(r, r);
        let i = ParabolicPressures { x1: on(1.0), x2: on(-0.5), x3: on(2.0), p1: 1.0, p2: 1.0, p3: 1.0 };
        vec![Case::invalid("negative-radius", "left of the axis", i)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\mathbf{x}_1 = \mathbf{x}_3",
            convention: Convention::Subgradient,
            holds: |i| i.x1 == i.x3,
            at: || {
                let (x1, x2) = (Vector2::new(1.0, 1.0), Vector2::new(2.0, 1.5));
                ParabolicPressures { x1, x2, x3: x1, p1: 1.0, p2: 2.0, p3: 3.0 }
            },
            across: || {
                let still = Vector2::zeros();
                ParabolicPressures { x1: still, x2: still, x3: Vector2::new(0.5, 1.0), p1: 0.0, p2: 0.0, p3: 0.0 }
            },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "with midside node and pressure in the middle it is that of ISL21A",
                sides: |i| {
                    let half = crate::Octuple::from(0.5);
                    let straight = ParabolicPressures { x2: (i.x1 + i.x3) * half, p2: (i.p1 + i.p3) * half, ..*i };
                    let linear = LinearPressures { x1: i.x1, x2: i.x3, p1: i.p1, p2: i.p3 };
                    law::equal(Self::eval(&straight).t, TorqueLinear::eval(&linear).t)
                },
            },
            Law {
                statement: "it does not depend on the sequence of the nodes",
                sides: |i| {
                    let back = ParabolicPressures { x1: i.x3, x3: i.x1, p1: i.p3, p3: i.p1, ..*i };
                    law::equal(Self::eval(i).t, Self::eval(&back).t)
                },
            },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;

    #[test]
    fn the_rule_is_the_nearest_to_its_definition() {
        assert_eq!(RULE, [0, 1, 2].map(|row| definition::<Octuple>(row).map(Octuple::to_f64)));
    }
}
