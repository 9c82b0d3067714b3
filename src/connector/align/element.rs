//! ALIGN: the three Cardan angles, and moments about their axes.

#[cfg(feature = "verify")]
mod proof;

use crate::connector::align::{Constraint, Misalignment, Orientations};
use crate::element::angle::{self, AlignLoads};
use crate::element::cardan::Angles;
use crate::element::nodes::two_nodes;
use crate::element::{Contribution, Element, Nodes, Nothing, Parameters};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{ALPHA0, BETA0, GAMMA0, LAMBDA_R1, LAMBDA_R2, LAMBDA_R3};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// ALIGN as an element, with a multiplier for each of the three angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AlignElement;

fields! {
    /// The Cardan angles at the start.
    pub struct AlignStart<T> { alpha0: T = ALPHA0, beta0: T = BETA0, gamma0: T = GAMMA0 }
}

impl<T: Component> AlignStart<T> {
    pub(super) const fn angles(&self) -> Angles<T> {
        Angles { alpha: self.alpha0, beta: self.beta0, gamma: self.gamma0 }
    }
}

/// The multipliers of the three angles.
pub(crate) const MULTIPLIERS: [Field; 3] =
    [Field::new("lambda_r1", &LAMBDA_R1), Field::new("lambda_r2", &LAMBDA_R2), Field::new("lambda_r3", &LAMBDA_R3)];

impl Element<3> for AlignElement {
    const SPEC: Spec = Spec::new(
        "align",
        "ALIGN as an element",
        Document::TRANSLATOR.ours(
            "Description",
            "the page of ALIGN was not given; the element is derived from the angles that are held",
        ),
    )
    .eta_of_value(12.0)
    .normwise_of_value(4.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <Misalignment<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &MULTIPLIERS;
    type Start<T: Component> = AlignStart<T>;
    type Contact<T: Component> = Nothing<T>;
    type State<T: Component> = Nothing<T>;

    fn validate<D: Scalar>(nodes: &Nodes<D>, _: &Parameters<Self, D, 3>) -> Result<(), Error> {
        angle::Rows::validate(&nodes.triads())
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &Vector3<D>,
        parameters: &Parameters<Self, D, 3>,
        before: &Nothing<D>,
    ) -> (Contribution<D, 3>, Nothing<D>) {
        let triads = nodes.triads();
        let Misalignment { ur1, ur2, ur3 } = Constraint::eval(&Orientations::new(&triads, &parameters.start.angles()));
        let loads = AlignLoads::new(&triads, *multipliers.as_ref());
        let found = Contribution::smooth(
            Vector3::new(ur1, ur2, ur3),
            angle::Rows::eval(&triads).matrix(),
            angle::Moments::eval(&loads).vector(),
            angle::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, *before)
    }
}
