//! UJOINT: the elements of JOIN and UNIVERSAL, with friction moments about both axes of the cross.
//!
//! A friction moment works against a Cardan angle, so that its contribution to forces and stiffness is that of ALIGN, with the
//! opposite moments in place of the multipliers.

#[cfg(feature = "verify")]
mod proof;

use crate::connector::ujoint::{
    AllContactMoments, Constraint, ContactMomentPair, ContactMoments, CrossAxes, JointLoads, JointResiduals, Jointed,
    NormalMoments,
};
use crate::connector::universal::{Angles, Turns};
use crate::contact::coulomb::Sliding;
use crate::element::angle::{self, AlignLoads};
use crate::element::cardan::nearest;
use crate::element::cross::{self, UniversalLoads};
use crate::element::line::{self, JoinForces};
use crate::element::nodes::{by_spins, two_nodes};
use crate::element::{Contribution, Element, Nodes, Parameters};
use crate::element::{Forces, NodalForces, Rows};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA0, C0, CROSS_M1, CROSS_M3, D0, F2, F3, GAMMA0, JOIN_F1, K_STICK_R1, K_STICK_R3, LA, LAMBDA_ROT, LS, MC1_INT,
    MC3_INT, MU, RA, RP, TURN1, TURN3,
};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Vector3, Vector4};

/// UJOINT as an element, with the multipliers f1, f2, f3 of JOIN and that of UNIVERSAL.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UJointElement;

fields! {
    /// The components of x_b − x_a in a's triad, e1a·e3b, and the angles about both axes of the cross at the start.
    pub struct UJointStart<T> { d0: Vector3<T> = D0, c0: T = C0, alpha0: T = ALPHA0, gamma0: T = GAMMA0 }
}
fields! {
    /// The parameters of the friction in the hinges of the cross.
    pub struct UJointContact<T> {
        k_stick1: T = K_STICK_R1, k_stick3: T = K_STICK_R3, rp: T = RP, la: T = LA, ra: T = RA, ls: T = LS,
        mc1_int: T = MC1_INT, mc3_int: T = MC3_INT, mu: T = MU,
    }
}
fields! {
    /// The increases of α and γ since the start, followed beyond half a turn, and the friction moments: at the start all are 0.
    pub struct UJointState<T> { ur1: T = TURN1, ur3: T = TURN3, m1: T = CROSS_M1, m3: T = CROSS_M3 }
}

/// A friction moment, its derivative with respect to its own rotation, and its gradient with respect to the loads.
struct Rubbed<D> {
    moment: D,
    by_turn: D,
    by_loads: JointLoads<D>,
}

impl<D: Scalar> UJointContact<D> {
    /// The friction moments about both axes of the cross, after these rotations.
    fn rub(
        &self,
        nodes: &Nodes<D>,
        [f1, f2, f3, m2]: [D; 4],
        [ur1, ur3]: [D; 2],
        before: &UJointState<D>,
    ) -> [Rubbed<D>; 2] {
        let Nodes { e1a, e2a, e3a, e3b, .. } = *nodes;
        let Self { k_stick1, k_stick3, rp, la, ra, ls, mc1_int, mc3_int, mu } = *self;
        let loads = JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls };
        let (ContactMomentPair { mc1, mc3 }, contact) = ContactMoments::linearized(&loads);
        let (normal, by_contact) = NormalMoments::linearized(&AllContactMoments { mc1, mc3, mc1_int, mc3_int });
        let about = |du, f_before, k_stick, r#fn, by_contact, contact: JointLoads<D>| {
            let increment = Sliding { du, f_before, k_stick, mu, r#fn };
            let (moment, by_turn, [by_loads]) = increment.under([by_contact]);
            Rubbed { moment, by_turn, by_loads: contact.times(by_loads) }
        };
        [
            about(ur1 - before.ur1, before.m1, k_stick1, normal.mn1, by_contact.mn1.mc1, contact.mc1),
            about(ur3 - before.ur3, before.m3, k_stick3, normal.mn3, by_contact.mn3.mc3, contact.mc3),
        ]
    }
}

/// The increases of α and γ since the start.
pub(super) fn turned<D: Scalar>(nodes: &Nodes<D>, start: &UJointStart<D>, before: &UJointState<D>) -> [D; 2] {
    let Turns { alpha, gamma } = Angles::eval(&nodes.triads());
    [nearest(alpha - start.alpha0, before.ur1), nearest(gamma - start.gamma0, before.ur3)]
}

