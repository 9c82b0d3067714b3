//! UNIVERSAL: one residual, and moments about the line across both shafts.

#[cfg(feature = "verify")]
mod proof;

use super::{Contribution, Element, FORCES, Nodes, Nothing, Parameters, UNKNOWNS, by_spins};
use crate::connector::ujoint::CrossAxes;
use crate::connector::universal::{Constraint, Shafts, Skew};
use crate::element::universal::{self, UniversalLoads};
use crate::fields;
use crate::formula::quantity::{C0, LAMBDA_ROT};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector, Vector1};

/// UNIVERSAL as an element: the multiplier of e1a·e3b − c0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Universal;

/// UNIVERSAL with its start.
pub type UniversalElement<D = f64> = Parameters<Universal, D, 1>;

fields! {
    /// e1a·e3b at the start.
    pub struct UniversalStart<T> { c0: T = C0 }
}

impl Element<1> for Universal {
    const SPEC: Spec = Spec::new(
        "universal",
        "UNIVERSAL as an element",
        Document::UJOINT
            .ours("Description", "the page of UNIVERSAL was not given; the element is derived from its residual"),
    )
    .eta_of_value(2.0);
    const UNKNOWNS: &'static [Field] = UNKNOWNS;
    const FORCES: &'static [Field] = FORCES;
    const RESIDUALS: &'static [Field] = <Skew<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("lambda_rot", &LAMBDA_ROT)];
    type Nodes<T: Component> = Nodes<T>;
    type Start<T: Component> = UniversalStart<T>;
    type Contact<T: Component> = Nothing<T>;
    type State<T: Component> = Nothing<T>;

    fn moved<D: Scalar>(nodes: &Nodes<D>, motions: &SVector<D, 12>) -> Nodes<D> {
        nodes.moved(motions)
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multiplier: &Vector1<D>,
        parameters: &UniversalElement<D>,
        before: &Nothing<D>,
    ) -> (Contribution<D, 1>, Nothing<D>) {
        let (Nodes { e1a, e3b, .. }, UniversalStart { c0 }) = (*nodes, parameters.start);
        let loads = UniversalLoads { e1a, e3b, lambda_rot: multiplier.x };
        let row = universal::Rows::eval(&CrossAxes { e1a, e3b });
        let found = Contribution::smooth(
            Vector1::new(Constraint::eval(&Shafts { e1a, e3b, c0 }).g),
            SMatrix::from(by_spins(row.g_rot_ta, row.g_rot_tb).transpose()),
            universal::Moments::eval(&loads).vector(),
            universal::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, *before)
    }
}
