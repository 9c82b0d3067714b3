//! Contact area of the nodes of axisymmetric elements, around the whole circumference.

use super::basis::length_and_tangent;
use super::check_radii;
use super::points::{parabolas, quarter_point};
use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{A1, A2, A3, X1, X2, X3};
use crate::scalar::{Scalar, pi};
use crate::verify::{hard, law};
use nalgebra::Vector2;

const SOURCE: Source = Source::SLIDE_LINE.section("Defining slide line elements (slave surface)");

fields! {
    /// The two nodes of an ISL21A element.
    pub struct LinearNodes<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2 }
}
fields! {
    /// Contact areas of two nodes.
    pub struct TwoAreas<T> { a1: T = A1, a2: T = A2 }
}

/// Contact areas of ISL21A: Aᵢ = π ℓ rᵢ, half the length times the circumference at the node.
#[derive(Clone, Copy, Debug)]
pub struct ContactAreaLinear;

impl Formula for ContactAreaLinear {
    const SPEC: Spec = Spec {
        id: "slide_line.contact_area_linear",
        title: "Contact areas of ISL21A",
        latex: r"A_i = 2\pi r_i\,\tfrac{\ell}{2},\quad \ell = \lvert\mathbf{x}_2-\mathbf{x}_1\rvert",
        source: SOURCE,
        eta: 4.0,
        eta_jacobian: 4.0,
        objective: false,
    };
    type Inputs<T: Element> = LinearNodes<T>;
    type Outputs<T: Element> = TwoAreas<T>;

    fn eval<D: Scalar>(i: &LinearNodes<D>) -> TwoAreas<D> {
        let (length, _) = length_and_tangent(i.x2 - i.x1);
        let band = pi::<D>() * length;
        TwoAreas { a1: band * i.x1.x, a2: band * i.x2.x }
    }

    fn jacobian<D: Scalar>(i: &LinearNodes<D>) -> Jacobian<Self, D> {
        let (length, t) = length_and_tangent(i.x2 - i.x1);
        let band = pi::<D>() * length;
        let radius = Vector2::new(band, D::zero());
        let [s1, s2] = [i.x1.x, i.x2.x].map(|r| t * (pi::<D>() * r));
        TwoAreas { a1: LinearNodes { x1: radius - s1, x2: s1 }, a2: LinearNodes { x1: -s2, x2: radius + s2 } }
    }

    fn validate(i: &LinearNodes<f64>) -> Result<(), Error> {
        check_radii(&[("x1", i.x1), ("x2", i.x2)])
    }

    fn cases() -> Vec<Case<LinearNodes<f64>>> {
        let nodes = |x1: [f64; 2], x2: [f64; 2]| LinearNodes { x1: x1.into(), x2: x2.into() };
        let mut cases = vec![
            Case::hand("cylinder", "radius 2, length 3: 6π each, together 2π r ℓ", nodes([2.0, 0.0], [2.0, 3.0])),
            Case::hand("cone", "ℓ = 5: 5π and 20π", nodes([1.0, 0.0], [4.0, 4.0])),
            Case::limit("axis", "r → 0: a node on the axis has no area", nodes([0.0, 1.0], [0.5, 1.0])),
            Case::limit("on-the-axis", "both nodes on the axis", nodes([0.0, 1.0], [0.0, 2.0])),
            Case::hard("near-axis", "r = 1e-200", nodes([1e-200, 1.0], [0.5, 1.25])),
            Case::hard("coincident", "ℓ = 0: derivative 0 by convention", nodes([1.5, 1.0], [1.5, 1.0])),
        ];
        cases.extend(hard::places().into_iter().filter(|place| place.id != "coincident").map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, LinearNodes { x1, x2 })
        }));
        cases.extend([
            Case::hard("tiny", "lengths of 1e-150: squares underflow", nodes([3e-150, 1e-150], [7e-150, 4e-150])),
            Case::hard("huge", "lengths of 1e150: squares overflow", nodes([3e150, 1e150], [7e150, 4e150])),
        ]);
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearNodes<f64>>> {
        let nodes = LinearNodes { x1: Vector2::new(-1.0, 0.0), x2: Vector2::new(1.0, 0.0) };
        vec![Case::invalid("negative-radius", "left of the axis", nodes)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\mathbf{x}_1 = \mathbf{x}_2",
            convention: Convention::Subgradient,
            holds: |i| i.x1 == i.x2,
            at: || LinearNodes { x1: Vector2::new(1.5, 1.0), x2: Vector2::new(1.5, 1.0) },
            across: || LinearNodes { x1: Vector2::zeros(), x2: Vector2::new(0.6, 0.8) },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "the areas add up to that of the cone between the nodes, π ℓ (r1 + r2)",
                sides: |i| {
                    let TwoAreas { a1, a2 } = Self::eval(i);
                    let (length, _) = length_and_tangent(i.x2 - i.x1);
                    law::equal(a1 + a2, pi::<Octuple>() * length * (i.x1.x + i.x2.x))
                },
            },
            Law {
                statement: "moving along the axis and mirroring it changes nothing",
                sides: |i| {
                    let moved = |x: Vector2<Octuple>| Vector2::new(x.x, -x.y + 7.0);
                    let there = Self::eval(&LinearNodes { x1: moved(i.x1), x2: moved(i.x2) });
                    let here = Self::eval(i);
                    let size = pi::<Octuple>() * (i.x1.x + i.x2.x);
                    [law::equal_with(here.a1, there.a1, size), law::equal_with(here.a2, there.a2, size)].concat()
                },
            },
        ]
    }
}

