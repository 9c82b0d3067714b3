//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{ClosestLinear, LinearSlave};
use crate::Octuple;
use crate::contact::slide_line::closest::evidence;
use crate::contact::slide_line::running::{LINE, SLAVE};
use crate::contact::slide_line::{LinearPlace, LinearPoint, left, length};
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::sign;
use nalgebra::Vector2;

impl Proved for ClosestLinear {
    fn cases() -> Vec<Case<LinearSlave<f64>>> {
        let on = |xs: [f64; 2], x1: [f64; 2], x2: [f64; 2]| LinearSlave { xs: xs.into(), x1: x1.into(), x2: x2.into() };
        let flat = |xs| on(xs, [1.0, 0.0], [5.0, 0.0]);
        let mut cases = vec![
            Case::hand("open", "a quarter of the way, 2 above: g = -0.5", flat([2.0, 2.0])),
            Case::hand("closed", "2 below: penetration", flat([2.0, -2.0])),
            Case::hand(
                "inclined",
                "3-4-5: the foot is (4, 5), the separation 5, g = -0.5",
                on([0.0, 8.0], [1.0, 1.0], [13.0, 17.0]),
            ),
            Case::hand("on-the-segment", "separation 0", flat([2.5, 0.0])),
            Case::hand("beyond-first", "the foot stays at the first node", flat([-2.0, 2.0])),
            Case::hand("beyond-last", "the foot stays at the last node", flat([9.0, -2.0])),
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
            Case::running("(2.8, 2.4) is nearest", LinearSlave { xs: SLAVE.0, x1: LINE[0], x2: LINE[1] }),
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

    fn placed(drawn: LinearSlave<f64>) -> LinearSlave<f64> {
        let LinearSlave { xs, x1, x2 } = drawn;
        let on = |g| [LinearPoint::eval(&LinearPlace { x1, x2, g }).x, x2 - x1];
        LinearSlave { xs: evidence::slave_point(xs, on), ..drawn }
    }

    fn invalid_cases() -> Vec<Case<LinearSlave<f64>>> {
        let (xs, x) = (Vector2::new(1.0, 3.0), Vector2::new(1.0, 2.0));
        vec![Case::invalid("coincident", "no tangent", LinearSlave { xs, x1: x, x2: x })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switch(
                r"(\mathbf{x}_s-\mathbf{x}_1)\cdot\mathbf{X}' = 0",
                |i| (i.xs - i.x1).dot(&(i.x2 - i.x1)) == 0.0,
                above(1.0),
                along_r(),
            ),
            Kink::<Self>::switch(
                r"(\mathbf{x}_s-\mathbf{x}_2)\cdot\mathbf{X}' = 0",
                |i| (i.xs - i.x2).dot(&(i.x2 - i.x1)) == 0.0,
                above(5.0),
                along_r(),
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("xs − X is perpendicular to the segment, or the closest point is an end", |i| {
                let g = Self::eval(i).g;
                let gap = i.xs - LinearPoint::eval(&LinearPlace { x1: i.x1, x2: i.x2, g }).x;
                let (chord, zero) = (i.x2 - i.x1, Octuple::from(0.0));
                let along = gap.dot(&chord);
                let outside = g * g == 1.0 && sign(along) == sign(g);
                let size = (i.xs - i.x1).dot(&(i.xs - i.x1)) + chord.dot(&chord);
                law::equal_with(if outside { zero } else { along }, zero, size)
            }),
            Law::<Self>::new("reversing the nodes reverses g and the sign of the separation", |i| {
                let (here, back) = (Self::eval(i), Self::eval(&LinearSlave { x1: i.x2, x2: i.x1, ..*i }));
                [
                    law::equal_with(here.g, -back.g, 1.0.into()),
                    law::equal_with(here.separation, -back.separation, length(i.xs - i.x1)),
                ]
                .concat()
            }),
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
