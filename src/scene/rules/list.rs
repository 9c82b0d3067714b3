//! Every formula that scenes add to the documented ones.

use super::{
    Alignment, Bearing, Follow, Joining, KeptAxis, KeptAxis2d, Kinetic, PivotAxes, PivotAxis2d, Slip, Stick, Traction,
    TurnedBack, Turns,
};
use crate::catalog::AnyFormula;

/// The formulas of this module.
pub const RULES: &[&dyn AnyFormula] = &[
    &Stick,
    &Follow,
    &Slip,
    &Kinetic,
    &Traction,
    &Joining,
    &Turns,
    &Alignment,
    &KeptAxis,
    &KeptAxis2d,
    &PivotAxes,
    &PivotAxis2d,
    &Bearing,
    &TurnedBack,
];
