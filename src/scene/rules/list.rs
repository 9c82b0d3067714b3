//! Every formula that scenes use in addition to the documented ones.

use super::{
    Accumulated, Alignment, Bearing, Follow, Increment, Joining, KeptAxis, KeptAxis2d, Kinetic, PivotAxes, PivotAxis2d,
    Traction, TurnedBack, Turns,
};
use crate::catalog::AnyFormula;

/// The formulas of this module.
pub const RULES: &[&dyn AnyFormula] = &[
    &Increment,
    &Follow,
    &Accumulated,
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
