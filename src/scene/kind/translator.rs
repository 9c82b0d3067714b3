//! TRANSLATOR: SLOT and ALIGN.

use super::dimension::Dimension;
use super::shared::{
    CONSTRAINT_FORCE, CSF1, FORCES, FRICTION, Given, INITIAL, KINETIC_FORCE, LENGTHS, MOMENTS, MOTION, NODES, NORMAL,
    ORDERED_LENGTHS, RETURN_MAP, SECOND_TRIAD, SLIP, STOP, TRIAL, YIELD,
};
use super::table::{Fallback, Kind, Origin, When, always, renamed};
use crate::scene::rules::{Alignment, Turns};
use crate::{align, slot, translator};
use Fallback::Number;
use Origin::{Initial, Parameter};

/// The levers of a TRANSLATOR's moments; where both are 0, its friction is that of the SLOT.
const LEVERS: &[&str] = &["rr", "l"];

/// The angles where the analysis begins.
pub(super) const ALIGNED: &[Given] =
    &[("alpha0", Initial("alpha")), ("beta0", Initial("beta")), ("gamma0", Initial("gamma"))];

pub(super) const TRANSLATOR: Kind = Kind {
    name: "translator",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[
        NODES,
        SECOND_TRIAD,
        INITIAL,
        ALIGNED,
        LENGTHS,
        &[("rr", Parameter(Number(0.0))), ("l", Parameter(Number(0.0)))],
        FRICTION,
        FORCES,
        MOMENTS,
    ],
    ordered: ORDERED_LENGTHS,
    formulas: &[
        always(&slot::RelativePosition),
        always(&slot::Constraint),
        always(&Turns),
        always(&Alignment),
        CONSTRAINT_FORCE,
        renamed(&align::ConstraintMoment, &[("m", "rm")]),
        MOTION,
        KINETIC_FORCE[0],
        KINETIC_FORCE[1],
        KINETIC_FORCE[2],
        always(&translator::TorqueForce),
        always(&translator::RadialForce),
        always(&translator::BendingForce),
        always(&slot::ContactForce).when(When::AllZero(LEVERS)),
        always(&translator::ContactForce).when(When::NotAllZero(LEVERS)),
        NORMAL,
        YIELD[0],
        YIELD[1],
        YIELD[2],
        STOP[0],
        STOP[1],
        STOP[2],
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
        ("UR1", "ur1"),
        ("UR2", "ur2"),
        ("UR3", "ur3"),
        ("GAPMIN", "gap_min"),
        ("GAPMAX", "gap_max"),
        ("RF", "rf"),
        ("RM", "rm"),
        ("KF", "kf"),
        ("MTORQ", "m_torq"),
        ("FTORQ", "f_torq"),
        ("FR", "fr"),
        ("MBEND", "m_bend"),
        ("FBEND", "f_bend"),
        ("FC", "fc"),
        ("FN", "fn"),
        ("P", "p"),
        ("PHI", "phi"),
        ("CSF1", "csf"),
        ("SLIP1", "slip"),
        ("CASU1", "slip_total"),
    ],
};
