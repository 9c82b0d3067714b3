//! UNIVERSAL in scenes.

use super::{Angles, Constraint, ConstraintMoment, KineticMoment, RelativeMotion};
use crate::connector::align::since::Turns;
use crate::connector::align::table::{ALIGN, MOMENT};
use crate::contact::increments::Follow;
use crate::element::table::{
    Fallback, Given, Kind, MOMENTS, NODES, Origin, Outputs, SECOND_TRIAD, Use, always, renamed,
};
use crate::formula::quantity::{CROSS_M1, CROSS_M3, Domain, Quantity, Unit};
use Fallback::As;
use Origin::{Before, Initial, Parameter, Zero};

/// The given quantities of a cross: its initial orientation, and its rotations in the last state.
pub(crate) const CROSSED: &[Given] = &[
    ("no_number", Zero),
    ("c0", Initial("c")),
    ("alpha0", Initial("alpha_start")),
    ("gamma0", Initial("gamma_start")),
    ("ur1_before", Before("ur1")),
    ("ur3_before", Before("ur3")),
    ("theta1_ref", Parameter(As("alpha0"))),
    ("theta3_ref", Parameter(As("gamma0"))),
];
/// Angles are computed from −π to π, and followed from state to state. A cross whose arms are parallel at the start is refused.
pub(crate) const CROSSING: &[Use] = &[
    renamed(&Constraint, &[("g", "g_rot")]),
    renamed(&Constraint, &[("c0", "no_number"), ("g", "c")]),
    renamed(&Turns, &[("alpha", "alpha_start"), ("beta", "no_beta"), ("gamma", "gamma_start")]),
    renamed(&Angles, &[("alpha", "alpha_now"), ("gamma", "gamma_now")]),
    renamed(&Follow, &[("angle", "alpha_now"), ("start", "alpha0"), ("turned", "ur1_before"), ("followed", "alpha")]),
    renamed(&Follow, &[("angle", "gamma_now"), ("start", "gamma0"), ("turned", "ur3_before"), ("followed", "gamma")]),
    always(&RelativeMotion),
    renamed(&ConstraintMoment, &[("m", "rm")]),
];
pub(crate) const FOLLOWED1: Quantity = Quantity::scalar(
    r"\alpha",
    Unit::ONE,
    Domain::Angle,
    "angle of b's triad relative to a's about e1a, tracked over full turns",
);
pub(crate) const FOLLOWED3: Quantity = Quantity::scalar(
    r"\gamma",
    Unit::ONE,
    Domain::Angle,
    "angle of b's triad relative to a's about e3b, tracked over full turns",
);
pub(crate) const ANGLES: Outputs = &[
    ("GROT", "g_rot"),
    ("ALPHA", "alpha"),
    ("GAMMA", "gamma"),
    ("UR1", "ur1"),
    ("UR3", "ur3"),
    ("UR1MAT", "ur1_mat"),
    ("UR3MAT", "ur3_mat"),
];
pub(crate) const KINETIC_MOMENT: Outputs = &[("KM", "km")];

pub(crate) const UNIVERSAL: Kind = Kind {
    name: "universal",
    given: &[NODES, SECOND_TRIAD, CROSSED, MOMENTS],
    formulas: &[CROSSING, &[renamed(&KineticMoment, &[("m", "km")])]],
    meanings: &[("alpha", &FOLLOWED1), ("gamma", &FOLLOWED3), ("m1", &CROSS_M1), ("m3", &CROSS_M3)],
    outputs: &[ANGLES, MOMENT, KINETIC_MOMENT],
    ..ALIGN
};
