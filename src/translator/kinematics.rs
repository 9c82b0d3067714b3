//! The five residuals: SLOT's two and ALIGN's three.

use crate::Octuple;
use crate::align::{self, Misalignment, Orientations};
use crate::cardan::{self, Angles, CardanAngles, Oriented, Triads};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{ALPHA0, BETA0, E1A, E1B, E2A, E2B, E3A, E3B, GAMMA0, GY, GZ, UR1, UR2, UR3, XA, XB, Y0, Z0};
use crate::scalar::{Scalar, norm};
use crate::slot::{self, CrossFrame, Residuals, SlotPositions};
use crate::verify::{hard, law};
use nalgebra::Vector3;
use num_traits::Zero;

fields! {
    /// Where both nodes are, how they are turned, and the initial position and angles.
    pub struct Placement<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
        y0: T = Y0, z0: T = Z0, alpha0: T = ALPHA0, beta0: T = BETA0, gamma0: T = GAMMA0,
    }
}
fields! {
    /// By how much b is off the slot and out of alignment.
    pub struct AllResiduals<T> { gy: T = GY, gz: T = GZ, ur1: T = UR1, ur2: T = UR2, ur3: T = UR3 }
}

impl<T: Element> Placement<T> {
    /// From what SLOT and ALIGN see of it.
    pub const fn new(slot: &SlotPositions<T>, align: &Orientations<T>) -> Self {
        let SlotPositions { xa, xb, y0, z0, .. } = *slot;
        let Orientations { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 } = *align;
        Self { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb, y0, z0, alpha0, beta0, gamma0 }
    }

    /// What SLOT sees of it.
    pub const fn slot(&self) -> SlotPositions<T> {
        let Self { e2a, e3a, xa, xb, y0, z0, .. } = *self;
        SlotPositions { e2a, e3a, xa, xb, y0, z0 }
    }

    /// What ALIGN sees of it.
    pub const fn align(&self) -> Orientations<T> {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0, .. } = *self;
        Orientations { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 }
    }
}

impl<D: Scalar> Oriented<D> for Placement<D> {
    fn triads(&self) -> Triads<D> {
        self.align().triads()
    }
    fn of(triads: Triads<D>) -> Self {
        Self::new(&SlotPositions::filled(D::zero()), &Orientations::of(triads))
    }
}