fields! {
    /// The three nodes of an ISL22A element; the second is the midside node.
    pub struct ParabolicNodes<T> { x1: Vector2<T> = X1, x2: Vector2<T> = X2, x3: Vector2<T> = X3 }
}
fields! {
    /// Contact areas of three nodes.
    pub struct ThreeAreas<T> { a1: T = A1, a2: T = A2, a3: T = A3 }
}

/// Contact areas of ISL22A: Aᵢ = 2π rᵢ wᵢ |X′(gᵢ)|, with w = 1/3, 4/3, 1/3 at g = −1, 0, 1 (Simpson's rule).
#[derive(Clone, Copy, Debug)]
pub struct ContactAreaParabolic;

/// The lengths whose products with π rᵢ/3 are the areas, and their directions: of 6X′(−1)/3, 4·2X′(0), 6X′(1)/3.
#[inline]
fn lengths<D: Scalar>(i: &ParabolicNodes<D>) -> [(D, Vector2<D>); 3] {
    let (before, after) = (i.x2 - i.x1, i.x3 - i.x2);
    let three = D::from(3.0);
    [before * three - after, i.x3 - i.x1, after * three - before].map(length_and_tangent)
}

impl Formula for ContactAreaParabolic {
    const SPEC: Spec = Spec {
        id: "slide_line.contact_area_parabolic",
        title: "Contact areas of ISL22A",
        latex: r"A_i = 2\pi r_i\,w_i\,\lvert\mathbf{X}'(g_i)\rvert,\quad w = \tfrac13, \tfrac43, \tfrac13\ \text{at}\ g = -1, 0, 1",
        source: SOURCE,
        eta: 4.0,
        eta_jacobian: 6.0,
        objective: false,
    };
    type Inputs<T: Element> = ParabolicNodes<T>;
    type Outputs<T: Element> = ThreeAreas<T>;

    fn eval<D: Scalar>(i: &ParabolicNodes<D>) -> ThreeAreas<D> {
        let [(first, _), (middle, _), (last, _)] = lengths(i);
        let third = pi::<D>() / 3.0;
        ThreeAreas { a1: third * i.x1.x * first, a2: third * 4.0 * i.x2.x * middle, a3: third * i.x3.x * last }
    }

    fn jacobian<D: Scalar>(i: &ParabolicNodes<D>) -> Jacobian<Self, D> {
        let [(first, t1), (middle, t2), (last, t3)] = lengths(i);
        let third = pi::<D>() / 3.0;
        let radius = |x| Vector2::new(third * x, D::zero());
        let scaled = |t: Vector2<D>, factor: f64| t * D::from(factor);
        let (s1, s2, s3) = (t1 * (third * i.x1.x), t2 * (third * 4.0 * i.x2.x), t3 * (third * i.x3.x));
        ThreeAreas {
            a1: ParabolicNodes { x1: radius(first) - scaled(s1, 3.0), x2: scaled(s1, 4.0), x3: -s1 },
            a2: ParabolicNodes { x1: -s2, x2: radius(middle * 4.0), x3: s2 },
            a3: ParabolicNodes { x1: s3, x2: scaled(s3, -4.0), x3: radius(last) + scaled(s3, 3.0) },
        }
    }

