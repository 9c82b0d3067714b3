//! TRANSLATOR in scenes: SLOT and ALIGN.

use super::{BendingForce, ContactForce, RadialForce, TorqueForce};
use crate::connector::align::table::{ALIGNED, ALIGNING, MOMENT, TURNED, URS1, URS2, URS3};
use crate::connector::slot;
use crate::connector::slot::table::{
    ALONG, CSF1, FRICTION, INITIAL, KINETIC, LENGTHS, MOVED, MOVED_3, ORDERED_LENGTHS, PLACE, PLACE_3, RUBBED, RUBBING,
    STOPPED,
};
use crate::element::table::{Dimension, FORCES, Fallback, Kind, MOMENTS, NODES, Origin, SECOND_TRIAD, When, always};
use Fallback::Number;
use Origin::Parameter;

/// The levers of a TRANSLATOR's moments; if both are 0, its friction is that of the SLOT.
const LEVERS: &[&str] = &["rr", "l"];

pub(crate) const TRANSLATOR: Kind = Kind {
    name: "translator",
    dimension: Dimension::Space,
    nodes: &["a", "b"],
    given: &[
        NODES,
        SECOND_TRIAD,
        INITIAL,
        ALIGNED,
        LENGTHS,
        &[("rr", Parameter(Number(0.0))), ("l", Parameter(Number(0.0)))],
        FRICTION,
        FORCES,
        MOMENTS,
    ],
    ordered: ORDERED_LENGTHS,
    formulas: &[
        ALONG,
        &[always(&slot::Constraint)],
        ALIGNING,
        &[
            always(&TorqueForce),
            always(&RadialForce),
            always(&BendingForce),
            always(&slot::ContactForce).when(When::AllZero(LEVERS)),
            always(&ContactForce).when(When::NotAllZero(LEVERS)),
        ],
        RUBBING,
    ],
    meanings: &[("csf", &CSF1), ("urs1", &URS1), ("urs2", &URS2), ("urs3", &URS3)],
    outputs: &[
        PLACE,
        PLACE_3,
        MOVED,
        MOVED_3,
        TURNED,
        STOPPED,
        MOMENT,
        KINETIC,
        &[("MTORQ", "m_torq"), ("FTORQ", "f_torq"), ("FR", "fr"), ("MBEND", "m_bend"), ("FBEND", "f_bend")],
        RUBBED,
    ],
};
