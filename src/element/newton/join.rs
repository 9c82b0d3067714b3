//! JOIN: three residuals, and the forces along a's triad.

use super::{Contribution, Element, Nodes};
use crate::connector::join::{Constraint, Joined};
use crate::element::join;
use crate::formula::error::Error;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// JOIN as an element: multipliers f1, f2 and f3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinElement {
    /// The components of x_b − x_a in a's triad at the start.
    pub d0: Vector3<f64>,
}

impl JoinElement {
    fn joined<D: Scalar>(&self, nodes: &Nodes<D>) -> Joined<D> {
        let ([e1a, e2a, e3a], xa, xb) = (nodes.a, nodes.xa, nodes.xb);
        Joined { e1a, e2a, e3a, xa, xb, d0: self.d0.map(D::from) }
    }
}

impl Element<3> for JoinElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = ();

    fn check(&self, nodes: &Nodes<f64>, multipliers: &Vector3<f64>, (): &()) -> Result<(), Error> {
        check::<Constraint>(&self.joined(nodes))?;
        check::<join::Forces>(&nodes.join_loads(*multipliers.as_ref()))
    }

    fn smooth(&self) -> Self {
        *self
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &Nodes<D>,
        multipliers: &Vector3<D>,
        &(): &(),
    ) -> (Contribution<D, 3>, ()) {
        let loads = nodes.join_loads(*multipliers.as_ref());
        let found = Contribution::smooth(
            Constraint::eval(&self.joined(nodes)).g,
            join::Rows::eval(&nodes.positions()).matrix(),
            join::Forces::eval(&loads).vector(),
            join::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, ())
    }
}
