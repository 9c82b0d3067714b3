//! UJOINT: the element of JOIN and UNIVERSAL, with friction moments about both axes of the cross.
//!
//! A friction moment works against a Cardan angle, so that its part in forces and stiffness is ALIGN's, with the opposite
//! moments in place of the multipliers.

use super::{Contribution, Element, Nodes, by_spins};
use crate::connector::cardan::nearest;
use crate::connector::ujoint::{Constraint, Cross, Jointed};
use crate::connector::universal::{Angles, Turns};
use crate::element::Forces;
use crate::element::align::{self, AlignLoads};
use crate::element::ujoint::{self, JointLoads, JointPlaces};
use crate::element::ujoint_friction::{CrossSlid, CrossSliding, Response};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::{Vector3, Vector4};

/// UJOINT as an element: multipliers f1, f2, f3 of JOIN and that of UNIVERSAL.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UJointElement {
    /// The components of x_b − x_a in a's triad at the start.
    pub d0: Vector3<f64>,
    /// e1a·e3b at the start.
    pub c0: f64,
    /// The angles α0 and γ0 at the start.
    pub angles0: [f64; 2],
    /// How the hinges of the cross rub, if they do.
    pub contact: Option<CrossContact>,
}

/// How the hinges of the cross rub.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossContact {
    /// The cross.
    pub cross: Cross,
    /// Moment per radian about e1a while it sticks, > 0.
    pub k_el1: f64,
    /// Moment per radian about e3b while it sticks, > 0.
    pub k_el3: f64,
}

/// The turns of the last increment, and those at which the friction moments would be 0. At the start all are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UJointState<D> {
    /// By how much α and γ have grown since the start, followed beyond half a turn.
    pub turns: [D; 2],
    /// What has slipped of each.
    pub slip: [D; 2],
}

impl CrossContact {
    fn sliding<D: Scalar>(&self, nodes: &Nodes<D>, [f1, f2, f3, m2]: [D; 4]) -> CrossSliding<D> {
        let ([e1a, e2a, e3a], [.., e3b], zero) = (nodes.a, nodes.b, D::zero());
        let Cross { rp, la, ra, ls, mu, mc1_int, mc3_int } = self.cross;
        let [rp, la, ra, ls, mu, mc1_int, mc3_int] = [rp, la, ra, ls, mu, mc1_int, mc3_int].map(D::from);
        let [k_el1, k_el3] = [self.k_el1, self.k_el3].map(D::from);
        let [ur1, ur3, slip1_before, slip3_before] = [zero; 4];
        CrossSliding {
            ur1,
            ur3,
            slip1_before,
            slip3_before,
            k_el1,
            k_el3,
            e1a,
            e2a,
            e3a,
            e3b,
            f1,
            f2,
            f3,
            m2,
            rp,
            la,
            ra,
            ls,
            mc1_int,
            mc3_int,
            mu,
        }
    }
}

impl UJointElement {
    fn jointed<D: Scalar>(&self, nodes: &Nodes<D>) -> Jointed<D> {
        let ([e1a, e2a, e3a], [.., e3b], xa, xb) = (nodes.a, nodes.b, nodes.xa, nodes.xb);
        Jointed { e1a, e2a, e3a, e3b, xa, xb, d0: self.d0.map(D::from), c0: self.c0.into() }
    }
}

fn loads<D: Scalar>(nodes: &Nodes<D>, multipliers: &Vector4<D>) -> JointLoads<D> {
    let ([e1a, e2a, e3a], [.., e3b], xa, xb) = (nodes.a, nodes.b, nodes.xa, nodes.xb);
    let [f1, f2, f3, lambda_rot] = *multipliers.as_ref();
    JointLoads { e1a, e2a, e3a, e3b, xa, xb, f1, f2, f3, lambda_rot }
}

