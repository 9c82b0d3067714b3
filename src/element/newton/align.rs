//! ALIGN: the three Cardan angles, and moments about their axes.

use super::{Contribution, Element, Nodes};
use crate::connector::align::{Constraint, Misalignment, Orientations};
use crate::connector::cardan::Angles;
use crate::element::align::{self, AlignLoads};
use crate::formula::error::Error;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// ALIGN as an element: the multipliers of the three angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlignElement {
    /// The Cardan angles α0, β0 and γ0 at the start.
    pub angles0: [f64; 3],
}

impl AlignElement {
    fn orientations<D: Scalar>(&self, nodes: &Nodes<D>) -> Orientations<D> {
        let [alpha, beta, gamma] = self.angles0.map(D::from);
        Orientations::new(&nodes.triads(), &Angles { alpha, beta, gamma })
    }
}

impl Element<3> for AlignElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = ();

    fn check(&self, nodes: &Nodes<f64>, multipliers: &Vector3<f64>, (): &()) -> Result<(), Error> {
        check::<Constraint>(&self.orientations(nodes))?;
        check::<align::Moments>(&AlignLoads::new(&nodes.triads(), *multipliers.as_ref()))
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
        let (triads, Misalignment { ur1, ur2, ur3 }) = (nodes.triads(), Constraint::eval(&self.orientations(nodes)));
        let loads = AlignLoads::new(&triads, *multipliers.as_ref());
        let found = Contribution::smooth(
            Vector3::new(ur1, ur2, ur3),
            align::Rows::eval(&triads).matrix(),
            align::Moments::eval(&loads).vector(),
            align::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, ())
    }
}
