//! Evidence for the formulas of the parent module: cases, laws.

use super::{Constraint, Jointed, Stop, StopAngles};
use crate::Octuple;
use crate::connector::join::{self, Joined};
use crate::connector::ujoint::running::E3B;
use crate::connector::universal::{self, Shafts};
use crate::element::cardan::turns;
use crate::formula::Formula;
use crate::formula::proof::{Case, Law, Proved, hard, law};
use nalgebra::Vector3;
use num_traits::Zero;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Jointed<f64>>> {
        let hand = Jointed {
            e1a: Vector3::x(),
            e2a: Vector3::y(),
            e3a: Vector3::z(),
            e3b: Vector3::z(),
            xa: Vector3::new(1.0, 2.0, 3.0),
            xb: Vector3::new(4.0, 6.0, 15.0),
            d0: Vector3::new(3.0, 4.0, 12.0),
            c0: 0.0,
        };
        let mut cases = vec![
            Case::running(
                "(3, 4, 12) - (2.75, 4.25, 11.5), and the arms perpendicular",
                Jointed { e3b: E3B, d0: Vector3::new(2.75, 4.25, 11.5), ..hand },
            ),
            Case::hand("in-place", "b at (3, 4, 12) and e1a across e3b: no residual", hand),
            Case::hand(
                "off",
                "(3, 4, 12) - (1, 1, 1), 0.6 - 0.5",
                Jointed { d0: Vector3::new(1.0, 1.0, 1.0), e3b: Vector3::new(0.6, 0.0, 0.8), c0: 0.5, ..hand },
            ),
        ];
        let [e1a, e2a, e3a] = hard::triad();
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            let d0 = Vector3::new(0.25, -0.5, 0.125);
            Case::hard(place.id, place.comment, Jointed { e1a, e2a, e3a, e3b: e3a, xa, xb, d0, c0: 0.0 })
        }));
        cases.extend(turns::triads().into_iter().map(|pair| {
            let [[e1a, e2a, e3a], [.., e3b]] = pair.value;
            Case::hard(pair.id, pair.comment, Jointed { e1a, e2a, e3a, e3b, ..hand })
        }));
        cases
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("its residuals and their derivatives are JOIN's and UNIVERSAL's", |i| {
                let (out, jac) = Self::linearized(i);
                let Jointed { e1a, e2a, e3a, e3b, xa, xb, d0, c0 } = *i;
                let (joined, shafts) = (Joined { e1a, e2a, e3a, xa, xb, d0 }, Shafts { e1a, e3b, c0 });
                let (join, universal) = (join::Constraint::eval(&joined), universal::Constraint::eval(&shafts));
                let (by_join, by_universal) =
                    (join::Constraint::jacobian(&joined), universal::Constraint::jacobian(&shafts));
                let mut sides = law::equal_vectors(out.g, join.g);
                sides.extend(law::equal(out.g_rot, universal.g));
                for (row, by_join) in jac.g.iter().zip(by_join.g.iter()) {
                    sides.extend(law::equal_vectors(row.e1a, by_join.e1a));
                    sides.extend(law::equal_vectors(row.e2a, by_join.e2a));
                    sides.extend(law::equal_vectors(row.e3a, by_join.e3a));
                    sides.extend(law::equal_vectors(row.xa, by_join.xa));
                    sides.extend(law::equal_vectors(row.xb, by_join.xb));
                    sides.extend(law::equal_vectors(row.d0, by_join.d0));
                }
                sides.extend(law::equal_vectors(jac.g_rot.e1a, by_universal.g.e1a));
                sides.extend(law::equal_vectors(jac.g_rot.e3b, by_universal.g.e3b));
                sides
            }),
            Law::<Self>::new(
                "exchanging the nodes and the arms of the cross changes neither the distance nor the angle that is held",
                |i| {
                    let ([e1a, e2a, e3a], zero) = (law::orthonormal([i.e1a, i.e2a, i.e3a]), Octuple::zero());
                    // The other axes of b are arbitrary.
                    let [e3b, p, q] = law::orthonormal([i.e3b, i.e2a, i.e1a]);
                    let here = Jointed { e1a, e2a, e3a, e3b, d0: Vector3::from_element(zero), ..*i };
                    let there = Jointed { e1a: e3b, e2a: p, e3a: q, e3b: e1a, xa: i.xb, xb: i.xa, ..here };
                    let (held, exchanged) = (Self::eval(&here), Self::eval(&there));
                    let mut sides = law::equal(law::length(held.g), law::length(exchanged.g));
                    sides.extend(law::equal_with(held.g_rot, exchanged.g_rot, Octuple::from(1.0)));
                    sides
                },
            ),
            Law::<Self>::new(
                "under any translation and spin of both nodes, Jacobianᵀ · (f1, f2, f3, m2) is the force F on b, -F on a with the moment -d × F, and the moment m2 e3b × e1a between them",
                |i| {
                    let jac = Self::jacobian(i);
                    let (f, m2) = (i.d0, i.c0); // arbitrary numbers
                    let force = i.e1a * f.x + i.e2a * f.y + i.e3a * f.z;
                    let moment = i.e3b.cross(&i.e1a) * m2;
                    // A spin changes a vector by δe = ω × e, so that e × ∂g/∂e is the moment.
                    let on_a =
                        |row: &Jointed<Octuple>| i.e1a.cross(&row.e1a) + i.e2a.cross(&row.e2a) + i.e3a.cross(&row.e3a);
                    let moment_on_a = on_a(&jac.g.x) * f.x + on_a(&jac.g.y) * f.y + on_a(&jac.g.z) * f.z;
                    let on_b = jac.g.x.xb * f.x + jac.g.y.xb * f.y + jac.g.z.xb * f.z;
                    let on_a_force = jac.g.x.xa * f.x + jac.g.y.xa * f.y + jac.g.z.xa * f.z;
                    let d = i.xb - i.xa;
                    [
                        law::equal_vectors(on_b, force),
                        law::equal_vectors(on_a_force, -force),
                        law::equal_vectors(moment_on_a, -d.cross(&force)),
                        law::equal_vectors(i.e3b.cross(&jac.g_rot.e3b) * m2, moment),
                        law::equal_vectors(on_a(&jac.g_rot) * m2, -moment),
                    ]
                    .concat()
                },
            ),
        ]
    }
}

