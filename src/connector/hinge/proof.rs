//! Evidence for the formulas and the element next door: cases, kinks, laws.

use super::element::turned;
use super::{
    Constraint, ContactMoment, Friction, HingeContact, HingeElement, HingeLoads, HingeStart, HingeState, Hinged,
    PinLoads, Stop, StopAngle,
};
use crate::Octuple;
use crate::connector::join::{self, Joined};
use crate::connector::revolute::{self, Axes};
use crate::element::cardan::turns;
use crate::element::cross::{self, UniversalLoads};
use crate::element::nodes::proof::poses;
use crate::element::{Nodes, Parameters};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, ProvedElement, Rubbed, Step, hard, law};
use crate::number::scalar::Scalar;
use nalgebra::{SVector, Vector3};
use num_traits::Zero;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Hinged<f64>>> {
        let hand = Hinged {
            e1a: Vector3::x(),
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            e2b: Vector3::y(),
            e3b: Vector3::z(),
            xa: Vector3::new(1.0, 2.0, 3.0),
            xb: Vector3::new(4.0, 6.0, 15.0),
            d0: Vector3::new(3.0, 4.0, 12.0),
            c2: 0.0,
            c3: 0.0,
        };
        let tilted = Hinged { e2b: Vector3::new(-0.6, 0.8, 0.0), d0: Vector3::new(1.0, 1.0, 1.0), c2: 0.5, ..hand };
        let mut cases = vec![
            Case::hand("in-place", "b at (3, 4, 12) and the axes together: no residual", hand),
            Case::hand("off", "(3, 4, 12) - (1, 1, 1), -0.6 - 0.5, 0", tilted),
            {
                let [_, e2b, e3b] = turns::PYTHAGOREAN;
                let d0 = Vector3::new(2.75, 4.25, 11.5);
                Case::running(
                    "(3, 4, 12) - (2.75, 4.25, 11.5), -0.48 + 0.5, 0.6 - 0.55",
                    Hinged { e2b, e3b, d0, c2: -0.5, c3: 0.55, ..hand },
                )
            },
        ];
        let [e1a, e2a, e3a] = hard::triad();
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            let d0 = Vector3::new(0.25, -0.5, 0.125);
            let inputs = Hinged { e1a, e2a, e3a, e2b: e2a, e3b: e3a, xa, xb, d0, c2: 0.0, c3: 0.0 };
            Case::hard(place.id, place.comment, inputs)
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("its residuals are those of JOIN, then those of REVOLUTE", |i| {
            let Hinged { e1a, e2a, e3a, e2b, e3b, xa, xb, d0, c2, c3 } = *i;
            let (found, join) = (Self::eval(i), join::Constraint::eval(&Joined { e1a, e2a, e3a, xa, xb, d0 }));
            let revolute = revolute::Constraint::eval(&Axes { e1a, e2b, e3b, c2, c3 });
            [law::equal_vectors(found.g, join.g), law::equal_all([(found.g2, revolute.g2), (found.g3, revolute.g3)])]
                .concat()
        })]
    }
}

impl Proved for Stop {
    fn cases() -> Vec<Case<StopAngle<f64>>> {
        let hand = StopAngle { alpha: 0.5, theta1_min: -1.0, theta1_max: 2.0 };
        vec![
            Case::hand("between", "1.5 to both stops", hand),
            Case::hand("beyond", "past the upper stop: the gap is negative", StopAngle { alpha: 2.5, ..hand }),
            Case::hand("locked", "both stops at one angle", StopAngle { alpha: 2.0, theta1_min: 2.0, ..hand }),
            Case::hard("after-turns", "a hundred radians on", StopAngle { alpha: 100.0, theta1_max: 100.5, ..hand }),
            Case::running("1.6435 and 0.3565", StopAngle { alpha: 0.6435, theta1_max: 1.0, ..hand }),
        ]
    }

