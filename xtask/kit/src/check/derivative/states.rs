//! The states at which a derivative is compared, and the points around each.

use super::super::random::Random;
use super::quotients::{FIRST, STEPS};
use super::spec::{Routine, Spec, Turning};

/// A state.
pub(super) struct State {
    pub(super) name: String,
    pub(super) x: Vec<f64>,
}

/// How far the states around the given one are, in parts of the sizes.
const AROUND: [f64; 6] = [0.01, 0.03, 0.1, 0.01, 0.03, 0.1];

/// The given state, states around it, and for an element that at rest.
pub(super) fn states(spec: &Spec) -> Vec<State> {
    let sizes = spec.sizes();
    let mut random = Random::new();
    let mut states = vec![State { name: "the given state".into(), x: spec.at.clone() }];
    for (k, &distance) in AROUND.iter().enumerate() {
        let x = spec.at.iter().zip(&sizes).map(|(x, size)| x + distance * size * random.next()).collect();
        states.push(State { name: format!("state {} around it", k + 1), x });
    }
    if matches!(spec.routine, Routine::Uel | Routine::Uelmat) && spec.at.iter().any(|&u| u != 0.0) {
        states.push(State { name: "U = 0".into(), x: vec![0.0; spec.at.len()] });
    }
    states
}

/// The points on both sides of a state along an input, at every step, with the steps.
pub(super) struct Line {
    pub(super) steps: Vec<[f64; 2]>,
    pub(super) points: Vec<[Vec<f64>; 2]>,
}

/// The points along an input; of a rotation by spins or by components.
pub(super) fn line(spec: &Spec, x: &[f64], input: usize, turning: Turning) -> Line {
    let size = spec.sizes()[input];
    let mut line = Line { steps: Vec::new(), points: Vec::new() };
    let mut step = binade(size * FIRST);
    for _ in 0..STEPS {
        let moved = |step: f64| match spec.rotation(input) {
            Some((triple, place)) if turning == Turning::Spin => spun(x, triple, place, step),
            _ => {
                let mut x = x.to_vec();
                x[input] += step;
                x
            }
        };
        let points = [moved(step), moved(-step)];
        let taken = match (spec.rotation(input), turning) {
            (Some(_), Turning::Spin) => [step, step],
            _ => [points[0][input] - x[input], x[input] - points[1][input]],
        };
        line.steps.push(taken);
        line.points.push(points);
        step /= 2.0;
    }
    line
}

/// The largest power of two that is not above a number.
fn binade(x: f64) -> f64 {
    x.log2().floor().exp2()
}

/// A rotation followed by a rotation by this angle about an axis of space.
fn spun(x: &[f64], triple: [usize; 3], place: usize, angle: f64) -> Vec<f64> {
    let theta = triple.map(|dof| x[dof]);
    let mut axis = [0.0; 3];
    axis[place] = angle;
    let [a, b] = [quaternion(axis), quaternion(theta)];
    let product = multiplied(a, b);
    let found = nearest(product, theta);
    let mut x = x.to_vec();
    for (dof, component) in triple.into_iter().zip(found) {
        x[dof] = component;
    }
    x
}

/// The matrix of a rotation vector, row by row.
pub(in crate::check) fn rotation(theta: [f64; 3]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = quaternion(theta);
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// The scalar part comes first.
fn quaternion(theta: [f64; 3]) -> [f64; 4] {
    let angle = norm(theta);
    let part = if angle > 0.0 { (angle / 2.0).sin() / angle } else { 0.5 };
    [(angle / 2.0).cos(), part * theta[0], part * theta[1], part * theta[2]]
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

fn multiplied([a0, a1, a2, a3]: [f64; 4], [b0, b1, b2, b3]: [f64; 4]) -> [f64; 4] {
    [
        a0 * b0 - a1 * b1 - a2 * b2 - a3 * b3,
        a0 * b1 + a1 * b0 + a2 * b3 - a3 * b2,
        a0 * b2 + a2 * b0 + a3 * b1 - a1 * b3,
        a0 * b3 + a3 * b0 + a1 * b2 - a2 * b1,
    ]
}

/// Of the rotation vectors of a quaternion the one that is nearest to another.
fn nearest([scalar, x, y, z]: [f64; 4], to: [f64; 3]) -> [f64; 3] {
    let length = norm([x, y, z]);
    if length <= 0.0 {
        return [0.0; 3];
    }
    let axis = [x / length, y / length, z / length];
    let angle = 2.0 * length.atan2(scalar);
    let along = axis[0] * to[0] + axis[1] * to[1] + axis[2] * to[2];
    let turn = std::f64::consts::TAU;
    let angle = angle + turn * ((along - angle) / turn).round();
    axis.map(|component| component * angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rotation about its own axis adds angles, beyond half a turn and a turn, too.
    #[test]
    fn a_spin_about_the_axis_of_a_rotation_adds() {
        for angle in [0.0, 1e-9, 0.5, 3.0, 3.5, 6.5, -4.0] {
            let x = [7.0, 0.0, angle, 0.0];
            let found = spun(&x, [1, 2, 3], 1, 0.25);
            for (found, expected) in found.iter().zip([7.0, 0.0, angle + 0.25, 0.0]) {
                assert!((found - expected).abs() < 1e-14, "{angle}: {found} {expected}");
            }
        }
    }

    /// Quarter turns about x and then about y are a third of a turn about the diagonal (1, 1, -1).
    #[test]
    fn a_spin_follows_the_rotation() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let found = spun(&[quarter, 0.0, 0.0], [0, 1, 2], 1, quarter);
        let each = std::f64::consts::TAU / 3.0 / 3.0_f64.sqrt();
        for (found, expected) in found.iter().zip([each, each, -each]) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
}
