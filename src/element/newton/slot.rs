//! SLOT: JOIN's element, whose first force is not a multiplier but the friction along the slot.

#[cfg(feature = "verify")]
pub(super) mod proof;

use super::{Contribution, Element, FORCES, Nodes, Parameters, UNKNOWNS};
use crate::connector::slot::{Constraint, RelativePosition, Residuals, SlotPositions};
use crate::element::join;
use crate::element::slot_friction::{Response, SlotSliding};
use crate::fields;
use crate::formula::quantity::{F2, F3, FC_INT, K_EL, MU, U_SLIP, X0, Y0, Z0};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{SVector, Vector2};

/// SLOT as an element: multipliers f2 and f3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot;

/// SLOT with its start, and how it rubs.
pub type SlotElement<D = f64> = Parameters<Slot, D, 2>;

fields! {
    /// The components of x_b − x_a in a's triad at the start.
    pub struct SlotStart<T> { x0: T = X0, y0: T = Y0, z0: T = Z0 }
}
fields! {
    /// How b rubs in the slot.
    pub struct SlotContact<T> { k_el: T = K_EL, fc_int: T = FC_INT, mu: T = MU }
}
fields! {
    /// The motion along the slot at which the friction force would be 0: at the start, 0.
    pub struct Slipped<T> { slip: T = U_SLIP }
}

impl<T: Component> SlotContact<T> {
    const fn sliding(&self, u1: T, slip_before: T, [f2, f3]: [T; 2]) -> SlotSliding<T> {
        let Self { k_el, fc_int, mu } = *self;
        SlotSliding { u1, slip_before, k_el, f2, f3, fc_int, mu }
    }
}

impl Element<2> for Slot {
    const SPEC: Spec = Spec::new(
        "slot",
        "SLOT as an element",
        Document::SLOT.ours("Description", "the page prints residuals and friction; the element is derived from them"),
    )
    .eta_of_value(4.0);
    const UNKNOWNS: &'static [Field] = UNKNOWNS;
    const FORCES: &'static [Field] = FORCES;
    const RESIDUALS: &'static [Field] = <Residuals<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("f2", &F2), Field::new("f3", &F3)];
    type Nodes<T: Component> = Nodes<T>;
    type Start<T: Component> = SlotStart<T>;
    type Contact<T: Component> = SlotContact<T>;
    type State<T: Component> = Slipped<T>;

    fn moved<D: Scalar>(nodes: &Nodes<D>, motions: &SVector<D, 12>) -> Nodes<D> {
        nodes.moved(motions)
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &Vector2<D>,
        parameters: &SlotElement<D>,
        before: &Slipped<D>,
    ) -> (Contribution<D, 2>, Slipped<D>) {
        let (positions, [f2, f3]) = (nodes.positions(), *multipliers.as_ref());
        let (Nodes { e2a, e3a, xa, xb, .. }, SlotStart { x0, y0, z0 }) = (*nodes, parameters.start);
        let Residuals { gy, gz } = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0 });
        let all = join::Rows::eval(&positions).matrix();
        let (along, rows) = (all.row(0).transpose(), all.fixed_rows::<2>(1).into_owned());

        let u1 = RelativePosition::eval(&positions).x - x0;
        let rubbed =
            parameters.contact.map(|contact| Response::linearized(&contact.sliding(u1, before.slip, [f2, f3])));
        let friction = rubbed.map_or(D::zero(), |(value, _)| value.f1);
        let loads = nodes.join_loads([-friction, f2, f3]);
        let mut found = Contribution::smooth(
            Vector2::new(gy, gz),
            rows,
            join::Forces::eval(&loads).vector(),
            join::GeometricStiffness::eval(&loads).matrix(),
        );
        let Some((value, by)) = rubbed else { return (found, *before) };
        found.follow_friction(&along, &(along * by.f1.u1), &Vector2::new(by.f1.f2, by.f1.f3));
        (found, Slipped { slip: value.slip })
    }
}
