//! UJOINT: JOIN and UNIVERSAL, with the friction of the cross.

use super::dimension::Dimension;
use super::shared::{FORCES, MOMENTS, NODES, SECOND_TRIAD};
use super::table::{Fallback, Kind, Origin, Use, always, renamed};
use crate::coulomb::ReturnMap;
use crate::quantity::{Domain, Quantity, Unit};
use crate::scene::rules::{Slip, TURN_STICK, TurnStick, scalar};
use crate::{join, ujoint, universal};
use Fallback::{As, Number, Required};
use Origin::{Before, Initial, Parameter, Zero};

/// What friction about an axis is called in the formulas that all connectors share, and here: the first axis, the third.
const TURN: [&[(&str, &str)]; 2] = [
    &[("ur", "ur1"), ("ur_before", "ur1_before"), ("m_before", "m1_before"), ("m_trial", "m1_trial")],
    &[("ur", "ur3"), ("ur_before", "ur3_before"), ("m_before", "m3_before"), ("m_trial", "m3_trial")],
];
const MAP: [&[(&str, &str)]; 2] = [
    &[("f_trial", "m1_trial"), ("fn", "mn1"), ("f", "csm1")],
    &[("f_trial", "m3_trial"), ("fn", "mn3"), ("f", "csm3")],
];
const SLIP: [&[(&str, &str)]; 2] = [
    &[
        ("f_trial", "m1_trial"),
        ("csf", "csm1"),
        ("slip_before", "slip1_before"),
        ("slip", "slip1"),
        ("slip_total", "slip1_total"),
    ],
    &[
        ("f_trial", "m3_trial"),
        ("csf", "csm3"),
        ("slip_before", "slip3_before"),
        ("slip", "slip3"),
        ("slip_total", "slip3_total"),
    ],
];

const CSM1: Quantity = scalar(r"m_1", Unit::FL, Domain::Real, "moment about e1a that friction transmits");
const CSM3: Quantity = scalar(r"m_3", Unit::FL, Domain::Real, "moment about e3b that friction transmits");
const SLIP1: Quantity =
    scalar(r"\Delta s_1", Unit::ONE, Domain::Real, "slip about e1a in this increment, 0 while it sticks");
const SLIP3: Quantity =
    scalar(r"\Delta s_3", Unit::ONE, Domain::Real, "slip about e3b in this increment, 0 while it sticks");
const TOTAL1: Quantity = scalar(r"s_1", Unit::ONE, Domain::NonNegative, "accumulated slip about e1a, never falling");
const TOTAL3: Quantity = scalar(r"s_3", Unit::ONE, Domain::NonNegative, "accumulated slip about e3b, never falling");

const STICK: [Use; 2] = [renamed(&TurnStick, TURN[0]), renamed(&TurnStick, TURN[1])];

/// What holds initially is what the residuals are where nothing is taken off.
pub(super) const UJOINT: Kind = Kind {
    name: "ujoint",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[
        NODES,
        SECOND_TRIAD,
        &[
            ("no_vector", Zero),
            ("no_number", Zero),
            ("d0", Initial("d")),
            ("c0", Initial("c")),
            ("alpha0", Initial("alpha")),
            ("gamma0", Initial("gamma")),
            ("theta1_ref", Parameter(As("alpha0"))),
            ("theta3_ref", Parameter(As("gamma0"))),
            ("theta1_min", Parameter(Required)),
            ("theta1_max", Parameter(Required)),
            ("theta3_min", Parameter(Required)),
            ("theta3_max", Parameter(Required)),
            ("rp", Parameter(Required)),
            ("la", Parameter(Required)),
            ("ra", Parameter(Number(0.0))),
            ("ls", Parameter(Number(0.0))),
            ("mu", Parameter(Number(0.0))),
            ("mc1_int", Parameter(Number(0.0))),
            ("mc3_int", Parameter(Number(0.0))),
            ("k_stick", Parameter(Required)),
            ("ur1_before", Before("ur1")),
            ("ur3_before", Before("ur3")),
            ("m1_before", Before("csm1")),
            ("m3_before", Before("csm3")),
            ("slip1_before", Before("slip1_total")),
            ("slip3_before", Before("slip3_total")),
        ],
        FORCES,
        MOMENTS,
    ],
    ordered: &[("theta1_min", "theta1_max"), ("theta3_min", "theta3_max")],
    formulas: &[
        always(&join::Constraint),
        renamed(&join::Constraint, &[("d0", "no_vector"), ("g", "d")]),
        renamed(&universal::Constraint, &[("g", "g_rot")]),
        renamed(&universal::Constraint, &[("c0", "no_number"), ("g", "c")]),
        always(&universal::Angles),
        always(&universal::RelativeMotion),
        always(&ujoint::Stop),
        renamed(&universal::ConstraintMoment, &[("m", "rm")]),
        renamed(&universal::KineticMoment, &[("m", "km")]),
        always(&ujoint::Reaction),
        always(&ujoint::Decomposition),
        always(&ujoint::HingeTwist),
        always(&ujoint::HingeAxial),
        always(&ujoint::HingeTransverse),
        always(&ujoint::HingeBending),
        always(&ujoint::ContactMoments),
        always(&ujoint::NormalMoments),
        always(&ujoint::Friction),
        STICK[0],
        STICK[1],
        renamed(&ReturnMap, MAP[0]),
        renamed(&ReturnMap, MAP[1]),
        renamed(&Slip, SLIP[0]),
        renamed(&Slip, SLIP[1]),
    ],
    meanings: &[
        ("k_stick", &TURN_STICK),
        ("csm1", &CSM1),
        ("csm3", &CSM3),
        ("slip1", &SLIP1),
        ("slip3", &SLIP3),
        ("slip1_total", &TOTAL1),
        ("slip3_total", &TOTAL3),
    ],
    outputs: &[
        ("G", "g"),
        ("GROT", "g_rot"),
        ("ALPHA", "alpha"),
        ("GAMMA", "gamma"),
        ("UR1", "ur1"),
        ("UR3", "ur3"),
        ("UR1MAT", "ur1_mat"),
        ("UR3MAT", "ur3_mat"),
        ("GAP1MIN", "gap1_min"),
        ("GAP1MAX", "gap1_max"),
        ("GAP3MIN", "gap3_min"),
        ("GAP3MAX", "gap3_max"),
        ("RM", "rm"),
        ("KM", "km"),
        ("FR", "fr"),
        ("FAXIAL1", "f_axial1"),
        ("FAXIAL3", "f_axial3"),
        ("FBEND", "f_bend"),
        ("MTWIST", "m_twist_hinge"),
        ("FTOTAL1", "f_total_hinge1"),
        ("FTOTAL3", "f_total_hinge3"),
        ("MTOTAL", "m_total_hinge"),
        ("MC1", "mc1"),
        ("MC3", "mc3"),
        ("MN1", "mn1"),
        ("MN3", "mn3"),
        ("PHI1", "phi1"),
        ("PHI3", "phi3"),
        ("CSM1", "csm1"),
        ("CSM3", "csm3"),
        ("SLIPR1", "slip1"),
        ("SLIPR3", "slip3"),
        ("CASUR1", "slip1_total"),
        ("CASUR3", "slip3_total"),
    ],
};
