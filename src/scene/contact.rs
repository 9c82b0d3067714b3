//! Slide lines in a scene: which of their formulas are needed, and evaluating them node by node.
//!
//! A node of an ISL element is looked for on its line once a state, however many elements have it. What follows from
//! where it is found is evaluated only as far as an output asks: slip, pressure, shear stress, torque.

mod line;
mod plan;
mod run;

pub(super) use line::{DAMPING_KEYS, FRICTION_KEYS, LINE_KEYS, Line, PRESSURE_KEYS, TYPES, lines_of};
pub(super) use plan::ContactPlan;
pub(super) use run::{Contact, Motion};
