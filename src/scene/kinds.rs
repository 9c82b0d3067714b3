//! The tables of the kinds.

use super::kind::{Dimension, Fallback, Kind, Origin, Use, When, always, renamed};
use super::rules;
use crate::{align, coulomb, join, slider, slot, translator, universal};
use Fallback::{As, Number, Required};
use Origin::{Axis, Before, Increment, Initial, Load, Parameter, Position, Zero};

/// Every kind of element.
pub(super) static KINDS: &[Kind] = &[SLOT, SLOT_2D, TRANSLATOR, UJOINT, SLIDER, SLIDER_2D];

type Given = (&'static str, Origin);

/// What friction over increments is given, in every connector with a slot.
const STICK: [Given; 4] = [
    ("k_stick", Parameter(Required)),
    ("u1_before", Before("u1")),
    ("f_before", Before("csf")),
    ("slip_before", Before("slip_total")),
];
const MU: Given = ("mu", Parameter(Number(0.0)));
const FC_INT: Given = ("fc_int", Parameter(Number(0.0)));
const X0: Given = ("x0", Initial("x"));
const Y0: Given = ("y0", Initial("y"));
const Z0: Given = ("z0", Initial("z"));
const L1_REF: Given = ("l1_ref", Parameter(As("x0")));
const L1_MIN: Given = ("l1_min", Parameter(Required));
const L1_MAX: Given = ("l1_max", Parameter(Required));

/// Formulas of motion and friction along a slot, in every connector with one.
const MOTION: Use = always(&slot::RelativeMotion);
const STOP: Use = always(&slot::Stop);
const NORMAL: Use = always(&slot::NormalForce);
const TRIAL: Use = always(&rules::Stick);
const RETURN_MAP: Use = renamed(&coulomb::ReturnMap, &[("f", "csf")]);
const SLIP: Use = always(&rules::Slip);
const CONSTRAINT_FORCE: Use = renamed(&slot::ConstraintForce, &[("f", "rf")]);
const KINETIC_FORCE: Use = renamed(&slot::KineticForce, &[("f", "kf")]);

const SLOT: Kind = Kind {
    name: "slot",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[
        ("xa", Position(0)),
        ("xb", Position(1)),
        ("e1a", Axis(0, 0)),
        ("e2a", Axis(0, 1)),
        ("e3a", Axis(0, 2)),
        X0,
        Y0,
        Z0,
        L1_REF,
        L1_MIN,
        L1_MAX,
        MU,
        FC_INT,
        STICK[0],
        STICK[1],
        STICK[2],
        STICK[3],
        ("f1", Load),
        ("f2", Load),
        ("f3", Load),
    ],
    formulas: &[
        always(&slot::RelativePosition),
        always(&slot::Constraint),
        CONSTRAINT_FORCE,
        MOTION,
        KINETIC_FORCE,
        always(&slot::ContactForce),
        NORMAL,
        always(&slot::Friction),
        STOP,
        TRIAL,
        RETURN_MAP,
        SLIP,
    ],
    outputs: &[
        ("X", "x"),
        ("Y", "y"),
        ("Z", "z"),
        ("U1", "u1"),
        ("U1MAT", "u1_mat"),
        ("GY", "gy"),
        ("GZ", "gz"),
        ("GAPMIN", "gap_min"),
        ("GAPMAX", "gap_max"),
        ("RF", "rf"),
        ("KF", "kf"),
        ("FC", "fc"),
        ("FN", "fn"),
        ("P", "p"),
        ("PHI", "phi"),
        ("CSF1", "csf"),
        ("SLIP1", "slip"),
        ("CASU1", "slip_total"),
    ],
};

const SLOT_2D: Kind = Kind {
    dimension: Dimension::Plane,
    given: &[
        ("xa", Position(0)),
        ("xb", Position(1)),
        ("e1a", Axis(0, 0)),
        ("e2a", Axis(0, 1)),
        ("e3a", Axis(0, 2)),
        X0,
        Y0,
        L1_REF,
        L1_MIN,
        L1_MAX,
        MU,
        FC_INT,
        STICK[0],
        STICK[1],
        STICK[2],
        STICK[3],
        ("f1", Load),
        ("f2", Load),
        ("f3", Zero),
    ],
    formulas: &[
        always(&slot::RelativePosition),
        always(&slot::Constraint2d),
        CONSTRAINT_FORCE,
        MOTION,
        KINETIC_FORCE,
        always(&slot::ContactForce),
        NORMAL,
        always(&slot::Friction),
        STOP,
        TRIAL,
        RETURN_MAP,
        SLIP,
    ],
    outputs: &[
        ("X", "x"),
        ("Y", "y"),
        ("U1", "u1"),
        ("U1MAT", "u1_mat"),
        ("GY", "gy"),
        ("GAPMIN", "gap_min"),
        ("GAPMAX", "gap_max"),
        ("RF", "rf"),
        ("KF", "kf"),
        ("FC", "fc"),
        ("FN", "fn"),
        ("P", "p"),
        ("PHI", "phi"),
        ("CSF1", "csf"),
        ("SLIP1", "slip"),
        ("CASU1", "slip_total"),
    ],
    ..SLOT
};

/// The levers of a TRANSLATOR's moments; where both are 0, its friction is that of the SLOT.
const LEVERS: &[&str] = &["rr", "l"];

const TRANSLATOR: Kind = Kind {
    name: "translator",
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
        X0,
        Y0,
        Z0,
        ("alpha0", Initial("alpha")),
        ("beta0", Initial("beta")),
        ("gamma0", Initial("gamma")),
        L1_REF,
        L1_MIN,
        L1_MAX,
        ("rr", Parameter(Number(0.0))),
        ("l", Parameter(Number(0.0))),
        MU,
        FC_INT,
        STICK[0],
        STICK[1],
        STICK[2],
        STICK[3],
        ("f1", Load),
        ("f2", Load),
        ("f3", Load),
        ("m1", Load),
        ("m2", Load),
        ("m3", Load),
    ],
    formulas: &[
        always(&slot::RelativePosition),
        always(&slot::Constraint),
        always(&rules::Turns),
        always(&rules::Alignment),
        CONSTRAINT_FORCE,
        renamed(&align::ConstraintMoment, &[("m", "rm")]),
        MOTION,
        KINETIC_FORCE,
        always(&translator::TorqueForce),
        always(&translator::RadialForce),
        always(&translator::BendingForce),
        renamed(&slot::ContactForce, &[]).when(When::AllZero(LEVERS)),
        always(&translator::ContactForce).when(When::NotAllZero(LEVERS)),
        NORMAL,
        always(&slot::Friction).when(When::AllZero(LEVERS)),
        always(&translator::Friction).when(When::NotAllZero(LEVERS)),
        STOP,
        TRIAL,
        RETURN_MAP,
        SLIP,
    ],
    outputs: &[
        ("X", "x"),
        ("Y", "y"),
        ("Z", "z"),
        ("U1", "u1"),
        ("U1MAT", "u1_mat"),
        ("GY", "gy"),
        ("GZ", "gz"),
        ("UR1", "ur1"),
        ("UR2", "ur2"),
        ("UR3", "ur3"),
        ("GAPMIN", "gap_min"),
        ("GAPMAX", "gap_max"),
        ("RF", "rf"),
        ("RM", "rm"),
        ("KF", "kf"),
        ("FTORQ", "f_torq"),
        ("FR", "fr"),
        ("FBEND", "f_bend"),
        ("FC", "fc"),
        ("FN", "fn"),
        ("P", "p"),
        ("PHI", "phi"),
        ("CSF1", "csf"),
        ("SLIP1", "slip"),
        ("CASU1", "slip_total"),
    ],
};

