//! ALIGN, JOIN and UNIVERSAL by themselves: what TRANSLATOR and UJOINT are made of.

use super::dimension::Dimension;
use super::shared::{FORCES, MOMENTS, NODES, SECOND_TRIAD};
use super::table::{Fallback, Kind, Origin, always, renamed};
use super::translator::ALIGNED;

use crate::quantity::{CROSS_M1, CROSS_M3};
use crate::scene::rules::{Alignment, Joining, Turns};
use crate::{align, join, universal};
use Fallback::As;
use Origin::{Initial, Parameter, Zero};

pub(super) const ALIGN: Kind = Kind {
    name: "align",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, SECOND_TRIAD, ALIGNED, MOMENTS],
    ordered: &[],
    formulas: &[always(&Turns), always(&Alignment), renamed(&align::ConstraintMoment, &[("m", "rm")])],
    meanings: &[],
    outputs: &[
        ("ALPHA", "alpha"),
        ("BETA", "beta"),
        ("GAMMA", "gamma"),
        ("UR1", "ur1"),
        ("UR2", "ur2"),
        ("UR3", "ur3"),
        ("RM", "rm"),
    ],
};

/// Where b is initially is what the residual is where nothing is taken off.
pub(super) const JOIN: Kind = Kind {
    name: "join",
    given: &[NODES, &[("no_vector", Zero), ("d0", Initial("d"))], FORCES],
    formulas: &[
        always(&join::Constraint),
        renamed(&join::Constraint, &[("d0", "no_vector"), ("g", "d")]),
        renamed(&Joining, &[("f", "rf")]),
    ],
    outputs: &[("G", "g"), ("RF", "rf")],
    ..ALIGN
};

pub(super) const UNIVERSAL: Kind = Kind {
    name: "universal",
    given: &[
        NODES,
        SECOND_TRIAD,
        &[
            ("no_number", Zero),
            ("c0", Initial("c")),
            ("alpha0", Initial("alpha")),
            ("gamma0", Initial("gamma")),
            ("theta1_ref", Parameter(As("alpha0"))),
            ("theta3_ref", Parameter(As("gamma0"))),
        ],
        MOMENTS,
    ],
    formulas: &[
        renamed(&universal::Constraint, &[("g", "g_rot")]),
        renamed(&universal::Constraint, &[("c0", "no_number"), ("g", "c")]),
        always(&universal::Angles),
        always(&universal::RelativeMotion),
        renamed(&universal::ConstraintMoment, &[("m", "rm")]),
        renamed(&universal::KineticMoment, &[("m", "km")]),
    ],
    meanings: &[("m1", &CROSS_M1), ("m3", &CROSS_M3)],
    outputs: &[
        ("GROT", "g_rot"),
        ("ALPHA", "alpha"),
        ("GAMMA", "gamma"),
        ("UR1", "ur1"),
        ("UR3", "ur3"),
        ("UR1MAT", "ur1_mat"),
        ("UR3MAT", "ur3_mat"),
        ("RM", "rm"),
        ("KM", "km"),
    ],
    ..ALIGN
};
