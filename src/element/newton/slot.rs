//! SLOT: JOIN's element, whose first force is not a multiplier but the friction along the slot.

use super::{Contribution, Element, Nodes};
use crate::connector::slot::{Constraint, Positions, RelativePosition, Residuals, SlotPositions};
use crate::element::join;
use crate::element::slot_friction::{Response, SlotSliding};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::{Vector2, Vector3};

/// SLOT as an element: multipliers f2 and f3.
///
/// Its state is the motion u1 along the slot at which the friction force would be 0: at the start, 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlotElement {
    /// The components of x_b − x_a in a's triad at the start: x0, y0 and z0.
    pub start: Vector3<f64>,
    /// How b rubs in the slot, if it does.
    pub contact: Option<SlotContact>,
}

/// How b rubs in the slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlotContact {
    /// Stiffness while it sticks, > 0.
    pub k_el: f64,
    /// Internal contact force, as of a press fit.
    pub fc_int: f64,
    /// Friction coefficient, ≥ 0.
    pub mu: f64,
}

impl SlotContact {
    fn sliding<D: Scalar>(&self, u1: D, slip_before: D, [f2, f3]: [D; 2]) -> SlotSliding<D> {
        let [k_el, fc_int, mu] = [self.k_el, self.fc_int, self.mu].map(D::from);
        SlotSliding { u1, slip_before, k_el, f2, f3, fc_int, mu }
    }
}

impl Element<2> for SlotElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = D;

    fn check(&self, nodes: &Nodes<f64>, multipliers: &Vector2<f64>, &before: &f64) -> Result<(), Error> {
        let (Positions { e2a, e3a, xa, xb, .. }, [f2, f3]) = (nodes.positions(), *multipliers.as_ref());
        let [x0, y0, z0] = *self.start.as_ref();
        Error::check("x0", None, x0, Domain::Real)?;
        check::<Constraint>(&SlotPositions { e2a, e3a, xa, xb, y0, z0 })?;
        check::<join::Forces>(&nodes.join_loads([0.0, f2, f3]))?;
        self.contact.map_or(Ok(()), |contact| check::<Response>(&contact.sliding(0.0, before, [f2, f3])))
    }

    fn smooth(&self) -> Self {
        Self { contact: None, ..*self }
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &Nodes<D>,
        multipliers: &Vector2<D>,
        before: &D,
    ) -> (Contribution<D, 2>, D) {
        let (positions, [f2, f3]) = (nodes.positions(), *multipliers.as_ref());
        let Positions { e2a, e3a, xa, xb, .. } = positions;
        let [x0, y0, z0] = self.start.map(D::from).data.0[0];
        let Residuals { gy, gz } = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0 });
        let all = join::Rows::eval(&positions).matrix();
        let (along, rows) = (all.row(0).transpose(), all.fixed_rows::<2>(1).into_owned());

        let u1 = RelativePosition::eval(&positions).x - x0;
        let rubbed = self.contact.map(|contact| Response::linearized(&contact.sliding(u1, *before, [f2, f3])));
        let friction = rubbed.map_or(D::zero(), |(value, _)| value.f1);
        let loads = nodes.join_loads([-friction, f2, f3]);
        let mut found = Contribution {
            residuals: Vector2::new(gy, gz),
            rows,
            forces: join::Forces::eval(&loads).vector(),
            stiffness: join::GeometricStiffness::eval(&loads).matrix(),
            by_multipliers: rows.transpose(),
        };
        let Some((value, by)) = rubbed else { return (found, *before) };
        found.follow_friction(&along, &(along * by.f1.u1), &Vector2::new(by.f1.f2, by.f1.f3));
        (found, value.slip)
    }
}
