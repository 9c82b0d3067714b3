//! UNIVERSAL: one residual, and moments about the line perpendicular to both shafts.

#[cfg(feature = "verify")]
mod proof;

use crate::connector::ujoint::CrossAxes;
use crate::connector::universal::{Constraint, Shafts, Skew};
use crate::element::cross::{self, UniversalLoads};
use crate::element::nodes::{by_spins, two_nodes};
use crate::element::{Contribution, Element, Nodes, Nothing, Parameters};
use crate::fields;
use crate::formula::quantity::{C0, LAMBDA_ROT};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, Vector1};

/// UNIVERSAL as an element, with the multiplier of e1a·e3b − c0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UniversalElement;

fields! {
    /// e1a·e3b at the start.
    pub struct UniversalStart<T> { c0: T = C0 }
}

impl Element<1> for UniversalElement {
    const SPEC: Spec = Spec::new(
        "universal",
        "UNIVERSAL as an element",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; the element is derived from its residual"),
    )
    .eta_of_value(2.0);
    two_nodes!();
    const RESIDUALS: &'static [Field] = <Skew<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("lambda_rot", &LAMBDA_ROT)];
    type Start<T: Component> = UniversalStart<T>;
    type Contact<T: Component> = Nothing<T>;
    type State<T: Component> = Nothing<T>;

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multiplier: &Vector1<D>,
        parameters: &Parameters<Self, D, 1>,
        before: &Nothing<D>,
    ) -> (Contribution<D, 1>, Nothing<D>) {
        let (Nodes { e1a, e3b, .. }, UniversalStart { c0 }) = (*nodes, parameters.start);
        let loads = UniversalLoads { e1a, e3b, lambda_rot: multiplier.x };
        let row = cross::Rows::eval(&CrossAxes { e1a, e3b });
        let found = Contribution::smooth(
            Vector1::new(Constraint::eval(&Shafts { e1a, e3b, c0 }).g),
            SMatrix::from(by_spins(row.g_rot_ta, row.g_rot_tb).transpose()),
            cross::Moments::eval(&loads).vector(),
            cross::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, *before)
    }
}
