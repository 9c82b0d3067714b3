//! The greatest torque that a slide line transmits: T = ∬ r² p ds dθ, as if the friction coefficient were 1.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::basis::length_and_tangent;
use super::points::ParabolicPoint;
use super::{check_radii, length};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{P1, P2, P3, TORQUE, X1, X2, X3};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Source, Spec};
use crate::number::scalar;
use crate::number::scalar::{Leaf, Scalar, pi};
use nalgebra::Vector2;

const SOURCE: Source = Document::SLIDE_LINE.ours(
    "Obtaining the “maximum torque” that can be transmitted across axisymmetric slide lines",
    "the integral of r² p is printed; how r and p go along an element, and the integration, are ours",
);

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
    const SPEC: Spec = Spec::new("slide_line.torque_linear", "Torque over ISL21A", SOURCE)
        .equation(r"T = 2\pi\ell\left[p_1\Bigl(\tfrac{r_1^2}{4}+\tfrac{r_1 r_2}{6}+\tfrac{r_2^2}{12}\Bigr) + p_2\Bigl(\tfrac{r_1^2}{12}+\tfrac{r_1 r_2}{6}+\tfrac{r_2^2}{4}\Bigr)\right],\quad r_i = x_{i,1}\quad (i = 1, 2),\quad \ell = \lvert\mathbf{x}_2-\mathbf{x}_1\rvert")
        // The largest η that `audit --attack` found is 1.52 for the value, and 2.6 is possible to first order; for the Jacobian 17.9
        // and 29.
        .eta(3.0, 29.0)
        .scale(1e120)
        .finite(Finite::Below)
        .not_objective();
    type Inputs<T: Component> = LinearPressures<T>;
    type Outputs<T: Component> = Torque<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearPressures<D>) -> Torque<D> {
        let (length, _) = length_and_tangent(i.x2 - i.x1);
        let (r1, r2) = (i.x1.x, i.x2.x);
        let [m1, m2] = moments(r1, r2);
        Torque { t: pi::<D>() / 6.0 * length * (i.p1 * m1 + i.p2 * m2) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &LinearPressures<D>) -> Jacobian<Self, D> {
        let (length, t) = length_and_tangent(i.x2 - i.x1);
        let (r1, r2) = (i.x1.x, i.x2.x);
        let ([m1, m2], both) = (moments(r1, r2), r1 + r2);
        let sixth = pi::<D>() / 6.0;
        let band = sixth * length;
        // The effects of a node through its radius and through the length may cancel: π/6 is multiplied last.
        let (twice, stretch) = (length * 2.0, t * (i.p1 * m1 + i.p2 * m2));
        let radius = |moment| Vector2::new(twice * moment, D::zero());
        let x1 = (radius(i.p1 * (both + r1 * 2.0) + i.p2 * both) - stretch) * sixth;
        let x2 = (radius(i.p1 * both + i.p2 * (both + r2 * 2.0)) + stretch) * sixth;
        Torque { t: LinearPressures { x1, x2, p1: band * m1, p2: band * m2 } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &LinearPressures<D>) -> Result<(), Error> {
        check_radii([("x1", i.x1), ("x2", i.x2)])
    }
}

/// 3r1² + 2r1r2 + r2² and r1² + 2r1r2 + 3r2², as (r1 + r2)² + 2r².
#[inline(always)]
fn moments<D: Scalar>(r1: D, r2: D) -> [D; 2] {
    let square = (r1 + r2) * (r1 + r2);
    [r1, r2].map(|r| square + r * r * 2.0)
}

fields! {
    /// The three nodes of an ISL22A element, and the pressures there; the second is the midside node.
    pub struct ParabolicPressures<T> {
        x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3, p1: T = P1, p2: T = P2, p3: T = P3,
    }
}

/// Torque over an ISL22A element: T = 2π Σ w r² p |X′| over the five Gauss–Legendre points, with p parabolic.
#[derive(Clone, Copy, Debug)]
pub struct TorqueParabolic;

/// The Gauss–Legendre rule with five points, which integrates polynomials of degree 9 exactly.
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

/// A row of the rule from its definition, the roots of the Legendre polynomial.
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

// Five of these are computed for every result; as calls they took as long as all the rest.
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

    /// The derivative of the torque with respect to the pressure here.
    #[inline(always)]
    fn by_pressure(&self) -> D {
        self.moment * self.length * self.radius
    }

    /// Half of the derivative of the torque with respect to the radius here.
    #[inline(always)]
    fn by_radius(&self) -> D {
        self.moment * self.length * self.pressure
    }

    /// The derivative of the torque with respect to X′ here.
    #[inline(always)]
    fn by_rate(&self) -> Vector2<D> {
        let along = self.moment * (self.radius * self.pressure) / self.length;
        self.rate * if self.length == 0.0 { D::zero() } else { along }
    }
}

