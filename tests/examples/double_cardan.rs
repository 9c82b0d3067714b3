//! A double cardan shaft: two UJOINTs, with an intermediate shaft that is inclined to the parallel shafts at its ends. Kinematics
//! alone: the constraints determine every position, so that a step of Newton's method needs their rows and nothing else. Needs no
//! feature.
//!
//! ```sh
//! cargo run --example double_cardan
//! ```

use jointproof::connector::ujoint::{UJointElement, UJointStart, UJointState};
use jointproof::element::offset::Arms;
use jointproof::element::{Contribution, Nodes, Parameters};
use nalgebra::{Rotation3, SMatrix, SVector, Vector3, Vector4};
use std::f64::consts::TAU;

/// Both joints: two points in one place, two pins at right angles.
const JOINT: Parameters<UJointElement, f64, 4> = Parameters {
    start: UJointStart { d0: Vector3::new(0.0, 0.0, 0.0), c0: 0.0, alpha0: 0.0, gamma0: 0.0 },
    contact: None,
};
/// The shafts lie along their second axes; the intermediate one is so long.
const SHAFT: Vector3<f64> = Vector3::new(0.0, 2.0, 0.0);
/// The angle between the intermediate shaft and the others: 40°.
const BETA: f64 = TAU / 9.0;

/// How the yokes of the intermediate shaft are mounted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Yokes {
    /// Its pins are parallel: the second joint cancels the non-uniformity of the first.
    InPhase,
    /// Its pins are at right angles: the second joint doubles it.
    Crossed,
}

/// One position of the shafts.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    /// The angle of the driving shaft.
    pub input: f64,
    /// The angle of the driven shaft.
    pub output: f64,
    /// The number of Newton steps, and the last two of them.
    pub steps: (usize, [f64; 2]),
}

fn axes(turn: &Rotation3<f64>) -> [Vector3<f64>; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turn * axis)
}

/// What can move: the intermediate shaft, by its end at the first joint, and the driven shaft, which turns and slides in its
/// bearing.
struct Shafts {
    end: Vector3<f64>,
    turn: Rotation3<f64>,
    driven: Vector3<f64>,
    output: f64,
}

impl Shafts {
    /// Both joints, as they are when the driving shaft has turned by an angle.
    // ANCHOR: joints
    fn joints(&self, yokes: Yokes, input: f64) -> [Contribution<f64, 4>; 2] {
        let [driving, driven] = [input, self.output].map(|angle| axes(&Rotation3::new(Vector3::y() * angle)));
        let (middle, arm) = (axes(&self.turn), self.turn * SHAFT);
        let (origin, none) = (Vector3::zeros(), Vector3::zeros());
        let first = Nodes::new([driving, middle], [origin, self.end]);
        // The pins are e1 of node a and e3 of node b.
        let (second, arms) = match yokes {
            Yokes::InPhase => (Nodes::new([driven, middle], [self.driven, self.end + arm]), Arms { a: none, b: arm }),
            Yokes::Crossed => (Nodes::new([middle, driven], [self.end + arm, self.driven]), Arms { a: arm, b: none }),
        };
        let state = UJointState { ur1: 0.0, ur3: 0.0, m1: 0.0, m3: 0.0 };
        let at = |nodes| JOINT.newton(&nodes, &Vector4::zeros(), &state).expect("the shafts are finite").0;
        [at(first), at(second).on_arms(&arms)]
    }
    // ANCHOR_END: joints

    /// A step of Newton's method: eight conditions for the six motions of the intermediate shaft, and the slide and the turn of the
    /// driven one. Its size.
    fn step(&mut self, yokes: Yokes, input: f64) -> f64 {
        let [first, second] = self.joints(yokes, input);
        let (middle, driven) = if yokes == Yokes::InPhase { (6, 0) } else { (0, 6) };
        let (mut rows, mut residuals) = (SMatrix::<f64, 8, 8>::zeros(), SVector::<f64, 8>::zeros());
        residuals.fixed_rows_mut::<4>(0).copy_from(&first.residuals);
        residuals.fixed_rows_mut::<4>(4).copy_from(&second.residuals);
        rows.fixed_view_mut::<4, 6>(0, 0).copy_from(&first.rows.fixed_columns::<6>(6));
        rows.fixed_view_mut::<4, 6>(4, 0).copy_from(&second.rows.fixed_columns::<6>(middle));
        // Along and about the second axis.
        rows.fixed_view_mut::<4, 1>(4, 6).copy_from(&second.rows.column(driven + 1));
        rows.fixed_view_mut::<4, 1>(4, 7).copy_from(&second.rows.column(driven + 4));
        let step = rows.lu().solve(&-residuals).expect("at 40° no position is singular");
        self.end += step.fixed_rows::<3>(0);
        self.turn = Rotation3::new(step.fixed_rows::<3>(3).into_owned()) * self.turn;
        self.driven.y += step[6];
        self.output += step[7];
        step.amax()
    }
}

/// A revolution of the driving shaft, in equal increments.
///
/// # Panics
/// Never: no position of this example is singular.
pub fn revolution(yokes: Yokes, increments: u32) -> Vec<Position> {
    let turn = Rotation3::new(Vector3::x() * BETA);
    let mut shafts = Shafts { end: Vector3::zeros(), turn, driven: turn * SHAFT, output: 0.0 };
    let position = |increment: u32| {
        let input = TAU * f64::from(increment) / f64::from(increments);
        let (mut count, mut sizes) = (0, [f64::INFINITY; 2]);
        while sizes[1] > 1e-13 && count < 20 {
            sizes = [sizes[1], shafts.step(yokes, input)];
            count += 1;
        }
        Position { input, output: shafts.output, steps: (count, sizes) }
    };
    (0..=increments).map(position).collect()
}

fn main() {
    for yokes in [Yokes::InPhase, Yokes::Crossed] {
        println!("yokes {yokes:?}: driven against driving angle, in degrees");
        for Position { input, output, steps: (count, _) } in revolution(yokes, 12) {
            println!("  {:5.1} {:9.4}  ({count} steps)", input.to_degrees(), output.to_degrees());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BETA, Yokes, revolution};

    #[test]
    fn in_phase_the_driven_shaft_turns_as_the_driving_one() {
        for position in revolution(Yokes::InPhase, 24) {
            assert!((position.output - position.input).abs() < 1e-13, "{position:?}");
        }
    }

    /// From this start each joint alone gives tan θ₂ = tan θ₁ cos β; both in the same sense give cos² β.
    #[test]
    fn crossed_both_joints_add_their_non_uniformity() {
        for position in revolution(Yokes::Crossed, 24) {
            let (sine, cosine) = position.input.sin_cos();
            let expected = (sine * BETA.cos().powi(2)).atan2(cosine);
            let off = (position.output - expected).rem_euclid(std::f64::consts::TAU);
            assert!(off.min(std::f64::consts::TAU - off) < 1e-13, "{position:?}, {expected}");
        }
    }

    #[test]
    fn the_error_is_squared() {
        for yokes in [Yokes::InPhase, Yokes::Crossed] {
            for position in revolution(yokes, 24) {
                let (count, [before, last]) = position.steps;
                assert!(count <= 7 && last < 10.0 * before * before + 1e-15, "{position:?}");
            }
        }
    }
}
