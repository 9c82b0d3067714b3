//! TRANSLATOR: SLOT and ALIGN.

use super::dimension::Dimension;
use super::parts::{ALIGNED, ALIGNING, MOMENT, TURNED, URS1, URS2, URS3};
use super::shared::{CSF1, FORCES, FRICTION, INITIAL, LENGTHS, MOMENTS, NODES, ORDERED_LENGTHS, SECOND_TRIAD};
use super::slot::{ALONG, KINETIC, MOVED, MOVED_3, PLACE, PLACE_3, RUBBED, RUBBING, STOPPED};
use super::table::{Fallback, Kind, Origin, When, always};
use crate::connector::{slot, translator};
use Fallback::Number;
use Origin::Parameter;

/// The levers of a TRANSLATOR's moments; if both are 0, its friction is that of the SLOT.
const LEVERS: &[&str] = &["rr", "l"];

pub(super) const TRANSLATOR: Kind = Kind {
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
            always(&translator::TorqueForce),
            always(&translator::RadialForce),
            always(&translator::BendingForce),
            always(&slot::ContactForce).when(When::AllZero(LEVERS)),
            always(&translator::ContactForce).when(When::NotAllZero(LEVERS)),
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
