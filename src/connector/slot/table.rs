//! SLOT in scenes, in space and in the plane.

use super::{
    Constraint, Constraint2d, ConstraintForce, ContactForce, KineticForce, NormalForce, RelativeMotion,
    RelativePosition, Stop,
};
use crate::contact::coulomb::{Response, Yield};
use crate::contact::increments::{Accumulated, Increment, Kinetic, Traction};
use crate::element::table::{
    Dimension, FORCES, Fallback, Given, Kind, NODES, Origin, Outputs, Use, WITH_FRICTION, WITHOUT_FRICTION, When,
    always, renamed,
};
use crate::formula::quantity::{Domain, Quantity, Unit};
use Fallback::{As, Number, Required};
use Origin::{Before, Initial, Parameter, Zero};

/// The given quantities of motion and friction along a slot, for every connector with one; friction proceeds in increments.
pub(crate) const INITIAL: &[Given] = &[("x0", Initial("x")), ("y0", Initial("y")), ("z0", Initial("z"))];
pub(crate) const LENGTHS: &[Given] =
    &[("l1_ref", Parameter(As("x0"))), ("l1_min", Parameter(Required)), ("l1_max", Parameter(Required))];
/// The stops of a slot.
pub(crate) const ORDERED_LENGTHS: &[(&str, &str)] = &[("l1_min", "l1_max")];
pub(crate) const FRICTION: &[Given] = &[
    ("mu", Parameter(Number(0.0))),
    ("fc_int", Parameter(Number(0.0))),
    ("k_stick", Parameter(Required)),
    ("u1_before", Before("u1")),
    ("f_before", Before("csf")),
    ("slip_before", Before("slip_total")),
    ("no_friction", Zero),
];

/// Both stops at once, or only the given one, which then replaces the other too.
pub(crate) const STOP: [Use; 3] = [
    always(&Stop).when(When::AllGiven(STOPS)),
    renamed(&Stop, &[("l1_max", "l1_min"), ("gap_max", "no_gap_max")]).when(When::NotAllGiven(STOPS)),
    renamed(&Stop, &[("l1_min", "l1_max"), ("gap_min", "no_gap_min")]).when(When::NotAllGiven(STOPS)),
];
const STOPS: &[&str] = &["l1_min", "l1_max"];
pub(crate) const NORMAL: Use = always(&NormalForce);
/// Friction after an increment of motion, and the accumulated slip.
pub(crate) const SLIDING: [Use; 3] = [always(&Increment), renamed(&Response, &[("f", "csf")]), always(&Accumulated)];
pub(crate) const CONSTRAINT_FORCE: Use = renamed(&ConstraintForce, &[("f", "rf")]);

/// The kinetic force: the load along the slot, and friction.
pub(crate) const KINETIC_FORCE: [Use; 3] = [
    renamed(&KineticForce, &[("f", "kf")]).when(WITHOUT_FRICTION),
    renamed(&Kinetic, &[("f_load", "f1")]),
    renamed(&KineticForce, &[("f1", "f_kinetic"), ("f", "kf")]).when(WITH_FRICTION),
];
/// The friction force along a slot.
pub(crate) const CSF1: Quantity = Quantity::scalar(
    r"f",
    Unit::F,
    Domain::Real,
    "friction force along e1a, positive where it resists positive u1: on node a, its opposite on node b",
);
/// P and Φ of friction alone.
pub(crate) const YIELD: [Use; 3] = [
    renamed(&Traction, &[("csf", "no_friction")]).when(WITHOUT_FRICTION),
    always(&Traction).when(WITH_FRICTION),
    always(&Yield),
];

/// The position of b along a slot, for every connector with one.
pub(crate) const ALONG: &[Use] =
    &[always(&RelativePosition), always(&RelativeMotion), CONSTRAINT_FORCE, STOP[0], STOP[1], STOP[2]];
/// The friction along a slot.
pub(crate) const RUBBING: &[Use] = &[
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

/// The outputs of a slot, for every connector with one; third coordinates only in space.
pub(crate) const PLACE: Outputs = &[("X", "x"), ("Y", "y")];
pub(crate) const PLACE_3: Outputs = &[("Z", "z")];
pub(crate) const MOVED: Outputs = &[("U1", "u1"), ("U1MAT", "u1_mat"), ("GY", "gy")];
pub(crate) const MOVED_3: Outputs = &[("GZ", "gz")];
pub(crate) const STOPPED: Outputs = &[("GAPMIN", "gap_min"), ("GAPMAX", "gap_max"), ("RF", "rf")];
pub(crate) const KINETIC: Outputs = &[("KF", "kf")];
pub(crate) const RUBBED: Outputs = &[
    ("FC", "fc"),
    ("FN", "fn"),
    ("P", "p"),
    ("PHI", "phi"),
    ("CSF1", "csf"),
    ("SLIP1", "slip"),
    ("CASU1", "slip_total"),
];

pub(crate) const SLOT: Kind = Kind {
    name: "slot",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[NODES, INITIAL, LENGTHS, FRICTION, FORCES],
    ordered: ORDERED_LENGTHS,
    formulas: &[ALONG, &[always(&Constraint), always(&ContactForce)], RUBBING],
    meanings: &[("csf", &CSF1)],
    outputs: &[PLACE, PLACE_3, MOVED, MOVED_3, STOPPED, KINETIC, RUBBED],
};

pub(crate) const SLOT_2D: Kind = Kind {
    dimension: Dimension::Plane,
    given: &[NODES, &[INITIAL[0], INITIAL[1]], LENGTHS, FRICTION, &[FORCES[0], FORCES[1], ("f3", Zero)]],
    formulas: &[ALONG, &[always(&Constraint2d), always(&ContactForce)], RUBBING],
    outputs: &[PLACE, MOVED, STOPPED, KINETIC, RUBBED],
    ..SLOT
};