/// A row of the rule.
#[inline(always)]
fn rule<D: Scalar>(row: usize) -> [D; 5] {
    D::Leaf::constants(RULE[row], || definition(row)).map(scalar::constant)
}

impl Formula for TorqueParabolic {
    const SPEC: Spec = Spec::new("slide_line.torque_parabolic", "Torque over ISL22A", SOURCE)
        .equation(r"\begin{aligned} T &= 2\pi \sum_{q=1}^{5} w_q\, r(g_q)^2\, p(g_q)\, \lvert\mathbf{X}'(g_q)\rvert,\quad r(g) = \sum_{i=1}^{3} N_i(g)\,r_i,\quad p(g) = \sum_{i=1}^{3} N_i(g)\,p_i, \\ N_1(g) &= \tfrac12 g(g-1),\quad N_2(g) = 1-g^2,\quad N_3(g) = \tfrac12 g(g+1),\quad r_i = x_{i,1}\quad (i = 1, 2, 3), \\ g_5 &= \tfrac13\sqrt{5+2\sqrt{\tfrac{10}{7}}},\quad g_4 = \tfrac13\sqrt{5-2\sqrt{\tfrac{10}{7}}},\quad g_3 = 0,\quad g_2 = -g_4,\quad g_1 = -g_5, \\ w_5 &= \tfrac{322-13\sqrt{70}}{900},\quad w_4 = \tfrac{322+13\sqrt{70}}{900},\quad w_3 = \tfrac{128}{225},\quad w_2 = w_4,\quad w_1 = w_5 \end{aligned}")
.given(&[Given::new(r"\mathbf{X}'(g)", &ParabolicPoint::SPEC)])
        // A quadratic that is ≥ 0 at the nodes can be negative between them, and the weight of a node always is somewhere: terms
        // of opposite signs then cancel in the sum.
        // The largest η that `audit --attack` found is 4.2 for the value, and 8.2 is possible to first order; for the Jacobian 64 and 183.
        .eta(16.0, 96.0)
        .normwise(9.0, 190.0)
        .apart(0.01)
        .scale(1e50)
        .finite(Finite::Between)
        .not_objective();
    type Inputs<T: Component> = ParabolicPressures<T>;
    type Outputs<T: Component> = Torque<T>;

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

    #[inline(always)]
    fn linearized<D: Scalar>(i: &ParabolicPressures<D>) -> (Torque<D>, Jacobian<Self, D>) {
        let (middle, pairs) = Station::all(i);
        let zero = D::zero();
        let (mut p, mut r) = ([zero, middle.by_pressure(), zero], [zero, middle.by_radius(), zero]);
        let mut t = p[1] * middle.pressure;
        // Derivatives with respect to the halves of the element; in the middle X′ is half their sum, and x2 drops out.
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

    #[inline]
    fn validate<D: Scalar>(i: &ParabolicPressures<D>) -> Result<(), Error> {
        check_radii([("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])
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
