//! UJOINT: JOIN and UNIVERSAL.

use crate::scene::kind::{Dimension, Fallback, Kind, Origin, always, renamed};
use crate::{join, universal};
use Fallback::As;
use Origin::{Axis, Initial, Load, Parameter, Position, Zero};

/// JOIN and UNIVERSAL. What holds initially is what their residuals are where nothing is taken off.
pub(super) const UJOINT: Kind = Kind {
    name: "ujoint",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[
        ("xa", Position(0)),
        ("xb", Position(1)),
        ("e1a", Axis(0, 0)),
        ("e2a", Axis(0, 1)),
        ("e3a", Axis(0, 2)),
        ("e1b", Axis(1, 0)),
        ("e2b", Axis(1, 1)),
        ("e3b", Axis(1, 2)),
        ("no_vector", Zero),
        ("no_number", Zero),
        ("d0", Initial("d")),
        ("c0", Initial("c")),
        ("alpha0", Initial("alpha")),
        ("gamma0", Initial("gamma")),
        ("theta1_ref", Parameter(As("alpha0"))),
        ("theta3_ref", Parameter(As("gamma0"))),
        ("m1", Load),
        ("m2", Load),
        ("m3", Load),
    ],
    formulas: &[
        always(&join::Constraint),
        renamed(&join::Constraint, &[("d0", "no_vector"), ("g", "d")]),
        renamed(&universal::Constraint, &[("g", "g_rot")]),
        renamed(&universal::Constraint, &[("c0", "no_number"), ("g", "c")]),
        always(&universal::Angles),
        always(&universal::RelativeMotion),
        renamed(&universal::ConstraintMoment, &[("m", "rm")]),
        renamed(&universal::KineticMoment, &[("m", "km")]),
    ],
    meanings: &[],
    outputs: &[
        ("G", "g"),
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
};
