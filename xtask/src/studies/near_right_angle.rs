//! The errors of both forms of β near 90°.

use jointproof::Octuple;
use jointproof::element::cardan::{CardanAngles, Triads, accurate, rotation, turned};
use jointproof::formula::value;
use jointproof::number::scalar::abs;
use nalgebra::Vector3;

/// The results of both forms of β for triads that are rotations rounded to doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NearRightAngle {
    /// 90° − β, in radians.
    pub(crate) distance: f64,
    /// The largest relative error of the arc sine, if it exists.
    pub(crate) arc_sine: f64,
    /// The fraction of the poses in which rounding made |e1a·e3b| > 1, so that there is no arc sine.
    pub(crate) rejected: f64,
    /// The largest relative error of the two-argument form.
    pub(crate) two_argument: f64,
}

/// The errors of both forms of β at each of these distances from 90°, the largest over 64 poses: the figure in the book.
pub(crate) fn errors_near_right_angle(distances: &[f64]) -> Vec<NearRightAngle> {
    distances.iter().map(|&distance| errors_at(distance)).collect()
}

fn errors_at(distance: f64) -> NearRightAngle {
    let beta = Octuple::PI / 2.0 - distance;
    let error = |found: f64| abs((Octuple::from(found) - beta) / beta).to_f64();

    let mut worst = NearRightAngle { distance, arc_sine: 0.0, rejected: 0.0, two_argument: 0.0 };
    for pose in poses(beta) {
        let triads = rounded_triads(pose);
        worst.two_argument = worst.two_argument.max(error(accurate(&triads).beta));
        match value::<CardanAngles>(&triads) {
            Ok(angles) => worst.arc_sine = worst.arc_sine.max(error(angles.beta)),
            Err(_) => worst.rejected += 1.0 / 64.0,
        }
    }
    worst
}

/// Eight α by eight γ, over the full circle.
fn poses(beta: Octuple) -> impl Iterator<Item = [Octuple; 3]> {
    let turns = (0..8).map(|k| Octuple::from(-2.75) + f64::from(k) * 0.75);
    turns.clone().flat_map(move |alpha| turns.clone().map(move |gamma| [alpha, beta, gamma]))
}

/// Triads with these angles relative to each other, neither along the global axes, every component rounded once.
fn rounded_triads([alpha, beta, gamma]: [Octuple; 3]) -> Triads<f64> {
    let global = [Vector3::x(), Vector3::y(), Vector3::z()];
    let a = turned(&global, &rotation(alpha, gamma * 0.25, gamma - alpha));
    let b = turned(&a, &rotation(alpha, beta, gamma));
    let [a, b] = [a, b].map(|triad| triad.map(|e| e.map(Octuple::to_f64)));
    Triads::new(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_go_all_around_in_equal_steps() {
        let all: Vec<_> = poses(Octuple::from(1.5)).map(|pose| pose.map(Octuple::to_f64)).collect();
        let steps = [-2.75, -2.0, -1.25, -0.5, 0.25, 1.0, 1.75, 2.5];
        let expected = steps.iter().flat_map(|&alpha| steps.iter().map(move |&gamma| [alpha, 1.5, gamma]));
        assert_eq!(all, expected.collect::<Vec<_>>());
    }

    /// Far from 90° both forms keep all digits; very close to 90° the arc sine keeps half of them or none.
    #[test]
    fn the_arc_sine_loses_half_of_the_digits_and_then_all() {
        let [far, near] = [0.5, 1e-9].map(errors_at);
        assert_eq!((far.distance, far.rejected), (0.5, 0.0));
        assert!(far.arc_sine > 0.0 && far.arc_sine < 1e-15, "{far:?}");
        assert!(far.two_argument > 0.0 && far.two_argument < 1e-15, "{far:?}");
        assert!(near.arc_sine > 1e-9 && near.arc_sine < 1e-7 && near.two_argument < 1e-15, "{near:?}");
        // Rounding makes about every other sine exceed 1.
        assert_eq!(near.rejected, 31.0 / 64.0);
    }
}