impl Proved for Stop {
    fn cases() -> Vec<Case<StopAngles<f64>>> {
        let hand = StopAngles {
            alpha: 0.25,
            gamma: -0.5,
            theta1_min: -1.0,
            theta1_max: 0.75,
            theta3_min: -1.5,
            theta3_max: 1.5,
        };
        vec![
            Case::running(
                "sin α = 0.6: 1.6435, 0.3565, 2, 1",
                StopAngles { alpha: 0.6435, gamma: 0.5, theta1_max: 1.0, ..hand },
            ),
            Case::hand("between", "1.25, 0.5, 1, 2", hand),
            Case::limit(
                "at-the-stops",
                "α at its upper, γ at its lower stop",
                StopAngles { alpha: 0.75, gamma: -1.5, ..hand },
            ),
            Case::hand("beyond", "negative gaps", StopAngles { alpha: 1.0, gamma: -2.0, ..hand }),
            Case::hand("locked", "both stops at one angle", StopAngles { theta1_min: 0.75, theta3_min: 1.5, ..hand }),
            Case::hard(
                "ulp",
                "one ulp from the stops",
                StopAngles { alpha: 0.75_f64.next_down(), gamma: -1.5_f64.next_down(), ..hand },
            ),
            Case::hard(
                "tiny",
                "angles of 1e-200",
                StopAngles { alpha: 1e-200, gamma: -3e-200, theta1_min: 0.0, ..hand },
            ),
        ]
    }

    fn invalid_cases() -> Vec<Case<StopAngles<f64>>> {
        let hand =
            StopAngles { alpha: 0.0, gamma: 0.0, theta1_min: -1.0, theta1_max: 1.0, theta3_min: -1.0, theta3_max: 1.0 };
        vec![
            Case::invalid(
                "crossed-stops-1",
                "the lower stop of α is above the upper",
                StopAngles { theta1_min: 2.0, ..hand },
            ),
            Case::invalid(
                "crossed-stops-3",
                "the lower stop of γ is above the upper",
                StopAngles { theta3_max: -2.0, ..hand },
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("the gaps of an angle add up to the angle between its stops", |i| {
            let gaps = Self::eval(i);
            [
                law::equal_with(gaps.gap1_min + gaps.gap1_max, i.theta1_max - i.theta1_min, i.alpha),
                law::equal_with(gaps.gap3_min + gaps.gap3_max, i.theta3_max - i.theta3_min, i.gamma),
            ]
            .concat()
        })]
    }
}
