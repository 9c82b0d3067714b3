//! Evidence for the formulas of the parent module: cases, laws.

use super::{Forces, GeometricStiffness, PlaneForces, PlaneLoads, PlanePlaces, Rows, left};
use crate::Octuple;
use crate::connector::slot::{Constraint2d, SlotPositions2d};
use crate::element::motion::{Moving, still};
use crate::formula::Formula;
use crate::formula::proof::{Case, Equation, Law, Proved, hard, law};
use nalgebra::{Vector2, Vector6};
use num_dual::Dual;
use num_traits::{One, Zero};

type Vector = Vector2<Octuple>;

/// The axis of a and the positions of both nodes, moved by a motion of the six degrees of freedom.
fn moved(i: &PlanePlaces<Octuple>, motion: &Vector6<Octuple>) -> PlanePlaces<Moving> {
    let with = |v: Vector, change: Vector| v.zip_map(&change, Dual::new);
    PlanePlaces {
        e2a: with(i.e2a, left(&i.e2a) * motion[2]),
        xa: with(i.xa, Vector2::new(motion[0], motion[1])),
        xb: with(i.xb, Vector2::new(motion[3], motion[4])),
    }
}

/// A unit motion of each of the six degrees of freedom alone.
fn alone() -> [Vector6<Octuple>; 6] {
    std::array::from_fn(|k| Vector6::from_fn(|j, _| if j == k { Octuple::one() } else { Octuple::zero() }))
}

/// The motion of both nodes as one rigid body with a unit spin about node a.
fn turn(xa: Vector, xb: Vector) -> Vector6<Octuple> {
    let (one, zero, ub) = (Octuple::one(), Octuple::zero(), left(&(xb - xa)));
    Vector6::new(zero, zero, one, ub.x, ub.y, one)
}

fn places() -> Vec<Case<PlanePlaces<f64>>> {
    let [_, e2a] = hard::plane_triad();
    let axes = PlanePlaces { e2a: Vector2::y(), xa: Vector2::new(1.0, 2.0), xb: Vector2::new(4.0, 6.0) };
    let mut cases = vec![
        Case::running("d = (3, 4), (-1, 0)·d = -3", axes),
        Case::hand("in-one-place", "no distance, no moment", PlanePlaces { xb: axes.xa, ..axes }),
    ];
    cases.extend(hard::places().into_iter().map(|place| {
        let [xa, xb] = place.value;
        Case::hard(place.id, place.comment, PlanePlaces { e2a, xa, xb })
    }));
    cases
}

fn loads() -> Vec<Case<PlaneLoads<f64>>> {
    let with = |case: Case<PlanePlaces<f64>>| {
        let PlanePlaces { e2a, xa, xb } = case.inputs;
        Case::new(case.flag, case.id, case.comment, PlaneLoads { e2a, xa, xb, f2: -3.0 })
    };
    let mut cases: Vec<_> = places().into_iter().map(with).collect();
    let here = cases[0].inputs;
    cases.extend(hard::norms().into_iter().map(|load| {
        let [f2] = load.value;
        Case::hard(format!("force-{}", load.id), "a force of extreme size", PlaneLoads { f2, ..here })
    }));
    cases
}

/// The vectors are equal, relative to the sizes of forces and of moments.
fn equal(left: &Vector6<Octuple>, right: &Vector6<Octuple>, [force, moment]: [Octuple; 2]) -> Vec<Equation> {
    let size = |k: usize| if k % 3 == 2 { moment } else { force };
    (0..6).flat_map(|k| law::equal_with(left[k], right[k], size(k))).collect()
}

fn length(v: Vector) -> Octuple {
    crate::number::scalar::norm([v.x, v.y])
}

impl Proved for Rows {
    fn cases() -> Vec<Case<PlanePlaces<f64>>> {
        places()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the residual with respect to translations and spins", |i| {
                let residual = |motion: &Vector6<Octuple>| {
                    let PlanePlaces { e2a, xa, xb } = moved(i, motion);
                    Constraint2d::eval(&SlotPositions2d { e2a, xa, xb, y0: still(Octuple::zero()) }).gy
                };
                let derivative = Vector6::from_row_slice(&alone().map(|motion| residual(&motion).eps));
                equal(&Self::eval(i).vector(), &derivative, [length(i.e2a), length(i.xb - i.xa)])
            }),
            Law::<Self>::new("it does no work in a rigid-body motion", |i| {
                let row = Self::eval(i).vector();
                let turned = law::vanish([row.dot(&turn(i.xa, i.xb))], length(i.xb - i.xa));
                [law::equal_all([(row[0], -row[3]), (row[1], -row[4])]), turned].concat()
            }),
        ]
    }
}

/// The sizes of the terms of forces and of moments.
fn sizes(i: &PlaneLoads<Octuple>) -> [Octuple; 2] {
    let force = length(i.force());
    [force, force * length(i.xb - i.xa)]
}

impl Proved for Forces {
    fn cases() -> Vec<Case<PlaneLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the row times the multiplier", |i| {
                let PlaneLoads { e2a, xa, xb, f2 } = *i;
                let row = Rows::eval(&PlanePlaces { e2a, xa, xb }).vector();
                equal(&Self::eval(i).vector(), &(row * f2), sizes(i))
            }),
            Law::<Self>::new("forces and moments on both nodes balance", |i| {
                let PlaneForces { fa, ma, fb } = Self::eval(i);
                let balance = law::equal_all([(fa.x, -fb.x), (fa.y, -fb.y)]);
                [balance, law::vanish([ma + (i.xb - i.xa).perp(&fb)], sizes(i)[1])].concat()
            }),
        ]
    }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<PlaneLoads<f64>>> {
        loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the nodal forces with respect to translations and spins", |i| {
                let matrix = Self::eval(i).matrix();
                let columns = alone().into_iter().enumerate().flat_map(|(k, motion)| {
                    let PlanePlaces { e2a, xa, xb } = moved(&PlanePlaces { e2a: i.e2a, xa: i.xa, xb: i.xb }, &motion);
                    let forces = Forces::eval(&PlaneLoads { e2a, xa, xb, f2: still(i.f2) }).vector();
                    equal(&matrix.column(k).into_owned(), &forces.map(|force| force.eps), sizes(i))
                });
                columns.collect()
            }),
            Law::<Self>::new("it is symmetric: there is one axis to turn about", |i| {
                let matrix = Self::eval(i).matrix();
                law::equal_all(matrix.iter().copied().zip(matrix.transpose().iter().copied()))
            }),
            Law::<Self>::new("where both nodes turn as one body, forces turn with them and the moment stays", |i| {
                let PlaneForces { fa, fb, .. } = Forces::eval(i);
                let ([fa, fb], zero) = ([left(&fa), left(&fb)], Octuple::zero());
                let turned = Vector6::new(fa.x, fa.y, zero, fb.x, fb.y, zero);
                equal(&(Self::eval(i).matrix() * turn(i.xa, i.xb)), &turned, sizes(i))
            }),
        ]
    }
}
