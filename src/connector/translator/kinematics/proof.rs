//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{AllResiduals, Constraint, Placement};
use crate::Octuple;
use crate::connector::align::Orientations;
use crate::connector::align::{self};
use crate::connector::slot::{self, CrossFrame, SlotPositions};
use crate::element::cardan::Angles;
use crate::element::cardan::turns;
use crate::element::cardan::{CardanAngles, Oriented, Triads};
use crate::formula::proof::{Case, Kink, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::norm;
use nalgebra::Vector3;
use num_traits::Zero;

impl Proved for Constraint {
    fn cases() -> Vec<Case<Placement<f64>>> {
        let [[x, y, z], _] = turns::axes([1, 2, 3]);
        let aligned = Placement {
            xb: Vector3::new(7.0, 2.0, -3.0),
            y0: 2.0,
            z0: -3.0,
            ..Placement::of(Triads::new([x, y, z], [x, y, z]))
        };
        let mut cases = vec![
            Case::hand("aligned", "on the slot and aligned: no residual", aligned),
            Case::hand(
                "offset",
                "2 - 5, -3 - 1, and minus the initial angles",
                Placement { y0: 5.0, z0: 1.0, alpha0: 0.5, beta0: -0.25, gamma0: 3.0, ..aligned },
            ),
            Case::running(
                "4 - 5, 12 - 10, and 0.6435 minus the initial angles",
                Placement {
                    xa: Vector3::new(1.0, 2.0, 3.0),
                    xb: Vector3::new(4.0, 6.0, 15.0),
                    y0: 5.0,
                    z0: 10.0,
                    alpha0: 0.6,
                    beta0: 0.7,
                    gamma0: 0.5,
                    ..Placement::of(Triads::new([x, y, z], turns::PYTHAGOREAN))
                },
            ),
        ];
        let [a, b] = turns::at_angles([0.3, 0.4, -0.7].map(Octuple::from));
        cases.extend(hard::places().into_iter().map(|place| {
            let [xa, xb] = place.value;
            let triads = Triads::new(a, b);
            Case::hard(place.id, place.comment, Placement { xa, xb, y0: 0.25, z0: -0.5, ..Placement::of(triads) })
        }));
        cases.extend(align::Constraint::cases().into_iter().map(|case| {
            let slot = SlotPositions { e2a: case.inputs.e2a, e3a: case.inputs.e3a, ..aligned.slot() };
            Case::new(case.flag, format!("align-{}", case.id), case.comment, Placement::new(&slot, &case.inputs))
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<Placement<f64>>> {
        let of_angles = CardanAngles::invalid_cases().into_iter();
        of_angles.map(|case| Case::invalid(case.id, case.comment, Placement::of(case.inputs))).collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        turns::kinks()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("assembly: residuals and Jacobian are SLOT's and ALIGN's", |i| {
                let (here, rows) = (Self::eval(i), Self::jacobian(i));
                let (slot, slot_rows) = (slot::Constraint::eval(&i.slot()), slot::Constraint::jacobian(&i.slot()));
                let (align, align_rows) =
                    (align::Constraint::eval(&i.align()), align::Constraint::jacobian(&i.align()));
                let values = [here.gy, here.gz, here.ur1, here.ur2, here.ur3];
                let parts = [slot.gy, slot.gz, align.ur1, align.ur2, align.ur3];
                let mut pairs: Vec<_> = values.into_iter().zip(parts).collect();
                for (row, part) in [(rows.gy, slot_rows.gy), (rows.gz, slot_rows.gz)] {
                    pairs.extend(row.slot().components().into_iter().zip(part.components()));
                }
                for (row, part) in [(rows.ur1, align_rows.ur1), (rows.ur2, align_rows.ur2), (rows.ur3, align_rows.ur3)]
                {
                    pairs.extend(row.align().components().into_iter().zip(part.components()));
                }
                law::equal_all(pairs)
            }),
            Law::<Self>::new("sliding along e1a is free: it changes no residual, so no multiplier does work", |i| {
                let (a, b) = i.triads().orthonormal();
                let [e1a, ..] = a;
                let rows = Self::jacobian(&i.with_triads(&Triads::new(a, b)));
                let rows = [rows.gy, rows.gz, rows.ur1, rows.ur2, rows.ur3];
                rows.iter().flat_map(|row| law::no_work(row.xb, e1a)).collect()
            }),
            Law::<Self>::new(
                "aligned, Jacobianᵀ · multipliers on b is SLOT's constraint force and ALIGN's moment",
                |i| {
                    let (a, _) = i.triads().orthonormal();
                    let [e1a, e2a, e3a] = a;
                    let multipliers = i.any_multipliers();
                    let [f2, f3, m1, m2, m3] = multipliers;
                    let [_, [force, moment]] = reactions(&i.with_triads(&Triads::new(a, a)), multipliers);
                    let f = slot::ConstraintForce::eval(&CrossFrame { e2a, e3a, f2, f3 }).f;
                    let m = align::ConstraintMoment::eval(&align::Moments { e1a, e2a, e3a, m1, m2, m3 }).m;
                    [law::equal_vectors(force, f), law::equal_vectors(moment, m)].concat()
                },
            ),
            Law::<Self>::new("aligned, the exchanged nodes are held in the same place by the same reactions", |i| {
                let (a, _) = i.triads().orthonormal();
                let [_, e2, e3] = a;
                let here = i.with_triads(&Triads::new(a, a));
                let Placement { xa, xb, y0, z0, alpha0, beta0, gamma0, .. } = here;
                let there = Placement {
                    xa: xb,
                    xb: xa,
                    y0: -y0,
                    z0: -z0,
                    alpha0: -alpha0,
                    beta0: -beta0,
                    gamma0: -gamma0,
                    ..here
                };
                let residuals = |at: &Placement<Octuple>| {
                    let AllResiduals { gy, gz, ur1, ur2, ur3 } = Self::eval(at);
                    [gy, gz, ur1, ur2, ur3]
                };
                let held = residuals(&here).into_iter().zip(residuals(&there)).map(|(g, exchanged)| (g, -exchanged));
                let mut sides = law::equal_all(held);
                let [[force_a, moment_a], [force_b, moment_b]] = reactions(&here, here.any_multipliers());
                let [m1, m2, m3] = a.map(|axis| axis.dot(&moment_a));
                let [on_b, on_a] = reactions(&there, [e2.dot(&force_a), e3.dot(&force_a), m1, m2, m3]);
                let size = law::length(xb - xa) * law::length(force_b) + law::length(moment_b);
                for (reaction, exchanged) in [(force_a, on_a[0]), (force_b, on_b[0])] {
                    sides.extend(law::equal_vectors(reaction, exchanged));
                }
                for (reaction, exchanged) in [(moment_a, on_a[1]), (moment_b, on_b[1])] {
                    sides.extend((0..3).flat_map(|k| law::equal_with(reaction[k], exchanged[k], size)));
                }
                sides
            }),
            Law::<Self>::new("in any position the reactions on a and b are in equilibrium, about xa too", |i| {
                let (a, b) = i.triads().orthonormal();
                let [[force_a, moment_a], [force_b, moment_b]] =
                    reactions(&i.with_triads(&Triads::new(a, b)), i.any_multipliers());
                let arm = i.xb - i.xa;
                let length = |v: Vector3<Octuple>| norm([v.x, v.y, v.z]);
                let size = length(arm) * length(force_b) + length(moment_b);
                let about_a = moment_a + moment_b + arm.cross(&force_b);
                let mut sides = law::equal_vectors(force_a, -force_b);
                sides.extend(about_a.iter().flat_map(|&m| law::equal_with(m, Octuple::zero(), size)));
                sides
            }),
        ]
    }
}

/// Force and moment on a and on b from Jacobianᵀ · multipliers under a virtual motion of both nodes.
fn reactions(i: &Placement<Octuple>, multipliers: [Octuple; 5]) -> [[Vector3<Octuple>; 2]; 2] {
    let AllResiduals { gy, gz, ur1, ur2, ur3 } = Constraint::jacobian(i);
    let rows = [gy, gz, ur1, ur2, ur3].into_iter().zip(multipliers);
    rows.fold([[Vector3::from_element(Octuple::zero()); 2]; 2], |[[fa, ma], [fb, mb]], (row, multiplier)| {
        let [on_a, on_b] = i.triads().moments(&row.triads());
        [[fa + row.xa * multiplier, ma + on_a * multiplier], [fb + row.xb * multiplier, mb + on_b * multiplier]]
    })
}

impl Placement<Octuple> {
    /// The same positions with other triads.
    fn with_triads(&self, triads: &Triads<Octuple>) -> Self {
        let slot = self.slot();
        Self::new(
            &slot,
            &Orientations::new(triads, &Angles { alpha: self.alpha0, beta: self.beta0, gamma: self.gamma0 }),
        )
    }

    /// Five arbitrary numbers.
    fn any_multipliers(&self) -> [Octuple; 5] {
        [self.y0, self.z0, self.alpha0, self.beta0, self.gamma0]
    }
}
