//! TRANSLATOR: SLOT and ALIGN together. Node b slides along a line of node a and keeps its orientation relative to a.
//!
//! Frames, matrices, zero positions and signs are those of [`slot`](crate::connector::slot) and
//! [`align`](crate::connector::align), and so are the residuals, two and three, the forces and the moments. Only the friction is
//! new: in addition to the force normal to the slot, the torque m1 about it and the bending moments m2, m3 press the parts
//! together, each with its own lever, the radius R_r and half the length L.
//!
//! [`Translator`] is what a program calls; its formulas are in three modules.

mod connector;
mod contact;
mod element;
mod friction;
mod kinematics;
#[cfg(feature = "scene")]
pub(crate) mod table;

pub use connector::{Gradient, Loads, Pose, Translator};
pub use contact::{
    Bending, BendingContact, BendingForce, RadialContact, RadialForce, Torque, TorqueContact, TorqueForce,
};
pub use element::{TranslatorContact, TranslatorElement, TranslatorStart};
pub use friction::{ContactForce, ContactLoads, Friction, FrictionLoads};
pub use kinematics::{AllResiduals, Constraint, Placement};
