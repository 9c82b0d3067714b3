//! Tables that several kinds share.

use super::table::{Fallback, Origin, Use, When, always, renamed};
use crate::connector::slot::{ConstraintForce, KineticForce, NormalForce, Stop};
use crate::contact::coulomb::{Response, Yield};
use crate::formula::quantity::{Domain, Quantity, Unit};
use crate::scene::rules::{Accumulated, Increment, Kinetic, Traction, scalar};
use Fallback::{As, Number, Required};
use Origin::{Axis, Before, Initial, Load, Parameter, Position, Zero};

pub(super) type Given = (&'static str, Origin);

/// Two nodes, and the triad of the first, for every connector.
pub(super) const NODES: &[Given] =
    &[("xa", Position(0)), ("xb", Position(1)), ("e1a", Axis(0, 0)), ("e2a", Axis(0, 1)), ("e3a", Axis(0, 2))];
/// The triad of the second node, if angles are measured.
pub(super) const SECOND_TRIAD: &[Given] = &[("e1b", Axis(1, 0)), ("e2b", Axis(1, 1)), ("e3b", Axis(1, 2))];
pub(super) const FORCES: &[Given] = &[("f1", Load), ("f2", Load), ("f3", Load)];
pub(super) const MOMENTS: &[Given] = &[("m1", Load), ("m2", Load), ("m3", Load)];

/// The given quantities of motion and friction along a slot, for every connector with one; friction proceeds in increments.
pub(super) const INITIAL: &[Given] = &[("x0", Initial("x")), ("y0", Initial("y")), ("z0", Initial("z"))];
pub(super) const LENGTHS: &[Given] =
    &[("l1_ref", Parameter(As("x0"))), ("l1_min", Parameter(Required)), ("l1_max", Parameter(Required))];
/// The stops of a slot.
pub(super) const ORDERED_LENGTHS: &[(&str, &str)] = &[("l1_min", "l1_max")];
pub(super) const FRICTION: &[Given] = &[
    ("mu", Parameter(Number(0.0))),
    ("fc_int", Parameter(Number(0.0))),
    ("k_stick", Parameter(Required)),
    ("u1_before", Before("u1")),
    ("f_before", Before("csf")),
    ("slip_before", Before("slip_total")),
    ("no_friction", Zero),
];

/// Both stops at once, or only the given one, which then replaces the other too.
pub(super) const STOP: [Use; 3] = [
    always(&Stop).when(When::AllGiven(STOPS)),
    renamed(&Stop, &[("l1_max", "l1_min"), ("gap_max", "no_gap_max")]).when(When::NotAllGiven(STOPS)),
    renamed(&Stop, &[("l1_min", "l1_max"), ("gap_min", "no_gap_min")]).when(When::NotAllGiven(STOPS)),
];
const STOPS: &[&str] = &["l1_min", "l1_max"];
pub(super) const NORMAL: Use = always(&NormalForce);
/// Friction after an increment of motion, and the accumulated slip.
pub(super) const SLIDING: [Use; 3] = [always(&Increment), renamed(&Response, &[("f", "csf")]), always(&Accumulated)];
pub(super) const CONSTRAINT_FORCE: Use = renamed(&ConstraintForce, &[("f", "rf")]);

/// With friction, everything that depends on it follows from the computed friction force; if μ is 0 there is none, and nothing is
/// computed.
const MU: &[&str] = &["mu"];
pub(super) const WITHOUT_FRICTION: When = When::AllZero(MU);
pub(super) const WITH_FRICTION: When = When::NotAllZero(MU);
/// The kinetic force: the load along the slot, and friction.
pub(super) const KINETIC_FORCE: [Use; 3] = [
    renamed(&KineticForce, &[("f", "kf")]).when(WITHOUT_FRICTION),
    renamed(&Kinetic, &[("f_load", "f1")]),
    renamed(&KineticForce, &[("f1", "f_kinetic"), ("f", "kf")]).when(WITH_FRICTION),
];
/// The friction force along a slot.
pub(super) const CSF1: Quantity = scalar(
    r"f",
    Unit::F,
    Domain::Real,
    "friction force along e1a, positive where it resists positive u1: on node a, its opposite on node b",
);
/// P and Φ of friction alone.
pub(super) const YIELD: [Use; 3] = [
    renamed(&Traction, &[("csf", "no_friction")]).when(WITHOUT_FRICTION),
    always(&Traction).when(WITH_FRICTION),
    always(&Yield),
];
