//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{ContactAreaLinear, ContactAreaParabolic, LinearNodes, ParabolicNodes, ThreeAreas, TwoAreas, lengths};
use crate::Octuple;
use crate::contact::slide_line::basis::length_and_tangent;
use crate::contact::slide_line::points::proof::{parabolas, quarter_point};
use crate::contact::slide_line::running::ELEMENT;
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::pi;
use nalgebra::Vector2;

impl Proved for ContactAreaLinear {
    fn cases() -> Vec<Case<LinearNodes<f64>>> {
        let nodes = |x1: [f64; 2], x2: [f64; 2]| LinearNodes { x1: x1.into(), x2: x2.into() };
        let mut cases = vec![
            Case::hand("cylinder", "radius 2, length 3: 6π each, together 2π r ℓ", nodes([2.0, 0.0], [2.0, 3.0])),
            Case::hand("cone", "ℓ = 5: 5π and 20π", nodes([1.0, 0.0], [4.0, 4.0])),
            Case::hand("axis", "r → 0: a node on the axis has no area", nodes([0.0, 1.0], [0.5, 1.0])),
            Case::hand("on-the-axis", "both nodes on the axis", nodes([0.0, 1.0], [0.0, 2.0])),
            Case::hard("near-axis", "r = 1e-200", nodes([1e-200, 1.0], [0.5, 1.25])),
            Case::hard("coincident", "ℓ = 0: derivative 0 by convention", nodes([1.5, 1.0], [1.5, 1.0])),
            Case::running("ℓ = 5: 16π and 31π", LinearNodes { x1: ELEMENT[0], x2: ELEMENT[1] }),
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
        vec![Kink::<Self>::subgradient(
            r"\mathbf{x}_1 = \mathbf{x}_2",
            |i| i.x1 == i.x2,
            LinearNodes { x1: Vector2::new(1.5, 1.0), x2: Vector2::new(1.5, 1.0) },
            LinearNodes { x1: Vector2::zeros(), x2: Vector2::new(0.6, 0.8) },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("the areas add up to that of the cone between the nodes, π ℓ (r1 + r2)", |i| {
                let TwoAreas { a1, a2 } = Self::eval(i);
                let (length, _) = length_and_tangent(i.x2 - i.x1);
                law::equal(a1 + a2, pi::<Octuple>() * length * (i.x1.x + i.x2.x))
            }),
            Law::<Self>::new("moving along the axis and mirroring it changes nothing", |i| {
                let moved = |x: Vector2<Octuple>| Vector2::new(x.x, -x.y + 7.0);
                let there = Self::eval(&LinearNodes { x1: moved(i.x1), x2: moved(i.x2) });
                let here = Self::eval(i);
                let size = pi::<Octuple>() * (i.x1.x + i.x2.x);
                [law::equal_with(here.a1, there.a1, size), law::equal_with(here.a2, there.a2, size)].concat()
            }),
        ]
    }
}

impl Proved for ContactAreaParabolic {
    fn cases() -> Vec<Case<ParabolicNodes<f64>>> {
        let nodes =
            |x1: [f64; 2], x2: [f64; 2], x3: [f64; 2]| ParabolicNodes { x1: x1.into(), x2: x2.into(), x3: x3.into() };
        let mut cases = vec![
            Case::hand("cylinder", "radius 2, length 6: 4π, 16π, 4π", nodes([2.0, 0.0], [2.0, 3.0], [2.0, 6.0])),
            Case::hand("cone", "ℓ = 10: 20π/6, 200π/3, 70π/6", nodes([1.0, 0.0], [4.0, 4.0], [7.0, 8.0])),
            Case::hand("axis", "r → 0: a node on the axis has no area", nodes([0.0, 1.0], [0.5, 1.0], [1.0, 1.5])),
            Case::hard("near-axis", "r = 1e-200", nodes([1e-200, 1.0], [0.5, 1.25], [1.0, 1.0])),
            Case::hard("closed", "x1 = x3: derivative 0 by convention", nodes([1.0, 1.0], [2.0, 1.5], [1.0, 1.0])),
            Case::hard("coincident", "all nodes coincide", nodes([1.5, 1.0], [1.5, 1.0], [1.5, 1.0])),
            {
                let [x1, x2, x3] = ELEMENT;
                Case::running("ℓ = 10: a sixth, two thirds, a sixth of 20π r", ParabolicNodes { x1, x2, x3 })
            },
        ];
        cases.extend(parabolas().into_iter().map(|p| {
            // Shifted to the right of the axis; lengths of 1e200 would give areas that overflow.
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
            Kink::<Self>::subgradient(
                r"\mathbf{X}'(-1) = 0",
                |i| lengths(i)[0].0 == 0.0,
                {
                    let [x1, x2, x3] = quarter_point();
                    ParabolicNodes { x1, x2, x3 }
                },
                ParabolicNodes { x2: Vector2::new(0.25, -0.5), ..still() },
            ),
            Kink::<Self>::subgradient(
                r"\mathbf{X}'(0) = 0",
                |i| lengths(i)[1].0 == 0.0,
                {
                    let [x1, x2] = [Vector2::new(1.0, 1.0), Vector2::new(2.0, 1.5)];
                    ParabolicNodes { x1, x2, x3: x1 }
                },
                ParabolicNodes { x3: Vector2::new(0.5, 1.0), ..still() },
            ),
            Kink::<Self>::subgradient(
                r"\mathbf{X}'(1) = 0",
                |i| lengths(i)[2].0 == 0.0,
                {
                    let [x3, x2, x1] = quarter_point();
                    ParabolicNodes { x1, x2, x3 }
                },
                ParabolicNodes { x2: Vector2::new(0.25, -0.5), ..still() },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new(
            "with the midside node in the middle they are Simpson's share of the cone: 1/6, 4/6, 1/6 of 2π r ℓ",
            |i| {
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
        )]
    }
}
