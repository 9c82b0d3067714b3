//! The state that the chapter on slide lines follows. Three nodes make two straight segments; a slave node penetrates the first by 0.5,
//! where the tangent is (0.6, 0.8), another the corner, where it is (0.8, 0.6). A parabolic segment has the tangent (0.6, 0.8) at
//! g = 0.5. The element of the slave node begins at it and runs along the first segment.

use nalgebra::Vector2;

/// The nodes of the line; the midside nodes of a parabolic one are in the middle.
pub(crate) const LINE: [Vector2<f64>; 3] = [Vector2::new(1.0, 0.0), Vector2::new(4.0, 4.0), Vector2::new(9.0, 6.0)];
/// The midside nodes of its two segments.
pub(crate) const MIDSIDE: [Vector2<f64>; 2] = [Vector2::new(2.5, 2.0), Vector2::new(6.5, 5.0)];
/// The tangent of the first segment, not normalised.
pub(crate) const RATE: Vector2<f64> = Vector2::new(1.5, 2.0);
/// The slave node at the first segment, and the coordinate of its closest point.
pub(crate) const SLAVE: (Vector2<f64>, f64) = (Vector2::new(3.2, 2.1), 0.2);
/// The slave node at the corner, the fraction of a segment that is smoothed, and the coordinate of its closest point.
pub(crate) const AT_CORNER: (Vector2<f64>, f64, f64) = (Vector2::new(4.4, 3.5), 0.2, 0.5);
/// A parabolic segment.
pub(crate) const PARABOLA: [Vector2<f64>; 3] = [Vector2::new(1.0, 0.0), Vector2::new(3.5, 1.0), Vector2::new(5.0, 3.0)];
/// The slave node at it, and the coordinate of its closest point.
pub(crate) const AT_PARABOLA: (Vector2<f64>, f64) = (Vector2::new(4.775, 1.575), 0.5);
/// The increments of a slave node and of the three nodes of the line.
pub(crate) const MOTION: [Vector2<f64>; 4] =
    [Vector2::new(0.3, 0.1), Vector2::new(0.1, -0.1), Vector2::new(0.2, 0.2), Vector2::new(-0.1, 0.1)];
/// The nodes of an element with three nodes on the slave surface; one with two has the first two.
pub(crate) const ELEMENT: [Vector2<f64>; 3] = [SLAVE.0, Vector2::new(6.2, 6.1), Vector2::new(9.2, 10.1)];
/// The pressures at its nodes.
pub(crate) const PRESSURE: [f64; 3] = [4.0, 2.0, 1.0];
