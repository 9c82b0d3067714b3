//! Evidence for the formulas of the parent module: cases, laws.

use super::{CurvePoint, LinearPlace, LinearPoint, ParabolicPlace, ParabolicPoint};
use crate::Octuple;
use crate::contact::slide_line::running::{AT_PARABOLA, LINE, PARABOLA, SLAVE};
use crate::formula::proof::{Case, Hard, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use nalgebra::Vector2;

impl Proved for LinearPoint {
    fn cases() -> Vec<Case<LinearPlace<f64>>> {
        let hand = LinearPlace { x1: Vector2::new(1.0, 2.0), x2: Vector2::new(5.0, -1.0), g: 0.5 };
        let mut cases = vec![
            Case::hand("three-quarters", "X = (4, -0.25), X' = (2, -1.5)", hand),
            Case::hand("first-node", "g = -1 is the first node", LinearPlace { g: -1.0, ..hand }),
            Case::hand("middle", "g = 0 is the middle", LinearPlace { g: 0.0, ..hand }),
            Case::hand("last-node", "g = 1 is the last node", LinearPlace { g: 1.0, ..hand }),
            Case::hard("near-first", "g one ulp above -1", LinearPlace { g: (-1.0_f64).next_up(), ..hand }),
            Case::hard("near-last", "g one ulp below 1", LinearPlace { g: 1.0_f64.next_down(), ..hand }),
            Case::running("0.4 and 0.6 of the nodes", LinearPlace { x1: LINE[0], x2: LINE[1], g: SLAVE.1 }),
        ];
        cases.extend(hard::places().into_iter().map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, LinearPlace { x1, x2, g: 0.3125 })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("reversing the nodes and g gives the same point and the opposite derivative", |i| {
                let (here, back) = (Self::eval(i), Self::eval(&LinearPlace { x1: i.x2, x2: i.x1, g: -i.g }));
                reversed(&here, &back)
            }),
            Law::<Self>::new("it is the parabola whose midside node is in the middle", |i| {
                let middle = (i.x1 + i.x2) * Octuple::from(0.5);
                let parabola = ParabolicPoint::eval(&ParabolicPlace { x1: i.x1, x2: middle, x3: i.x2, g: i.g });
                same(&Self::eval(i), &parabola, size(&i.components()))
            }),
        ]
    }
}

impl Proved for ParabolicPoint {
    fn cases() -> Vec<Case<ParabolicPlace<f64>>> {
        let place = |[x1, x2, x3]: [Vector2<f64>; 3], g| ParabolicPlace { x1, x2, x3, g };
        let hand = place(arch(1.0), 0.5);
        let mut cases = vec![
            Case::hand("arch", "the parabola z = 1 - (r - 2)² at r = 2.5: X = (2.5, 0.75), X' = (1, -1)", hand),
            Case::hand("first-node", "g = -1 is the first node", ParabolicPlace { g: -1.0, ..hand }),
            Case::hand("midside-node", "g = 0 is the midside node", ParabolicPlace { g: 0.0, ..hand }),
            Case::hand("last-node", "g = 1 is the last node", ParabolicPlace { g: 1.0, ..hand }),
            Case::hard("near-first", "g one ulp above -1", ParabolicPlace { g: (-1.0_f64).next_up(), ..hand }),
            Case::hard("near-last", "g one ulp below 1", ParabolicPlace { g: 1.0_f64.next_down(), ..hand }),
            Case::hard("near-midside", "g = 1e-17", ParabolicPlace { g: 1e-17, ..hand }),
            Case::running("-0.125, 0.75 and 0.375 of the nodes", place(PARABOLA, AT_PARABOLA.1)),
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
        vec![Law::<Self>::new("reversing the nodes and g gives the same point and the opposite derivative", |i| {
            let back = ParabolicPlace { x1: i.x3, x2: i.x2, x3: i.x1, g: -i.g };
            reversed(&Self::eval(i), &Self::eval(&back))
        })]
    }
}

/// Hard parabolas: almost straight, with the midside node at the quarter point, far away, tiny and huge.
pub(crate) fn parabolas() -> Vec<Hard<[Vector2<f64>; 3]>> {
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

/// The parabola through (1, 0), (2, sagitta), (3, 0).
pub(crate) fn arch(sagitta: f64) -> [Vector2<f64>; 3] {
    [Vector2::new(1.0, 0.0), Vector2::new(2.0, sagitta), Vector2::new(3.0, 0.0)]
}

/// Three nodes on a line, with the middle one at a quarter of it.
pub(crate) fn quarter_point() -> [Vector2<f64>; 3] {
    [Vector2::new(1.0, 2.0), Vector2::new(2.0, 4.0), Vector2::new(5.0, 10.0)]
}

/// The points are equal, and the derivatives opposite.
pub(crate) fn reversed(here: &CurvePoint<Octuple>, back: &CurvePoint<Octuple>) -> Vec<crate::formula::proof::Equation> {
    law::equal_all([(here.x.x, back.x.x), (here.x.y, back.x.y), (here.dx.x, -back.dx.x), (here.dx.y, -back.dx.y)])
}

/// Points and derivatives are equal, with terms up to `size`.
pub(crate) fn same(
    a: &CurvePoint<Octuple>,
    b: &CurvePoint<Octuple>,
    size: Octuple,
) -> Vec<crate::formula::proof::Equation> {
    let pairs = a.components().into_iter().zip(b.components());
    pairs.flat_map(|(a, b)| law::equal_with(a, b, size)).collect()
}

/// Σ|x|.
pub(crate) fn size(components: &[Octuple]) -> Octuple {
    components.iter().fold(0.0.into(), |sum, &x| sum + abs(x))
}
