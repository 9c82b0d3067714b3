//! The state that the chapter on SLIDER follows from the line to the increment of node m: n = (0.6, 0.48, 0.64), l = 25,
//! t1 = (0, 0.8, −0.6) and t2 = (−0.8, 0.36, 0.48). Node m starts beside the line; with its third coordinate retained it is half-way
//! between the ends.

use nalgebra::{Vector2, Vector3};

/// Node 1.
pub(crate) const X1: Vector3<f64> = Vector3::new(1.0, 1.0, 1.0);
/// Node n.
pub(crate) const XN: Vector3<f64> = Vector3::new(16.0, 13.0, 17.0);
/// Node m, not on the line.
pub(crate) const BESIDE: Vector3<f64> = Vector3::new(9.0, 8.0, 9.0);
/// Node m on the line, with the same third coordinate.
pub(crate) const XM: Vector3<f64> = Vector3::new(8.5, 7.0, 9.0);
/// Node m on the line, at a quarter: half-way some derivatives of the forces would vanish.
pub(crate) const QUARTER: Vector3<f64> = Vector3::new(4.75, 4.0, 5.0);
/// The motion of node 1.
pub(crate) const DX1: Vector3<f64> = Vector3::new(0.5, -0.65, 1.55);
/// That of node n.
pub(crate) const DXN: Vector3<f64> = Vector3::new(1.5, 4.65, 4.45);
/// That of node m, which does not keep it on the line.
pub(crate) const DXM: Vector3<f64> = Vector3::new(2.0, 3.0, 3.8);
/// The direction of the line.
pub(crate) const N: Vector3<f64> = Vector3::new(0.6, 0.48, 0.64);
/// Its variation.
pub(crate) const DN: Vector3<f64> = Vector3::new(-0.08, 0.116, -0.012);

/// In the plane: node 1.
pub(crate) const PLANE_X1: Vector2<f64> = Vector2::new(1.0, 1.0);
/// Node n: n = (0.6, 0.8), l = 5, t = (−0.8, 0.6).
pub(crate) const PLANE_XN: Vector2<f64> = Vector2::new(4.0, 5.0);
/// Node m, not on the line.
pub(crate) const PLANE_BESIDE: Vector2<f64> = Vector2::new(2.0, 4.0);
/// Node m on the line, with the same second coordinate.
pub(crate) const PLANE_XM: Vector2<f64> = Vector2::new(3.25, 4.0);
/// The motion of node 1.
pub(crate) const PLANE_DX1: Vector2<f64> = Vector2::new(1.0, -2.0);
/// That of node n.
pub(crate) const PLANE_DXN: Vector2<f64> = Vector2::new(3.0, 2.0);
/// That of node m, which does not keep it on the line.
pub(crate) const PLANE_DXM: Vector2<f64> = Vector2::new(3.0, 1.8);
