//! ALIGN in scenes.

use super::ConstraintMoment;
use super::since::{Alignment, Bearing, TurnedBack, Turns};
use crate::element::cardan::{BetaTwoArgument, CardanAngles};
use crate::element::table::{
    Dimension, Given, Kind, MOMENTS, NODES, Origin, Outputs, SECOND_TRIAD, Use, always, renamed,
};
use crate::formula::quantity::{Domain, Quantity, Unit};
use Origin::Initial;

/// The angles in the initial configuration.
pub(crate) const ALIGNED: &[Given] = &[
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
pub(crate) const ALIGNING: &[Use] = &[
    always(&Turns),
    always(&Alignment),
    always(&Bearing),
    always(&TurnedBack),
    renamed(&CardanAngles, SINCE),
    renamed(&BetaTwoArgument, SINCE_2),
    renamed(&ConstraintMoment, &[("m", "rm")]),
];
/// The angles since the start, in every kind that has them.
pub(crate) const URS1: Quantity = Quantity::scalar(
    r"u_{r1}",
    Unit::ONE,
    Domain::Angle,
    "first Cardan angle by which b has rotated relative to a since the start",
);
pub(crate) const URS2: Quantity = Quantity::scalar(
    r"u_{r2}",
    Unit::ONE,
    Domain::Angle,
    "second Cardan angle by which b has rotated relative to a since the start",
);
pub(crate) const URS3: Quantity = Quantity::scalar(
    r"u_{r3}",
    Unit::ONE,
    Domain::Angle,
    "third Cardan angle by which b has rotated relative to a since the start",
);
pub(crate) const TURNED: Outputs =
    &[("UR1", "ur1"), ("UR2", "ur2"), ("UR3", "ur3"), ("URS1", "urs1"), ("URS2", "urs2"), ("URS3", "urs3")];
pub(crate) const MOMENT: Outputs = &[("RM", "rm")];

pub(crate) const ALIGN: Kind = Kind {
    name: "align",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, SECOND_TRIAD, ALIGNED, MOMENTS],
    ordered: &[],
    formulas: &[ALIGNING],
    meanings: &[("urs1", &URS1), ("urs2", &URS2), ("urs3", &URS3)],
    outputs: &[&[("ALPHA", "alpha"), ("BETA", "beta"), ("GAMMA", "gamma")], TURNED, MOMENT],
};
