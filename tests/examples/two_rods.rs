//! Two rods, one hung on the other, by UJOINTs: where forces and springs take them, by Newton's method with multipliers.
//! A verification example, dense and small, not a solver to be grown. Needs no feature.
//!
//! ```sh
//! cargo run --example two_rods
//! ```

use jointproof::connector::ujoint::{UJointElement, UJointStart, UJointState};
use jointproof::element::offset::Arms;
use jointproof::element::{Contribution, Nodes, Parameters};
use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3, Vector4};

/// The ground and both rods with six degrees of freedom each, then four multipliers for each joint.
const ALL: usize = 26;
const FIRST_MULTIPLIER: usize = 18;
/// The ground stands still; what is solved for begins behind it.
const FREE: usize = ALL - 6;

/// A rod lies along the second axis of its triad, from −1 to 1.
const END: Vector3<f64> = Vector3::new(0.0, 1.0, 0.0);
/// The springs that hold the middle of each rod where it begins.
const SPRING: f64 = 6.0;

/// The joint of both rods: it holds points in one place and two axes at right angles, and does not rub.
const JOINT: Parameters<UJointElement, f64, 4> = Parameters {
    start: UJointStart { d0: Vector3::new(0.0, 0.0, 0.0), c0: 0.0, alpha0: 0.0, gamma0: 0.0 },
    contact: None,
};

/// A body: where its node is and how it is turned, and the force on it.
#[derive(Clone, Copy)]
struct Body {
    x: Vector3<f64>,
    turn: Rotation3<f64>,
    start: Vector3<f64>,
    force: Vector3<f64>,
}

impl Body {
    fn new(start: Vector3<f64>, force: Vector3<f64>) -> Self {
        Self { x: start, turn: Rotation3::identity(), start, force }
    }

    fn triad(&self) -> [Vector3<f64>; 3] {
        [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| self.turn * axis)
    }

    // ANCHOR: step
    /// Moves the node, and turns it by a spin, in front of what it is turned by.
    fn step(&mut self, step: &[f64]) {
        self.x += Vector3::from_column_slice(&step[..3]);
        self.turn = Rotation3::new(Vector3::from_column_slice(&step[3..6])) * self.turn;
    }
    // ANCHOR_END: step
}

// ANCHOR: joint
/// What the joint between the end of a, or the ground itself, and the beginning of b gives to the equations of both.
fn joint(a: &Body, end: Vector3<f64>, b: &Body, multipliers: &Vector4<f64>) -> Contribution<f64, 4> {
    let arms = Arms { a: a.turn * end, b: b.turn * -END };
    let nodes = Nodes::new([a.triad(), b.triad()], [a.x + arms.a, b.x + arms.b]);
    let state = UJointState { ur1: 0.0, ur3: 0.0, m1: 0.0, m3: 0.0 };
    let (at_points, _) = JOINT.newton(&nodes, multipliers, &state).expect("two bodies are in reach of each other");
    at_points.on_arms(&arms)
}
// ANCHOR_END: joint

/// The largest translation or spin of every step, until it is below 1e-13.
///
/// # Panics
/// Never: the matrix of this example is regular.
pub fn steps(with_stiffness: bool) -> Vec<f64> {
    let mut bodies = [
        Body::new(Vector3::zeros(), Vector3::zeros()),
        Body::new(Vector3::new(0.0, 1.0, 0.0), Vector3::new(2.0, 0.0, -1.0)),
        Body::new(Vector3::new(0.0, 3.0, 0.0), Vector3::new(1.0, -3.0, 3.0)),
    ];
    let mut multipliers = [Vector4::zeros(); 2];
    let mut sizes = Vec::new();
    while sizes.len() < 100 && sizes.last().is_none_or(|&size| size > 1e-13) {
        let (mut matrix, mut right) = (SMatrix::<f64, ALL, ALL>::zeros(), SVector::<f64, ALL>::zeros());
        for (k, body) in bodies.iter().enumerate() {
            let mut block = matrix.fixed_view_mut::<3, 3>(6 * k, 6 * k);
            block -= Matrix3::identity() * SPRING;
            let mut force = right.fixed_rows_mut::<3>(6 * k);
            force += body.force - (body.x - body.start) * SPRING;
        }
        // ANCHOR: assembly
        for (k, multipliers) in multipliers.iter().enumerate() {
            let end = if k == 0 { Vector3::zeros() } else { END };
            let given = joint(&bodies[k], end, &bodies[k + 1], multipliers);
            let (first, multiplier) = (6 * k, FIRST_MULTIPLIER + 4 * k);
            let mut acting = right.fixed_rows_mut::<12>(first);
            acting += given.forces;
            right.fixed_rows_mut::<4>(multiplier).copy_from(&given.residuals);
            matrix.fixed_view_mut::<4, 12>(multiplier, first).copy_from(&given.rows);
            matrix.fixed_view_mut::<12, 4>(first, multiplier).copy_from(&given.by_multipliers);
            if with_stiffness {
                let mut block = matrix.fixed_view_mut::<12, 12>(first, first);
                block += given.stiffness;
            }
        }
        // ANCHOR_END: assembly
        let free = matrix.fixed_view::<FREE, FREE>(6, 6).into_owned();
        let step = free.lu().solve(&-right.fixed_rows::<FREE>(6).into_owned()).expect("the springs hold every body");
        for (k, body) in bodies.iter_mut().skip(1).enumerate() {
            body.step(&step.as_slice()[6 * k..]);
        }
        for (k, multipliers) in multipliers.iter_mut().enumerate() {
            *multipliers += step.fixed_rows::<4>(FIRST_MULTIPLIER - 6 + 4 * k);
        }
        sizes.push(step.fixed_rows::<12>(0).amax());
    }
    sizes
}

fn main() {
    for (with_stiffness, name) in [(true, "with"), (false, "without")] {
        let steps = steps(with_stiffness);
        println!("{} steps {name} the geometric stiffness:", steps.len());
        for step in steps {
            println!("  {step:.1e}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::steps;

    /// Each of the last steps is in proportion to the square of the one before, down to rounding.
    #[test]
    fn with_the_geometric_stiffness_the_error_is_squared() {
        let steps = steps(true);
        assert!(steps.len() <= 8, "{steps:?}");
        for pair in steps.windows(2).filter(|pair| pair[0] < 0.1) {
            assert!(pair[1] < 4.0 * pair[0] * pair[0] + 1e-15, "{steps:?}");
        }
    }

    /// Without it each is the same part of the one before.
    #[test]
    fn without_it_the_convergence_is_linear() {
        let steps = steps(false);
        assert!((15..100).contains(&steps.len()), "{steps:?}");
        for pair in steps.windows(2).filter(|pair| pair[0] < 1e-2 && pair[1] > 1e-12) {
            let part = pair[1] / pair[0];
            assert!((0.1..0.4).contains(&part), "{steps:?}");
        }
    }
}
