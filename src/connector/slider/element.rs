//! SLIDER, in space and in a plane: translations of three nodes, no spins.
//!
//! Rows and forces are those of m on the line, and the stiffness is the derivative of these forces, wherever m is. With m on the
//! line it equals Σ λ ∂²g in every motion that satisfies the constraint; with m off the line, by the residual that Newton's
//! method has not yet closed, it keeps the convergence quadratic, which Σ λ ∂²g does not.

#[cfg(feature = "verify")]
mod proof;

use super::rows::{Forces, Rows, SliderForces, SliderLoads};
use super::rows_plane::{self, SliderForces2d, SliderLoads2d};
use crate::connector::slider::{Constraint, Constraint2d, Distance2d, Distances, Nodes, Nodes2d};
use crate::element::{Contribution, Element, Nothing, Parameters};
use crate::formula::error::Error;
use crate::formula::quantity::{
    SLIDER_LAMBDA, SLIDER_LAMBDA1, SLIDER_LAMBDA2, TRANSLATION_1, TRANSLATION_1_PLANE, TRANSLATION_M,
    TRANSLATION_M_PLANE, TRANSLATION_N, TRANSLATION_N_PLANE,
};
use crate::formula::{Component, Document, Field, Fields, Formula, Spec};
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector, Vector1, Vector2};

/// SLIDER as an element: multipliers λ1 and λ2 normal to the line, and the translations of nodes 1, n and m.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SliderElement;

/// SLIDER in the plane, (x, y) or (r, z), as an element: the multiplier λ normal to the line, and the translations of nodes 1, n
/// and m.
///
/// In an axisymmetric model λ is the force on the whole circumference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SliderElement2d;

const WHY: &str = "the page prints the constraint; the element is derived from it";

impl Element<2, 9> for SliderElement {
    const SPEC: Spec = Spec::new("slider", "SLIDER as an element", Document::SLIDER.ours("", WHY))
        .eta_of_value(8.0)
        .normwise_of_value(8.0)
        .not_objective();
    const UNKNOWNS: &'static [Field] =
        &[Field::new("u1", &TRANSLATION_1), Field::new("un", &TRANSLATION_N), Field::new("um", &TRANSLATION_M)];
    const FORCES: &'static [Field] = <SliderForces<f64> as Fields<f64>>::FIELDS;
    const RESIDUALS: &'static [Field] = <Distances<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] =
        &[Field::new("lambda_1", &SLIDER_LAMBDA1), Field::new("lambda_2", &SLIDER_LAMBDA2)];
    type Nodes<T: Component> = Nodes<T>;
    type Start<T: Component> = Nothing<T>;
    type Contact<T: Component> = Nothing<T>;
    type State<T: Component> = Nothing<T>;

    fn moved<D: Scalar>(&Nodes { x1, xn, xm }: &Nodes<D>, motions: &SVector<D, 9>) -> Nodes<D> {
        let [u1, un, um] = [0, 3, 6].map(|k| motions.fixed_rows::<3>(k));
        Nodes { x1: x1 + u1, xn: xn + un, xm: xm + um }
    }

    fn validate<D: Scalar>(nodes: &Nodes<D>, _: &Parameters<Self, D, 2, 9>) -> Result<(), Error> {
        Constraint::validate(nodes)
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes<D>,
        multipliers: &Vector2<D>,
        _: &Parameters<Self, D, 2, 9>,
        before: &Nothing<D>,
    ) -> (Contribution<D, 2, 9>, Nothing<D>) {
        let (Nodes { x1, xn, xm }, [lambda_1, lambda_2]) = (*nodes, *multipliers.as_ref());
        let held = Constraint::eval(nodes);
        let (forces, SliderForces { force_1, force_n, force_m }) =
            Forces::linearized(&SliderLoads { x1, xn, xm, lambda_1, lambda_2 });
        let (by, places) = ([force_1, force_n, force_m], |by: SliderLoads<D>| [by.x1, by.xn, by.xm]);
        let found = Contribution::smooth(
            Vector2::new(held.g1, held.g2),
            Rows::eval(nodes).matrix(),
            forces.vector(),
            SMatrix::from_fn(|row, column| places(by[row / 3][row % 3])[column / 3][column % 3]),
        );
        (found, *before)
    }
}

impl Element<1, 6> for SliderElement2d {
    const SPEC: Spec = Spec::new("slider_2d", "SLIDER in the plane as an element", Document::SLIDER.ours("", WHY))
        .eta_of_value(8.0)
        .normwise_of_value(8.0);
    const UNKNOWNS: &'static [Field] = &[
        Field::new("u1", &TRANSLATION_1_PLANE),
        Field::new("un", &TRANSLATION_N_PLANE),
        Field::new("um", &TRANSLATION_M_PLANE),
    ];
    const FORCES: &'static [Field] = <SliderForces2d<f64> as Fields<f64>>::FIELDS;
    const RESIDUALS: &'static [Field] = <Distance2d<f64> as Fields<f64>>::FIELDS;
    const MULTIPLIERS: &'static [Field] = &[Field::new("lambda", &SLIDER_LAMBDA)];
    type Nodes<T: Component> = Nodes2d<T>;
    type Start<T: Component> = Nothing<T>;
    type Contact<T: Component> = Nothing<T>;
    type State<T: Component> = Nothing<T>;

    fn moved<D: Scalar>(&Nodes2d { x1, xn, xm }: &Nodes2d<D>, motions: &SVector<D, 6>) -> Nodes2d<D> {
        let [u1, un, um] = [0, 2, 4].map(|k| motions.fixed_rows::<2>(k));
        Nodes2d { x1: x1 + u1, xn: xn + un, xm: xm + um }
    }

    fn validate<D: Scalar>(nodes: &Nodes2d<D>, _: &Parameters<Self, D, 1, 6>) -> Result<(), Error> {
        Constraint2d::validate(nodes)
    }

    fn contribution<D: Scalar>(
        nodes: &Nodes2d<D>,
        multiplier: &Vector1<D>,
        _: &Parameters<Self, D, 1, 6>,
        before: &Nothing<D>,
    ) -> (Contribution<D, 1, 6>, Nothing<D>) {
        let (Nodes2d { x1, xn, xm }, lambda) = (*nodes, multiplier.x);
        let (forces, SliderForces2d { force_1, force_n, force_m }) =
            rows_plane::Forces::linearized(&SliderLoads2d { x1, xn, xm, lambda });
        let (by, places) = ([force_1, force_n, force_m], |by: SliderLoads2d<D>| [by.x1, by.xn, by.xm]);
        let found = Contribution::smooth(
            Vector1::new(Constraint2d::eval(nodes).g),
            rows_plane::Rows::eval(nodes).vector().transpose(),
            forces.vector(),
            SMatrix::from_fn(|row, column| places(by[row / 2][row % 2])[column / 2][column % 2]),
        );
        (found, *before)
    }
}
