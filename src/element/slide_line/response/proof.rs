//! Evidence for the formula next door: cases, kinks, laws.

use super::{Linear, LinearAnswer, LinearPressed};
use crate::Octuple;
use crate::contact::coulomb::response::proof::not_positive;
use crate::contact::slide_line::{ClosestLinear, LinearSlave, left};
use crate::formula::proof::{Case, Equation, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{abs, norm, pi};
use nalgebra::Vector2;
use num_traits::{One, Zero};

type Vector = Vector2<Octuple>;

/// Pressed in by 1/8 above the segment from (1, 0) to (5, 0), and sticking: 1 + 2 × 0.5 < 0.25 × 16.
fn hand() -> LinearPressed<f64> {
    let [xs, xo, x1, x2] = [[2.0, -0.125], [2.5, -0.125], [1.0, 0.0], [5.0, 0.0]].map(Vector2::from);
    LinearPressed { xs, xo, x1, x2, g_before: -0.75, s12_before: 1.0, k: 128.0, k_el: 2.0, mu: 0.25 }
}

/// As before, and slipping: 1 + 2 × 0.5 > 0.0625 × 16.
fn slipping() -> LinearPressed<f64> {
    LinearPressed { mu: 0.0625, ..hand() }
}

/// The shear stress if the contact stuck.
fn trial(i: &LinearPressed<Octuple>, dslip: Octuple) -> Octuple {
    i.s12_before + i.k_el * dslip
}

/// With a segment through these places, pressed in and slipping.
fn about(x1: Vector2<f64>, x2: Vector2<f64>) -> LinearPressed<f64> {
    let chord = x2 - x1;
    let xs = x1 + chord * 0.25 - left(chord) * 0.125;
    LinearPressed { xs, xo: xs + chord * 0.5, x1, x2, ..slipping() }
}

fn separation(i: &LinearPressed<Octuple>) -> Octuple {
    ClosestLinear::eval(&LinearSlave { xs: i.xs, x1: i.x1, x2: i.x2 }).separation
}

/// Gradients by places are equal, apart from a factor.
fn proportional(left: &LinearPressed<Octuple>, right: &LinearPressed<Octuple>, factor: Octuple) -> Vec<Equation> {
    let by_places = |by: &LinearPressed<Octuple>| [by.xs, by.xo, by.x1, by.x2];
    let pairs = by_places(left).into_iter().zip(by_places(right));
    let pairs = pairs.flat_map(|(l, r)| [(l.x, r.x * factor), (l.y, r.y * factor)]);
    law::equal_all_with(pairs, norm([left.xs.x, left.xs.y]) + norm([right.xs.x, right.xs.y]) * abs(factor))
}

/// Pressed in, if it was not: the slave point is as far on the other side.
fn closed(i: &LinearPressed<Octuple>) -> LinearPressed<Octuple> {
    let h = separation(i);
    let chord = i.x2 - i.x1;
    let n = left(chord) / norm([chord.x, chord.y]);
    if h < 0.0 { *i } else { LinearPressed { xs: i.xs - n * (h * 2.0), ..*i } }
}

impl Proved for Linear {
    fn cases() -> Vec<Case<LinearPressed<f64>>> {
        let hand = hand();
        let at = |r: f64, z: f64| LinearPressed { xs: Vector2::new(r, z), ..hand };
        let mut cases = vec![
            Case::hand("stick", "S11 = 128/8 = 16, slip 0.5: S12 = 1 + 2 × 0.5 = 2 < 4; A = π × 2 × 0.5", hand),
            Case::hand("slip", "cut down to 0.0625 × 16 = 1", slipping()),
            Case::hand("slip-back", "from the other side", LinearPressed { g_before: 1.0, ..slipping() }),
            Case::hand("open", "nothing is transmitted", at(2.0, 0.5)),
            Case::hand("frictionless", "pressure alone", LinearPressed { mu: 0.0, ..hand }),
            Case::hand("no-slip", "the closest point stands still", LinearPressed { g_before: -0.5, ..hand }),
            Case::hand("past-the-end", "the segment goes on straight: g = 2", at(7.0, -0.125)),
            Case::hand("past-the-start", "g = -1.25", at(0.5, -0.125)),
            Case::hand("at-the-end", "g = 1 is no kink", at(5.0, -0.125)),
            Case::hand("on-the-axis", "r = 0: no area", at(0.0, -0.125)),
            Case::hard("touching", "E11 = 0: the Jacobian is not defined", at(2.0, 0.0)),
            Case::hard(
                "tie",
                "the trial stress is μ S11: the Jacobian is not defined",
                LinearPressed { mu: 0.125, ..hand },
            ),
            Case::hard(
                "no-length",
                "both nodes of the element at one place: no area, derivative 0 by convention",
                LinearPressed { xo: hand.xs, ..hand },
            ),
            Case::hard("hardly-closed", "a penetration of 1e-12", at(2.25, -1e-12)),
            Case::hard("stiff", "contact stiffnesses of 1e12", LinearPressed { k: 1e12, k_el: 1e12, ..hand }),
            Case::hard("inclined", "3-4-5, turned about", about(Vector2::new(4.0, 5.0), Vector2::new(1.0, 1.0))),
        ];
        let places = hard::places().into_iter().filter(|place| place.id != "coincident");
        cases.extend(places.map(|place| {
            let [x1, x2] = place.value;
            Case::hard(place.id, place.comment, about(x1, x2))
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<LinearPressed<f64>>> {
        let hand = hand();
        vec![
            Case::invalid("coincident", "no tangent", LinearPressed { x2: hand.x1, ..hand }),
            Case::invalid("negative-radius", "left of the axis", LinearPressed { xs: Vector2::new(-1.0, 0.0), ..hand }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let zero = LinearPressed::filled(0.0);
        let touching = LinearPressed { xs: Vector2::new(2.0, 0.0), ..hand() };
        vec![
            Kink::<Self>::switch(
                "E_{11} = 0",
                |i| separation(i).is_zero(),
                touching,
                LinearPressed { xs: Vector2::new(0.0, 1.0), ..zero },
            ),
            Kink::<Self>::switch(
                r"E_{11} < 0,\ \lvert S^{\mathrm{trial}}\rvert = \mu S_{11}",
                |i| {
                    let LinearAnswer { dslip, s11, .. } = Self::eval(i);
                    s11 > 0.0 && abs(trial(i, dslip)) == i.mu * s11
                },
                LinearPressed { mu: 0.125, ..hand() },
                LinearPressed { mu: 1.0, ..zero },
            ),
            Kink::<Self>::subgradient(
                r"\mathbf{x}_o = \mathbf{x}_s",
                |i| i.xs == i.xo,
                LinearPressed { xo: hand().xs, ..hand() },
                LinearPressed { xo: Vector2::new(0.6, 0.8), ..zero },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("forces along the axis and along the radius balance", |i| {
                let LinearAnswer { fs, f1, f2, .. } = Self::eval(i);
                let sum = fs + f1 + f2;
                law::vanish([sum.x, sum.y], norm([fs.x, fs.y]) + norm([f1.x, f1.y]) + norm([f2.x, f2.y]))
            }),
            Law::<Self>::new(
                "with the half length of the element, the force is around its circumference: 2π r ½ℓ of the stresses",
                |i| {
                    let LinearAnswer { fs, s11, s12, .. } = Self::eval(i);
                    let (length, half) = (norm([i.xo.x - i.xs.x, i.xo.y - i.xs.y]), Octuple::from(0.5));
                    let area = pi::<Octuple>() * 2.0 * i.xs.x * length * half;
                    law::equal(norm([fs.x, fs.y]), area * norm([s11, s12]))
                },
            ),
            Law::<Self>::new("what is transmitted never exceeds μ S11, and slip dissipates", |i| {
                let LinearAnswer { dslip, s11, s12, .. } = Self::eval(i);
                let slipped = dslip - (s12 - i.s12_before) / i.k_el;
                let terms = abs(dslip) + (abs(s12) + abs(i.s12_before)) / i.k_el;
                [not_positive(abs(s12) - i.mu * s11, i.mu * s11), not_positive(-s12 * slipped, abs(s12) * terms)]
                    .concat()
            }),
            Law::<Self>::new("moving along the axis changes nothing", |i| {
                let up = |x: Vector| x + Vector::y() * Octuple::from(7.0);
                let there = LinearPressed { xs: up(i.xs), xo: up(i.xo), x1: up(i.x1), x2: up(i.x2), ..*i };
                let (here, there) = (Self::eval(i), Self::eval(&there));
                let one = Octuple::one();
                let turned = norm([i.x2.x - i.x1.x, i.x2.y - i.x1.y]);
                let reach = norm([i.xs.x - i.x1.x, i.xs.y - i.x1.y]) + 1.0;
                let pairs = here.components().into_iter().zip(there.components());
                let force = norm([here.fs.x, here.fs.y]) * (reach / turned + one) + i.k * reach + i.k_el * reach;
                law::equal_all_with(pairs, force + reach / turned + one)
            }),
            Law::<Self>::new(
                "in stick the shear stress changes by the stiffness times the slip, whatever the pressure does",
                |i| {
                    let i = closed(i);
                    let LinearAnswer { dslip, s11, .. } = Self::eval(&i);
                    let by = Self::jacobian(&LinearPressed { mu: (abs(trial(&i, dslip)) + 1.0) * 2.0 / s11, ..i });
                    proportional(&by.s12, &by.dslip, i.k_el)
                },
            ),
            Law::<Self>::new("in slip it changes by μ times the pressure, whatever the slip does", |i| {
                let i = closed(i);
                let LinearAnswer { dslip, s11, .. } = Self::eval(&i);
                let beyond = (i.mu * s11 + abs(i.k_el * dslip) + 1.0) * 2.0;
                let by = Self::jacobian(&LinearPressed { s12_before: beyond, ..i });
                proportional(&by.s12, &by.s11, i.mu)
            }),
            Law::<Self>::new("in stick a closed cycle brings the shear stress back", |i| {
                let i = closed(i);
                let there = Self::eval(&i);
                let stuck = LinearPressed {
                    mu: (abs(i.s12_before) + abs(trial(&i, there.dslip)) + 1.0) * 2.0 / there.s11,
                    ..i
                };
                let out = Self::eval(&stuck);
                let chord = i.x2 - i.x1;
                // Back along the segment to where it was before.
                let home = i.xs - chord * ((out.g - i.g_before) * 0.5);
                let back = Self::eval(&LinearPressed { xs: home, g_before: out.g, s12_before: out.s12, ..stuck });
                law::equal_with(back.s12, i.s12_before, abs(out.s12) + i.k_el * abs(out.dslip))
            }),
        ]
    }
}
