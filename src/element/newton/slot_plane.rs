//! SLOT in the plane: one residual, and friction along the slot.

use super::{Contribution, Element, SlotContact};
use crate::connector::slot::{Constraint2d, SlotPositions2d};
use crate::element::slot_friction::{Response2d, SlotSliding2d};
use crate::element::slot_plane::{Forces, GeometricStiffness, PlaneLoads, PlanePlaces, Rows};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::{Vector1, Vector2};

/// SLOT in the plane as an element: the multiplier f2. Its nodes have a translation and a spin each, u_a, θ_a, u_b, θ_b.
///
/// Its state is the motion u1 along the slot at which the friction force would be 0: at the start, 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlotElement2d {
    /// The components of x_b − x_a along and across the slot at the start: x0 and y0.
    pub start: Vector2<f64>,
    /// How b rubs in the slot, if it does.
    pub contact: Option<SlotContact>,
}

impl SlotContact {
    fn sliding_2d<D: Scalar>(&self, u1: D, slip_before: D, f2: D) -> SlotSliding2d<D> {
        let [k_el, fc_int, mu] = [self.k_el, self.fc_int, self.mu].map(D::from);
        SlotSliding2d { u1, slip_before, k_el, f2, fc_int, mu }
    }
}

impl SlotElement2d {
    fn positions<D: Scalar>(&self, nodes: &PlanePlaces<D>) -> SlotPositions2d<D> {
        let PlanePlaces { e2a, xa, xb } = *nodes;
        SlotPositions2d { e2a, xa, xb, y0: self.start.y.into() }
    }
}

/// Of a force along an axis of a.
fn loads<D: Scalar>(nodes: &PlanePlaces<D>, f2: D) -> PlaneLoads<D> {
    let PlanePlaces { e2a, xa, xb } = *nodes;
    PlaneLoads { e2a, xa, xb, f2 }
}

impl Element<1, 6> for SlotElement2d {
    type Nodes<D: Scalar> = PlanePlaces<D>;
    type State<D: Scalar> = D;

    fn check(&self, nodes: &PlanePlaces<f64>, multiplier: &Vector1<f64>, &before: &f64) -> Result<(), Error> {
        Error::check("x0", None, self.start.x, Domain::Real)?;
        check::<Constraint2d>(&self.positions(nodes))?;
        check::<Forces>(&loads(nodes, multiplier.x))?;
        self.contact.map_or(Ok(()), |contact| check::<Response2d>(&contact.sliding_2d(0.0, before, multiplier.x)))
    }

    fn smooth(&self) -> Self {
        Self { contact: None, ..*self }
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &PlanePlaces<D>,
        multiplier: &Vector1<D>,
        before: &D,
    ) -> (Contribution<D, 1, 6>, D) {
        let across = loads(nodes, multiplier.x);
        let mut found = Contribution::smooth(
            Vector1::new(Constraint2d::eval(&self.positions(nodes)).gy),
            Rows::eval(nodes).vector().transpose(),
            Forces::eval(&across).vector(),
            GeometricStiffness::eval(&across).matrix(),
        );
        let Some(contact) = self.contact else { return (found, *before) };

        // What holds across the slot holds along it: e1a is e2a turned by 90° to the right.
        let slot = PlanePlaces { e2a: Vector2::new(nodes.e2a.y, -nodes.e2a.x), ..*nodes };
        let u1 = slot.e2a.dot(&(slot.xb - slot.xa)) - D::from(self.start.x);
        let (value, by) = Response2d::linearized(&contact.sliding_2d(u1, *before, multiplier.x));
        let (rubbing, row) = (loads(&slot, -value.f1), Rows::eval(&slot).vector());
        found.forces += Forces::eval(&rubbing).vector();
        found.stiffness += GeometricStiffness::eval(&rubbing).matrix();
        found.follow_friction(&row, &(row * by.f1.u1), &Vector1::new(by.f1.f2));
        (found, value.slip)
    }
}