/// The five conditions of a TRANSLATOR: those of SLOT and those of ALIGN.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "translator.constraint",
        title: "Constraint",
        latex: r"\begin{aligned} g_y &= \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - y_0, & g_z &= \mathbf{e}_{3a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - z_0,\\ u_{r1} &= \alpha - \alpha_0, & u_{r2} &= \beta - \beta_0,\quad u_{r3} = \gamma - \gamma_0 \end{aligned}",
        source: Source::TRANSLATOR.section("Description"),
        eta: 2.5,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Placement<T>;
    type Outputs<T: Element> = AllResiduals<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Placement<D>) -> AllResiduals<D> {
        let Residuals { gy, gz } = slot::Constraint::eval(&i.slot());
        let Misalignment { ur1, ur2, ur3 } = align::Constraint::eval(&i.align());
        AllResiduals { gy, gz, ur1, ur2, ur3 }
    }

    fn jacobian<D: Scalar>(i: &Placement<D>) -> Jacobian<Self, D> {
        let Residuals { gy, gz } = slot::Constraint::jacobian(&i.slot());
        let Misalignment { ur1, ur2, ur3 } = align::Constraint::jacobian(&i.align());
        let zero = D::zero();
        let of_slot = |g: SlotPositions<D>| {
            let SlotPositions { e2a, e3a, xa, xb, y0, z0 } = g;
            Placement { e2a, e3a, xa, xb, y0, z0, ..Placement::filled(zero) }
        };
        let of_align = |g| Placement::new(&SlotPositions::filled(zero), &g);
        AllResiduals { gy: of_slot(gy), gz: of_slot(gz), ur1: of_align(ur1), ur2: of_align(ur2), ur3: of_align(ur3) }
    }

    #[inline]
    fn validate(i: &Placement<f64>) -> Result<(), Error> {
        align::Constraint::validate(&i.align())
    }

    fn cases() -> Vec<Case<Placement<f64>>> {
        let [[x, y, z], _] = hard::axes([1, 2, 3]);
        let aligned = Placement {
            xb: Vector3::new(7.0, 2.0, -3.0),
            y0: 2.0,
            z0: -3.0,
            ..Placement::of(Triads::new([x, y, z], [x, y, z]))
        };
        let mut cases = vec![
            Case::limit("aligned", "on the slot and aligned: no residual", aligned),
            Case::hand(
                "offset",
                "2 - 5, -3 - 1, and minus the initial angles",
                Placement { y0: 5.0, z0: 1.0, alpha0: 0.5, beta0: -0.25, gamma0: 3.0, ..aligned },
            ),
        ];
        let [a, b] = hard::at_angles([0.3, 0.4, -0.7].map(Octuple::from));
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
        cardan::kinks()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "assembly: residuals and Jacobian are SLOT's and ALIGN's",
                sides: |i| {
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
                    for (row, part) in
                        [(rows.ur1, align_rows.ur1), (rows.ur2, align_rows.ur2), (rows.ur3, align_rows.ur3)]
                    {
                        pairs.extend(row.align().components().into_iter().zip(part.components()));
                    }
                    law::equal_all(pairs)
                },
            },
            Law {
                statement: "sliding along e1a is free: it changes no residual, so no multiplier does work on it",
                sides: |i| {
                    let (a, b) = i.triads().orthonormal();
                    let [e1a, ..] = a;
                    let rows = Self::jacobian(&i.with_triads(&Triads::new(a, b)));
                    let rows = [rows.gy, rows.gz, rows.ur1, rows.ur2, rows.ur3];
                    rows.iter().flat_map(|row| law::no_work(row.xb, e1a)).collect()
                },
            },
            Law {
                statement: "aligned, Jacobianᵀ · multipliers on b is SLOT's constraint force and ALIGN's moment",
                sides: |i| {
                    let (a, _) = i.triads().orthonormal();
                    let [e1a, e2a, e3a] = a;
                    let multipliers = i.any_multipliers();
                    let [f2, f3, m1, m2, m3] = multipliers;
                    let [_, [force, moment]] = reactions(&i.with_triads(&Triads::new(a, a)), multipliers);
                    let f = slot::ConstraintForce::eval(&CrossFrame { e2a, e3a, f2, f3 }).f;
                    let m = align::ConstraintMoment::eval(&align::Moments { e1a, e2a, e3a, m1, m2, m3 }).m;
                    [law::equal_vectors(force, f), law::equal_vectors(moment, m)].concat()
                },
            },
            Law {
                statement: "in any position the reactions on a and b are in equilibrium, about xa too",
                sides: |i| {
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
                },
            },
        ]
    }
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

    /// Any five numbers will do.
    fn any_multipliers(&self) -> [Octuple; 5] {
        [self.y0, self.z0, self.alpha0, self.beta0, self.gamma0]
    }
}

/// Force and moment on a and on b that Jacobianᵀ · multipliers gives under a virtual motion of both nodes.
fn reactions(i: &Placement<Octuple>, multipliers: [Octuple; 5]) -> [[Vector3<Octuple>; 2]; 2] {
    let AllResiduals { gy, gz, ur1, ur2, ur3 } = Constraint::jacobian(i);
    let rows = [gy, gz, ur1, ur2, ur3].into_iter().zip(multipliers);
    rows.fold([[Vector3::from_element(Octuple::zero()); 2]; 2], |[[fa, ma], [fb, mb]], (row, multiplier)| {
        let [on_a, on_b] = i.triads().moments(&row.triads());
        [[fa + row.xa * multiplier, ma + on_a * multiplier], [fb + row.xb * multiplier, mb + on_b * multiplier]]
    })
}
