//! A slider-crank with friction: the piston runs in a SLOT, whose normal force is that of the inclined rod. Newton's method
//! with the consistent tangent of the friction, and without the part that the constraint force has in it.
//! A verification example, and no solver to be grown. Needs no feature.
//!
//! ```sh
//! cargo run --example slider_crank
//! ```

use jointproof::connector::slot::plane::{Forces, PlaneLoads, PlanePlaces, Rows};
use jointproof::connector::slot::{Constraint2d, Friction, SlotLoads, SlotPositions2d};
use jointproof::contact::coulomb::{Response, Slid, Sliding};
use jointproof::formula::Formula;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use std::f64::consts::TAU;

/// The radius of the crank; length and stiffness of the rod.
const RADIUS: f64 = 1.0;
const ROD: f64 = 3.0;
const ROD_STIFFNESS: f64 = 200.0;
/// The force on the piston, along the slot.
const LOAD: f64 = -20.0;
/// The friction of the slot.
const MU: f64 = 0.3;
const STICK_STIFFNESS: f64 = 500.0;
/// The crank turns once in so many increments.
const INCREMENTS: u32 = 24;

/// The slot is along the first axis of the ground, and the piston begins at the far end of its way.
const ACROSS: Vector2<f64> = Vector2::new(0.0, 1.0);
const GROUND: Vector2<f64> = Vector2::new(0.0, 0.0);
const START: Vector2<f64> = Vector2::new(RADIUS + ROD, 0.0);

/// What is solved for: where the piston is, and the constraint force.
#[derive(Clone, Copy)]
struct State {
    piston: Vector2<f64>,
    f2: f64,
}

/// The force of the elastic rod on the piston, and its derivative by the place of the piston.
fn rod(piston: &Vector2<f64>, pin: &Vector2<f64>) -> (Vector2<f64>, Matrix2<f64>) {
    let length = (piston - pin).norm();
    let n = (piston - pin) / length;
    let along = n * n.transpose();
    let across = (Matrix2::identity() - along) * (1.0 - ROD / length);
    (n * ((ROD - length) * ROD_STIFFNESS), (along + across) * -ROD_STIFFNESS)
}

// ANCHOR: step
/// A step of Newton's method, and the friction, from the motion and the friction in the last state.
fn step(
    state: &State,
    pin: &Vector2<f64>,
    [u1_before, f_before]: [f64; 2],
    consistent: bool,
) -> (Vector3<f64>, [f64; 2]) {
    let State { piston, f2 } = *state;
    let places = PlanePlaces { e2a: ACROSS, xa: GROUND, xb: piston };
    let row = Rows::eval(&places).gy_ub;
    let held = Forces::eval(&PlaneLoads { e2a: ACROSS, xa: GROUND, xb: piston, f2 }).fb;
    let off = Constraint2d::eval(&SlotPositions2d { e2a: ACROSS, xa: GROUND, xb: piston, y0: 0.0 }).gy;

    let u1 = piston.x - START.x;
    let (friction, by_loads) = Friction::linearized(&SlotLoads { f1: 0.0, f2, f3: 0.0, fc_int: 0.0, mu: MU });
    let sliding = Sliding { du: u1 - u1_before, f_before, k_stick: STICK_STIFFNESS, mu: MU, r#fn: friction.r#fn };
    let (Slid { f: f1, .. }, Slid { f: by, .. }) = Response::linearized(&sliding);

    // f1 acts on the piston against the slot's axis, as it is conjugate to u1.
    let (rod, by_rod) = rod(&piston, pin);
    let force = rod + held + Vector2::new(LOAD - f1, 0.0);
    let mut matrix = Matrix3::zeros();
    matrix.fixed_view_mut::<2, 2>(0, 0).copy_from(&by_rod);
    matrix.fixed_view_mut::<2, 1>(0, 2).copy_from(&row);
    matrix.fixed_view_mut::<1, 2>(2, 0).copy_from(&row.transpose());
    matrix[(0, 0)] -= by.du;
    if consistent {
        matrix[(0, 2)] -= by.r#fn * by_loads.r#fn.f2;
    }
    let step = matrix.lu().solve(&-force.push(off)).expect("the rod holds the piston");
    (step, [u1, f1])
}
// ANCHOR_END: step

/// How many steps each increment of a turn takes.
pub fn steps(consistent: bool) -> Vec<u32> {
    let (mut state, mut before) = (State { piston: START, f2: 0.0 }, [0.0; 2]);
    let increments = (1..=INCREMENTS).map(|increment| {
        let angle = TAU * f64::from(increment) / f64::from(INCREMENTS);
        let pin = Vector2::new(angle.cos(), angle.sin()) * RADIUS;
        for count in 1..100 {
            let (step, after) = step(&state, &pin, before, consistent);
            state.piston += step.xy();
            state.f2 += step.z;
            if step.xy().amax() < 1e-13 {
                before = after;
                return count;
            }
        }
        100
    });
    increments.collect()
}

fn mean(steps: &[u32]) -> f64 {
    f64::from(steps.iter().sum::<u32>()) / f64::from(INCREMENTS)
}

fn main() {
    for (consistent, name) in [(true, "with"), (false, "without")] {
        let steps = steps(consistent);
        println!("{:.1} steps an increment {name} ∂(μ F_N)/∂f: {steps:?}", mean(&steps));
    }
}

#[cfg(test)]
mod tests {
    use super::{mean, steps};

    #[test]
    fn newton_needs_what_the_normal_force_does() {
        let [with, without] = [true, false].map(steps);
        assert!(with.iter().all(|&count| count <= 7), "{with:?}");
        assert!(mean(&without) > 2.0 * mean(&with), "{without:?} {with:?}");
    }
}
