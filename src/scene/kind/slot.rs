//! SLOT, in space and in the plane.

use super::dimension::Dimension;
use super::shared::{
    CONSTRAINT_FORCE, CSF1, FORCES, FRICTION, INITIAL, KINETIC_FORCE, LENGTHS, NODES, NORMAL, ORDERED_LENGTHS, SLIDING,
    STOP, YIELD,
};
use super::table::{Kind, Origin, Use, always};
use crate::connector::slot;
use Origin::Zero;

/// The position of b along a slot, for every connector with one.
pub(super) const ALONG: &[Use] =
    &[always(&slot::RelativePosition), always(&slot::RelativeMotion), CONSTRAINT_FORCE, STOP[0], STOP[1], STOP[2]];
/// The friction along a slot.
pub(super) const RUBBING: &[Use] = &[
    KINETIC_FORCE[0],
    KINETIC_FORCE[1],
    KINETIC_FORCE[2],
    NORMAL,
    YIELD[0],
    YIELD[1],
    YIELD[2],
    SLIDING[0],
    SLIDING[1],
    SLIDING[2],
];

pub(super) type Outputs = &'static [(&'static str, &'static str)];

/// The outputs of a slot, for every connector with one; third coordinates only in space.
pub(super) const PLACE: Outputs = &[("X", "x"), ("Y", "y")];
pub(super) const PLACE_3: Outputs = &[("Z", "z")];
pub(super) const MOVED: Outputs = &[("U1", "u1"), ("U1MAT", "u1_mat"), ("GY", "gy")];
pub(super) const MOVED_3: Outputs = &[("GZ", "gz")];
pub(super) const STOPPED: Outputs = &[("GAPMIN", "gap_min"), ("GAPMAX", "gap_max"), ("RF", "rf")];
pub(super) const KINETIC: Outputs = &[("KF", "kf")];
pub(super) const RUBBED: Outputs = &[
    ("FC", "fc"),
    ("FN", "fn"),
    ("P", "p"),
    ("PHI", "phi"),
    ("CSF1", "csf"),
    ("SLIP1", "slip"),
    ("CASU1", "slip_total"),
];

pub(super) const SLOT: Kind = Kind {
    name: "slot",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, INITIAL, LENGTHS, FRICTION, FORCES],
    ordered: ORDERED_LENGTHS,
    formulas: &[ALONG, &[always(&slot::Constraint), always(&slot::ContactForce)], RUBBING],
    meanings: &[("csf", &CSF1)],
    outputs: &[PLACE, PLACE_3, MOVED, MOVED_3, STOPPED, KINETIC, RUBBED],
};

pub(super) const SLOT_2D: Kind = Kind {
    dimension: Dimension::Plane,
    given: &[NODES, &[INITIAL[0], INITIAL[1]], LENGTHS, FRICTION, &[FORCES[0], FORCES[1], ("f3", Zero)]],
    formulas: &[ALONG, &[always(&slot::Constraint2d), always(&slot::ContactForce)], RUBBING],
    outputs: &[PLACE, MOVED, STOPPED, KINETIC, RUBBED],
    ..SLOT
};