    fn validate(i: &ParabolicNodes<f64>) -> Result<(), Error> {
        check_radii(&[("x1", i.x1), ("x2", i.x2), ("x3", i.x3)])
    }

    fn cases() -> Vec<Case<ParabolicNodes<f64>>> {
        let nodes =
            |x1: [f64; 2], x2: [f64; 2], x3: [f64; 2]| ParabolicNodes { x1: x1.into(), x2: x2.into(), x3: x3.into() };
        let mut cases = vec![
            Case::hand("cylinder", "radius 2, length 6: 4π, 16π, 4π", nodes([2.0, 0.0], [2.0, 3.0], [2.0, 6.0])),
            Case::hand("cone", "ℓ = 10: 20π/6, 200π/3, 70π/6", nodes([1.0, 0.0], [4.0, 4.0], [7.0, 8.0])),
            Case::limit("axis", "r → 0: a node on the axis has no area", nodes([0.0, 1.0], [0.5, 1.0], [1.0, 1.5])),
            Case::hard("near-axis", "r = 1e-200", nodes([1e-200, 1.0], [0.5, 1.25], [1.0, 1.0])),
            Case::hard("closed", "x1 = x3: derivative 0 by convention", nodes([1.0, 1.0], [2.0, 1.5], [1.0, 1.0])),
            Case::hard("coincident", "all nodes at one place", nodes([1.5, 1.0], [1.5, 1.0], [1.5, 1.0])),
        ];
        cases.extend(parabolas().into_iter().map(|p| {
            // Moved right of the axis; lengths of 1e200 would make areas that overflow.
            let [x1, x2, x3] = p.value.map(|x| if p.id == "huge" { x * 1e-50 } else { x });
            let right = Vector2::new((-x1.x).max(0.0), 0.0);
            Case::hard(p.id, p.comment, ParabolicNodes { x1: x1 + right, x2: x2 + right, x3: x3 + right })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<ParabolicNodes<f64>>> {
        let on = |r| Vector2::new(r, r);
        let nodes = ParabolicNodes { x1: on(0.5), x2: on(1.0), x3: on(-1.0) };
        vec![Case::invalid("negative-radius", "left of the axis", nodes)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        fn still() -> ParabolicNodes<f64> {
            ParabolicNodes::filled(0.0)
        }
        vec![
            Kink {
                condition: r"\mathbf{X}'(-1) = 0",
                convention: Convention::Subgradient,
                holds: |i| lengths(i)[0].0 == 0.0,
                at: || {
                    let [x1, x2, x3] = quarter_point();
                    ParabolicNodes { x1, x2, x3 }
                },
                across: || ParabolicNodes { x2: Vector2::new(0.25, -0.5), ..still() },
            },
            Kink {
                condition: r"\mathbf{X}'(0) = 0",
                convention: Convention::Subgradient,
                holds: |i| lengths(i)[1].0 == 0.0,
                at: || {
                    let [x1, x2] = [Vector2::new(1.0, 1.0), Vector2::new(2.0, 1.5)];
                    ParabolicNodes { x1, x2, x3: x1 }
                },
                across: || ParabolicNodes { x3: Vector2::new(0.5, 1.0), ..still() },
            },
            Kink {
                condition: r"\mathbf{X}'(1) = 0",
                convention: Convention::Subgradient,
                holds: |i| lengths(i)[2].0 == 0.0,
                at: || {
                    let [x3, x2, x1] = quarter_point();
                    ParabolicNodes { x1, x2, x3 }
                },
                across: || ParabolicNodes { x2: Vector2::new(0.25, -0.5), ..still() },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "with the midside node in the middle they are Simpson's share of the cone: 1/6, 4/6, 1/6 of 2π r ℓ",
            sides: |i| {
                let straight = ParabolicNodes { x2: (i.x1 + i.x3) * Octuple::from(0.5), ..*i };
                let ThreeAreas { a1, a2, a3 } = Self::eval(&straight);
                let (length, _) = length_and_tangent(i.x3 - i.x1);
                let share = |r| pi::<Octuple>() * length * r / 3.0;
                law::equal_all([
                    (a1, share(i.x1.x)),
                    (a2, share(straight.x2.x) * 4.0),
                    (a3, share(i.x3.x)),
                    (a1 + a2 + a3, pi::<Octuple>() * length * (i.x1.x + i.x3.x)),
                ])
            },
        }]
    }
}
