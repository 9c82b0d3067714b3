//! Evidence for the formulas next door: none beyond what every formula owes.

use super::{
    Alignment, Bearing, Follow, Joining, KeptAxis, KeptAxis2d, Kinetic, PivotAxes, Slip, Stick, Traction, TurnedBack,
    Turns,
};
use crate::proof::Proved;

impl Proved for Stick {}

impl Proved for Follow {}

impl Proved for Slip {}

impl Proved for Kinetic {}

impl Proved for Traction {}

impl Proved for Joining {}

impl Proved for Turns {}

impl Proved for Alignment {}

impl Proved for KeptAxis {}

impl Proved for KeptAxis2d {}

impl Proved for PivotAxes {}

impl Proved for Bearing {}

impl Proved for TurnedBack {}
