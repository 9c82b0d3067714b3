//! What most kinds of elements are given, and the condition of friction.

use super::{Origin, When};
use Origin::{Axis, Load, Position};

/// Registers that no formula computes, with their sources.
pub(crate) type Given = (&'static str, Origin);
/// Outputs: the name in scene files, and the register that is shown.
pub(crate) type Outputs = &'static [(&'static str, &'static str)];

/// Two nodes, and the triad of the first, for every connector.
pub(crate) const NODES: &[Given] =
    &[("xa", Position(0)), ("xb", Position(1)), ("e1a", Axis(0, 0)), ("e2a", Axis(0, 1)), ("e3a", Axis(0, 2))];
/// The triad of the second node, if angles are measured.
pub(crate) const SECOND_TRIAD: &[Given] = &[("e1b", Axis(1, 0)), ("e2b", Axis(1, 1)), ("e3b", Axis(1, 2))];
pub(crate) const FORCES: &[Given] = &[("f1", Load), ("f2", Load), ("f3", Load)];
pub(crate) const MOMENTS: &[Given] = &[("m1", Load), ("m2", Load), ("m3", Load)];

/// With friction, everything that depends on it follows from the computed friction force; if μ is 0 there is none, and nothing is
/// computed.
const MU: &[&str] = &["mu"];
pub(crate) const WITHOUT_FRICTION: When = When::AllZero(MU);
pub(crate) const WITH_FRICTION: When = When::NotAllZero(MU);
