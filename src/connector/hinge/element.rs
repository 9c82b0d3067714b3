//! HINGE: the element of JOIN and REVOLUTE, with a friction moment about the pin.
//!
//! REVOLUTE's residuals are two of UNIVERSAL's kind, e1a·e2b and e1a·e3b. Their multipliers λ2 and λ3 act on b with the moment
//! λ2 e2b × e1a + λ3 e3b × e1a, whose components along e2a and e3a are the documented m2 and m3: as b rotates by α, (m2, m3) is
//! (λ3, −λ2) rotated by α.

use super::{Constraint, DOCUMENT, Friction, HingeLoads, HingeResiduals, Hinged, LS, MC_INT, RA, RP};
use crate::connector::revolute::{C2, C3};
use crate::contact::coulomb::Sliding;
use crate::element::angle::{self, AlignLoads};
use crate::element::cardan::{alpha, nearest};
use crate::element::cross::{self, CrossAxes, UniversalLoads};
use crate::element::nodes::{by_spins, two_nodes};
use crate::element::{Contribution, Element, Nodes, Parameters, Rows, line};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA0, CROSS_M1, D0, Domain, F2, F3, JOIN_F1, K_STICK_R1, MU, Quantity, Shape, TURN1, Unit,
};
use crate::formula::{Component, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{SVector, Vector3};

/// HINGE as an element: multipliers f1, f2, f3 of JOIN, and those of REVOLUTE.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HingeElement;

/// Multiplier of e1a·e2b.
const LAMBDA_2: Quantity =
    multiplier(r"\lambda_2", "multiplier of REVOLUTE's residual e1a·e2b: its moment on b is λ2 e2b × e1a");
/// Multiplier of e1a·e3b.
const LAMBDA_3: Quantity =
    multiplier(r"\lambda_3", "multiplier of REVOLUTE's residual e1a·e3b: its moment on b is λ3 e3b × e1a");

const fn multiplier(latex: &'static str, meaning: &'static str) -> Quantity {
    Quantity::new(latex, Shape::Scalar, Unit::FL, Domain::Real, meaning)
}

fields! {
    /// The components of x_b − x_a in a's triad, e1a·e2b, e1a·e3b, and the angle about the pin at the start.
    pub struct HingeStart<T> { d0: Vector3<T> = D0, c2: T = C2, c3: T = C3, alpha0: T = ALPHA0 }
}
fields! {
    /// The friction of the pin.
    pub struct HingeContact<T> { k_stick: T = K_STICK_R1, rp: T = RP, ra: T = RA, ls: T = LS, mc_int: T = MC_INT, mu: T = MU }
}
fields! {
    /// The rotation since the start, followed beyond half a turn, and the friction moment: both are 0 at the start.
    pub struct HingeState<T> { ur1: T = TURN1, m1: T = CROSS_M1 }
}

impl<D: Scalar> HingeContact<D> {
    /// The friction moment after a rotation, with its derivatives with respect to the rotation and to f1, f2, f3, m2 and m3.
    fn rub(&self, ur1: D, before: &HingeState<D>, [f1, f2, f3, m2, m3]: [D; 5]) -> (D, D, [D; 5]) {
        let Self { k_stick, rp, ra, ls, mc_int, mu } = *self;
        let loads = HingeLoads { m1: D::zero(), f1, f2, f3, m2, m3, rp, ra, ls, mc_int, mu };
        let (friction, by_loads) = Friction::linearized(&loads);
        let increment = Sliding { du: ur1 - before.ur1, f_before: before.m1, k_stick, mu, r#fn: friction.mn };
        let HingeLoads { f1, f2, f3, m2, m3, .. } = by_loads.mn;
        increment.under([f1, f2, f3, m2, m3])
    }
}

/// The rotation since the start.
pub(super) fn turned<D: Scalar>(nodes: &Nodes<D>, start: &HingeStart<D>, before: &HingeState<D>) -> D {
    nearest(alpha(&nodes.e2a, &nodes.e3a, &nodes.e3b) - start.alpha0, before.ur1)
}

impl Element<5> for HingeElement {
    const SPEC: Spec = Spec::new(
        "hinge",
        "HINGE as an element",
        DOCUMENT.ours("Description", "the page names JOIN, REVOLUTE and friction; the element is derived from them"),
    )
    .eta_of_value(16.0)
    .normwise_of_value(8.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <HingeResiduals<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[
        Field::new("f1", &JOIN_F1),
        Field::new("f2", &F2),
        Field::new("f3", &F3),
        Field::new("lambda2", &LAMBDA_2),
        Field::new("lambda3", &LAMBDA_3),
    ];
    type Start<T: Component> = HingeStart<T>;
    type Contact<T: Component> = HingeContact<T>;
    type State<T: Component> = HingeState<T>;

    /// Friction needs the angle about the pin.
    fn validate<D: Scalar>(nodes: &Nodes<D>, parameters: &Parameters<Self, D, 5>) -> Result<(), Error> {
        if parameters.contact.is_some() { angle::Rows::validate(&nodes.triads()) } else { Ok(()) }
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &SVector<D, 5>,
        parameters: &Parameters<Self, D, 5>,
        before: &HingeState<D>,
    ) -> (Contribution<D, 5>, HingeState<D>) {
        let Nodes { e1a, e2a, e3a, e2b, e3b, xa, xb, .. } = *nodes;
        let (HingeStart { d0, c2, c3, .. }, [f1, f2, f3, lambda2, lambda3]) = (parameters.start, multipliers.data.0[0]);
        let HingeResiduals { g, g2, g3 } = Constraint::eval(&Hinged { e1a, e2a, e3a, e2b, e3b, xa, xb, d0, c2, c3 });
        let tilts = [(e2b, lambda2), (e3b, lambda3)];
        let crossed = tilts.map(|(e3b, _)| cross::Rows::eval(&CrossAxes { e1a, e3b }));
        let loads = tilts.map(|(e3b, lambda_rot)| UniversalLoads { e1a, e3b, lambda_rot });
        let (moments, bent) =
            (loads.map(|i| cross::Moments::eval(&i)), loads.map(|i| cross::GeometricStiffness::eval(&i)));
        let joined = nodes.join_loads([f1, f2, f3]);
        let mut rows = Rows::<D, 5>::zeros();
        rows.fixed_rows_mut::<3>(0).copy_from(&line::Rows::eval(&nodes.positions()).matrix());
        for (k, row) in crossed.iter().enumerate() {
            rows.set_row(3 + k, &by_spins(row.g_rot_ta, row.g_rot_tb).transpose());
        }
        let mut stiffness = line::GeometricStiffness::eval(&joined).matrix();
        for of in &bent {
            of.add_to(&mut stiffness);
        }
        let (ma, mb) = (moments[0].ma + moments[1].ma, moments[0].mb + moments[1].mb);
        let mut found = Contribution::smooth(
            SVector::from([g.x, g.y, g.z, g2, g3]),
            rows,
            line::Forces::eval(&joined).vector() + by_spins(ma, mb),
            stiffness,
        );
        let Some(contact) = parameters.contact else { return (found, *before) };

        let ur1 = turned(nodes, &parameters.start, before);
        let pressing = [f1, f2, f3, e2a.dot(&mb), e3a.dot(&mb)];
        let (m1, by_turn, [by_f1, by_f2, by_f3, by_m2, by_m3]) = contact.rub(ur1, before, pressing);
        let triads = nodes.triads();
        // The friction moment works against α: its part is ALIGN's, with the opposite moment in place of a multiplier.
        let rubbing = AlignLoads::new(&triads, [-m1, D::zero(), D::zero()]);
        found.forces += angle::Moments::eval(&rubbing).vector();
        found.stiffness += angle::GeometricStiffness::eval(&rubbing).matrix();
        // m2 and m3 change with the moment on b, and with the axes as a rotates.
        let along: Vector3<D> = e2a * by_m2 + e3a * by_m3;
        let by_ta = along.cross(&mb) + bent[0].k_ta_tb * along + bent[1].k_ta_tb * along;
        let by_tb = bent[0].k_tb_tb.transpose() * along + bent[1].k_tb_tb.transpose() * along;
        let turn = angle::Rows::eval(&triads).ur1_tb;
        let row = by_spins(-turn, turn);
        let [by_lambda2, by_lambda3] = crossed.map(|row| along.dot(&row.g_rot_tb));
        found.follow_friction(
            &row,
            &(row * by_turn + by_spins(by_ta, by_tb)),
            &SVector::from([by_f1, by_f2, by_f3, by_lambda2, by_lambda3]),
        );
        (found, HingeState { ur1, m1 })
    }
}
