//! REVOLUTE in scenes.

use super::{Angle, Constraint, ConstraintMoment, KineticMoment, RelativeMotion};
use crate::connector::align::table::MOMENT;
use crate::connector::universal::table::{FOLLOWED1, KINETIC_MOMENT};
use crate::contact::increments::Follow;
use crate::element::table::{
    Dimension, Fallback, Given, Kind, MOMENTS, NODES, Origin, Outputs, SECOND_TRIAD, Use, always, renamed,
};
use crate::formula::quantity::CROSS_M1;
use Fallback::As;
use Origin::{Before, Initial, Parameter, Zero};

/// What a pin is given: its orientation at the start, and how far b was rotated before.
pub(crate) const HELD: &[Given] = &[
    ("no_number", Zero),
    ("c2", Initial("c2_now")),
    ("c3", Initial("c3_now")),
    ("alpha0", Initial("alpha_now")),
    ("ur1_before", Before("ur1")),
    ("theta1_ref", Parameter(As("alpha0"))),
];
/// The angle is read off from −π to π, and followed from state to state.
pub(crate) const TURNING: &[Use] = &[
    always(&Constraint),
    renamed(&Constraint, &[("c2", "no_number"), ("c3", "no_number"), ("g2", "c2_now"), ("g3", "c3_now")]),
    renamed(&Angle, &[("alpha", "alpha_now")]),
    renamed(&Follow, &[("angle", "alpha_now"), ("start", "alpha0"), ("turned", "ur1_before"), ("followed", "alpha")]),
    always(&RelativeMotion),
    renamed(&ConstraintMoment, &[("m", "rm")]),
];
pub(crate) const TURNED: Outputs =
    &[("G2", "g2"), ("G3", "g3"), ("ALPHA", "alpha"), ("UR1", "ur1"), ("UR1MAT", "ur1_mat")];

pub(crate) const REVOLUTE: Kind = Kind {
    name: "revolute",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, SECOND_TRIAD, HELD, MOMENTS],
    ordered: &[],
    formulas: &[TURNING, &[renamed(&KineticMoment, &[("m", "km")])]],
    meanings: &[("alpha", &FOLLOWED1), ("m1", &CROSS_M1)],
    outputs: &[TURNED, MOMENT, KINETIC_MOMENT],
};
