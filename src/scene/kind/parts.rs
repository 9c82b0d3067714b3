//! ALIGN, JOIN and UNIVERSAL on their own: the parts of TRANSLATOR and UJOINT.

use super::dimension::Dimension;
use super::shared::{FORCES, Given, MOMENTS, NODES, SECOND_TRIAD};
use super::slot::Outputs;
use super::table::{Fallback, Kind, Origin, Use, always, renamed};
use crate::connector::{align, join, universal};
use crate::element::cardan::{BetaTwoArgument, CardanAngles};
use crate::formula::quantity::{CROSS_M1, CROSS_M3, Domain, Quantity, Unit};
use crate::scene::rules::{Alignment, Bearing, Follow, Joining, TurnedBack, Turns, scalar};
use Fallback::As;
use Origin::{Before, Initial, Parameter, Zero};

/// The angles in the initial configuration.
pub(super) const ALIGNED: &[Given] = &[
    ("alpha0", Initial("alpha")),
    ("beta0", Initial("beta")),
    ("gamma0", Initial("gamma")),
    ("r10", Initial("r1")),
    ("r20", Initial("r2")),
    ("r30", Initial("r3")),
];
/// The triads from which the angles since the start are computed.
const SINCE: &[(&str, &str)] = &[
    ("e1b", "q1"),
    ("e2b", "q2"),
    ("e3b", "q3"),
    ("alpha", "urs1"),
    ("gamma", "urs3"),
    // β by the arc sine is not used.
    ("beta", "no_beta"),
];
const SINCE_2: &[(&str, &str)] = &[("e1b", "q1"), ("e2b", "q2"), ("e3b", "q3"), ("beta", "urs2")];
pub(super) const ALIGNING: &[Use] = &[
    always(&Turns),
    always(&Alignment),
    always(&Bearing),
    always(&TurnedBack),
    renamed(&CardanAngles, SINCE),
    renamed(&BetaTwoArgument, SINCE_2),
    renamed(&align::ConstraintMoment, &[("m", "rm")]),
];
/// The angles since the start, in every kind that has them.
pub(super) const URS1: Quantity =
    scalar(r"u_{r1}", Unit::ONE, Domain::Angle, "first Cardan angle by which b has turned against a since the start");
pub(super) const URS2: Quantity =
    scalar(r"u_{r2}", Unit::ONE, Domain::Angle, "second Cardan angle by which b has turned against a since the start");
pub(super) const URS3: Quantity =
    scalar(r"u_{r3}", Unit::ONE, Domain::Angle, "third Cardan angle by which b has turned against a since the start");
pub(super) const TURNED: Outputs =
    &[("UR1", "ur1"), ("UR2", "ur2"), ("UR3", "ur3"), ("URS1", "urs1"), ("URS2", "urs2"), ("URS3", "urs3")];
pub(super) const MOMENT: Outputs = &[("RM", "rm")];

pub(super) const ALIGN: Kind = Kind {
    name: "align",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, SECOND_TRIAD, ALIGNED, MOMENTS],
    ordered: &[],
    formulas: &[ALIGNING],
    meanings: &[("urs1", &URS1), ("urs2", &URS2), ("urs3", &URS3)],
    outputs: &[&[("ALPHA", "alpha"), ("BETA", "beta"), ("GAMMA", "gamma")], TURNED, MOMENT],
};

/// The initial position of b is the residual with nothing subtracted.
pub(super) const JOINED: &[Given] = &[("no_vector", Zero), ("d0", Initial("d"))];
pub(super) const JOINING: &[Use] = &[
    always(&join::Constraint),
    renamed(&join::Constraint, &[("d0", "no_vector"), ("g", "d")]),
    renamed(&Joining, &[("f", "rf")]),
];
pub(super) const APART: Outputs = &[("G", "g")];
pub(super) const FORCE: Outputs = &[("RF", "rf")];

pub(super) const JOIN: Kind = Kind {
    name: "join",
    given: &[NODES, JOINED, FORCES],
    formulas: &[JOINING],
    meanings: &[],
    outputs: &[APART, FORCE],
    ..ALIGN
};

/// The given quantities of a cross: its initial orientation, and its rotations in the last state.
pub(super) const CROSSED: &[Given] = &[
    ("no_number", Zero),
    ("c0", Initial("c")),
    ("alpha0", Initial("alpha_now")),
    ("gamma0", Initial("gamma_now")),
    ("ur1_before", Before("ur1")),
    ("ur3_before", Before("ur3")),
    ("theta1_ref", Parameter(As("alpha0"))),
    ("theta3_ref", Parameter(As("gamma0"))),
];
/// Angles are computed from −π to π, and followed from state to state.
pub(super) const CROSSING: &[Use] = &[
    renamed(&universal::Constraint, &[("g", "g_rot")]),
    renamed(&universal::Constraint, &[("c0", "no_number"), ("g", "c")]),
    renamed(&universal::Angles, &[("alpha", "alpha_now"), ("gamma", "gamma_now")]),
    renamed(&Follow, &[("angle", "alpha_now"), ("start", "alpha0"), ("turned", "ur1_before"), ("followed", "alpha")]),
    renamed(&Follow, &[("angle", "gamma_now"), ("start", "gamma0"), ("turned", "ur3_before"), ("followed", "gamma")]),
    always(&universal::RelativeMotion),
    renamed(&universal::ConstraintMoment, &[("m", "rm")]),
];
pub(super) const FOLLOWED1: Quantity = scalar(
    r"\alpha",
    Unit::ONE,
    Domain::Angle,
    "angle of b's triad relative to a's about e1a, tracked over full turns",
);
pub(super) const FOLLOWED3: Quantity = scalar(
    r"\gamma",
    Unit::ONE,
    Domain::Angle,
    "angle of b's triad relative to a's about e3b, tracked over full turns",
);
pub(super) const ANGLES: Outputs = &[
    ("GROT", "g_rot"),
    ("ALPHA", "alpha"),
    ("GAMMA", "gamma"),
    ("UR1", "ur1"),
    ("UR3", "ur3"),
    ("UR1MAT", "ur1_mat"),
    ("UR3MAT", "ur3_mat"),
];
pub(super) const KINETIC_MOMENT: Outputs = &[("KM", "km")];

pub(super) const UNIVERSAL: Kind = Kind {
    name: "universal",
    given: &[NODES, SECOND_TRIAD, CROSSED, MOMENTS],
    formulas: &[CROSSING, &[renamed(&universal::KineticMoment, &[("m", "km")])]],
    meanings: &[("alpha", &FOLLOWED1), ("gamma", &FOLLOWED3), ("m1", &CROSS_M1), ("m3", &CROSS_M3)],
    outputs: &[ANGLES, MOMENT, KINETIC_MOMENT],
    ..ALIGN
};
