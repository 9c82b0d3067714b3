//! SLOT, in space and in the plane.

use super::dimension::Dimension;
use super::shared::{
    CONSTRAINT_FORCE, CSF1, FORCES, FRICTION, INITIAL, KINETIC_FORCE, LENGTHS, MOTION, NODES, NORMAL, ORDERED_LENGTHS,
    RETURN_MAP, SLIP, STOP, TRIAL, YIELD,
};
use super::table::{Kind, Origin, always};
use crate::slot;
use Origin::Zero;

pub(super) const SLOT: Kind = Kind {
    name: "slot",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, INITIAL, LENGTHS, FRICTION, FORCES],
    ordered: ORDERED_LENGTHS,
    formulas: &[
        always(&slot::RelativePosition),
        always(&slot::Constraint),
        CONSTRAINT_FORCE,
        MOTION,
        KINETIC_FORCE[0],
        KINETIC_FORCE[1],
        KINETIC_FORCE[2],
        always(&slot::ContactForce),
        NORMAL,
        YIELD[0],
        YIELD[1],
        YIELD[2],
        STOP,
        TRIAL,
        RETURN_MAP,
        SLIP,
    ],
    meanings: &[("csf", &CSF1)],
    outputs: &[
        ("X", "x"),
        ("Y", "y"),
        ("Z", "z"),
        ("U1", "u1"),
        ("U1MAT", "u1_mat"),
        ("GY", "gy"),
        ("GZ", "gz"),
        ("GAPMIN", "gap_min"),
        ("GAPMAX", "gap_max"),
        ("RF", "rf"),
        ("KF", "kf"),
        ("FC", "fc"),
        ("FN", "fn"),
        ("P", "p"),
        ("PHI", "phi"),
        ("CSF1", "csf"),
        ("SLIP1", "slip"),
        ("CASU1", "slip_total"),
    ],
};

pub(super) const SLOT_2D: Kind = Kind {
    dimension: Dimension::Plane,
    given: &[NODES, &[INITIAL[0], INITIAL[1]], LENGTHS, FRICTION, &[FORCES[0], FORCES[1], ("f3", Zero)]],
    formulas: &[
        always(&slot::RelativePosition),
        always(&slot::Constraint2d),
        CONSTRAINT_FORCE,
        MOTION,
        KINETIC_FORCE[0],
        KINETIC_FORCE[1],
        KINETIC_FORCE[2],
        always(&slot::ContactForce),
        NORMAL,
        YIELD[0],
        YIELD[1],
        YIELD[2],
        STOP,
        TRIAL,
        RETURN_MAP,
        SLIP,
    ],
    outputs: &[
        ("X", "x"),
        ("Y", "y"),
        ("U1", "u1"),
        ("U1MAT", "u1_mat"),
        ("GY", "gy"),
        ("GAPMIN", "gap_min"),
        ("GAPMAX", "gap_max"),
        ("RF", "rf"),
        ("KF", "kf"),
        ("FC", "fc"),
        ("FN", "fn"),
        ("P", "p"),
        ("PHI", "phi"),
        ("CSF1", "csf"),
        ("SLIP1", "slip"),
        ("CASU1", "slip_total"),
    ],
    ..SLOT
};
