//! HINGE in scenes: JOIN and REVOLUTE, with the friction of the pin.

use crate::connector::align::table::MOMENT;
use crate::connector::join::table::{APART, JOINED, JOINING, REACTION};
use crate::connector::revolute::table::{HELD, REVOLUTE, TURNED, TURNING};
use crate::connector::universal::table::{FOLLOWED1, KINETIC_MOMENT};
use crate::connector::{hinge, revolute};
use crate::contact::coulomb::{Response, Yield};
use crate::contact::increments::{Accumulated, Increment, Kinetic, TURN_STICK, Traction};
use crate::element::table::{
    FORCES, Fallback, Kind, MOMENTS, NODES, Origin, SECOND_TRIAD, Use, WITH_FRICTION, WITHOUT_FRICTION, When, always,
    renamed,
};
use crate::formula::quantity::{CROSS_M1, Domain, Quantity, Unit};
use Fallback::{Number, Required};
use Origin::{Before, Parameter};

const STOPS: &[&str] = &["theta1_min", "theta1_max"];
/// Both stops at once, or the one that is given, which then stands for the other too.
const STOPPING: &[Use] = &[
    always(&hinge::Stop).when(When::AllGiven(STOPS)),
    renamed(&hinge::Stop, &[("theta1_max", "theta1_min"), ("gap_max", "no_gap_max")]).when(When::NotAllGiven(STOPS)),
    renamed(&hinge::Stop, &[("theta1_min", "theta1_max"), ("gap_min", "no_gap_min")]).when(When::NotAllGiven(STOPS)),
];

const CSM1: Quantity = Quantity::scalar(
    r"m_1",
    Unit::FL,
    Domain::Real,
    "friction moment about e1a, positive where it resists positive ur1: on node a, its opposite on node b",
);
const SLIP1: Quantity =
    Quantity::scalar(r"\Delta s_1", Unit::ONE, Domain::Real, "slip about e1a in this increment, 0 in stick");
const TOTAL1: Quantity =
    Quantity::scalar(r"s_1", Unit::ONE, Domain::NonNegative, "accumulated slip about e1a, never falling");

/// The moment about the pin: the load, and friction.
const KINETIC: &[Use] = &[
    renamed(&revolute::KineticMoment, &[("m", "km")]).when(WITHOUT_FRICTION),
    renamed(&Kinetic, &[("f_load", "m1"), ("csf", "csm1"), ("f_kinetic", "m1_kinetic")]),
    renamed(&revolute::KineticMoment, &[("m1", "m1_kinetic"), ("m", "km")]).when(WITH_FRICTION),
];
/// Φ is of friction alone.
const RUBBING: &[Use] = &[
    always(&hinge::ContactMoment),
    renamed(&hinge::Friction, &[("m1", "no_number"), ("p", "no_traction"), ("phi", "no_yield")]),
    renamed(&Traction, &[("csf", "no_number")]).when(WITHOUT_FRICTION),
    renamed(&Traction, &[("csf", "csm1")]).when(WITH_FRICTION),
    renamed(&Yield, &[("fn", "mn")]),
    renamed(&Increment, &[("u1", "ur1"), ("u1_before", "ur1_before"), ("du", "dur1")]),
    renamed(&Response, &[("du", "dur1"), ("f_before", "m1_before"), ("fn", "mn"), ("f", "csm1"), ("slip", "slip1")]),
    renamed(&Accumulated, &[("slip", "slip1"), ("slip_before", "slip1_before"), ("slip_total", "slip1_total")]),
];

pub(crate) const HINGE: Kind = Kind {
    name: "hinge",
    given: &[
        NODES,
        SECOND_TRIAD,
        JOINED,
        HELD,
        &[
            ("theta1_min", Parameter(Required)),
            ("theta1_max", Parameter(Required)),
            ("rp", Parameter(Required)),
            ("ra", Parameter(Number(0.0))),
            ("ls", Parameter(Number(0.0))),
            ("mu", Parameter(Number(0.0))),
            ("mc_int", Parameter(Number(0.0))),
            ("k_stick", Parameter(Required)),
            ("m1_before", Before("csm1")),
            ("slip1_before", Before("slip1_total")),
        ],
        FORCES,
        MOMENTS,
    ],
    ordered: &[("theta1_min", "theta1_max")],
    formulas: &[JOINING, TURNING, STOPPING, KINETIC, RUBBING],
    meanings: &[
        ("k_stick", &TURN_STICK),
        ("alpha", &FOLLOWED1),
        ("m1", &CROSS_M1),
        ("p", &hinge::P_MOMENT),
        ("phi", &hinge::PHI_MOMENT),
        ("csm1", &CSM1),
        ("slip1", &SLIP1),
        ("slip1_total", &TOTAL1),
    ],
    outputs: &[
        APART,
        TURNED,
        &[("GAP1MIN", "gap_min"), ("GAP1MAX", "gap_max")],
        REACTION,
        MOMENT,
        KINETIC_MOMENT,
        &[
            ("MC", "mc"),
            ("MN", "mn"),
            ("P", "p"),
            ("PHI", "phi"),
            ("CSM1", "csm1"),
            ("SLIPR1", "slip1"),
            ("CASUR1", "slip1_total"),
        ],
    ],
    ..REVOLUTE
};
