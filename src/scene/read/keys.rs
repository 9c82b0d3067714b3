//! The keys of a scene file, which the schema also uses.

use crate::contact::slide_line::Interpolation;
use crate::formula::quantity::{CLEARANCE, DAMPING_FRACTION, Domain, MU, MU0, PRESSURE_AT_TOUCH, STIFFNESS};

/// The keys of a scene.
pub(in crate::scene) const SCENE: [&str; 10] = [
    "title",
    "dimension",
    "angles",
    "columns",
    "orientations",
    "nodes",
    "slide_lines",
    "elements",
    "frames",
    "outputs",
];
/// The keys of a node, which has either the first or the last.
pub(in crate::scene) const NODE: [&str; 3] = ["at", "orientation", "with"];
/// The keys of an orientation in space, of which exactly one must be present.
pub(in crate::scene) const SPACE_ORIENTATION: [&str; 3] = ["axes", "rotation", "quaternion"];
pub(in crate::scene) const PLANE_ORIENTATION: [&str; 1] = ["angle"];
/// The keys of every element, followed by those of its kind's parameters.
pub(in crate::scene) const ELEMENT: [&str; 3] = ["kind", "nodes", "outputs"];
/// The keys of a sliding element.
pub(in crate::scene) const SLIDING_ELEMENT: [&str; 4] = ["kind", "nodes", "outputs", "slide_line"];
pub(in crate::scene) const FRAME: [&str; 3] = ["time", "nodes", "loads"];
/// The keys of a frame of an axisymmetric scene.
pub(in crate::scene) const SLIDING_FRAME: [&str; 3] = ["time", "nodes", "pressures"];
/// The keys of frames that name tables.
pub(in crate::scene) const TABLES: [&str; 3] = ["nodes", "loads", "pressures"];
pub(in crate::scene) const MOTION: [&str; 2] = ["u", "ur"];
pub(in crate::scene) const SLIDE_LINE: [&str; 9] =
    ["type", "nodes", "generate", "smooth", "extension_zone", "pressure", "damping", "friction", "torque_frequency"];
/// The keys of generated nodes.
pub(in crate::scene) const GENERATE: [&str; 3] = ["first", "last", "increment"];
/// The types of slide lines.
pub(in crate::scene) const TYPES: [(&str, Interpolation); 2] =
    [("linear", Interpolation::Linear), ("parabolic", Interpolation::Parabolic)];
/// The keys of a pressure law: linear has the first, exponential the two in the middle, hard contact the last.
pub(in crate::scene) const PRESSURE: [(&str, Domain); 4] = [
    ("k", STIFFNESS.domain),
    ("c0", CLEARANCE.domain),
    ("p0", PRESSURE_AT_TOUCH.domain),
    ("tolerance", Domain::NonNegative),
];
pub(in crate::scene) const DAMPING: [(&str, Domain); 3] =
    [("mu0", MU0.domain), ("c0", CLEARANCE.domain), ("eta", DAMPING_FRACTION.domain)];
pub(in crate::scene) const FRICTION: [(&str, Domain); 2] = [("mu", MU.domain), ("k_stick", STIFFNESS.domain)];
