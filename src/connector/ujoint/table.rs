//! UJOINT in scenes: JOIN and UNIVERSAL, with the friction of the cross.

use crate::connector::align::table::MOMENT;
use crate::connector::join::table::{APART, JOINED, JOINING, REACTION};
use crate::connector::universal::table::{ANGLES, CROSSED, CROSSING, FOLLOWED1, FOLLOWED3, KINETIC_MOMENT};
use crate::connector::{ujoint, universal};
use crate::contact::coulomb::{Response, Yield};
use crate::contact::increments::{Accumulated, Increment, Kinetic, TURN_STICK, Traction};
use crate::element::table::{
    Dimension, FORCES, Fallback, Kind, MOMENTS, NODES, Origin, SECOND_TRIAD, Use, WITH_FRICTION, WITHOUT_FRICTION,
    When, always, renamed,
};
use crate::formula::quantity::{CROSS_M1, CROSS_M3, Domain, PHI1, PHI3, Quantity, TWIST_M2, Unit};
use Fallback::{Number, Required};
use Origin::{Before, Parameter, Zero};

/// The names of friction about an axis in the formulas that all connectors share, and here: for the first axis and the third.
const TURN: [&[(&str, &str)]; 2] = [
    &[("u1", "ur1"), ("u1_before", "ur1_before"), ("du", "dur1")],
    &[("u1", "ur3"), ("u1_before", "ur3_before"), ("du", "dur3")],
];
const RESPONSE: [&[(&str, &str)]; 2] = [
    &[("du", "dur1"), ("f_before", "m1_before"), ("fn", "mn1"), ("f", "csm1"), ("slip", "slip1")],
    &[("du", "dur3"), ("f_before", "m3_before"), ("fn", "mn3"), ("f", "csm3"), ("slip", "slip3")],
];
const SLIP: [&[(&str, &str)]; 2] = [
    &[("slip", "slip1"), ("slip_before", "slip1_before"), ("slip_total", "slip1_total")],
    &[("slip", "slip3"), ("slip_before", "slip3_before"), ("slip_total", "slip3_total")],
];

const CSM1: Quantity = Quantity::scalar(
    r"m_1",
    Unit::FL,
    Domain::Real,
    "friction moment about e1a, positive where it resists positive ur1: on node a, its opposite on node b",
);
const CSM3: Quantity = Quantity::scalar(
    r"m_3",
    Unit::FL,
    Domain::Real,
    "friction moment about e3b, positive where it resists positive ur3: on node a, its opposite on node b",
);
const M_TWIST: Quantity = Quantity::scalar(
    r"M_{\mathrm{twist}}",
    Unit::FL,
    Domain::NonNegative,
    "magnitude of the twisting moment, the constraint moment m2",
);
const P1: Quantity = Quantity::scalar(
    r"P_1",
    Unit::FL,
    Domain::NonNegative,
    "magnitude of the moment about e1a that friction transmits",
);
const P3: Quantity = Quantity::scalar(
    r"P_3",
    Unit::FL,
    Domain::NonNegative,
    "magnitude of the moment about e3b that friction transmits",
);
const SLIP1: Quantity =
    Quantity::scalar(r"\Delta s_1", Unit::ONE, Domain::Real, "slip about e1a in this increment, 0 in stick");
const SLIP3: Quantity =
    Quantity::scalar(r"\Delta s_3", Unit::ONE, Domain::Real, "slip about e3b in this increment, 0 in stick");
const TOTAL1: Quantity =
    Quantity::scalar(r"s_1", Unit::ONE, Domain::NonNegative, "accumulated slip about e1a, never falling");
const TOTAL3: Quantity =
    Quantity::scalar(r"s_3", Unit::ONE, Domain::NonNegative, "accumulated slip about e3b, never falling");

const STOPS: &[&str] = &["theta1_min", "theta1_max", "theta3_min", "theta3_max"];
/// One stop, which also replaces the other stop of its angle; those of the other angle are 0.
const fn one_stop(names: &'static [(&'static str, &'static str)]) -> Use {
    renamed(&ujoint::Stop, names).when(When::NotAllGiven(STOPS))
}
const LOWER_1: &[(&str, &str)] = &[
    ("theta1_max", "theta1_min"),
    ("theta3_min", "no_number"),
    ("theta3_max", "no_number"),
    ("gap1_max", "no_gap"),
    ("gap3_min", "no_gap"),
    ("gap3_max", "no_gap"),
];
const UPPER_1: &[(&str, &str)] = &[
    ("theta1_min", "theta1_max"),
    ("theta3_min", "no_number"),
    ("theta3_max", "no_number"),
    ("gap1_min", "no_gap"),
    ("gap3_min", "no_gap"),
    ("gap3_max", "no_gap"),
];
const LOWER_3: &[(&str, &str)] = &[
    ("theta3_max", "theta3_min"),
    ("theta1_min", "no_number"),
    ("theta1_max", "no_number"),
    ("gap3_max", "no_gap"),
    ("gap1_min", "no_gap"),
    ("gap1_max", "no_gap"),
];
const UPPER_3: &[(&str, &str)] = &[
    ("theta3_min", "theta3_max"),
    ("theta1_min", "no_number"),
    ("theta1_max", "no_number"),
    ("gap3_min", "no_gap"),
    ("gap1_min", "no_gap"),
    ("gap1_max", "no_gap"),
];

