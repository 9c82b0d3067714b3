//! SLOT: the element of JOIN, except that its first force is the friction along the slot instead of a multiplier.

#[cfg(feature = "verify")]
pub(crate) mod proof;

use crate::connector::slot::{Constraint, Friction, RelativePosition, Residuals, SlotLoads, SlotPositions};
use crate::contact::coulomb::Sliding;
use crate::element::line;
use crate::element::nodes::two_nodes;
use crate::element::{Contribution, Element, Nodes, Parameters};
use crate::fields;
use crate::formula::quantity::{F1, F2, F3, FC_INT, K_STICK, MU, U1, X0, Y0, Z0};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

/// SLOT as an element, with the multipliers f2 and f3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SlotElement;

fields! {
    /// The components of x_b − x_a in a's triad at the start.
    pub struct SlotStart<T> { x0: T = X0, y0: T = Y0, z0: T = Z0 }
}
fields! {
    /// The parameters of the friction of b in the slot.
    pub struct SlotContact<T> { k_stick: T = K_STICK, fc_int: T = FC_INT, mu: T = MU }
}
fields! {
    /// The motion along the slot, and the friction force: both are 0 at the start.
    pub struct SlotState<T> { u1: T = U1, f1: T = F1 }
}

impl<D: Scalar> SlotContact<D> {
    /// The friction force after a motion, with its derivatives with respect to u1, f2 and f3.
    pub(super) fn rub(&self, u1: D, before: &SlotState<D>, [f2, f3]: [D; 2]) -> (D, D, [D; 2]) {
        let Self { k_stick, fc_int, mu } = *self;
        let (friction, by_loads) = Friction::linearized(&SlotLoads { f1: D::zero(), f2, f3, fc_int, mu });
        let increment = Sliding { du: u1 - before.u1, f_before: before.f1, k_stick, mu, r#fn: friction.r#fn };
        increment.under([by_loads.r#fn.f2, by_loads.r#fn.f3])
    }
}

impl Element<2> for SlotElement {
    const SPEC: Spec = Spec::new(
        "slot",
        "SLOT as an element",
        Document::SLOT.ours("Description", "the page prints residuals and friction; the element is derived from them"),
    )
    .eta_of_value(4.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <Residuals<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("f2", &F2), Field::new("f3", &F3)];
    type Start<T: Component> = SlotStart<T>;
    type Contact<T: Component> = SlotContact<T>;
    type State<T: Component> = SlotState<T>;

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &Vector2<D>,
        parameters: &Parameters<Self, D, 2>,
        before: &SlotState<D>,
    ) -> (Contribution<D, 2>, SlotState<D>) {
        let (positions, [f2, f3]) = (nodes.positions(), *multipliers.as_ref());
        let (Nodes { e2a, e3a, xa, xb, .. }, SlotStart { x0, y0, z0 }) = (*nodes, parameters.start);
        let Residuals { gy, gz } = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0 });
        let all = line::Rows::eval(&positions).matrix();
        let (along, rows) = (all.row(0).transpose(), all.fixed_rows::<2>(1).into_owned());

        let u1 = RelativePosition::eval(&positions).x - x0;
        let rubbed = parameters.contact.map(|contact| contact.rub(u1, before, [f2, f3]));
        let loads = nodes.join_loads([rubbed.map_or(D::zero(), |(f1, ..)| -f1), f2, f3]);
        let mut found = Contribution::smooth(
            Vector2::new(gy, gz),
            rows,
            line::Forces::eval(&loads).vector(),
            line::GeometricStiffness::eval(&loads).matrix(),
        );
        let Some((f1, by_u1, [by_f2, by_f3])) = rubbed else { return (found, *before) };
        found.follow_friction(&along, &(along * by_u1), &Vector2::new(by_f2, by_f3));
        (found, SlotState { u1, f1 })
    }
}
