//! TRANSLATOR: SLOT's element and ALIGN's, with a friction along the slot that the moments press for as the forces do.

use super::{Contribution, Element, Nodes, by_spins};
use crate::connector::align::Orientations;
use crate::connector::cardan::Angles;
use crate::connector::slot::{RelativePosition, SlotPositions};
use crate::connector::translator::{AllResiduals, Constraint, Placement};
use crate::element::align::{self, AlignLoads, AlignRows};
use crate::element::translator_friction::{Response, TranslatorSliding};
use crate::element::{Rows, join};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::{SVector, Vector3};

/// TRANSLATOR as an element: multipliers f2, f3 and those of ALIGN's three angles.
///
/// Its state is the motion u1 along the slot at which the friction force would be 0: at the start, 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TranslatorElement {
    /// The components of x_b − x_a in a's triad at the start: x0, y0 and z0.
    pub start: Vector3<f64>,
    /// The Cardan angles α0, β0 and γ0 at the start.
    pub angles0: [f64; 3],
    /// How b rubs in the slot, if it does.
    pub contact: Option<TranslatorContact>,
}

/// How b rubs in the slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TranslatorContact {
    /// Stiffness while it sticks, > 0.
    pub k_el: f64,
    /// Effective friction radius, ≥ 0; 0 ignores the torque.
    pub rr: f64,
    /// Length over which b overlaps the slot, ≥ 0; 0 ignores bending.
    pub l: f64,
    /// Internal contact force, as of a press fit.
    pub fc_int: f64,
    /// Friction coefficient, ≥ 0.
    pub mu: f64,
}

impl TranslatorContact {
    fn sliding<D: Scalar>(&self, u1: D, slip_before: D, forces: [D; 2], moments: [D; 3]) -> TranslatorSliding<D> {
        let Self { k_el, rr, l, fc_int, mu } = *self;
        let ([k_el, rr, l, fc_int, mu], [f2, f3], [m1, m2, m3]) =
            ([k_el, rr, l, fc_int, mu].map(D::from), forces, moments);
        TranslatorSliding { u1, slip_before, k_el, f2, f3, m1, m2, m3, rr, l, fc_int, mu }
    }
}

impl TranslatorElement {
    fn placement<D: Scalar>(&self, nodes: &Nodes<D>) -> Placement<D> {
        let ([.., e2a, e3a], xa, xb) = (nodes.a, nodes.xa, nodes.xb);
        let [_, y0, z0] = self.start.map(D::from).data.0[0];
        let [alpha, beta, gamma] = self.angles0.map(D::from);
        Placement::new(
            &SlotPositions { e2a, e3a, xa, xb, y0, z0 },
            &Orientations::new(&nodes.triads(), &Angles { alpha, beta, gamma }),
        )
    }
}

impl Element<5> for TranslatorElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = D;

    fn check(&self, nodes: &Nodes<f64>, multipliers: &SVector<f64, 5>, &before: &f64) -> Result<(), Error> {
        let [f2, f3, l1, l2, l3] = multipliers.data.0[0];
        Error::check("x0", None, self.start.x, Domain::Real)?;
        check::<Constraint>(&self.placement(nodes))?;
        check::<join::Forces>(&nodes.join_loads([0.0, f2, f3]))?;
        check::<align::Moments>(&AlignLoads::new(&nodes.triads(), [l1, l2, l3]))?;
        self.contact.map_or(Ok(()), |contact| check::<Response>(&contact.sliding(0.0, before, [f2, f3], [0.0; 3])))
    }

    fn smooth(&self) -> Self {
        Self { contact: None, ..*self }
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &Nodes<D>,
        multipliers: &SVector<D, 5>,
        before: &D,
    ) -> (Contribution<D, 5>, D) {
        let (positions, triads) = (nodes.positions(), nodes.triads());
        let [f2, f3, l1, l2, l3] = multipliers.data.0[0];
        let AllResiduals { gy, gz, ur1, ur2, ur3 } = Constraint::eval(&self.placement(nodes));
        let (join_rows, align_rows) = (join::Rows::eval(&positions).matrix(), align::Rows::eval(&triads));
        let AlignRows { ur1_tb, ur2_tb, ur3_tb } = align_rows;
        let mut rows = Rows::<D, 5>::zeros();
        rows.fixed_rows_mut::<2>(0).copy_from(&join_rows.fixed_rows::<2>(1));
        rows.fixed_rows_mut::<3>(2).copy_from(&align_rows.matrix());

        let aligning = AlignLoads::new(&triads, [l1, l2, l3]);
        let (moments, k_align) = (align::Moments::eval(&aligning), align::GeometricStiffness::eval(&aligning));
        let along_axes = nodes.a.map(|axis| axis.dot(&moments.mb));
        let u1 = RelativePosition::eval(&positions).x - D::from(self.start.x);
        let rubbed =
            self.contact.map(|contact| Response::linearized(&contact.sliding(u1, *before, [f2, f3], along_axes)));
        let friction = rubbed.map_or(D::zero(), |(value, _)| value.f1);
        let loads = nodes.join_loads([-friction, f2, f3]);
        let mut found = Contribution {
            residuals: SVector::from([gy, gz, ur1, ur2, ur3]),
            rows,
            forces: join::Forces::eval(&loads).vector() + moments.vector(),
            stiffness: join::GeometricStiffness::eval(&loads).matrix() + k_align.matrix(),
            by_multipliers: rows.transpose(),
        };
        let Some((value, by)) = rubbed else { return (found, *before) };
        // The moments along a's axes are e_ia·m_b: they change with m_b, and with the axes as a turns.
        let [e1a, e2a, e3a] = nodes.a;
        let pressing: Vector3<D> = e1a * by.f1.m1 + e2a * by.f1.m2 + e3a * by.f1.m3;
        let by_ta = pressing.cross(&moments.mb) - k_align.k_tb_tb * pressing;
        let by_tb = k_align.k_tb_tb.transpose() * pressing;
        let along = join_rows.row(0).transpose();
        let [r1, r2, r3] = [ur1_tb, ur2_tb, ur3_tb].map(|row| pressing.dot(&row));
        found.follow_friction(
            &along,
            &(along * by.f1.u1 + by_spins(by_ta, by_tb)),
            &SVector::from([by.f1.f2, by.f1.f3, r1, r2, r3]),
        );
        (found, value.slip)
    }
}
