//! SLIDER, in space and in a plane: translations of three nodes, no spins.
//!
//! Rows and forces are those of m on the line, and the stiffness is the derivative of these forces, wherever m is. On the line
//! it does in every motion along the constraint what Σ λ ∂²g does there; beside it, by as much as Newton's method has not yet
//! closed, it keeps the convergence quadratic, which Σ λ ∂²g does not.

use super::{Contribution, Element};
use crate::connector::slider::{Constraint, Constraint2d, Nodes, Nodes2d};
use crate::element::slider::{Forces, Rows, SliderForces, SliderLoads};
use crate::element::slider_plane::{self, SliderForces2d, SliderLoads2d};
use crate::formula::error::Error;
use crate::formula::{Formula, check};
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, Vector1, Vector2};

/// SLIDER as an element: multipliers λ1 and λ2 across the line, and the translations of nodes 1, n and m.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SliderElement;

fn loads<D: Scalar>(nodes: &Nodes<D>, [lambda_1, lambda_2]: [D; 2]) -> SliderLoads<D> {
    let Nodes { x1, xn, xm } = *nodes;
    SliderLoads { x1, xn, xm, lambda_1, lambda_2 }
}

impl Element<2, 9> for SliderElement {
    type Nodes<D: Scalar> = Nodes<D>;
    type State<D: Scalar> = ();

    fn check(&self, nodes: &Nodes<f64>, multipliers: &Vector2<f64>, (): &()) -> Result<(), Error> {
        check::<Constraint>(nodes)?;
        check::<Forces>(&loads(nodes, *multipliers.as_ref()))
    }

    fn smooth(&self) -> Self {
        Self
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &Nodes<D>,
        multipliers: &Vector2<D>,
        &(): &(),
    ) -> (Contribution<D, 2, 9>, ()) {
        let held = Constraint::eval(nodes);
        let (forces, SliderForces { force_1, force_n, force_m }) =
            Forces::linearized(&loads(nodes, *multipliers.as_ref()));
        let (by, places) = ([force_1, force_n, force_m], |by: SliderLoads<D>| [by.x1, by.xn, by.xm]);
        let found = Contribution::smooth(
            Vector2::new(held.g1, held.g2),
            Rows::eval(nodes).matrix(),
            forces.vector(),
            SMatrix::from_fn(|row, column| places(by[row / 3][row % 3])[column / 3][column % 3]),
        );
        (found, ())
    }
}

/// SLIDER in the plane, (x, y) or (r, z), as an element: the multiplier λ across the line, and the translations of nodes 1, n
/// and m.
///
/// Of an axisymmetric model λ is the force on the whole circumference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SliderElement2d;

fn loads_2d<D: Scalar>(nodes: &Nodes2d<D>, multiplier: &Vector1<D>) -> SliderLoads2d<D> {
    let Nodes2d { x1, xn, xm } = *nodes;
    SliderLoads2d { x1, xn, xm, lambda: multiplier.x }
}

impl Element<1, 6> for SliderElement2d {
    type Nodes<D: Scalar> = Nodes2d<D>;
    type State<D: Scalar> = ();

    fn check(&self, nodes: &Nodes2d<f64>, multiplier: &Vector1<f64>, (): &()) -> Result<(), Error> {
        check::<Constraint2d>(nodes)?;
        check::<slider_plane::Forces>(&loads_2d(nodes, multiplier))
    }

    fn smooth(&self) -> Self {
        Self
    }

    fn contribution<D: Scalar>(
        &self,
        nodes: &Nodes2d<D>,
        multiplier: &Vector1<D>,
        &(): &(),
    ) -> (Contribution<D, 1, 6>, ()) {
        let (forces, SliderForces2d { force_1, force_n, force_m }) =
            slider_plane::Forces::linearized(&loads_2d(nodes, multiplier));
        let (by, places) = ([force_1, force_n, force_m], |by: SliderLoads2d<D>| [by.x1, by.xn, by.xm]);
        let found = Contribution::smooth(
            Vector1::new(Constraint2d::eval(nodes).g),
            slider_plane::Rows::eval(nodes).vector().transpose(),
            forces.vector(),
            SMatrix::from_fn(|row, column| places(by[row / 2][row % 2])[column / 2][column % 2]),
        );
        (found, ())
    }
}
