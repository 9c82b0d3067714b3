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
        rounded(self.moved(exactly(point)))
    }

    fn moved(&self, point: V) -> V {
        let moved = point + exactly(self.by);
        match &self.turn {
            None => moved,
            Some((a, rotation)) => a + rotation * (moved - a),
        }
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

/// How points give axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum System {
    /// Point a on the first axis, b in the plane of the first two.
    Rectangular,
    /// Point a on the third axis, b in the plane of the third and the first.
    ThirdRectangular,
    /// Both points on the third axis; the first is along the radius through the node.
    Cylindrical,
    /// Point a in the middle, b on the polar axis; the first is along the radius through the node, the second around the axis.
    Spherical,
}

/// The first axis, and a vector in the plane of the first two, of a system by the points a, b and the origin, at a node. Without a
/// rotation those of a rectangular system are the differences of the points.
pub(super) fn axes(
    points: [[f64; 3]; 3],
    system: System,
    node: [f64; 3],
    turn: Option<(usize, f64)>,
    motion: Option<&Motion>,
) -> [[f64; 3]; 2] {
    let [a, b, c] = points.map(exactly);
    let [mut first, mut second] = [a - c, b - c];
    if system == System::ThirdRectangular {
        let third = unit(first);
        second = unit(third.cross(&second));
        first = second.cross(&third);
    }
    let direction = |v| motion.map_or(v, |motion| motion.of_direction(v));
    if matches!(system, System::Cylindrical | System::Spherical) {
        let from = exactly(node) - motion.map_or(a, |motion| motion.moved(a));
        let axis = unit(direction(b - a));
        second = axis.cross(&from);
        first = if system == System::Cylindrical { second.cross(&axis) } else { from };
    } else {
        [first, second] = [first, second].map(direction);
    }
    if let Some((axis, degrees)) = turn {
        let first_unit = unit(first);
        let third = unit(first_unit.cross(&second));
        let triad = [first_unit, third.cross(&first_unit), third];
        let rotation = rotation(&triad[axis], degrees);
        [first, second] = [rotation * triad[0], rotation * triad[1]];
    }
    [first, second].map(rounded)
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
        let of = |system, turn, motion| axes(points, system, [5.0, 1.0, 4.0], turn, motion);
        let rectangular = |turn| of(System::Rectangular, turn, None);
        assert_eq!(rectangular(None), [[2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]);
        assert_eq!(rectangular(Some((0, 90.0))), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(rectangular(Some((2, 90.0))), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);
        assert_eq!(of(System::ThirdRectangular, None, None), [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        // About an axis through (1, 1, 1) along the third, of an instance that has turned by a right angle, and moved.
        let points = [[1.0, -1.0, 1.0], [1.0, -1.0, 3.0], [0.0; 3]];
        let moved = Motion::new([0.0, 0.0, 0.5], Some(([0.0; 3], [0.0, 0.0, 1.0], 90.0))).unwrap();
        let of = |system| axes(points, system, [1.0, 5.0, 4.5], None, Some(&moved));
        assert_eq!(of(System::Cylindrical), [[0.0, 4.0, 0.0], [-4.0, 0.0, 0.0]]);
        assert_eq!(of(System::Spherical), [[0.0, 4.0, 3.0], [-4.0, 0.0, 0.0]]);
        assert_eq!(angle([[0.0, 2.0, 0.0], [-1.0, 0.0, 0.0]]), Some(std::f64::consts::FRAC_PI_2));
        assert_eq!(angle([[0.0, 2.0, 0.0], [1.0, 0.0, 0.0]]), None);
    }
}