impl Element<4> for UJointElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = UJointState<D>;

    fn check(&self, nodes: &Nodes<f64>, multipliers: &Vector4<f64>, before: &UJointState<f64>) -> Result<(), Error> {
        check::<Constraint>(&self.jointed(nodes))?;
        check::<ujoint::Forces>(&loads(nodes, multipliers))?;
        let Some(contact) = self.contact else { return Ok(()) };
        Error::check("alpha0", None, self.angles0[0], Domain::Real)?;
        Error::check("gamma0", None, self.angles0[1], Domain::Real)?;
        check::<align::Rows>(&nodes.triads())?;
        Error::check_vector("turns", before.turns.into())?;
        let [slip1_before, slip3_before] = before.slip;
        let sliding = contact.sliding(nodes, *multipliers.as_ref());
        check::<Response>(&CrossSliding { slip1_before, slip3_before, ..sliding })
    }

    fn smooth(&self) -> Self {
        Self { contact: None, ..*self }
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &Nodes<D>,
        multipliers: &Vector4<D>,
        before: &UJointState<D>,
    ) -> (Contribution<D, 4>, UJointState<D>) {
        let loads = loads(nodes, multipliers);
        let JointLoads { e1a, e2a, e3a, e3b, xa, xb, .. } = loads;
        let held = Constraint::eval(&self.jointed(nodes));
        let rows = ujoint::Rows::eval(&JointPlaces { e1a, e2a, e3a, e3b, xa, xb }).matrix();
        let mut found = Contribution {
            residuals: held.g.push(held.g_rot),
            rows,
            forces: ujoint::Forces::eval(&loads).vector(),
            stiffness: ujoint::GeometricStiffness::eval(&loads).matrix(),
            by_multipliers: rows.transpose(),
        };
        let Some(contact) = self.contact else { return (found, *before) };

        let triads = nodes.triads();
        let Turns { alpha, gamma } = Angles::eval(&triads);
        let [alpha0, gamma0] = self.angles0.map(D::from);
        let turns = [nearest(alpha - alpha0, before.turns[0]), nearest(gamma - gamma0, before.turns[1])];
        // The twisting moment is conjugate to the angle β, the multiplier to its sine.
        let sine = e1a.dot(&e3b);
        let cosine = ((D::one() - sine) * (D::one() + sine)).sqrt();
        let m2 = loads.lambda_rot * cosine;
        let [ur1, ur3, slip1_before, slip3_before] = [turns[0], turns[1], before.slip[0], before.slip[1]];
        let sliding = CrossSliding {
            ur1,
            ur3,
            slip1_before,
            slip3_before,
            ..contact.sliding(nodes, [loads.f1, loads.f2, loads.f3, m2])
        };
        let (CrossSlid { m1, m3, slip1, slip3 }, by) = Response::linearized(&sliding);

        let rubbing = AlignLoads::new(&triads, [-m1, D::zero(), -m3]);
        found.forces += align::Moments::eval(&rubbing).vector();
        found.stiffness += align::GeometricStiffness::eval(&rubbing).matrix();
        let turned = align::Rows::eval(&triads);
        let by_m2 = rows.row(3).transpose() * (-(loads.lambda_rot * sine) / cosine);
        let mut follow = |row: Vector3<D>, by: CrossSliding<D>, by_turn: D| {
            let row: Forces<D> = by_spins(-row, row);
            let by_ta = e1a.cross(&by.e1a) + e2a.cross(&by.e2a) + e3a.cross(&by.e3a);
            let by_motions = row * by_turn + by_spins(by_ta, e3b.cross(&by.e3b)) + by_m2 * by.m2;
            found.follow_friction(&row, &by_motions, &Vector4::new(by.f1, by.f2, by.f3, by.m2 * cosine));
        };
        follow(turned.ur1_tb, by.m1, by.m1.ur1);
        follow(turned.ur3_tb, by.m3, by.m3.ur3);
        (found, UJointState { turns, slip: [slip1, slip3] })
    }
}