impl Element<4> for UJointElement {
    const SPEC: Spec = Spec::new(
        "ujoint",
        "UJOINT as an element",
        Document::UJOINT
            .ours("Description", "the page names JOIN, UNIVERSAL and friction; the element is derived from them"),
    )
    .eta_of_value(16.0)
    .normwise_of_value(8.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <JointResiduals<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[
        Field::new("f1", &JOIN_F1),
        Field::new("f2", &F2),
        Field::new("f3", &F3),
        Field::new("lambda_rot", &LAMBDA_ROT),
    ];
    type Start<T: Component> = UJointStart<T>;
    type Contact<T: Component> = UJointContact<T>;
    type State<T: Component> = UJointState<T>;

    /// Friction needs the angles of the cross.
    fn validate<D: Scalar>(nodes: &Nodes<D>, parameters: &Parameters<Self, D, 4>) -> Result<(), Error> {
        if parameters.contact.is_some() { angle::Rows::validate(&nodes.triads()) } else { Ok(()) }
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &Vector4<D>,
        parameters: &Parameters<Self, D, 4>,
        before: &UJointState<D>,
    ) -> (Contribution<D, 4>, UJointState<D>) {
        let Nodes { e1a, e2a, e3a, e3b, xa, xb, .. } = *nodes;
        let (UJointStart { d0, c0, .. }, [f1, f2, f3, lambda_rot]) = (parameters.start, *multipliers.as_ref());
        let held = Constraint::eval(&Jointed { e1a, e2a, e3a, e3b, xa, xb, d0, c0 });
        let (joined, crossed) = (nodes.join_loads([f1, f2, f3]), UniversalLoads { e1a, e3b, lambda_rot });
        let across = cross::Rows::eval(&CrossAxes { e1a, e3b });
        let mut rows = Rows::<D, 4>::zeros();
        rows.fixed_rows_mut::<3>(0).copy_from(&line::Rows::eval(&nodes.positions()).matrix());
        rows.set_row(3, &by_spins(across.g_rot_ta, across.g_rot_tb).transpose());
        let JoinForces { fa, ma, fb } = line::Forces::eval(&joined);
        let moments = cross::Moments::eval(&crossed);
        let mut stiffness = line::GeometricStiffness::eval(&joined).matrix();
        cross::GeometricStiffness::eval(&crossed).add_to(&mut stiffness);
        let mut found = Contribution::smooth(
            held.g.push(held.g_rot),
            rows,
            NodalForces { fa, ma: ma + moments.ma, fb, mb: moments.mb }.vector(),
            stiffness,
        );
        let Some(contact) = parameters.contact else { return (found, *before) };

        // The twisting moment is conjugate to the angle β, the multiplier to its sine.
        let sine = e1a.dot(&e3b);
        let cosine = ((D::one() - sine) * (D::one() + sine)).sqrt();
        let (turned, m2) = (turned(nodes, &parameters.start, before), lambda_rot * cosine);
        let rubbed = contact.rub(nodes, [f1, f2, f3, m2], turned, before);
        let [m1, m3] = [rubbed[0].moment, rubbed[1].moment];

        let triads = nodes.triads();
        let rubbing = AlignLoads::new(&triads, [-m1, D::zero(), -m3]);
        found.forces += angle::Moments::eval(&rubbing).vector();
        found.stiffness += angle::GeometricStiffness::eval(&rubbing).matrix();
        let rows_of_angles = angle::Rows::eval(&triads);
        let by_m2 = rows.row(3).transpose() * (-(lambda_rot * sine) / cosine);
        let mut follow = |row: Vector3<D>, Rubbed { by_turn, by_loads: by, .. }: &Rubbed<D>| {
            let row: Forces<D> = by_spins(-row, row);
            let by_ta = e1a.cross(&by.e1a) + e2a.cross(&by.e2a) + e3a.cross(&by.e3a);
            let by_motions = row * *by_turn + by_spins(by_ta, e3b.cross(&by.e3b)) + by_m2 * by.m2;
            found.follow_friction(&row, &by_motions, &Vector4::new(by.f1, by.f2, by.f3, by.m2 * cosine));
        };
        follow(rows_of_angles.ur1_tb, &rubbed[0]);
        follow(rows_of_angles.ur3_tb, &rubbed[1]);
        let [ur1, ur3] = turned;
        (found, UJointState { ur1, ur3, m1, m3 })
    }
}
