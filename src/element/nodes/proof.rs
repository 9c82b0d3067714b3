//! The poses at which elements of two nodes are tested.

use super::Nodes;
use crate::formula::proof::Hard;
use crate::formula::proof::hard::{triad, turned};
use nalgebra::Vector3;

/// Poses computed by hand, then hard ones.
pub(crate) fn poses() -> [Hard<Nodes<f64>>; 8] {
    let [global, other] = [turned([1.0, 0.0, 0.0, 0.0]), triad()];
    // Components of few digits: 0.6, 0.8, 0.48, 0.64, 0.36.
    let [a, b] = [[4.0, 2.0, 1.0, 2.0], [4.0, 2.0, 2.0, 1.0]].map(turned);
    let near = Vector3::new(0.75, -0.5, 0.4375);
    let place = |x: f64| Vector3::new(x, -x, x);
    let turn = |w: f64, x: f64, y: f64, z: f64| turned([w, x, y, z]);
    [
        Hard::new(
            "aligned",
            "both nodes along the global axes, b two along the first",
            Nodes::new([global; 2], [Vector3::zeros(), Vector3::new(2.0, 0.0, 0.0)]),
        ),
        Hard::new(
            "turned",
            "both nodes away from the axes, with components of few digits",
            Nodes::new([a, b], [Vector3::new(1.0, 2.0, 3.0), Vector3::new(2.5, 2.25, 4.0)]),
        ),
        Hard::new("coincident", "both nodes coincide", Nodes::new([other, turn(8.0, 1.0, -2.0, 3.0)], [near; 2])),
        Hard::new(
            "offset-1e8",
            "far from the origin: the difference must be taken before any product",
            Nodes::new([global, turn(9.0, 1.0, 1.0, -1.0)], [place(1e8), place(1e8) + near]),
        ),
        Hard::new(
            "distance-1e8",
            "nodes far apart",
            Nodes::new([other, turn(1.0, 2.0, -1.0, 0.5)], [Vector3::zeros(), near * 1e8]),
        ),
        Hard::new(
            "nearly-aligned",
            "b turned by a part in 1e8",
            Nodes::new([global, turn(1.0, 1e-8, -2e-8, 3e-8)], [Vector3::zeros(), near]),
        ),
        Hard::new(
            "second-angle-near-90-degrees",
            "the second Cardan angle is 90° less a part in 1e4, where the others nearly turn about one axis",
            Nodes::new([global, turn(1.0, 0.25, 1.0 - 1e-4, 0.25)], [Vector3::zeros(), near]),
        ),
        Hard::new(
            "half-a-turn",
            "b turned by nearly half a turn about its first axis",
            Nodes::new([global, turn(1e-3, 1.0, 0.02, 0.01)], [Vector3::zeros(), near]),
        ),
    ]
}
