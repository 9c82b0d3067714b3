//! Names of the deck's format, and those of scenes for the same.

use crate::scene::kind::{Dimension, Kind};

/// Basic types that are one assembled type together: its friction is not the sum of theirs.
pub(super) const ASSEMBLED: [([&str; 2], &str); 3] =
    [(["SLOT", "ALIGN"], "TRANSLATOR"), (["JOIN", "REVOLUTE"], "HINGE"), (["JOIN", "UNIVERSAL"], "UJOINT")];

/// Types with an optional orientation at a: the global axes by default, says the connection library. Others require one.
pub(super) const GLOBAL_IF_NONE: [&str; 2] = ["join", "align"];

/// The parameters of predefined friction, in the order of the connection library.
pub(super) const PREDEFINED: [(&str, &[&str]); 4] = [
    ("slot", &["fc_int"]),
    ("translator", &["rr", "l", "fc_int"]),
    ("hinge", &["rp", "ra", "ls", "mc_int"]),
    ("ujoint", &["rp", "la", "ra", "ls", "mc1_int", "mc3_int"]),
];

/// Of a component of relative motion: the reference, and the lower and the upper limit.
pub(super) const COMPONENTS: [[&str; 3]; 6] = [
    ["l1_ref", "l1_min", "l1_max"],
    ["l2_ref", "l2_min", "l2_max"],
    ["l3_ref", "l3_min", "l3_max"],
    ["theta1_ref", "theta1_min", "theta1_max"],
    ["theta2_ref", "theta2_min", "theta2_max"],
    ["theta3_ref", "theta3_min", "theta3_max"],
];

/// Whether a component is a rotation, which a deck gives in degrees.
pub(super) fn is_rotation(component: u8) -> bool {
    component > 3
}

/// The kind of a type of connection.
pub(super) fn kind(name: &str, dimension: Dimension) -> Option<&'static Kind> {
    Kind::find(&name.to_lowercase(), dimension).filter(|kind| !kind.slides() && kind.nodes.len() == 2)
}

/// The dimension of elements of a type that is not read, if it shows.
pub(super) fn dimension_of(other: &str) -> Option<Dimension> {
    let begins = |with: &[&str]| with.iter().any(|with| other.starts_with(with));
    if begins(&["CAX", "CGAX", "SAX", "MAX", "RAX", "ISL", "DCAX"]) {
        Some(Dimension::Axisymmetric)
    } else if begins(&["CPE", "CPS", "CPEG", "B21", "B22", "B23", "T2D", "R2D", "CONN2D"]) {
        Some(Dimension::Plane)
    } else {
        None
    }
}