const STOPPING: &[Use] = &[
    always(&ujoint::Stop).when(When::AllGiven(STOPS)),
    one_stop(LOWER_1),
    one_stop(UPPER_1),
    one_stop(LOWER_3),
    one_stop(UPPER_3),
];
/// The kinetic moments: the loads, and friction.
const KINETIC: &[Use] = &[
    renamed(&universal::KineticMoment, &[("m", "km")]).when(WITHOUT_FRICTION),
    renamed(&Kinetic, &[("f_load", "m1"), ("csf", "csm1"), ("f_kinetic", "m1_kinetic")]),
    renamed(&Kinetic, &[("f_load", "m3"), ("csf", "csm3"), ("f_kinetic", "m3_kinetic")]),
    renamed(&universal::KineticMoment, &[("m1", "m1_kinetic"), ("m3", "m3_kinetic"), ("m", "km")]).when(WITH_FRICTION),
];
/// The loads of the hinges of the cross.
const HINGES: &[Use] = &[
    always(&ujoint::Reaction),
    always(&ujoint::Decomposition),
    renamed(&Traction, &[("csf", "m2"), ("p", "m_twist")]),
    always(&ujoint::TwistFactors),
    always(&ujoint::AxialFactors),
    always(&ujoint::HingeTwist),
    always(&ujoint::HingeAxial),
    always(&ujoint::HingeTransverse),
    always(&ujoint::HingeBending),
    always(&ujoint::ContactMoments),
    always(&ujoint::NormalMoments),
];
/// Friction about the arms of the cross.
const RUBBING: &[Use] = &[
    renamed(&Traction, &[("csf", "no_friction"), ("p", "p1")]).when(WITHOUT_FRICTION),
    renamed(&Traction, &[("csf", "no_friction"), ("p", "p3")]).when(WITHOUT_FRICTION),
    renamed(&Traction, &[("csf", "csm1"), ("p", "p1")]).when(WITH_FRICTION),
    renamed(&Traction, &[("csf", "csm3"), ("p", "p3")]).when(WITH_FRICTION),
    renamed(&Yield, &[("p", "p1"), ("fn", "mn1"), ("phi", "phi1")]),
    renamed(&Yield, &[("p", "p3"), ("fn", "mn3"), ("phi", "phi3")]),
    renamed(&Increment, TURN[0]),
    renamed(&Increment, TURN[1]),
    renamed(&Response, RESPONSE[0]),
    renamed(&Response, RESPONSE[1]),
    renamed(&Accumulated, SLIP[0]),
    renamed(&Accumulated, SLIP[1]),
];

pub(crate) const UJOINT: Kind = Kind {
    name: "ujoint",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[
        NODES,
        SECOND_TRIAD,
        JOINED,
        CROSSED,
        &[
            ("no_friction", Zero),
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
            ("m1_before", Before("csm1")),
            ("m3_before", Before("csm3")),
            ("slip1_before", Before("slip1_total")),
            ("slip3_before", Before("slip3_total")),
        ],
        FORCES,
        MOMENTS,
    ],
    ordered: &[("theta1_min", "theta1_max"), ("theta3_min", "theta3_max")],
    formulas: &[JOINING, CROSSING, STOPPING, KINETIC, HINGES, RUBBING],
    meanings: &[
        ("k_stick", &TURN_STICK),
        ("alpha", &FOLLOWED1),
        ("gamma", &FOLLOWED3),
        ("m1", &CROSS_M1),
        ("m3", &CROSS_M3),
        ("m2", &TWIST_M2),
        ("m_twist", &M_TWIST),
        ("p1", &P1),
        ("p3", &P3),
        ("phi1", &PHI1),
        ("phi3", &PHI3),
        ("csm1", &CSM1),
        ("csm3", &CSM3),
        ("slip1", &SLIP1),
        ("slip3", &SLIP3),
        ("slip1_total", &TOTAL1),
        ("slip3_total", &TOTAL3),
    ],
    outputs: &[
        APART,
        ANGLES,
        &[("GAP1MIN", "gap1_min"), ("GAP1MAX", "gap1_max"), ("GAP3MIN", "gap3_min"), ("GAP3MAX", "gap3_max")],
        REACTION,
        MOMENT,
        KINETIC_MOMENT,
        &[
            ("FR", "fr"),
            ("FAXIAL1", "f_axial1"),
            ("FAXIAL3", "f_axial3"),
            ("FBEND", "f_bend"),
            ("ALPHATWIST", "alpha_twist"),
            ("BETATWIST", "beta_twist"),
            ("ALPHAAXIAL", "alpha_axial"),
            ("BETAAXIAL", "beta_axial"),
            ("MTWIST", "m_twist"),
            ("MTWISTH", "m_twist_hinge"),
            ("FTWIST", "f_twist_hinge"),
            ("FHINGE1", "f_axial_hinge1"),
            ("FHINGE3", "f_axial_hinge3"),
            ("FTRANSV1", "f_transv_hinge1"),
            ("FTRANSV3", "f_transv_hinge3"),
            ("FTOTAL1", "f_total_hinge1"),
            ("FTOTAL3", "f_total_hinge3"),
            ("MBEND", "m_bend_hinge"),
            ("MTOTAL", "m_total_hinge"),
            ("FTOTALBEND", "f_total_bend"),
            ("MC1", "mc1"),
            ("MC3", "mc3"),
            ("MN1", "mn1"),
            ("MN3", "mn3"),
            ("P1", "p1"),
            ("P3", "p3"),
            ("PHI1", "phi1"),
            ("PHI3", "phi3"),
            ("CSM1", "csm1"),
            ("CSM3", "csm3"),
            ("SLIPR1", "slip1"),
            ("SLIPR3", "slip3"),
            ("CASUR1", "slip1_total"),
            ("CASUR3", "slip3_total"),
        ],
    ],
};