/// JOIN and UNIVERSAL. What holds initially is what their residuals are where nothing is taken off.
const UJOINT: Kind = Kind {
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

const SLIDER: Kind = Kind {
    name: "slider",
    dimension: Dimension::Space,
    nodes: &["first", "last", "node"],
    given: &[
        ("x1", Position(0)),
        ("xn", Position(1)),
        ("xm", Position(2)),
        ("dx1", Increment(0)),
        ("dxn", Increment(1)),
        ("dxm", Increment(2)),
    ],
    formulas: &[
        always(&slider::Line),
        always(&slider::Constraint),
        always(&slider::IncrementalConstraint),
        always(&rules::KeptAxis),
        always(&slider::Eliminate),
        always(&slider::Increment),
    ],
    outputs: &[
        ("N", "n"),
        ("L", "l"),
        ("G1", "g1"),
        ("G2", "g2"),
        ("R1", "r1"),
        ("R2", "r2"),
        ("XMI", "xmi"),
        ("XMJ", "xmj"),
        ("DXMI", "dxmi"),
        ("DXMJ", "dxmj"),
    ],
};

const SLIDER_2D: Kind = Kind {
    dimension: Dimension::Plane,
    given: &[("x1", Position(0)), ("xn", Position(1)), ("xm", Position(2))],
    formulas: &[always(&slider::Constraint2d)],
    outputs: &[("G", "g")],
    ..SLIDER
};