    fn invalid_cases() -> Vec<Case<StopAngle<f64>>> {
        let crossed = StopAngle { alpha: 0.0, theta1_min: 1.0, theta1_max: -1.0 };
        vec![Case::invalid("crossed", "the lower stop above the upper one", crossed)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("both gaps add up to the range between the stops", |i| {
            let gaps = Self::eval(i);
            law::equal_with(gaps.gap_min + gaps.gap_max, i.theta1_max - i.theta1_min, i.alpha)
        })]
    }
}

/// 2 + 5 × 0.5 + 2 × 0.5/4 × 13: 2, 2.5 and 3.25.
const HAND: PinLoads<f64> = PinLoads { f1: -4.0, f2: 3.0, f3: 4.0, m2: 5.0, m3: -12.0, rp: 0.5, ra: 0.5, ls: 4.0 };

impl Proved for ContactMoment {
    fn cases() -> Vec<Case<PinLoads<f64>>> {
        let mut cases = vec![
            Case::running("2 + 2.5 + 3.25", HAND),
            Case::limit("no-arm", "R_a = 0 omits the force along the pin: 2.5 + 3.25", PinLoads { ra: 0.0, ..HAND }),
            Case::limit("no-overlap", "L_s = 0 omits bending: 2 + 2.5", PinLoads { ls: 0.0, ..HAND }),
            Case::hard("no-axial-force", "f1 = 0: derivative 0 by convention", PinLoads { f1: 0.0, ..HAND }),
            Case::hard(
                "no-radial-force",
                "f2 = f3 = 0: derivative 0 by convention",
                PinLoads { f2: 0.0, f3: 0.0, ..HAND },
            ),
            Case::hard("no-bending", "m2 = m3 = 0: derivative 0 by convention", PinLoads { m2: 0.0, m3: 0.0, ..HAND }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f2, f3] = load.value;
            Case::hard(
                format!("force-{}", load.id),
                "a force of extreme size alone",
                PinLoads { f1: 0.0, f2, f3, m2: 0.0, m3: 0.0, ..HAND },
            )
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink::<Self>::switched_off(HAND, |i| [i.ls]),
            Kink::<Self>::of_abs(HAND, |i| [i.f1]),
            Kink::<Self>::of_norm(HAND, |i| [i.f2, i.f3]),
            Kink::<Self>::of_norm(HAND, |i| [i.m2, i.m3]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is of degree 1 in the loads: the loads times their derivatives add up to it", |i| {
                let by = Self::jacobian(i).mc;
                let loads = [(i.f1, by.f1), (i.f2, by.f2), (i.f3, by.f3), (i.m2, by.m2), (i.m3, by.m3)];
                let sum = loads.iter().fold(Octuple::zero(), |sum, &(load, slope)| sum + load * slope);
                law::equal(sum, Self::eval(i).mc)
            }),
            Law::<Self>::new(
                "a couple of forces at both ends of the sleeve has the contact moment of its two forces",
                |i| {
                    let none = Octuple::zero();
                    let bending = Self::eval(&PinLoads { f1: none, f2: none, f3: none, m3: none, ..*i }).mc;
                    let of_force =
                        Self::eval(&PinLoads { f1: none, f2: i.m2 / i.ls, f3: none, m2: none, m3: none, ..*i }).mc;
                    law::equal(bending, of_force * 2.0)
                },
            ),
        ]
    }
}

