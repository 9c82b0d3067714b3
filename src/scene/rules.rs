//! Every formula that scenes need in addition to the documented ones: friction over increments, angles suited to programs, and
//! the coordinate that a sliding node keeps. They are not in the [catalog](crate::catalog), which contains the formulas of the
//! documents.

pub use crate::connector::align::since::{Alignment, Bearing, TurnedBack, Turns};
pub use crate::connector::join::table::Joining;
pub use crate::connector::slider::axes::{KeptAxis, KeptAxis2d, PivotAxes, PivotAxis2d};
pub use crate::contact::increments::{Accumulated, Displaced, Follow, Increment, Kinetic, Slips, Traction};

use crate::catalog::AnyFormula;

/// All of them.
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
