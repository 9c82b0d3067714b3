//! SLOT in the plane: one residual, and friction along the slot.

#[cfg(feature = "verify")]
mod proof;

use super::element::{SlotContact, SlotState};
use crate::connector::slot::plane::{Forces, GeometricStiffness, PlaneLoads, PlanePlaces, Rows};
use crate::connector::slot::{Constraint2d, Residual2d, SlotPositions2d};
use crate::element::{Contribution, Element, Parameters};
use crate::fields;
use crate::formula::quantity::{
    F2, FORCE_A_PLANE, FORCE_B_PLANE, MOMENT_A_PLANE, MOMENT_B_PLANE, SPIN_A_PLANE, SPIN_B_PLANE, TRANSLATION_A_PLANE,
    TRANSLATION_B_PLANE, X0, Y0,
};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{Vector1, Vector2, Vector6};

/// SLOT in the plane as an element, with the multiplier f2. Each node has a translation and a spin: u_a, θ_a, u_b, θ_b.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SlotElement2d;

fields! {
    /// The components of x_b − x_a along and normal to the slot at the start.
    pub struct SlotStart2d<T> { x0: T = X0, y0: T = Y0 }
}

/// The loads of a force along an axis of a.
const fn loads<T: Component>(nodes: &PlanePlaces<T>, f2: T) -> PlaneLoads<T> {
    let PlanePlaces { e2a, xa, xb } = *nodes;
    PlaneLoads { e2a, xa, xb, f2 }
}

impl Element<1, 6> for SlotElement2d {
    const SPEC: Spec = Spec::new(
        "slot_2d",
        "SLOT in the plane as an element",
        Document::SLOT.ours("Description", "the page prints residuals and friction; the element is derived from them"),
    )
    .eta_of_value(4.0);
    const UNKNOWNS: &'static [Field] = &[
        Field::new("ua", &TRANSLATION_A_PLANE),
        Field::new("ta", &SPIN_A_PLANE),
        Field::new("ub", &TRANSLATION_B_PLANE),
        Field::new("tb", &SPIN_B_PLANE),
    ];
    const FORCES: &'static [Field] = &[
        Field::new("fa", &FORCE_A_PLANE),
        Field::new("ma", &MOMENT_A_PLANE),
        Field::new("fb", &FORCE_B_PLANE),
        Field::new("mb", &MOMENT_B_PLANE),
    ];
    const RESIDUALS: &'static [Field] = <Residual2d<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("f2", &F2)];
    type Nodes<T: Component> = PlanePlaces<T>;
    type Start<T: Component> = SlotStart2d<T>;
    type Contact<T: Component> = SlotContact<T>;
    type State<T: Component> = SlotState<T>;

    fn moved<D: Scalar>(nodes: &PlanePlaces<D>, motions: &Vector6<D>) -> PlanePlaces<D> {
        let (PlanePlaces { e2a, xa, xb }, spin) = (*nodes, motions[2]);
        PlanePlaces {
            e2a: Vector2::new(e2a.x - e2a.y * spin, e2a.y + e2a.x * spin),
            xa: xa + motions.fixed_rows::<2>(0),
            xb: xb + motions.fixed_rows::<2>(3),
        }
    }

    fn contribution<D: Scalar>(
        nodes: &PlanePlaces<D>,
        multiplier: &Vector1<D>,
        parameters: &Parameters<Self, D, 1, 6>,
        before: &SlotState<D>,
    ) -> (Contribution<D, 1, 6>, SlotState<D>) {
        let (PlanePlaces { e2a, xa, xb }, SlotStart2d { x0, y0 }) = (*nodes, parameters.start);
        let across = loads(nodes, multiplier.x);
        let mut found = Contribution::smooth(
            Vector1::new(Constraint2d::eval(&SlotPositions2d { e2a, xa, xb, y0 }).gy),
            Rows::eval(nodes).vector().transpose(),
            Forces::eval(&across).vector(),
            GeometricStiffness::eval(&across).matrix(),
        );
        let Some(contact) = parameters.contact else { return (found, *before) };

        // The formulas of the direction normal to the slot apply along it as well: e1a is e2a rotated by 90° to the right.
        let slot = PlanePlaces { e2a: Vector2::new(e2a.y, -e2a.x), ..*nodes };
        let u1 = slot.e2a.dot(&(xb - xa)) - x0;
        let (f1, by_u1, [by_f2, _]) = contact.rub(u1, before, [multiplier.x, D::zero()]);
        let (rubbing, row) = (loads(&slot, -f1), Rows::eval(&slot).vector());
        found.forces += Forces::eval(&rubbing).vector();
        found.stiffness += GeometricStiffness::eval(&rubbing).matrix();
        found.follow_friction(&row, &(row * by_u1), &Vector1::new(by_f2));
        (found, SlotState { u1, f1 })
    }
}
