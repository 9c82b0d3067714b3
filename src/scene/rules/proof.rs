//! Evidence for the formulas next door: none beyond what every formula owes.

use super::{Alignment, Eliminate2d, IncrementalConstraint2d, KeptAxis, KeptAxis2d, Slip, Stick, TurnStick, Turns};
use crate::proof::Proved;

impl Proved for Stick {}

impl Proved for TurnStick {}

impl Proved for Slip {}

impl Proved for Turns {}

impl Proved for Alignment {}

impl Proved for KeptAxis {}

impl Proved for KeptAxis2d {}

impl Proved for IncrementalConstraint2d {}

impl Proved for Eliminate2d {}