impl Proved for Friction {
    fn cases() -> Vec<Case<HingeLoads<f64>>> {
        let PinLoads { f1, f2, f3, m2, m3, rp, ra, ls } = HAND;
        let hand = HingeLoads { m1: -1.5, f1, f2, f3, m2, m3, rp, ra, ls, mc_int: -0.25, mu: 0.25 };
        vec![
            Case::running("M_N = 7.75 + 0.25, Φ = 1.5 - 2: sticks", hand),
            Case::hand("slip", "P = 2 = μ M_N: Φ = 0", HingeLoads { m1: 2.0, ..hand }),
            Case::hand("frictionless", "μ = 0: Φ = P", HingeLoads { mu: 0.0, ..hand }),
            Case::hand("press-fit", "the press fit alone: M_N = 0.25", {
                HingeLoads { f1: 0.0, f2: 0.0, f3: 0.0, m2: 0.0, m3: 0.0, ..hand }
            }),
            Case::limit("no-overlap", "without bending: M_N = 4.75", HingeLoads { ls: 0.0, ..hand }),
            Case::hard("no-friction-moment", "m1 = 0: derivative 0 by convention", HingeLoads { m1: 0.0, ..hand }),
            Case::hard("no-press-fit", "derivative 0 by convention", HingeLoads { mc_int: 0.0, ..hand }),
            Case::hard("tiny", "loads of 1e-70", HingeLoads { f2: 3e-70, f3: 4e-70, m2: 1e-70, ..hand }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let hand = Self::cases()[0].inputs;
        vec![
            Kink::<Self>::switched_off(hand, |i| [i.ls]),
            Kink::<Self>::of_abs(hand, |i| [i.m1]),
            Kink::<Self>::of_abs(hand, |i| [i.f1]),
            Kink::<Self>::of_abs(hand, |i| [i.mc_int]),
            Kink::<Self>::of_norm(hand, |i| [i.f2, i.f3]),
            Kink::<Self>::of_norm(hand, |i| [i.m2, i.m3]),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("at the friction moment μ M_N it slips: Φ = 0", |i| {
            let limit = i.mu * Self::eval(i).mn;
            law::equal_with(Self::eval(&HingeLoads { m1: limit, ..*i }).phi, Octuple::zero(), limit)
        })]
    }
}

impl ProvedElement<5> for HingeElement {
    fn cases() -> Vec<Case<Step<Self, f64, 5>>> {
        let multipliers = SVector::from([3.0, -4.0, 12.0, 5.0, -2.0]);
        let before = HingeState { ur1: 6.0, m1: 0.5 };
        let start = HingeStart { d0: Vector3::new(0.5, 0.25, 0.125), c2: 0.0, c3: 0.0, alpha0: 0.125 };
        let contact = HingeContact { k_stick: 1e3, rp: 0.5, ra: 0.25, ls: 2.0, mc_int: -1.0, mu: 0.25 };
        let ways = [
            ("", None),
            ("-soft", Some(HingeContact { k_stick: 0.125, ..contact })),
            ("-stiff", Some(contact)),
            ("-without-axial", Some(HingeContact { ra: 0.0, ls: 0.0, ..contact })),
        ];
        let step = |nodes, contact| Step { nodes, multipliers, parameters: Parameters { start, contact }, before };
        let all = poses().into_iter().flat_map(|pose| {
            ways.map(|(how, contact)| Case::hard(format!("{}{how}", pose.id), pose.comment, step(pose.value, contact)))
        });
        all.collect()
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, 5>, after: &HingeState<D>) -> Vec<Rubbed<D>> {
        let Parameters { start, contact } = step.parameters;
        let Some(HingeContact { k_stick, rp, ra, ls, mc_int, mu }) = contact else { return Vec::new() };
        let (Nodes { e1a, e2a, e3a, e2b, e3b, .. }, [f1, f2, f3, lambda2, lambda3]) =
            (step.nodes, step.multipliers.data.0[0]);
        let moment = |e3b, lambda_rot| cross::Moments::eval(&UniversalLoads { e1a, e3b, lambda_rot }).mb;
        let on_b = moment(e2b, lambda2) + moment(e3b, lambda3);
        let (m1, m2, m3) = (after.m1, e2a.dot(&on_b), e3a.dot(&on_b));
        let phi = Friction::eval(&HingeLoads { m1, f1, f2, f3, m2, m3, rp, ra, ls, mc_int, mu }).phi;
        let motion = turned(&step.nodes, &start, &step.before) - step.before.ur1;
        vec![Rubbed { motion, force: [step.before.m1, m1], k_stick, phi }]
    }
}
