//! Triads, and their rotation.

use crate::element::table::Number;
use crate::number::scalar::norm_and_direction;
use nalgebra::Vector3;

/// The orientation of a triad as given in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::scene) enum Orientation {
    /// The first axis, and a vector in the plane of the first two.
    Axes([f64; 3], [f64; 3]),
    /// Axis times angle.
    Rotation([f64; 3]),
    /// Real part first; it need not have length 1.
    Quaternion([f64; 4]),
}

/// The vectors of a triad.
pub(in crate::scene) type Axes<T> = [Vector3<T>; 3];

/// A vector of exact doubles, converted to this number type.
pub(in crate::scene) fn exactly<T: Number>(v: [f64; 3]) -> Vector3<T> {
    Vector3::from(v.map(T::exactly))
}

fn unit<T: Number>(v: Vector3<T>) -> Vector3<T> {
    Vector3::from(norm_and_direction(<[T; 3]>::from(v)).1)
}

pub(in crate::scene) fn global<T: Number>() -> Axes<T> {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(exactly)
}

impl Orientation {
    pub(in crate::scene) fn axes<T: Number>(&self) -> Axes<T> {
        match *self {
            Self::Axes(first, second) => {
                let e1 = unit(exactly(first));
                let e3 = unit(e1.cross(&exactly(second)));
                [e1, e3.cross(&e1), e3]
            }
            Self::Rotation(rotation) => turned(&global(), rotation),
            Self::Quaternion(q) => {
                let [w, x, y, z] = norm_and_direction(q.map(T::exactly)).1;
                let v = Vector3::new(x, y, z);
                global().map(|e: Vector3<T>| {
                    let t = v.cross(&e) * (T::one() * 2.0);
                    e + t * w + v.cross(&t)
                })
            }
        }
    }
}

/// A triad rotated by a rotation vector (Rodrigues' formula, with 1 − cos θ as 2 sin² θ/2).
pub(in crate::scene) fn turned<T: Number>(axes: &Axes<T>, rotation: [f64; 3]) -> Axes<T> {
    if rotation == [0.0; 3] {
        return *axes;
    }
    let (angle, axis) = norm_and_direction(rotation.map(T::exactly));
    let axis = Vector3::from(axis);
    let (sine, half) = (angle.sin(), (angle * 0.5).sin());
    let versine = half * half * 2.0;
    axes.map(|e| {
        let across = axis.cross(&e);
        e + across * sine + axis.cross(&across) * versine
    })
}
