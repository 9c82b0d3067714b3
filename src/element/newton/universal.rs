//! UNIVERSAL: one residual, and moments about the line across both shafts.

use super::{Contribution, Element, Nodes};
use crate::connector::ujoint::CrossAxes;
use crate::connector::universal::{Constraint, Shafts};
use crate::element::universal::{self, UniversalLoads};
use crate::formula::error::Error;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, Vector1};

/// UNIVERSAL as an element: the multiplier of e1a·e3b − c0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniversalElement {
    /// e1a·e3b at the start.
    pub c0: f64,
}

impl UniversalElement {
    fn shafts<D: Scalar>(self, nodes: &Nodes<D>) -> Shafts<D> {
        let ([e1a, ..], [.., e3b]) = (nodes.a, nodes.b);
        Shafts { e1a, e3b, c0: self.c0.into() }
    }
}

fn loads<D: Scalar>(nodes: &Nodes<D>, multiplier: &Vector1<D>) -> UniversalLoads<D> {
    let ([e1a, ..], [.., e3b]) = (nodes.a, nodes.b);
    UniversalLoads { e1a, e3b, lambda_rot: multiplier.x }
}

impl Element<1> for UniversalElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = ();

    fn check(&self, nodes: &Nodes<f64>, multiplier: &Vector1<f64>, (): &()) -> Result<(), Error> {
        check::<Constraint>(&self.shafts(nodes))?;
        check::<universal::Moments>(&loads(nodes, multiplier))
    }

    fn smooth(&self) -> Self {
        *self
    }

    fn contribution<D: Scalar>(&self, nodes: &Nodes<D>, multiplier: &Vector1<D>, &(): &()) -> (Contribution<D, 1>, ()) {
        let loads = loads(nodes, multiplier);
        let row = universal::Rows::eval(&CrossAxes { e1a: loads.e1a, e3b: loads.e3b });
        let found = Contribution::smooth(
            Vector1::new(Constraint::eval(&self.shafts(nodes)).g),
            SMatrix::from(super::by_spins(row.g_rot_ta, row.g_rot_tb).transpose()),
            universal::Moments::eval(&loads).vector(),
            universal::GeometricStiffness::eval(&loads).matrix(),
        );
        (found, ())
    }
}
