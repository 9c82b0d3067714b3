//! JOIN: three residuals, and the forces along a's triad.

#[cfg(feature = "verify")]
mod proof;

use crate::connector::join::{Constraint, Displaced, Joined};
use crate::element::line;
use crate::element::nodes::two_nodes;
use crate::element::{Contribution, Element, Nodes, Nothing, Parameters};
use crate::fields;
use crate::formula::quantity::{D0, F2, F3, JOIN_F1};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// JOIN as an element, with the multipliers f1, f2 and f3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JoinElement;

fields! {
    /// The components of x_b − x_a in a's triad at the start.
    pub struct JoinStart<T> { d0: Vector3<T> = D0 }
}

impl Element<3> for JoinElement {
    const SPEC: Spec = Spec::new(
        "join",
        "JOIN as an element",
        Document::UJOINT
            .ours("Description", "the page of JOIN was not given; the element is derived from its residuals"),
    )
    .eta_of_value(2.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <Displaced<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("f1", &JOIN_F1), Field::new("f2", &F2), Field::new("f3", &F3)];
    type Start<T: Component> = JoinStart<T>;
    type Contact<T: Component> = Nothing<T>;
    type State<T: Component> = Nothing<T>;

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &Vector3<D>,
        parameters: &Parameters<Self, D, 3>,
        before: &Nothing<D>,
    ) -> (Contribution<D, 3>, Nothing<D>) {
        let (Nodes { e1a, e2a, e3a, xa, xb, .. }, JoinStart { d0 }) = (*nodes, parameters.start);
        let loads = nodes.join_loads(*multipliers.as_ref());
        let found = Contribution::smooth(
            Constraint::eval(&Joined { e1a, e2a, e3a, xa, xb, d0 }).g,
            line::Rows::eval(&nodes.positions()).matrix(),
            line::Forces::eval(&loads).vector(),
            line::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, *before)
    }
}
