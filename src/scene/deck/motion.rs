//! Rotations in degrees and coordinates, computed in 237 bits and rounded once.

use crate::Octuple;
use crate::number::scalar::norm_and_direction;
use nalgebra::{Matrix3, Vector3};
use num_dual::DualNum;

type V = Vector3<Octuple>;

/// Sine and cosine of an angle in degrees; exact at multiples of 90°.
fn sin_cos(degrees: f64) -> (Octuple, Octuple) {
    // The remainder, the difference and the quotient are exact.
    let turned = degrees % 360.0;
    let quarters = (turned / 90.0).round();
    let rest = (Octuple::from(turned) - Octuple::from(quarters * 90.0)) * Octuple::PI / 180.0;
    let (sine, cosine) = (rest.sin(), rest.cos());
    match quarters.rem_euclid(4.0) {
        1.0 => (cosine, -sine),
        2.0 => (-sine, -cosine),
        3.0 => (-cosine, sine),
        _ => (sine, cosine),
    }
}

/// An angle in degrees, in radians.
pub(super) fn radians(degrees: f64) -> f64 {
    (Octuple::from(degrees) * Octuple::PI / 180.0).to_f64()
}

pub(super) fn exactly(v: [f64; 3]) -> V {
    Vector3::from(v.map(Octuple::from))
}

pub(super) fn rounded(v: V) -> [f64; 3] {
    // Without negative zeros.
    [0, 1, 2].map(|k| v[k].to_f64() + 0.0)
}

fn unit(v: V) -> V {
    Vector3::from(norm_and_direction(<[Octuple; 3]>::from(v)).1)
}

/// The rotation about a unit vector.
fn rotation(axis: &V, degrees: f64) -> Matrix3<Octuple> {
    let (sine, cosine) = sin_cos(degrees);
    let one = Octuple::from(1.0);
    let [x, y, z] = <[Octuple; 3]>::from(*axis);
    let zero = Octuple::from(0.0);
    let cross = Matrix3::new(zero, -z, y, z, zero, -x, -y, x, zero);
    Matrix3::from_diagonal_element(cosine) + cross * sine + axis * axis.transpose() * (one - cosine)
}

/// How an instance is placed: it is moved, then rotated about an axis.
#[derive(Clone)]
pub(super) struct Motion {
    by: [f64; 3],
    /// A point of the axis, and the rotation.
    turn: Option<(V, Matrix3<Octuple>)>,
}

impl Motion {
    /// Moved by a vector, then rotated about the axis from one point to another, by an angle in degrees; `None` if the points
    /// are the same.
    pub(super) fn new(by: [f64; 3], turn: Option<([f64; 3], [f64; 3], f64)>) -> Option<Self> {
        let Some((a, b, degrees)) = turn else { return Some(Self { by, turn: None }) };
        (a != b).then(|| {
            let axis = unit(exactly(b) - exactly(a));
            Self { by, turn: Some((exactly(a), rotation(&axis, degrees))) }
        })
    }

    pub(super) fn of_point(&self, point: [f64; 3]) -> [f64; 3] {
        let moved = exactly(point) + exactly(self.by);
        rounded(match &self.turn {
            None => moved,
            Some((a, rotation)) => a + rotation * (moved - a),
        })
    }

    fn of_direction(&self, direction: V) -> V {
        self.turn.as_ref().map_or(direction, |(_, rotation)| rotation * direction)
    }
}

/// A point in cylindrical coordinates: radius, angle in degrees, height.
pub(super) fn cylindrical([r, degrees, z]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = sin_cos(degrees);
    rounded(Vector3::new(cosine, sine, Octuple::from(0.0)) * Octuple::from(r) + exactly([0.0, 0.0, z]))
}

/// The first axis, and a vector in the plane of the first two; point a is on the first axis, or on the third, b in the plane of the
/// first and the second, or of the third and the first. Without a rotation they are the differences of the points.
pub(super) fn axes(
    [a, b, c]: [[f64; 3]; 3],
    on_third: bool,
    turn: Option<(usize, f64)>,
    motion: Option<&Motion>,
) -> [[f64; 3]; 2] {
    let [mut first, mut second] = [a, b].map(|point| exactly(point) - exactly(c));
    if on_third {
        let third = unit(first);
        second = unit(third.cross(&second));
        first = second.cross(&third);
    }
    if let Some((axis, degrees)) = turn {
        let first_unit = unit(first);
        let third = unit(first_unit.cross(&second));
        let triad = [first_unit, third.cross(&first_unit), third];
        let rotation = rotation(&triad[axis], degrees);
        [first, second] = [rotation * triad[0], rotation * triad[1]];
    }
    [first, second].map(|v| rounded(motion.map_or(v, |motion| motion.of_direction(v))))
}

/// The angle of the first axis in the plane, in radians; `None` if the axes are not in the plane, or the third points below it.
pub(super) fn angle([first, second]: [[f64; 3]; 2]) -> Option<f64> {
    let up = exactly(first).cross(&exactly(second));
    let is_flat = first[2] == 0.0 && second[2] == 0.0 && up.z > Octuple::from(0.0);
    is_flat.then(|| Octuple::from(first[1]).atan2(Octuple::from(first[0])).to_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let quarter = Motion::new([1.0, 0.0, 0.0], Some(([0.0; 3], [0.0, 0.0, 2.0], 90.0))).unwrap();
        assert_eq!(quarter.of_point([1.0, 0.5, 3.0]), [-0.5, 2.0, 3.0]);
        for (degrees, expected) in
            [(-90.0, [0.0, -1.0]), (180.0, [-1.0, 0.0]), (450.0, [0.0, 1.0]), (-720.0, [1.0, 0.0])]
        {
            assert_eq!(cylindrical([1.0, degrees, 0.5]), [expected[0], expected[1], 0.5], "{degrees}");
        }
        assert!(Motion::new([0.0; 3], Some(([1.0; 3], [1.0; 3], 90.0))).is_none());
    }

    #[test]
    fn coordinates_are_rounded_once() {
        assert_eq!(cylindrical([2.0, 30.0, 0.0]), [3.0_f64.sqrt(), 1.0, 0.0]);
        assert_eq!(cylindrical([1.0, 45.0, 0.0]), [0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0]);
        assert_eq!(radians(180.0), std::f64::consts::PI);
        assert_eq!(radians(60.0), std::f64::consts::FRAC_PI_3);
    }

    #[test]
    fn axes_are_those_of_the_points() {
        let points = [[3.0, 1.0, 1.0], [1.0, 4.0, 1.0], [1.0, 1.0, 1.0]];
        assert_eq!(axes(points, false, None, None), [[2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]);
        assert_eq!(axes(points, true, None, None), [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(axes(points, false, Some((0, 90.0)), None), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(axes(points, false, Some((2, 90.0)), None), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);
        assert_eq!(angle([[0.0, 2.0, 0.0], [-1.0, 0.0, 0.0]]), Some(std::f64::consts::FRAC_PI_2));
        assert_eq!(angle([[0.0, 2.0, 0.0], [1.0, 0.0, 0.0]]), None);
    }
}
